"""Ends by a signal as by an exception, so that no emulator and no folder is left behind."""

import contextlib
import signal
import sys
from collections.abc import Callable, Iterator

#: Signals that ask a process to end: Ctrl-C, kill, a closed terminal, Ctrl-\\.
ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT)


def end_by(signals: tuple[signal.Signals, ...], before: Callable[[], None] = lambda: None) -> None:
    """Makes each of the signals exit with status 128 + its number, after a call of ``before``. Further
    signals do not disturb what is tidied up then. An ignored one stays so: nohup ignores SIGHUP."""
    def end(number: int, _) -> None:
        for each in ENDING:  # not SIG_IGN: Python complains of signals that are on their way
            signal.signal(each, lambda *_: None)
        before()
        sys.exit(128 + number)

    for each in signals:
        if signal.getsignal(each) != signal.SIG_IGN:
            signal.signal(each, end)


@contextlib.contextmanager
def held() -> Iterator[None]:
    """Makes signals wait until the block's end, so that it is not left half done."""
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
