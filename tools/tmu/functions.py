"""Combine functions and factors by Glide's names, and what trilinear filtering asks of units."""

from dataclasses import replace

from ..errors import UserError
from .state import (DETAIL, LOCAL, LOCAL_ALPHA, LOD_FRACTION, OTHER_ALPHA, ZERO, Combination,
                    Modes)

#: Name to what a function sets. Other names of Glide's: "blend" is
#: scale_other_minus_local_add_local, "blend_local" scale_minus_local_add_local.
FUNCTIONS = {
    "zero": Combination(zero_other=1),
    "local": Combination(zero_other=1, add_local=1),
    "local_alpha": Combination(zero_other=1, add_alpha_local=1),
    "scale_other": Combination(),
    "scale_other_add_local": Combination(add_local=1),
    "scale_other_add_local_alpha": Combination(add_alpha_local=1),
    "scale_other_minus_local": Combination(sub_local=1),
    "blend": Combination(sub_local=1, add_local=1),
    "scale_other_minus_local_add_local_alpha": Combination(sub_local=1, add_alpha_local=1),
    "blend_local": Combination(zero_other=1, sub_local=1, add_local=1),
    "scale_minus_local_add_local_alpha": Combination(zero_other=1, sub_local=1,
                                                     add_alpha_local=1),
}
SELECTED = {"zero": ZERO, "local": LOCAL, "other_alpha": OTHER_ALPHA,
            "local_alpha": LOCAL_ALPHA, "detail_factor": DETAIL, "lod_fraction": LOD_FRACTION}
#: Name to what a factor sets; one minus zero is "one".
FACTORS = ({name: {"mselect": m, "reverse": 1} for name, m in SELECTED.items()}
           | {f"one_minus_{name}" if m else "one": {"mselect": m, "reverse": 0}
              for name, m in SELECTED.items()})


def combination(function: str, factor: str = "zero", invert: int = 0) -> Combination:
    """A half of the combine unit."""
    for kind, name, names in (("function", function, FUNCTIONS), ("factor", factor, FACTORS)):
        if name not in names:
            raise UserError(f"combine: {kind} {name!r} is none of {', '.join(names)}")
    return replace(FUNCTIONS[function], **FACTORS[factor], invert=invert)


def combine(modes: Modes, function: str, factor: str = "zero", invert: int = 0) -> Modes:
    """The modes with both halves set alike."""
    half = combination(function, factor, invert)
    return replace(modes, rgb=half, alpha=half)


def lod_factor(odd: int) -> str:
    """The factor by which a unit of even or odd levels blends: its own part falls as the
    pixel's level leaves it."""
    return "one_minus_lod_fraction" if odd else "lod_fraction"


def trilinear_pair(modes: Modes, odd_first: int = 0) -> tuple[Modes, Modes]:
    """Modes of two units that filter trilinearly in one pass, the first nearest the frame
    buffer; ``odd_first``: that one has the odd levels."""
    first = replace(modes, trilinear=1, split=1, odd=odd_first)
    second = replace(modes, trilinear=1, split=1, odd=1 - odd_first)
    return combine(first, "blend", lod_factor(odd_first)), combine(second, "local")


def trilinear_passes(modes: Modes) -> tuple[Modes, Modes]:
    """Modes of the passes by which one unit filters trilinearly: what they draw is to be added.
    The map is split, or whole for both, as ``modes`` say."""
    return tuple(combine(replace(modes, trilinear=1, odd=odd), "blend_local", lod_factor(odd))
                 for odd in (0, 1))
