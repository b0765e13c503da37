"""The mutants' machinery: known mutants are noticed, explanations name lines that exist, the page says what they say."""

from functools import cache

import pytest

from tests.mutants import assembly, c_source, explained, page, python_source
from tests.mutants.changes import Mutant, chosen
from tests.mutants.judge import SAME, UNBUILT, Trials, judge
from tests.mutants.rooms import ROOMS
from tmap.base.paths import ROOT

#: File, line before and after, and how it must end.
KNOWN = {
    "a carry is lost": ("src68k/edge/edge_addx.s", "addx.l \\3,d2", "add.l \\3,d2", ("trials",)),
    "an exact error grows": ("src68k/include/edge.i", "sub.l a6,d0", "add.l a6,d0", ("trials",)),
    "an edge is used twice": ("src68k/include/edge.i", "lea edge_sizeof(a5),a5", "", ("trials",)),
    "edges are not counted": ("src68k/include/edge.i", "subq.l #1,(sp)", "", ("trials", "crash", "no end")),
    "a loop has no end": ("src68k/include/edge.i", "subq.l #1,d5", "", ("crash", "no end")),
}


@cache
def mutants(file: str) -> list[Mutant]:
    maker = {"c": c_source, "y": python_source}.get(file[-1], assembly)
    return maker.mutants(file)


@pytest.fixture(scope="module")
def trials() -> Trials:
    """The trials of edges alone."""
    return Trials(("edge",))


@pytest.mark.parametrize("name", KNOWN)
def test_known_mutants_are_noticed(trials, name: str) -> None:
    file, before, after, how = KNOWN[name]
    mutant = next(each for each in mutants(file) if (each.before, each.after) == (before, after))
    assert judge(mutant, trials, ()).how in how


def test_what_is_no_mutant_is_told(trials) -> None:
    """A changed comment makes the same code; what is no instruction cannot be built."""
    first = mutants("src68k/edge/edge_addx.s")[0]
    line = (ROOT / first.file).read_text().splitlines()[first.line - 1]
    for text, how in ((line + " ; the same", SAME), (" nothing d0", UNBUILT)):
        assert judge(Mutant(first.file, first.line, first.within, "removed", "", "", text), trials, ()).how == how


def test_explanations_are_of_changes_that_could_be_made() -> None:
    """A line that was changed or moved to another routine takes its explanation away."""
    gone = [key for key in explained.explanations() if key not in {each.key for each in mutants(key[0])}]
    assert not gone, f"{explained.FILE.name} explains what is no longer there: {gone}"


def test_the_draw_depends_on_seed_and_lines_alone() -> None:
    some = ROOMS["edges"].mutants()
    first, again = ([each.key for each, _ in zip(chosen(list(order), 1), range(50))] for order in (some, reversed(some)))
    assert first == again
    assert first != [each.key for each, _ in zip(chosen(some, 2), range(50))]
    others = [each for each in some if each.key != first[0]]
    assert len({*first} - {each.key for each, _ in zip(chosen(others, 1), range(50))}) <= 2


def test_each_mutant_changes_its_line() -> None:
    for name, room in ROOMS.items():
        for each in room.mutants():
            assert each.before != each.after and each.before, (name, each)


def test_the_page_has_no_survivor_without_a_reason() -> None:
    text = page.PAGE.read_text()
    assert page.UNEXPLAINED not in text
    assert all(len(line) <= page.WIDTH for line in text.splitlines())
