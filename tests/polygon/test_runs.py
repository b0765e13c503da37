"""Runs: objects of one material that follow one another are drawn together, with the picture of each by itself."""

import random
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import guest_program
from tmap.base.fixed import fix
from tmap.base.paths import GUEST
from tmap.base.pixel_formats import FORMATS
from tmap.corpus import random_maps
from tmap.guest import emulator, guest_frames
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import IDENTITY, ONE, Material, Object, Scene, Texture, write
from tmap.setup import snapped
from tmap.setup.texturing import Settings

MACHINE = "a1200-fast"
FRAMES, OBJECTS = 4, 90  # of each scene
SIZES = {"chunky": (160, 128), "tall": (96, 300), "rgb565": (160, 128), "rgba8888": (64, 96)}
POSES = [IDENTITY, (ONE, 0, 0, ONE, 3 * ONE // 2, -ONE // 3), (0, ONE, -ONE, 0, 0, 90 * ONE)]


def textures(pixels: str) -> list[Texture]:
    """A page; in chunky frames 64 levels of light, of which the first is one colour and the last all, and
    a map that does not repeat."""
    rng = np.random.default_rng(11)
    if FORMATS[pixels].bytes > 1:
        pixel = FORMATS[pixels]
        return [Texture(rng.integers(1, 256**pixel.bytes, (256, 256), dtype=pixel.dtype))]
    page, light = (rng.integers(1, 256, (h, 256), dtype=np.uint8) for h in (256, 64))
    light[0], light[63] = 9, np.arange(256)
    return [Texture(page), Texture(light, "light"), Texture(page.copy(), "linear")]


def materials(pixels: str) -> list[Material]:
    """Materials of every kind that has runs, and some without."""
    if pixels not in ("chunky", "tall"):
        return [Material("affine", "snapped", texture=0), Material("flat", "snapped", colour=77),
                Material("affine", "exact", texture=0)]
    return [Material("affine", "snapped", texture=0), Material("flat", "snapped", colour=77),
            Material("gouraud", "snapped"), Material("lit", "snapped", texture=0, light=1),
            Material("lit_gouraud", "snapped", texture=0, light=1), Material("arbitrary", "snapped", texture=2),
            Material("affine", "exact", texture=0), Material("affine", "snapped", "polygon", texture=0)]


def polygon(rng: random.Random, width: int, height: int, is_triangle: bool, inside: bool) -> list[tuple]:
    """A convex polygon: most inside the frame; level edges, values that are alike, and steps of whole
    texels are frequent. ``inside``: its texels are inside the map."""
    reach = rng.choice((3, 12, 12, 40, 200))
    x, y = (rng.uniform(min(reach, side / 2), max(side - reach, side / 2)) for side in (width, height))
    if rng.random() < 0.06:
        x += rng.choice((-2, 2)) * width
    count = 3 if is_triangle else rng.choice((3, 3, 3, 4, 4, 5))
    ends = sorted(rng.uniform(0, 6.28) for _ in range(count))
    points = [(x + reach * np.cos(angle), y + reach * np.sin(angle)) for angle in ends]
    if rng.random() < 0.3:
        points = [(x, y), (x + reach, y), (x + reach, y + reach / 2), (x, y + reach / 2)][:min(count, 4)]
    across, down, s, t = (rng.choice((0, 1, rng.uniform(-2, 2))) for _ in range(4))
    low = rng.choice((0, 3, 100, 253))
    most = 256 if inside else 450
    made = []
    for px, py in points:
        texels = (across * (px - x) + down * (py - y) + 128, s * (px - x) + t * (py - y) + 128)
        shade = low + rng.choice((0.0, 0.4)) if low != 100 else rng.uniform(0, 255)
        made.append((fix(px), fix(py), *(fix(min(max(c, 0.1), most - 0.1)) for c in texels), fix(shade), ONE))
    return made


def scene_of(name: str, seed: int, used: list[Material] | None = None) -> Scene:
    """Random objects over one another, in runs of every length."""
    pixels, rng = "chunky" if name == "tall" else name, random.Random(f"{name} {seed}")
    width, height = SIZES[name]
    used = used or materials(name)
    objects, vertices = [], []
    for frame in range(FRAMES):
        left = 0
        for _ in range(OBJECTS):
            if not left:
                number, left = rng.randrange(len(used)), rng.choice((1, 2, 5, 40, 60))
            left -= 1
            at = len(vertices)
            vertices += polygon(rng, width, height, used[number].gradients == "polygon",
                                used[number].mapper == "arbitrary")
            objects.append(Object(number, at, len(vertices) - at, rng.choice((0, 0, 1, 2)), 1, frame,
                                  rng.choice((0, 15))))
    return Scene(width, height, FRAMES, 7, random_maps.palette(), textures(pixels), used, objects,
                 np.array(vertices), np.array(POSES), format=pixels)


def apart(scene: Scene) -> Scene:
    """The same, no two neighbours with a material of the same number: no runs."""
    count = len(scene.materials)
    objects = [replace(o, material=o.material + count * (k & 1)) for k, o in enumerate(scene.objects)]
    return replace(scene, materials=scene.materials * 2, objects=objects)


@pytest.mark.parametrize("name", SIZES)
def test_a_run_has_the_picture_of_its_polygons(name: str):
    """Runs and single polygons, rules on and off: all frames are the model's."""
    scenes = [scene_of(name, seed) for seed in range(2)] + [
        scene_of(name, 5, [material]) for material in materials(name)[:1]]
    ways = [(made, way) for scene in scenes for made in (scene, apart(scene)) for way in ("addx", "addx OFF all")]
    digests = iter(guest_frames.draw(ways, MACHINE, timed=False))
    for scene in scenes:
        frames = [model.render(scene, number) for number in range(FRAMES)]
        for made in (scene, apart(scene)):
            for way in ("addx", "addx OFF all"):
                what = f"{name}, {'runs' if made is scene else 'apart'}, {way}"
                guest_frames.require_models(frames, next(digests), what, (made, way, MACHINE))


def test_counts_are_those_of_single_polygons():
    scene = scene_of("chunky", 3)
    files = {"runs.scene": write(scene), "apart.scene": write(apart(scene))}
    with emulator.workspace() as directory:
        done = emulator.run_batch([f"render {name} COUNT" for name in files], files, MACHINE, directory, timed=False)
    runs, single = (run.parse_output(each.output, FRAMES, len(made.materials))[0]
                    for each, made in zip(done, (scene, apart(scene))))
    for one, other in zip(runs, single, strict=True):
        assert one["spans"] == other["spans"] and one["polygons"] == other["polygons"]
        assert len(one["spans"]) > 5


@pytest.mark.parametrize("middle", ["handed on", "odd", "in range"])
def test_a_run_keeps_its_order(middle: str):
    """Three triangles over one another; the second is drawn as the others are, by another kind of span,
    or with a set-up of its own."""
    shades = {"odd": (90, 90, 90)}.get(middle, (60, 90, 120))
    second = [(-3, 20), (90, 5), (80, 60)] if middle == "handed on" else [(3, 20), (90, 5), (80, 60)]
    three = [([(10, 5), (60, 10), (30, 60)], (10, 30, 50)), (second, shades),
             ([(20, 8), (70, 30), (5, 50)], (140, 180, 220))]

    def made(order) -> Scene:
        vertices = [(fix(x), fix(y), 0, 0, fix(shade), ONE) for k in order
                    for (x, y), shade in zip(*three[k])]
        objects = [Object(0, 3 * k, 3, 0, 1, 0) for k in range(3)]
        return Scene(96, 64, 1, 7, random_maps.palette(), [], [Material("gouraud", "snapped")], objects,
                     np.array(vertices), np.array([IDENTITY]))

    orders = [(0, 1, 2), (1, 0, 2), (0, 2, 1), (2, 1, 0)]
    assert snapped.may_draw([(fix(x), fix(y)) for x, y in second], Settings("snapped", mapper="gouraud"),
                            96, 64) == (middle != "handed on")
    frames = [model.render(made(order), 0) for order in orders]
    digests = guest_frames.draw([(made(order), "addx") for order in orders], MACHINE, timed=False)
    assert len({frame.tobytes() for frame in frames}) == len(orders)
    for order, frame, digest in zip(orders, frames, digests):
        guest_frames.require_models([frame], digest, f"{middle}, {order}", (made(order), "addx", MACHINE))


def test_frames_upside_down_show_the_same(tmp_path) -> None:
    """A run of exact triangles goes up a frame whose pitch is negative."""
    guest_program.build(tmp_path, GUEST / "upside.c")
    result, = emulator.run_batch(["upside"], {}, MACHINE, tmp_path / "run", programs=tmp_path, timed=False)
    drawn, wrong = result.output.split(" drawn, wrong ")
    assert int(drawn) > 1000 and int(wrong) == 0, result.output
