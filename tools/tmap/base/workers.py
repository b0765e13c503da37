"""Work on all of the host's processors: processes that end with this one, whatever ends it."""

import os
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import active_children, get_context, resource_tracker
from threading import Event

from tmap.base.signals import ENDING, end_by, held

ended = Event()  # in a worker: if set, it begins nothing further
#: Spawned, not forked: progress bars have a thread.
SPAWNED = get_context("spawn")
told = None  # in a worker: the queue of what it says while it works, if there is one


def begin(queue) -> None:
    """Makes signals end a worker as an exit does, so that its emulator ends, its files are deleted, and no traceback
    is printed."""
    global told
    end_by(ENDING, ended.set)
    told = queue


def tell(*words) -> None:
    """Says something from a worker, which its pool's queue has then."""
    if told:
        told.put(words)


@contextmanager
def pool(most: int, queue=None) -> Iterator[ProcessPoolExecutor]:
    """Yields a pool of a process for each of the host's processors, ``most`` of them at most. ``queue``: for what is
    told, made by SPAWNED."""
    with held():  # multiprocessing's own process inherits that: it must outlive a closed terminal's signal
        resource_tracker.ensure_running()
    with ProcessPoolExecutor(max(min(os.cpu_count() or 1, most), 1), SPAWNED, begin, (queue,)) as made:
        try:
            yield made
        except BaseException:
            for process in active_children():  # they may not have had the signal
                process.terminate()
            made.shutdown(cancel_futures=True)
            raise
