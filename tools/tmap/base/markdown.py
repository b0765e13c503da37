"""Tables in Markdown, and the machines' names in their column heads."""

from collections.abc import Iterable, Sequence

#: A bench row's machine to the memory that its figures are for.
MACHINES = {"a1200-fast": "fast RAM", "a1200-mixed": "data in chip", "a1200": "chip RAM only"}
RULES = {"l": "---", "r": "--:"}


def table(titles: Sequence[str], rows: Iterable[Sequence[str]], sides: str = "lr") -> str:
    """Returns a table without a final newline. ``sides``: each column's alignment, l or r; the last
    letter applies to all further columns."""
    rules = "|".join(RULES[side] for side in sides.ljust(len(titles), sides[-1]))
    lines = [f"| {' | '.join(cells)} |" for cells in (titles, *rows)]
    return "\n".join([lines[0], f"|{rules}|", *lines[1:]])
