"""Dithered points: how far they are moved, that the pattern is fixed to the frame, and how much it
gains."""

import numpy as np
import pytest

from tmap.accuracy import dither_errors
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.setup.dithered import EIGHTH, MOST, MOVES

SETTINGS = model.Settings(edges="exact", mapper="dithered")
SIZE = 64


def square(first: tuple[int, int], last: tuple[int, int], moved: tuple[int, int] = (0, 0)):
    """x, y, u and v of a square with a turned map, moved on the screen with it."""
    (left, top), (right, bottom) = first, last
    return [(x + moved[0] << 16, y + moved[1] << 16, 40000 * x + 9000 * y, 38000 * y - 9000 * x)
            for x, y in ((left, top), (right, top), (right, bottom), (left, bottom))]


SQUARE = square((-5, -9), (70, 81))  # larger than the frame on all sides


def drawn(*polygons, width: int = SIZE, height: int = SIZE) -> np.ndarray:
    """A frame with polygons of a map of noise."""
    frame = np.zeros((height, width), np.uint8)
    texels = np.random.default_rng(3).integers(1, 256, (256, 256), dtype=np.uint8)
    for vertices in polygons:
        made = model.set_up(vertices, width, height, True, SETTINGS, (256, 256))
        model.draw(frame, made, texels, 0)
    return frame


def test_moves_part_a_texel_evenly() -> None:
    """Along each axis the four offsets of any 2x2 pixels are in the middles of the texel's
    quarters, with one in each quarter of its square; so their mean is zero."""
    for k in (0, 1):
        assert sorted(MOVES[..., k].ravel()) == [-3, -1, 1, 3]
    assert {(u > 0, v > 0) for u, v in MOVES.reshape(-1, 2).tolist()} == {
        (a, b) for a in (False, True) for b in (False, True)}
    assert abs(MOVES).max() * EIGHTH == MOST * 65536


def test_the_pattern_is_the_frames() -> None:
    """Two triangles show the same as their square; a frame that cuts more off shows the same
    pixels, and so does a square that is moved by an even number of them. (Where a frame cuts the left
    side off, values are raised by half a unit more a pixel: a texel within a unit of its border may differ.)"""
    whole = drawn(SQUARE)
    assert np.array_equal(drawn(SQUARE[:3], [SQUARE[0], *SQUARE[2:]]), whole)
    assert np.array_equal(drawn(SQUARE, width=40, height=33), whole[:33, :40])
    inside = (3, 5), (60, 61)
    assert np.array_equal(drawn(square(*inside, (-2, -4)))[:-4, :-2], drawn(square(*inside))[4:, 2:])


@pytest.mark.parametrize("kind", dither_errors.maps())
def test_means_gain_where_texels_are_large(kind: str) -> None:
    """The README's claim: means of 2x2 dithered pixels are nearer to the filter's than means of
    points if texels are 4 pixels long or more, but not if they are 2; single pixels never are."""
    for scale in dither_errors.SCALES:
        found = dither_errors.errors(dither_errors.maps()[kind], scale)
        (points, of_points), (dithered, of_dithered) = found["points"], found["dithered"]
        assert points < dithered, (kind, scale)
        assert (of_dithered < of_points) == (scale >= 4), (kind, scale)


def test_a_unit_draws_what_the_mapper_does() -> None:
    """The scene has the picture by the plain mapper and, 128 lines below, by Glide's unit. Each
    rounds the picture's colours to 5 and 6 bits in its own way: they differ by a step of 8 at
    most."""
    scene = compile_scene(SCENES / "dithered.toml", 1)
    frame = scene.pixel.colours(model.render(scene, 0)).astype(int)
    mapper, unit = frame[:128, 160:], frame[128:, 160:]
    assert abs(mapper - unit).max() <= 8
    assert abs(mapper - frame[:128, :160]).max() > 100
