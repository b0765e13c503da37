"""The limits in the C headers, each against its derivation in tmap.ideal.bounds_perspective."""

from math import ceil, log2

import numpy as np
import pytest

from tmap.base.fixed import M32, swap
from tmap.build import layout
from tmap.ideal import bounds_level, bounds_perspective
from tmap.ideal.bounds import check_set_up
from tmap.ideal.ideal import UNIT
from tmap.model import model
from tmap.setup import logarithm, perspective
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
    assert way.off * UNIT == bounds_level.LEVEL.get(setting, 0)
    assert way.width <= layout.load().constants["FRAME_SIDE_MAX"]
    if setting in CURVES:
        for chained, width in ((False, way.width), (True, way.chain)):
            bound = bounds_level.level_bound(0, setting, max(width - 1, 0), chained)
            assert bound < bounds_perspective.TOLERANCE[setting]


def test_lines_by_logarithms_keep_to_a_texel_in_32() -> None:
    """The limit holds at the worst index of each bucket, and excludes hardly any line
    needlessly."""
    for bucket, power in enumerate(logarithm.LIMITS):
        high = 1024 * (bucket - 23) - 1
        smallest = int(np.searchsorted(-logarithm.logs(), -high)) + logarithm.LOWEST
        q = swap((smallest - logarithm.ORIGIN << 16) & M32)
        line = logarithm.Logarithmic(0, 0, q, 0, (0, 0), (power - high,) * 2, 0)
        bound = logarithm.bound(line)
        assert bound <= bounds_perspective.TOLERANCE["pixel"] / UNIT, bucket
        assert bound > 0.98 * bounds_perspective.TOLERANCE["pixel"] / UNIT or power == logarithm.POWERS - 4


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


def test_k_takes_most_of_what_a_logarithm_was_rounded_by() -> None:
    """Far from K, C's logarithm is half a unit off: a quarter of K's move was not enough."""
    corners = [(7012352, -8192000, 8158985, 6421967, 0, 190741), (458752, -7274496, 1967522, 3064356, 0, 144700),
               (5046272, 7602176, 9281033, 14032907, 0, 172775)]
    settings = model.Settings("integer", perspective="pixel")
    corners = model.adapt(corners, settings, 256)
    polygon = model.set_up(corners, 96, 72, True, settings, (256, 256))
    verdict = check_set_up(corners, polygon, settings, 96, 72, (256, 256))
    assert verdict.pixels > 2000 and not verdict.complaint
