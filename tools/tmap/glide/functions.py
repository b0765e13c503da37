"""Combine functions and factors by the names of tmap.glide.words, and the modes for trilinear
filtering."""

from dataclasses import replace

from tmap.base.errors import UserError
from tmap.glide.state import Combination, Modes
from tmap.glide.words import FACTORS, FUNCTIONS as TERMS

#: Name to the combination that a function sets.
FUNCTIONS = {name: Combination(**dict.fromkeys(terms, 1)) for name, terms in TERMS.items()}


def combination(function: str, factor: str = "zero", invert: int = 0) -> Combination:
    """Returns a half of the combine unit."""
    for kind, name, names in (("function", function, FUNCTIONS), ("factor", factor, FACTORS)):
        if name not in names:
            raise UserError(f"combine: {kind} {name!r} is none of {', '.join(names)}")
    mselect, reverse = FACTORS[factor]
    return replace(FUNCTIONS[function], mselect=mselect, reverse=reverse, invert=invert)


def combine(modes: Modes, function: str, factor: str = "zero", invert: int = 0) -> Modes:
    """Returns the modes with both halves set alike."""
    half = combination(function, factor, invert)
    return replace(modes, rgb=half, alpha=half)


def lod_factor(odd: int) -> str:
    """Returns the factor by which a unit of even or odd levels blends: the weight of its own texel
    falls as the pixel's level moves away from its level."""
    return "one_minus_lod_fraction" if odd else "lod_fraction"


def trilinear_pair(modes: Modes, odd_first: int = 0) -> tuple[Modes, Modes]:
    """Returns modes of two units that filter trilinearly in one pass, the first nearest the frame
    buffer; ``odd_first``: that one has the odd levels."""
    first = replace(modes, trilinear=1, split=1, odd=odd_first)
    second = replace(modes, trilinear=1, split=1, odd=1 - odd_first)
    return combine(first, "blend", lod_factor(odd_first)), combine(second, "local")
