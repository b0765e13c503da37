"""Polygons of Glide's texture units that are added to the frame: trilinear filtering by two passes
of one unit equals that by one pass of two; paths that replace pixels are not used."""

from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.engine_scenes import compiled, folder, scene_text  # noqa: F401
from tmap.glide.words import FIELDS, LEVELS
from tmap.model import model
from tmap.scene_file.scene_file import Scene

PIXELS = ("rgb565", "rgba8888")
#: Shows all levels of a map of 32x32 texels; texels of the first one are larger than pixels.
FLOOR = ("vertices = [[0, 0, 0, 0, 1], [64, 0, 128, 0, 1], [64, 48, 900, 1800, 9], "
         "[0, 48, 0, 1800, 20]]")
BOTH = 'image = "noise.png", format = "argb4444", min = "bilinear", mag = "bilinear"'
SUM = 2  # units of a channel by which two passes may be darker


def unit(levels: str, whole: bool, combine: str = "") -> str:
    """A unit for the even or the odd levels; ``whole``: its map has all levels, see
    ``blend_whole``."""
    kept = "" if whole else f', levels = "{levels}", trilinear = true'
    return f"{{ {BOTH}{kept}{combine} }}"


def by(function: str, factor: str) -> str:
    return f', combine = {{ function = "{function}", factor = "{factor}" }}'


def glide(more: str, *units: str) -> str:
    return f"glide = {{ perspective = true, {more}units = [{', '.join(units)}] }}"


def blend_whole(scene: Scene, parities: tuple[str, ...]) -> Scene:
    """Sets the registers of units with whole maps as Glide's tex-lod-blend call does: each draws
    only the even or the odd levels."""
    glide_units = scene.glide_units.copy()
    for row, parity in zip(glide_units, parities):
        for field, bit in (("trilinear", 1), ("odd", *LEVELS[parity])):
            register, shift, _ = FIELDS[field]
            row[register] |= int(bit) << shift
    return replace(scene, glide_units=glide_units)


def trilinear(folder, whole: bool, passes: int, pixels: str = "rgba8888") -> Scene:
    """A floor by one pass of two units, or two passes of one."""
    if passes == 1:
        text = scene_text(glide("", unit("even", whole, by("blend", "lod_fraction")),
                                unit("odd", whole)), FLOOR, pixels)
    else:
        text = scene_text(glide("", unit("even", whole, by("blend_local", "lod_fraction"))), FLOOR,
                          pixels)
        second = glide('blend = "add", ', unit("odd", whole, by("blend_local",
                                                                "one_minus_lod_fraction")))
        text = text.replace("[[objects]]", f"second = {{ {second} }}\n[[objects]]")
        text += f'[[objects]]\nmaterial = "second"\n{FLOOR}\n'
    scene = compiled(folder, text)
    return blend_whole(scene, ("even", "odd")) if whole else scene


@pytest.mark.parametrize("whole", [False, True])
def test_two_passes_are_one(folder, whole):
    """With an even level's colour e, an odd one's o and the odd one's weight a / 256, a = 1 to 256,
    one pass gives floor((e (256 - a) + o a) / 256). Of two passes the first draws e - ceil(e a /
    256) = floor(e (256 - a) / 256), and the second adds o - ceil(o (257 - a) / 256) = floor(o (a -
    1) / 256), as its factor is the inverse of the first one's. Both floors lose less than 1, and o
    / 256 is less than 1: the sum is not above the one pass, and less than 3 below it. So 255 is
    never exceeded."""
    one, two = (trilinear(folder, whole, passes) for passes in (1, 2))
    colours = [scene.pixel.colours(model.render(scene, 0)).astype(int) for scene in (one, two)]
    darker = colours[0] - colours[1]
    y, x, channel = np.unravel_index(np.argmax(np.abs(darker)), darker.shape)
    assert darker.min() >= 0 and darker.max() <= SUM, (
        f"pixel ({x}, {y}), channel {channel}: {colours[1][y, x, channel]} by two passes, "
        f"{colours[0][y, x, channel]} by one")
    assert darker.max() == SUM and len(np.unique(colours[1].reshape(-1, 4), axis=0)) > 500
    for first in (0, 1):
        alone = replace(two, objects=two.objects[first:first + 1])
        part = alone.pixel.colours(model.render(alone, 0)).astype(int)
        assert (np.abs(part - colours[1]).max(-1) > 16).mean() > 0.3, f"pass {first + 1} alone"


def test_nothing_is_replaced(folder):
    """Polygons that pages, dithered points or tiles would draw if they were not added are drawn by
    passes; each is drawn twice, overlapping; in one boot."""
    square = "vertices = [[0, 0, 0, 0], [32, 0, 128, 0], [32, 32, 128, 128], [0, 32, 0, 128]]"
    plain = 'image = "noise.png", format = "rgb565", mipmap = "none"'
    filtered = plain + ', min = "bilinear", mag = "bilinear"'
    asked = {}
    for pixels in PIXELS:
        for texels in (plain, filtered, filtered + ', bilinear = "dithered"'):
            text = scene_text(f'glide = {{ blend = "add", units = [{{ {texels} }}] }}', square, pixels)
            text += f'[[objects]]\nmaterial = "it"\n{square.replace("32", "47")}\n'
            asked[f"{texels}, {pixels}"] = Asked(compiled(folder, text))
    for name, drawn in guest_runs.check_all(asked).items():
        assert "glide_passes" in drawn.rules, (name, drawn.rules)
        assert not drawn.rules & {"glide_plain", "glide_tiles"}, (name, drawn.rules)
        assert drawn.spans == {"glide_passes"}, (name, drawn.figures)
