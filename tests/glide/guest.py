"""Sends operations to the guest's texture units."""

from tests.helpers import vector_guest
from tmap.build import layout
from tmap.glide.words import ASPECTS, FORMATS, LEVELS

MASK = 0xFFFFFFFF
LEVEL_NUMBERS = {name: number for number, name in enumerate(LEVELS, 1)}  # in the order of the calls


class Guest(vector_guest.Guest):
    def call(self, name: str, *values: int) -> int:
        """Adds a call; its answer is (result, four registers, its own value)."""
        number = layout.load().constants[f"VECTOR_GLIDE_CALL_{name}"]
        return self.ask("GLIDE_CALL", number, *values, numbers=6)

    def one(self, name: str, *values: int) -> int:
        """Adds a question whose answer is one number."""
        return self.ask(f"GLIDE_{name}", *values, numbers=1)


def texture(largest: int, smallest: int, aspect: str, form: str) -> list[int]:
    """The fields of a struct glide_texture."""
    return [largest, smallest, ASPECTS.index(aspect), FORMATS[form]]


#: Results by number, without GLIDE_.
RESULTS = vector_guest.results("GLIDE")
