"""The conditions under which the bench measures: the machine, and the memory that holds the
data."""

from typing import NamedTuple


class Condition(NamedTuple):
    """``chip``: a kernel's far data is in chip RAM; ``options``: arguments that make ``render``
    place maps and frame alike."""

    machine: str
    chip: bool
    options: str


CONDITIONS = {"a1200": Condition("a1200", True, ""),
              "a1200-fast": Condition("a1200-fast", False, ""),
              "a1200-mixed": Condition("a1200-fast", True, " CHIP")}
