"""The texture unit's combine unit and chains: Glide's functions, detail, trilinear filtering."""


import numpy as np
import pytest

from tests.helpers.arrays import check_equal, check_within
from tmap.base.errors import UserError
from tmap.glide.combine import combined
from tmap.glide.functions import FACTORS, FUNCTIONS, combination, combine, trilinear_pair
from tmap.glide.state import Modes, packed, unpacked


#: Definitions of Glide's functions, with arguments: multiplication by the factor, other, local,
#: local alpha.
MEANT = {
    "zero": lambda f, o, c, a: 0 * c,
    "local": lambda f, o, c, a: c,
    "local_alpha": lambda f, o, c, a: a + 0 * c,
    "scale_other": lambda f, o, c, a: f(o),
    "scale_other_add_local": lambda f, o, c, a: f(o) + c,
    "scale_other_add_local_alpha": lambda f, o, c, a: f(o) + a,
    "scale_other_minus_local": lambda f, o, c, a: f(o - c),
    "blend": lambda f, o, c, a: f(o - c) + c,
    "blend_add_local_alpha": lambda f, o, c, a: f(o - c) + a,
    "blend_local": lambda f, o, c, a: f(-c) + c,
    "blend_local_add_local_alpha": lambda f, o, c, a: f(-c) + a,
}


@pytest.mark.parametrize("factor", FACTORS)
@pytest.mark.parametrize("function", FUNCTIONS)
def test_combine_functions(function, factor):
    """The functions do what Glide's names say, for random colours and the extremes."""
    random = np.random.default_rng(5)
    local, other = random.integers(0, 256, (2, 500, 4))
    local[:4], other[:4] = [[0], [255], [0], [255]], [[0], [0], [255], [255]]
    lod = random.integers(0, 0x801, 500)
    modes = Modes(detail_bias=5, detail_scale=3, detail_max=190)
    own = {"local": local, "other_alpha": other[:, 3:], "local_alpha": local[:, 3:],
           "lod_fraction": lod[:, None] % 256, "zero": 0,
           "detail": np.clip((1280 - lod) * 8 // 256, 0, 190)[:, None]}
    m = own[factor.removeprefix("one_minus_")] if factor != "one" else 255
    if factor.startswith("one_minus_"):
        m = 255 - m
    meant = MEANT[function](lambda x: x * (m + 1) // 256, other, local, local[:, 3:])
    want = np.clip(meant, 0, 255)
    for invert in (0, 1):
        found = combined(combine(modes, function, factor, invert), lod, local, other)
        check_equal(found, 255 - want if invert else want, f"inverted {invert}: case, channel")


def test_colour_and_alpha_are_combined_each_by_its_own():
    """Colour and alpha have separate functions; unknown names are refused."""
    modes = Modes(rgb=combination("local"), alpha=combination("scale_other", "one"))
    colour = combined(modes, np.array(0), unpacked(0x11223344), unpacked(0xAABBCCDD))
    assert packed(colour) == 0xAA223344
    with pytest.raises(UserError, match="function 'mix' is none"):
        combination("mix")
    with pytest.raises(UserError, match="factor 'two' is none"):
        combination("local", "two")


def weight_odd(lod: np.ndarray) -> np.ndarray:
    """The odd level's weight at a level of detail."""
    return np.where(lod >> 8 & 1, 255 - (lod & 255), lod & 255)[..., None]


def test_trilinear_blends():
    """For all fractions of levels one pass is even + ((odd - even) (w + 1) >> 8) if the first unit
    has the even levels. If it has the odd ones, odd has the weight w instead of w + 1: the values
    are less than 1 apart, so 1 after rounding down. Two passes: test_adds.py."""
    even, odd = (c[..., None] * np.ones(4, np.int64)
                 for c in np.meshgrid(np.arange(0, 256, 5), np.arange(0, 256, 5)))
    for n in (0, 1):
        for fraction in range(256):
            lod = np.full(even.shape[:2], n << 8 | fraction)
            what = f"level {n}, {fraction} / 256: 1/5 of odd, of even, channel"
            want = even + ((odd - even) * (weight_odd(lod) + 1) >> 8)
            first, _ = trilinear_pair(Modes())
            check_equal(combined(first, lod, even, odd), want, what)
            first, _ = trilinear_pair(Modes(), 1)
            check_within(combined(first, lod, odd, even), want, 1, f"odd first, {what}")
