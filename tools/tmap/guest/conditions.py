"""The conditions that the bench measures under: which machine, and where data lies."""

from typing import NamedTuple


class Condition(NamedTuple):
    """``chip``: a kernel's far data is in chip RAM; ``options``: what ``render`` is told for the
    same of maps and frame."""

    machine: str
    chip: bool
    options: str


CONDITIONS = {"a1200": Condition("a1200", True, ""),
              "a1200-fast": Condition("a1200-fast", False, ""),
              "a1200-mixed": Condition("a1200-fast", True, " CHIP")}
