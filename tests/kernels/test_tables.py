"""Tables in assembly, each entry against its formula: kernels' trials read few of them."""

import re
from fractions import Fraction

import pytest

from tmap.base.paths import ROOT

FILE = "src68k/edge/perspective_lines.s"
OCTAVE = 64  # entries
#: Whether an entry is the least or the greatest whole number n that its formula allows; all by integers.
RIGHT = {
    # n >= 64 log2(1 + (i + 1) / 64): 2^n >= ((65 + i) / 64)^64
    "log_up": lambda i, n: is_at_least(n, i + 1) and not is_at_least(n - 1, i + 1),
    # n <= 64 log2(1 + i / 64)
    "log_down": lambda i, n: not is_above(n, i) and is_above(n + 1, i),
    # n >= 2^(15 + i / 64): n^64 >= 2^(960 + i)
    "power_up": lambda i, n: n**OCTAVE >= 1 << 15 * OCTAVE + i > (n - 1) ** OCTAVE,
}


def is_at_least(n: int, i: int) -> bool:
    """Returns true if n >= 64 log2(1 + i / 64)."""
    return Fraction(2) ** n >= Fraction(OCTAVE + i, OCTAVE) ** OCTAVE


def is_above(n: int, i: int) -> bool:
    """Returns true if n > 64 log2(1 + i / 64)."""
    return Fraction(2) ** n > Fraction(OCTAVE + i, OCTAVE) ** OCTAVE


def entries(text: str, name: str) -> list[int]:
    """Returns the numbers that follow a label."""
    lines = re.search(rf"^{name}\n((?:\s+dc\.[bw] .*\n?)+)", text, re.MULTILINE)[1]
    return [int(number) for line in lines.splitlines() for number in line.split()[1].split(",")]


def wrong(text: str) -> list[tuple[str, int]]:
    """Returns the names and places of the wrong entries in a text of FILE."""
    return [(name, i) for name, is_right in RIGHT.items()
            for i, n in enumerate(entries(text, name)) if not is_right(i, n)]


def test_tables_are_their_formulas() -> None:
    text = (ROOT / FILE).read_text()
    assert all(len(entries(text, name)) == OCTAVE for name in RIGHT)
    assert not wrong(text)


@pytest.mark.parametrize("name", RIGHT)
def test_a_wrong_entry_is_found(name: str) -> None:
    """Each entry, one too high or too low."""
    text = (ROOT / FILE).read_text()
    right = entries(text, name)
    for i, n in enumerate(right):
        assert not RIGHT[name](i, n + 1) and not RIGHT[name](i, n - 1)
