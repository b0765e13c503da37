"""The limits in the C headers, each against its derivation in tmap.ideal.bounds_perspective."""

from fractions import Fraction
from math import ceil, log2

import pytest

from tmap.base import cubics
from tmap.build import layout
from tmap.ideal import bounds_level, bounds_perspective
from tmap.ideal.bounds import check_set_up
from tmap.ideal.ideal import UNIT
from tmap.model import model
from tmap.setup import cubic, perspective
from tmap.setup.perspective import CURVES, PIECES


@pytest.mark.parametrize("setting", CURVES)
def test_curves_bend_is_rounded_up(setting: str) -> None:
    """The bend is rounded up, so that no piece is longer than its tolerance allows."""
    way = perspective.way(setting)
    assert way.bend == ceil(bounds_perspective.bend(setting, way.piece))


def test_straight_pieces_have_their_names_pixels() -> None:
    """Straight pieces have the pixels of their name and no bend, which is how the C code
    distinguishes them from curves."""
    for setting, pixels in PIECES.items():
        way = perspective.way(setting)
        assert (way.piece, way.bend) == (log2(pixels), 0)


@pytest.mark.parametrize("setting", [*PIECES, *CURVES])
def test_level_lines_keep_the_tolerance(setting: str) -> None:
    """The error of a level line is the one in its bound, and the widest line still fits the
    tolerance."""
    way = perspective.way(setting)
    assert (way.off * UNIT or 2.0**-way.even) == bounds_level.LEVEL[setting]
    assert way.width <= layout.load().constants["FRAME_SIDE_MAX"]
    if setting in CURVES:
        for chained, width in ((False, way.width), (True, way.chain)):
            bound = bounds_level.level_bound(0, setting, max(width - 1, 0), chained)
            assert bound < bounds_perspective.TOLERANCE[setting]
        assert way.off + way.spare + 8 <= bounds_perspective.TOLERANCE[setting] / UNIT


def test_cubics_keep_their_error() -> None:
    """Each fit is as near to 1 / (1 + x) as it says, in exact fractions, and excludes hardly any length
    needlessly; twice what lines are raised by and the cubic's error are the setting's tolerance."""
    constants = layout.load().constants
    for row, (width, *factors) in enumerate(cubics.fits()):
        terms = [Fraction(1)]
        for factor in factors:
            terms.append(terms[-1] * Fraction(-factor, 1 << 31))
        worst = max(abs(sum(term * x**k for k, term in enumerate(terms)) - 1 / (1 + x))
                    for x in (Fraction(width * n, 500 << 32) for n in range(501)))
        allowed = Fraction(constants["CUBIC_ERROR_PIXEL"], 65536 << row + constants["CUBIC_NEAR"])
        assert 0.7 * allowed < worst <= allowed, row
        # a term's cut is not made larger by the terms behind it
        assert all(0 < factor * width < 2 << 63 for factor in factors[1:])
    assert (cubics.ROWS, cubics.NEAR) == (constants["CUBIC_ROWS"], constants["CUBIC_NEAR"])
    for setting, way in cubic.WAYS.items():
        names = [f"CUBIC_{name}_{setting.upper()}" for name in ("ERROR", "RAISE", "LONGEST", "CUTS")]
        assert way == tuple(constants[name] for name in names)
        assert (way[0] + 2 * way[1]) * UNIT == bounds_perspective.TOLERANCE[setting]
        steps = way[2] - 1
        assert way[3] >= ((steps + 1) * steps * (steps - 1) / 6 + steps**2 + 2 * steps) / 256 + 2


@pytest.mark.parametrize("setting", PIECES)
def test_steep_planes_are_not_stepped_beyond_their_format(setting: str) -> None:
    """A sliver's v falls by 470 texels a pixel: the end of its piece, beyond the polygon, would not fit S."""
    corners = [(0, 0, 0, 1065 << 16, 0, 0xf8000), (0x2a8000, 0x18000, 0, 0, 0, 0x174000),
               (0x668000, 0x40000, 0, 0, 0, 0x930000)]
    settings = model.Settings("exact", perspective=setting)
    corners = model.adapt(corners, settings, 256)
    polygon = model.set_up(corners, 160, 100, True, settings, (256, 256))
    verdict = check_set_up(corners, polygon, settings, 160, 100, (256, 256))
    assert verdict.pixels and not verdict.complaint
