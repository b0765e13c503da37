"""``python -m tests.mutants``: makes mutants, tries them on two processes, lists those that nothing notices.

The results of a run of all rooms of assembly are written to tests/mutants/MUTANTS.md. A mutant that survives must be explained in
explained.json, or noticed by a test that is still to be written.
"""

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from multiprocessing import active_children, get_context

from tests.mutants import page
from tests.mutants.changes import Mutant, chosen
from tests.mutants.explained import explanations
from tests.mutants.judge import KILLED, SURVIVES, Trials, Verdict, judge, judge_python
from tests.mutants.rooms import LISTED, ROOMS, Room
from tmap.base.errors import UserError
from tmap.base.paths import BUILD
from tmap.base.signals import ENDING, end_by

SEED = 1
PROCESSES = 2
LAST_SECONDS = 20  # that a process may take to tidy up
RESULTS = BUILD / "mutants" / "results.json"
trials: Trials | None = None  # made before the processes that use it are forked


def tried(mutant: Mutant, room: str) -> Verdict:
    """Returns a mutant's verdict, in a process of its own."""
    subjects = ROOMS[room].subjects
    return judge_python(mutant, subjects) if mutant.file.endswith(".py") else judge(mutant, trials, subjects)


class Draw:
    """The mutants of a room in their order: as many as it asks for that count."""

    def __init__(self, name: str, room: Room, seed: int, count: int, only: set[tuple], known: dict[tuple, Verdict]) -> None:
        self.name, self.count = name, count
        self.left: Iterator[Mutant] = iter([each for each in chosen(room.mutants(), seed) if not only or each.key in only])
        self.known, self.found = known, dict[Mutant, Verdict]()
        self.running = 0

    def next(self) -> Mutant | None:
        """Returns the next one to try, None if there are enough."""
        while sum(each.how in (*KILLED, SURVIVES) for each in self.found.values()) + self.running < self.count:
            if not (mutant := next(self.left, None)):
                break
            if mutant.key not in self.known:
                self.running += 1
                return mutant
            self.found[mutant] = self.known[mutant.key]
        return None


def show(draws: list[Draw], begun: float) -> None:
    """Shows how far the run is, in one line."""
    verdicts = Counter(each.how for draw in draws for each in draw.found.values())
    line = ", ".join(f"{count} {how}" for how, count in verdicts.items())
    end = "\r" if sys.stderr.isatty() else "\n"
    print(f"{time.monotonic() - begun:6.0f} s: {line}", end=end, file=sys.stderr, flush=True)


def run(draws: list[Draw]) -> None:
    """Tries the mutants of all draws."""
    begun = time.monotonic()
    with ProcessPoolExecutor(PROCESSES, get_context("fork"), end_by, (ENDING,)) as pool:
        running: dict[Future, tuple[Draw, Mutant]] = {}
        try:
            while True:
                for draw in draws:
                    while len(running) < PROCESSES and (mutant := draw.next()):
                        running[pool.submit(tried, mutant, draw.name)] = draw, mutant
                if not running:
                    return
                for done in wait(running, return_when=FIRST_COMPLETED).done:
                    draw, mutant = running.pop(done)
                    draw.running -= 1
                    draw.found[mutant] = done.result()
                    if draw.found[mutant].how == SURVIVES and mutant.key not in explanations():
                        print(f"{mutant.file}:{mutant.line}: {mutant.before} -> {mutant.after}", flush=True)
                show(draws, begun)
        except BaseException:
            for process in (some := active_children()):  # they may not have had the signal
                process.terminate()
            for process in some:
                process.join(LAST_SECONDS)
                process.kill()
            pool.shutdown(cancel_futures=True)
            raise


def as_json(draws: list[Draw]) -> list[dict]:
    """Returns the results as they are kept."""
    return [{"room": draw.name, **vars(mutant), **vars(verdict)} for draw in draws for mutant, verdict in draw.found.items()]


def keep(draws: list[Draw], is_part: bool) -> list[dict]:
    """Writes the results, of a part of the rooms beside those of the last run; returns them."""
    found = as_json(draws)
    if is_part and RESULTS.exists():
        new, there = {page.key(each) for each in found}, {each.key for room in ROOMS.values() for each in room.mutants()}
        found += [each for each in json.loads(RESULTS.read_text()) if page.key(each) in there - new]
    RESULTS.parent.mkdir(exist_ok=True)
    RESULTS.write_text(json.dumps(found, indent=0))
    return found


def last() -> dict[tuple, Verdict]:
    """Returns the verdicts of the last run by the mutants' keys."""
    found = json.loads(RESULTS.read_text()) if RESULTS.exists() else ()
    return {page.key(each): Verdict(each["how"], each["by"]) for each in found}


def survivors() -> set[tuple]:
    """Returns the keys of those that survived in the last run and are not explained."""
    if not RESULTS.exists():
        raise UserError(f"{RESULTS}: no run was made yet")
    return {key for each in json.loads(RESULTS.read_text()) if each["how"] == SURVIVES
            and (key := page.key(each)) not in explanations()}


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 1 if a mutant survives that is not explained."""
    global trials
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__.split("\n")[0])
    parser.add_argument("--seed", type=int, default=SEED, help=f"which mutants ({SEED}; others write no page)")
    parser.add_argument("--room", action="append", choices=tuple(ROOMS), help="one room, or several; all of assembly if none is named")
    parser.add_argument("--count", type=int, help="how many mutants of each room (as many as the page has)")
    parser.add_argument("--again", action="store_true", help="only those that survived in the last run, not explained")
    parser.add_argument("--more", action="store_true", help="go on with a run that was interrupted: keep what it found")
    parser.add_argument("--page", action="store_true", help="only write the page of the last run")
    args = parser.parse_args(words)
    if not args.page:
        end_by(ENDING)
        only = survivors() if args.again else set()
        if args.again and not only:
            print("mutants: none survived")
            return 0
        draws = [Draw(name, room, args.seed, args.count or room.count, only, last() if args.more else {})
                 for name, room in ROOMS.items()
                 if name in (args.room or LISTED)]
        if any(draw.name in LISTED for draw in draws):
            trials = Trials()
        try:
            run(draws)
        finally:
            keep(draws, args.again or bool(args.room))
    found = json.loads(RESULTS.read_text())
    unexplained = [each for each in found if each["how"] == SURVIVES and page.key(each) not in explanations()]
    if args.page or not (args.room or args.count or args.seed != SEED):
        page.write(found)
    for each in unexplained:
        print(f"{each['file']}:{each['line']}: {each['within']}: {each['before']} -> {each['after']}")
    print(f"mutants: {sum(each['how'] in (*KILLED, SURVIVES) for each in found)}, {len(unexplained)} survive unexplained")
    return 1 if unexplained else 0
