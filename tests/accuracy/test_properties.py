"""The properties in tests/helpers/properties.py hold for random polygons and meshes, with fixed
seeds."""

import random

import numpy as np
import pytest

from tests.helpers import properties, property_cases
from tests.helpers.property_cases import HEIGHT, WIDTH
from tmap.corpus import random_meshes
from tmap.guest import guest_frames
from tmap.ideal import ideal
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import ONE

#: Number of cases of each property; those that compare texels pixel by pixel take longer.
COUNTS = dict.fromkeys(property_cases.CHECKS, 1000)
COUNTS["splitting"] = 400
EDGES = scene_file.SETTINGS["edges"]


@pytest.mark.parametrize("name", COUNTS)
def test_property(monkeypatch, name: str) -> None:
    """The property holds in every case; of the polygons that are set up more than a third have
    pixels."""
    pixels, set_up = [], model.set_up

    def counting(*given):
        polygon = set_up(*given)
        pixels.append(polygon.pixels if polygon else 0)
        return polygon

    monkeypatch.setattr(model, "set_up", counting)
    found = list(property_cases.complaints(name, 1, COUNTS[name]))
    assert not found, f"{len(found)} complaints, the first:\n{found[0]}"
    assert np.count_nonzero(pixels) > len(pixels) / 3, f"{len(pixels)} polygons"


def some_meshes(seed: str, count: int) -> list[random_meshes.Mesh]:
    """``count`` meshes of each kind."""
    return [random_meshes.mesh(random.Random(f"{seed} {kind} {k}"), WIDTH, HEIGHT, kind)
            for kind in random_meshes.KINDS for k in range(count)]


def test_meshes_hold_what_they_promise() -> None:
    """The triangles tile their outlines: areas add up, and every inner side belongs to two
    triangles, in either winding."""
    windings = set()
    for mesh in some_meshes("tiles", 100):
        areas = [random_meshes.twice_area(t) for t in mesh.triangles]
        windings |= {area > 0 for area in areas}
        assert sum(map(abs, areas)) == random_meshes.twice_area(mesh.outline), mesh
        shared = {frozenset(pair) for t in mesh.triangles for pair in zip(t, t[1:] + t[:1])}
        border = set(map(frozenset, zip(mesh.outline, mesh.outline[1:] + mesh.outline[:1])))
        assert border <= shared, mesh
        assert 2 * len(shared) - len(border) == 3 * len(mesh.triangles), mesh
    assert windings == {True, False}


def test_how_watertight_meshes_are() -> None:
    """Exact edges cover each pixel once; subpixel and integer edges are worse, in this order."""
    wrong = {}
    for edges in EDGES:
        counts = dict.fromkeys(("pixels", "left out", "beside", "more than once"), 0)
        for mesh in some_meshes("figures", 250):
            case = properties.Case("", tuple((*p, 0, 0, 0, ONE) for p in mesh.outline), WIDTH, HEIGHT,
                                   model.Settings(edges, mapper="flat"))
            wanted = ideal.coverage(mesh.outline, WIDTH, HEIGHT)
            found = properties.counted(case, mesh.triangles)
            counts["pixels"] += int(wanted.sum())
            counts["left out"] += int(((wanted == 1) & (found == 0)).sum())
            counts["beside"] += int(((wanted == 0) & (found > 0)).sum())
            counts["more than once"] += int((found > 1).sum())
        wrong[edges] = counts
    sums = {edges: sum(counts.values()) - counts["pixels"] for edges, counts in wrong.items()}
    assert sums["exact"] == 0 < sums["subpixel"] < sums["integer"], wrong


def empty_scene() -> scene_file.Scene:
    """A scene without objects."""
    return scene_file.Scene(WIDTH, HEIGHT, 0, 0, np.zeros((256, 3), np.uint8), [], [], [],
                            np.zeros((0, 6), int), np.array([scene_file.IDENTITY]))


def add(scene: scene_file.Scene, material: scene_file.Material, vertices) -> None:
    """Adds a polygon to the last frame of a scene."""
    if material not in scene.materials:
        scene.materials.append(material)
    scene.objects.append(scene_file.Object(
        scene.materials.index(material), len(scene.vertices), len(vertices), 0, 1,
        scene.frames - 1))
    scene.vertices = np.concatenate([scene.vertices, np.array(vertices)])


def check_on_the_guest(scene: scene_file.Scene, about: list[str]) -> None:
    """The 68020 draws every frame as the model does, byte for byte, and refuses none."""
    __tracebackhide__ = True
    assert len(about) == scene.frames
    drawn = scene, "addx", "a1200-fast"
    digests, = guest_frames.draw([drawn[:2]], drawn[2], timed=False)
    guest_frames.require_models((model.render(scene, number) for number in range(scene.frames)),
                                digests, "properties", drawn, about)


def test_meshes_are_the_models() -> None:
    """One mesh a frame, each triangle in a different colour, with every setting of edges."""
    scene, about = empty_scene(), []
    for k, mesh in enumerate(some_meshes("guest", 3)):
        clip = scene_file.SETTINGS["clip"][k % 2]
        for edges in EDGES:
            scene.frames += 1
            about.append(f"{mesh.kind} {k}, edges {edges}, clip {clip}, {mesh.triangles}")
            for colour, triangle in enumerate(mesh.triangles, 1):
                add(scene, scene_file.Material(edges=edges, clip=clip, colour=colour),
                    [(*p, 0, 0, 0, ONE) for p in triangle])
    check_on_the_guest(scene, about)


def test_held_lines_are_the_models() -> None:
    """Lines that reach the end of the map or of the shades, planar or not."""
    scene, about, maps = empty_scene(), [], {}
    for k in range(200):
        case = property_cases.held_case(random.Random(f"guest {k}"), f"number {k}")
        if max(case.size) > 256:  # many of them would not fit into memory
            continue
        if case.size not in maps:
            maps[case.size] = len(maps)
            noise = np.random.default_rng(k).integers(0, 256, case.size[::-1], dtype=np.uint8)
            scene.textures.append(scene_file.Texture(noise, "linear"))
        scene.frames += 1
        about.append(case.complaint("it differs", ("?", "?"), "the model's pixels", "others"))
        s = case.settings
        texture = maps[case.size] if s.mapper == "arbitrary" else -1
        add(scene, scene_file.Material(s.mapper, s.edges, s.gradients, s.start, s.clip, s.perspective, texture),
            case.vertices)
    assert scene.frames > 100
    check_on_the_guest(scene, about)


def test_rows_of_the_map_are_the_models() -> None:
    """Lines that cover one row of the map, or up to a texel more or less: drawn by generated code
    or by affine spans."""
    scene, about, drawn = empty_scene(), [], set()
    noise = np.random.default_rng(1).integers(0, 256, (256, 256), dtype=np.uint8)
    scene.textures.append(scene_file.Texture(noise, "margins"))
    for k in range(200):
        case = property_cases.row_case(random.Random(f"row {k}"), f"number {k}")
        polygon = case.drawn()
        if polygon is None:
            continue
        drawn.add(polygon.mapper)
        scene.frames += 1
        about.append(case.complaint("it differs", ("?", "?"), "the model's pixels", "others"))
        s = case.settings
        add(scene, scene_file.Material(s.mapper, s.edges, s.gradients, s.start, s.clip, s.perspective, 0),
            case.vertices)
    assert scene.frames > 100 and drawn == {"generated", "affine"}
    check_on_the_guest(scene, about)
