"""Tables in Markdown, and the words for machines that stand over their columns."""

from collections.abc import Iterable, Sequence

#: Machine of a bench row to what its figures are of.
MACHINES = {"a1200-fast": "fast RAM", "a1200-mixed": "data in chip", "a1200": "chip RAM only"}
RULES = {"l": "---", "r": "--:"}


def table(titles: Sequence[str], rows: Iterable[Sequence[str]], sides: str = "lr") -> str:
    """A table without a line's end. ``sides``: where each column's cells stand, l or r; the last
    letter goes for all further columns."""
    rules = "|".join(RULES[side] for side in sides.ljust(len(titles), sides[-1]))
    lines = [f"| {' | '.join(cells)} |" for cells in (titles, *rows)]
    return "\n".join([lines[0], f"|{rules}|", *lines[1:]])
