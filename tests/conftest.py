"""Sets the order of the test files: ``make test`` hands whole files to two processes in this order.
Adds to each failure the command that runs it again, and at the end the files that took most processor time."""

import gc
import os
import shlex
from collections import Counter
from pathlib import Path

import pytest

import tmap  # noqa: F401  before NumPy, whose threads it limits
from tests.helpers.longest import LONGEST

RANKS = {name: rank for rank, name in enumerate(LONGEST)}
TESTS = Path(__file__).parent
SPENT = [sum(os.times()[:4])]  # processor time of this process and its children so far, seconds
SLOWEST = 15  # files in the list at the end
#: New objects before Python looks for cycles among them. There are few cycles here and many objects that live long
#: (tests, scenes, rows of trials): with Python's own 700 the search takes an eighth of the time.
YOUNG = 100_000


def place(item) -> str:
    """The path of a test's file below tests/, without its suffix."""
    return item.path.relative_to(TESTS).with_suffix("").as_posix()


def pytest_collection_modifyitems(items: list) -> None:
    """Sorts the tests by their files' ranks; unlisted ones keep their order at the end."""
    items.sort(key=lambda item: RANKS.get(place(item).replace("test_", ""), len(RANKS)))


def pytest_collection_finish() -> None:
    """Leaves what was imported and collected out of every later search for cycles."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNG, 10, 10)


def pytest_runtest_teardown(item, nextitem) -> None:
    """Frees what a file's tests have left, which the next search might be long in coming to."""
    if nextitem is None or nextitem.path != item.path:
        gc.collect()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item):
    """Adds a phase's processor time to its report, and to a failed one the command that runs it again."""
    report = yield
    SPENT.append(sum(os.times()[:4]))
    report.processor_time = SPENT[-1] - SPENT.pop(0)
    if report.failed:
        test = f"tests/{place(item)}.py::{item.nodeid.partition('::')[2]}"
        report.sections.append(
            ("again", f".deps/venv/bin/python -m pytest -q {shlex.quote(test)}"))
    return report


def pytest_terminal_summary(terminalreporter) -> None:
    """Lists the files that took most, with the seconds of all, if there are many."""
    seconds = Counter()
    for reports in terminalreporter.stats.values():
        for report in reports:
            if isinstance(report, pytest.TestReport):
                seconds[report.nodeid.partition("::")[0]] += report.processor_time
    if len(seconds) > SLOWEST:
        terminalreporter.section(f"seconds of processor time: {sum(seconds.values()):.0f} of {len(seconds)} files")
        for name, spent in seconds.most_common(SLOWEST):
            terminalreporter.write_line(f"{spent:7.1f}  {name}")
