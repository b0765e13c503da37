"""The guest's texture units asked step by step."""

from tests.helpers import vector_guest
from tmap.build import layout
from tmap.glide.words import ASPECTS, FORMATS, LEVELS

MASK = 0xFFFFFFFF
LEVEL_NUMBERS = {name: number for number, name in enumerate(LEVELS, 1)}  # of the calls


class Guest(vector_guest.Guest):
    """Asks Glide's texture units."""

    def call(self, name: str, *values: int) -> int:
        """A call; its answer is (result, four registers, its own)."""
        number = layout.load().constants[f"VECTOR_GLIDE_CALL_{name}"]
        return self.ask("GLIDE_CALL", number, *values, numbers=6)

    def one(self, name: str, *values: int) -> int:
        """A question that has one number as its answer."""
        return self.ask(f"GLIDE_{name}", *values, numbers=1)


def texture(largest: int, smallest: int, aspect: str, form: str) -> list[int]:
    """A struct glide_texture."""
    return [largest, smallest, ASPECTS.index(aspect), FORMATS[form]]


def results() -> dict[int, str]:
    """Names of results, without GLIDE_."""
    constants = layout.load().constants
    names = ("DONE", "OUTSIDE_MEMORY", "NO_LEVEL", "LEVEL_NOT_HELD",
             *(name.removeprefix("GLIDE_") for name in constants if name.startswith("GLIDE_BAD_")))
    return {constants[f"GLIDE_{name}"]: name for name in names}
