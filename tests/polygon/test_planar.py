"""Polygons of more than three vertices: if their values are on planes except for rounding they stay
in one piece, otherwise they are drawn as triangles, both in scene files and by polygon_draw."""

import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.property_cases import HEIGHT, WIDTH, convex, uneven_case
from tests.helpers.engine_scenes import compiled, folder  # noqa: F401
from tmap.base.fixed import ONE, fix, mul
from tmap.guest import guest_frames
from tmap.ideal import planarity
from tmap.model import model
from tmap.model.model import Settings
from tmap.scene_file.scene_file import (IDENTITY, Material, Object, Scene, Texture, vertices_at,
                                        write)
from tmap.setup import clip, planarity as model_planar

HEAD = """\
width = 64
height = 48
frames = 2
format = "{format}"
background = "#102030"
[textures]
noise = {{ image = "noise.png", width = 256, height = 256 }}
odd = {{ image = "noise.png", width = 96, height = 64 }}
[materials]
"""
NOISE = 'image = "noise.png", format = "rgb565"'
#: The material's fields and four corners that are on no plane; below, the frame's format.
SCENES = {
    "affine": ('texture = "noise", edges = "exact"', "[[4, 4, 0, 0], [60, 6, 255, 0], [56, 44, 255, 255], [6, 40, 90, 160]]"),
    "integer": ('texture = "noise", edges = "integer"',
                "[[4, 4, 0, 0], [60, 6, 255, 0], [56, 44, 255, 255], [6, 40, 90, 160]]"),
    "arbitrary": ('texture = "odd", mapper = "arbitrary"',
                  "[[4, 4, 0, 0], [60, 6, 255, 0], [56, 44, 200, 170], [6, 40, 90, 20]]"),
    "tiled": ('texture = "noise", mapper = "tiled"',
              "[[4, 4, 0, 0], [60, 6, 255, 0], [56, 44, 255, 255], [6, 40, 90, 160]]"),
    "gouraud": ('shades = ["#000000", "#ffff00"], edges = "exact"',
                "[[4, 4, 0], [60, 6, 255], [56, 44, 10], [6, 40, 200]]"),
    "lit_gouraud": ('texture = "noise", mapper = "lit_gouraud", edges = "exact"',
                    "[[4, 4, 0, 0, 0], [60, 6, 200, 0, 255], [56, 44, 200, 136, 10], [6, 40, 0, 128, 250]]"),
    "perspective": ('texture = "noise", perspective = "every8"',
                    "[[4, 4, 0, 0, 1], [60, 6, 255, 0, 2], [56, 44, 255, 255, 2], [6, 40, 0, 255, 2]]"),
    "n64": ('n64 = { tiles = [{ image = "noise.png", format = "rgba16" }] }',
             "[[4, 4, 0, 0], [60, 6, 32, 0], [56, 44, 32, 32], [6, 40, 20, 12]]"),
    "colours": ('n64 = { combine = "modulate", tiles = [{ image = "noise.png", format = "rgba16" }] }',
                "[[4, 4, 0, 0], [60, 4, 32, 0], [60, 44, 32, 32], [4, 44, 0, 32]]\n"
                'colours = ["#ffffff", "#ff0000", "#00ff00", "#0000ff"]'),
    "glide": (f"glide = {{ units = [{{ {NOISE} }}] }}",
              "[[4, 4, 0, 0], [60, 6, 255, 0], [56, 44, 255, 255], [6, 40, 90, 160]]"),
    "glide_divided": (f"glide = {{ perspective = true, units = [{{ {NOISE}, min = 'bilinear' }}] }}",
                      "[[4, 4, 0, 0, 1], [60, 6, 255, 0, 2], [56, 44, 255, 255, 2], [6, 40, 0, 255, 2]]"),
    "glide_own": (f"glide = {{ units = [{{ {NOISE}, combine = {{ function = 'scale_other', "
                  f"factor = 'local' }} }}, {{ {NOISE}, own = true }}] }}",
                  "[[4, 4, 0, 0], [60, 4, 255, 0], [60, 44, 255, 255], [4, 44, 0, 255]]\n"
                  "st1 = [[0, 0], [64, 0], [64, 64], [40, 0]]"),
}
FORMATS = {"n64": "rgba8888", "colours": "rgba8888", "glide": "rgb565", "glide_divided": "rgb565",
           "glide_own": "rgba8888"}


def made(folder, name: str) -> Scene:
    """The compiled scene of one of SCENES, with two frames: unturned and turned."""
    material, vertices = SCENES[name]
    head = HEAD.format(format=FORMATS.get(name, "chunky"))
    if name in FORMATS:
        head = head.replace(head[head.index("[textures]"):head.index("[materials]")], "")
    return compiled(folder, head + f'it = {{ {material} }}\n[[objects]]\nmaterial = "it"\n'
                    f"vertices = {vertices}\ncentre = [0, 0]\nturns = 0.02\n")


def cut(scene: Scene) -> Scene:
    """The same scene with its polygons as triangles."""
    objects, vertices = [], []
    for obj in scene.objects:
        corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices].tolist()
        halves = [corners]
        if scene.pipes.size and scene.pipes[0][2]:
            halves = [corners[:len(corners) // 2], corners[len(corners) // 2:]]
        for parts in zip(*map(model_planar.fan, halves)):
            part = sum(parts, [])
            objects.append(replace(obj, vertex=len(vertices), vertices=len(part), planar=model_planar.ALL))
            vertices += part
    return replace(scene, objects=objects, vertices=np.array(vertices))


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_is_drawn_as_its_triangles(folder, name: str) -> None:
    """The file does not mark its polygon as planar. The model draws the triangles that one would
    write by hand, not the plane through three of its corners."""
    scene = made(folder, name)
    assert [obj.planar for obj in scene.objects] != [model_planar.ALL]
    write(scene)
    vouched = replace(scene, objects=[replace(obj, planar=model_planar.ALL) for obj in scene.objects])
    for number in (0, 1):
        found = model.render(scene, number)
        assert np.array_equal(found, model.render(cut(scene), number))
        assert (found != model.render(vouched, number)).sum() > 100


def test_the_guest_draws_scenes_as_the_model(folder) -> None:
    """The guest draws the model's frames with and without rules of lowering, with the planar flags
    of the file and with the test left to the set-up. `make run` counts what is drawn: two polygons
    for a quad that is not planar, each pixel once."""
    scenes = {name: made(folder, name) for name in SCENES}
    unmarked = [replace(scene, objects=[replace(obj, planar=0) for obj in scene.objects])
                for scene in scenes.values()]
    asked = [Asked(scene, off, counted=scene is scenes["affine"] and not off)
             for off in (None, "all") for scene in [*scenes.values(), *unmarked]]
    drawn = guest_runs.draw(asked)
    for name, each, found in zip([*SCENES] * 4, asked, drawn, strict=True):
        assert not found.digests["result"].any(), name
        guest_runs.check(name, each, found)
    found, scene = drawn[list(SCENES).index("affine")], scenes["affine"]
    polygons = [model.prepare_polygon(scene, 0, part)
                for number in (0, 1) for part in model.parts(vertices_at(
                    scene, scene.objects[0], number), scene.materials[0], (scene.width, scene.height), 256)]
    assert [frame["polygons"] for frame in found.figures] == [2, 2]
    assert sum(frame["pixels"] for frame in found.figures) == sum(p.pixels for p in polygons)
    assert found.executed[0]["polygons"] == 4


def exact(rng: random.Random):
    """Returns a random plane as a function of x and y, with values in exact fractions of units."""
    steps = [Fraction(rng.choice((0, 1, -1, rng.uniform(-4, 4), rng.uniform(-40, 40)))) for _ in range(2)]
    base = Fraction(rng.uniform(-300, 300)) * ONE
    return lambda x, y: base + steps[0] * x + steps[1] * y


def written(rng: random.Random) -> tuple[list[tuple], list]:
    """A polygon's exact corners and planes for s, t and shade; no thinner than fan.c allows."""
    while True:
        points = convex(rng, 4)
        _, area = model_planar.corners_of(points)
        if abs(area) > 256 * max(abs(p[k] - q[k]) for p in points for q in points for k in (0, 1)):
            turned = [tuple(Fraction(c) + Fraction(rng.uniform(0, 1)) for c in p) for p in points]
            return turned, [exact(rng) for _ in range(3)]


def rounded(points, planes) -> list[tuple]:
    """Vertices as a person would write them: each number rounded to the nearest 16.16."""
    return [(round(x), round(y), *(round(plane(x, y)) for plane in planes), ONE) for x, y in points]


PLANES = Settings(mapper="lit_gouraud")


@pytest.mark.parametrize("edges", ["integer", "subpixel", "exact"])
def test_what_is_planar_stays_in_one_piece(edges: str) -> None:
    """As written and rounded; turned and enlarged, with two products each, rounded down; clipped to
    the frame."""
    rng, settings = random.Random(f"planar {edges}"), replace(PLANES, edges=edges)
    for number in range(400):
        points, planes = written(rng)
        vertices = rounded(points, planes)
        assert model.parts(vertices, settings, (WIDTH, HEIGHT), 256) == [vertices], number
        cos, sin = fix(rng.uniform(-1, 1)), fix(rng.uniform(-1, 1))
        if abs(cos) + abs(sin) > ONE // 2:  # else the rounding grows
            turned = [(mul(cos, x) - mul(sin, y), mul(sin, x) + mul(cos, y), *rest)
                      for x, y, *rest in vertices]
            assert model.parts(turned, settings, (WIDTH, HEIGHT), 256) == [turned], number
        left = clip.clip(vertices, clip.frame_window(WIDTH, HEIGHT))
        if len(left) > 3:
            assert model.parts(left, settings, (WIDTH, HEIGHT), 256) == [left], number


def test_polygon_draw_is_the_model() -> None:
    """Any mapper, edges, gradients and perspective, no planar flag: the guest draws the model's
    pixels, in each form and without rules."""
    cases = [uneven_case(random.Random(f"guest {k}"), f"number {k}") for k in range(300)]
    layouts = {"arbitrary": "linear", "generated": "margins"}
    layouts |= {name: name for name in ("tiled", "columns")}
    names = ["page", "linear", "tiled", "columns", "margins", "light"]
    noise = np.random.default_rng(3)
    maps = [Texture(noise.integers(0, 256, (64 if name == "light" else 256, 256), dtype=np.uint8), name)
            for name in names]
    materials, objects, vertices = {}, [], []
    for number, case in enumerate(cases):
        s = case.settings
        texture = -1 if s.mapper == "gouraud" else names.index(layouts.get(s.mapper, "page"))
        material = Material(s.mapper, s.edges, s.gradients, s.start, s.clip, s.perspective, texture,
                            light=5 if s.mapper == "lit_gouraud" else -1)
        objects.append(Object(materials.setdefault(material, len(materials)), len(vertices),
                              len(case.vertices), 0, 1, number, 0))
        vertices += case.vertices
    scene = Scene(WIDTH, HEIGHT, len(cases), 7, np.zeros((256, 3), np.uint8), maps, list(materials),
                  objects, np.array(vertices), np.array([IDENTITY]))
    forms = "addx", "swap", "addx OFF all"
    drawn = guest_frames.draw([(scene, form) for form in forms], "a1200-fast", timed=False)
    for number, case in enumerate(cases):
        right = guest_frames.digest_of(model.render(scene, number))
        for form, digests in zip(forms, drawn):
            found = tuple(int(digests[number][field]) for field in ("result", "sum", "hash"))
            assert found == (0, *right), case.complaint(f"it differs, {form}", ("?", "?"),
                                                        "the model's pixels", "others")


def test_wrong_numbers_of_pieces_are_noticed() -> None:
    """Judged by exact planes: a polygon that is not planar but drawn whole, and a planar one that
    is cut."""
    square = [(x * ONE, y * ONE, x * ONE, y * ONE, 0, ONE) for x, y in ((0, 0), (40, 0), (40, 40), (0, 40))]
    off = [*square[:3], (0, 40 * ONE, 9 * ONE, 40 * ONE, 0, ONE)]
    deep = [*square[:3], (*square[3][:5], 2 * ONE)]
    for settings, bad in ((Settings(), off), (Settings(perspective="pixel"), deep)):
        assert not planarity.judge(square, settings, 1) and not planarity.judge(bad, settings, 2)
        assert "units off the plane" in planarity.judge(bad, settings, 1)
        assert "drawn in 2 pieces" in planarity.judge(square, settings, 2)
