"""Mip maps: the level of a polygon is the nearest to a texel a pixel, and its picture that of a material with the
level's map alone."""

import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.engine_scenes import compiled, folder  # noqa: F401
from tests.helpers.guest_runs import Asked
from tests.helpers.property_cases import HEIGHT, WIDTH, any_settings, convex, long_triangle, textured
from tmap.base.errors import UserError
from tmap.base.fixed import ONE
from tmap.images import mipmap
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene, Texture
from tmap.scene_file.textures import MIPMAPPED, ON_PLANE
from tmap.setup.mipmap import level_of
from tmap.setup.shading import LIT

POLYGONS, EACH = 320, 4  # polygons, in each frame
SIZES = ((256, 256), (64, 256), (32, 16))
#: An area is off by half a percent where a triangle is not flat: a way is cut to 11 bits at least.
ROUGH = Fraction(1, 200)


def material_of(rng: random.Random, count: int, light: int) -> Material:
    """A random material that mip maps can have."""
    mapper = rng.choice(MIPMAPPED)
    fixed = {"gradients": "plane", "start": "subtexel"} if mapper in ON_PLANE else {}
    deep = rng.choice(("every16", "every8", "pixel", "fine")) if mapper in ("affine", *LIT) and rng.random() < 0.6 else "none"
    if deep != "none":
        fixed = {"gradients": "plane", "start": "subtexel", "perspective": deep}
    if rng.random() < 0.3:
        fixed["edges"] = "snapped"
    found = any_settings(rng, count, mapper=mapper, **fixed)
    return Material(mapper, found.edges, found.gradients, found.start, found.clip, found.perspective,
                    light=light if mapper in LIT else -1)


def deep(rng: random.Random, vertices) -> list[tuple]:
    """The vertices with random depths, some of them very different, and some hardly."""
    most = rng.choice((1.01, 4, 60, 4000))
    return [(*v[:5], round(ONE * rng.uniform(1, most))) for v in vertices]


def random_scene(seed: int) -> Scene:
    """Random polygons, tiny, huge and clipped ones among them, whose materials have mip maps."""
    rng, noise = random.Random(seed), np.random.default_rng(seed)
    textures, first = [], {}
    for size in SIZES:
        first[size] = len(textures)
        levels = min(size).bit_length() - 4
        textures += [Texture(noise.integers(0, 256, (size[1] >> k, size[0] >> k), np.uint8)) for k in range(levels + 1)]
    light = len(textures)
    textures.append(Texture(noise.integers(0, 256, (64, 256), np.uint8), "light"))
    made, objects, vertices = [], [], []
    for number in range(POLYGONS):
        points = long_triangle(rng, HEIGHT) if rng.random() < 0.1 else convex(rng)
        shrink = rng.choice((1, 1, 4, 40))
        corners = deep(rng, [(x // shrink, y // shrink, *rest) for x, y, *rest in textured(rng, points)])
        size = rng.choice(SIZES)
        levels = rng.randint(1, min(size).bit_length() - 4)
        made.append((replace(material_of(rng, len(corners), light), texture=first[size]), levels))
        objects.append(Object(number, len(vertices), len(corners), number // EACH, 1, number // EACH, 0))
        vertices += corners
    materials, behind = [], []
    for material, levels in made:
        materials.append(replace(material, levels=levels, level=len(made) + len(behind)))
        behind += [replace(material, texture=material.texture + k + 1) for k in range(levels)]
    frames = POLYGONS // EACH
    return Scene(WIDTH, HEIGHT, frames, 3, noise.integers(0, 256, (256, 3), np.uint8), textures, materials + behind,
                 objects, np.array(vertices, np.int64), np.array([IDENTITY] * frames, np.int64))


@pytest.fixture(scope="module")
def scene() -> Scene:
    return random_scene(1)


def levels_of(scene: Scene) -> list[int]:
    """The level of each polygon."""
    found = []
    for obj in scene.objects:
        m = scene.materials[obj.material]
        corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices].tolist()
        found.append(level_of(corners, max(scene.textures[m.texture].texels.shape), m.levels))
    return found


def test_the_guest_draws_the_model(scene) -> None:
    """Random polygons, with and without rules."""
    asked = {f"off {off}": Asked(scene, off) for off in (None, "all")}
    guest_runs.check_all(asked, colours=0)
    found = levels_of(scene)
    assert {0, 1, 2, 3, 4, 5} == set(found) and found.count(0) > 20


def test_a_level_is_a_map_alone(scene) -> None:
    """The picture is that of materials without mip maps that have the levels' maps."""
    chosen = [replace(m, texture=m.texture + level, levels=0, level=0)
              for m, level in zip(scene.materials, levels_of(scene))]
    plain = replace(scene, materials=chosen)
    for number in range(scene.frames):
        if all(scene.materials[obj.material].gradients == "plane" for obj in scene.objects if obj.first_frame == number):
            assert np.array_equal(model.render(scene, number), model.render(plain, number))


def exact_area(corners) -> Fraction:
    """Twice a triangle's area."""
    (ox, oy), (ax, ay), (bx, by) = corners
    return abs(Fraction((ax - ox) * (by - oy) - (bx - ox) * (ay - oy), ONE * ONE))


def test_levels_are_the_nearest() -> None:
    """Of a level that is not the first or the last, a half to two texels are on a pixel."""
    rng, seen = random.Random(2), set()
    for _ in range(2000):
        x, y, far = (rng.uniform(-16000, 16000) for _ in range(3))
        reach, texels = 2 ** rng.uniform(1, 10), 2 ** rng.uniform(0, 13)
        turn = rng.choice((-1, 1))
        corners = [(round(ONE * (x + dx * reach)), round(ONE * (y + dy * reach)), round(ONE * ds * texels),
                    round(ONE * dt * texels)) for dx, dy, ds, dt in ((0, 0, 0, 0), (1, 0.3, 1, 0), (0.2, turn, 0.3, turn))]
        longer = rng.choice((256, 64, 8))
        density = exact_area([c[2:] for c in corners]) / exact_area([c[:2] for c in corners]) * Fraction(longer, 256)**2
        level = level_of(corners, longer, 5)
        seen.add(level)
        assert level == 0 or density / 4**level > Fraction(1, 2) * (1 - ROUGH)
        assert level == 5 or density / 4**level < 2 * (1 + ROUGH)
        assert level == level_of([corners[k] for k in (1, 2, 0)], longer, 5) or any(
            abs(density / 4**k / 2 - 1) < ROUGH for k in range(5))
    assert seen == {0, 1, 2, 3, 4, 5}


@pytest.mark.parametrize("corners, level", [
    ([(0, 0, 0, 0)] * 3, 0), ([(0, 0, 0, 0), (0, 0, ONE, 0), (0, 0, 0, ONE)], 4),
    ([(0, 0, 0, 0), (ONE, 0, 0, 0), (0, ONE, 0, 0)], 0),
    ([(-1 << 30, -1 << 30, 1 << 31, 1 << 31), ((1 << 30) - 1, 0, -1 << 31, 0), (0, (1 << 30) - 1, 0, -1 << 31)], 0),
    ([(0, 0, 0, 0), (8 * ONE, 0, 8 * ONE, 0), (0, 8 * ONE, 0, 16 * ONE)], 0),
    ([(0, 0, 0, 0), (8 * ONE, 0, 8 * ONE, 0), (0, 8 * ONE, 0, 16 * ONE + 1)], 0),
    ([(0, 0, 0, 0), (8 * ONE, 0, 8 * ONE, 0), (0, 8 * ONE, 0, 17 * ONE)], 1)])
def test_ends(corners, level: int) -> None:
    """No area, of pixels or of texels; coordinates as far apart as they can be; twice as many texels as pixels."""
    assert level_of(corners, 256, 4) == level


SCENE = """\
width = 64
height = 48
frames = 1
format = "{pixels}"
background = "#102030"
[textures]
noise = {{ image = "noise.png", width = {width}, height = {height} }}
[materials]
it = {{ texture = "noise", {material} }}
[[objects]]
sides = 3
radius = 20
map_radius = 128
material = "it"
"""


def text(material: str, width: int = 64, height: int = 32, pixels: str = "chunky") -> str:
    """A scene's text."""
    return SCENE.format(material=material, width=width, height=height, pixels=pixels)


def test_levels_are_made(folder) -> None:
    """As many as asked for, of half the sides each; each texel is the palette's nearest to the mean light of the four
    below it. Levels have no light table of their own."""
    made = compiled(folder, text('mipmap = "polygon", mapper = "lit"', 256, 64))
    base, *levels = made.materials
    assert base.levels == len(levels) == 3 and base.level == 1
    shapes = [made.textures[each.texture].texels.shape for each in made.materials]
    assert shapes == [(64, 256), (32, 128), (16, 64), (8, 32)]
    assert all(replace(each, texture=base.texture) == replace(base, levels=0, level=0) for each in levels)
    one = compiled(folder, text('mipmap = "polygon", levels = 1'))
    assert one.materials[0].levels == 1 and len(one.textures) == 2


@pytest.mark.parametrize("pixels", ["rgb565", "rgba8888"])
def test_hicolor(folder, pixels: str) -> None:
    """Maps of wider texels have levels too, and the guest draws them."""
    shrunk = text('mipmap = "polygon"', pixels=pixels).replace("128\n", "8000\n")
    made = compiled(folder, shrunk)
    assert levels_of(made) == [2]
    guest_runs.check_all({pixels: Asked(made)}, colours=4)


def test_averages_of_light() -> None:
    """Black and white make the grey of half their light; alpha is averaged as it is."""
    checks = np.zeros((2, 2, 4), np.uint8)
    checks[0, 0] = checks[1, 1] = 255
    level, = mipmap.levels(checks, 1)
    assert level.tolist() == [[[188, 188, 188, 128]]]


@pytest.mark.parametrize("material, said", [
    ('mapper = "columns", mipmap = "polygon"', 'mipmap: "columns" has none; "affine", "lit", "lit_gouraud", "dithered" have'),
    ('mapper = "keyed", mipmap = "polygon"', 'mipmap: "keyed" has none'),
    ('mipmap = "polygon", levels = 3', "levels: texture 'noise' is 64x32: 2 at most"),
    ("levels = 2", "levels: there is no mip map"), ('mipmap = "cube"', "mipmap: 'cube'"),
    ('mipmap = "polygon", levels = 6', "levels: must be from 1 to 5")])
def test_what_is_refused(folder, material: str, said: str) -> None:
    """One line names the material's field."""
    with pytest.raises(UserError) as error:
        compiled(folder, text(material))
    assert said in str(error.value) and "materials.it" in str(error.value) and "\n" not in str(error.value)


def test_a_map_may_be_too_small(folder) -> None:
    """No level has a side of less than 8 texels."""
    with pytest.raises(UserError) as error:
        compiled(folder, text('mipmap = "polygon"', 64, 8))
    assert "64x8; the least side of a level is 8" in str(error.value)


def test_what_has_none_pays_nothing(folder) -> None:
    """A scene without mip maps is drawn by polygon_draw, and has no more maps."""
    made = compiled(folder, text('edges = "exact"'))
    assert [m.levels for m in made.materials] == [0] and len(made.textures) == 1
