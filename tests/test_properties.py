"""The properties of tests/properties.py hold on random polygons and meshes, by fixed seeds."""

from dataclasses import replace

import numpy as np
import properties
import pytest

from tools import emulator, ideal, meshes, model, random_polygons, scene_file

#: Cases of each property; those that compare texels pixel by pixel take longer.
COUNTS = dict.fromkeys(properties.CHECKS, 1000) | {"drift": 400, "splitting": 400, "clipping": 400}
EDGES = scene_file.SETTINGS["edges"]
WIDTH, HEIGHT = properties.WIDTH, properties.HEIGHT


@pytest.mark.parametrize("name", COUNTS)
def test_property(monkeypatch, name: str) -> None:
    """It holds in every case; in most of them something is drawn."""
    pixels, set_up = [], model.set_up

    def counting(*given):
        polygon = set_up(*given)
        pixels.append(polygon.pixels if polygon else 0)
        return polygon

    monkeypatch.setattr(model, "set_up", counting)
    found = list(properties.complaints(name, 1, COUNTS[name]))
    assert not found, f"{len(found)} complaints, the first:\n{found[0]}"
    assert np.count_nonzero(pixels) > len(pixels) / 3


def random_meshes(seed: str, count: int) -> list[meshes.Mesh]:
    """So many of each kind."""
    return [meshes.mesh(properties.random.Random(f"{seed} {kind} {k}"), WIDTH, HEIGHT, kind)
            for kind in meshes.KINDS for k in range(count)]


def test_meshes_hold_what_they_promise() -> None:
    """The triangles tile their outlines, in either winding; no kind is always alike."""
    windings = set()
    for mesh in random_meshes("tiles", 100):
        areas = [meshes.twice_area(t) for t in mesh.triangles]
        windings |= {area > 0 for area in areas}
        assert sum(map(abs, areas)) == meshes.twice_area(mesh.outline)
        shared = {frozenset(pair) for t in mesh.triangles for pair in zip(t, t[1:] + t[:1])}
        border = set(map(frozenset, zip(mesh.outline, mesh.outline[1:] + mesh.outline[:1])))
        assert border <= shared and 2 * len(shared) - len(border) == 3 * len(mesh.triangles)
    assert windings == {True, False}


def test_how_watertight_meshes_are() -> None:
    """Exact edges cover what they should, once; how far the others are off is printed."""
    wrong = {}
    for edges in EDGES:
        counts = dict.fromkeys(("pixels", "left out", "beside", "more than once"), 0)
        for mesh in random_meshes("figures", 250):
            case = properties.Case("", tuple((*p, 0, 0, 0) for p in mesh.outline), WIDTH, HEIGHT,
                                   model.Settings(edges, mapper="flat"))
            wanted = ideal.coverage(mesh.outline, WIDTH, HEIGHT)
            found = properties.counted(case, mesh.triangles)
            counts["pixels"] += int(wanted.sum())
            counts["left out"] += int(((wanted == 1) & (found == 0)).sum())
            counts["beside"] += int(((wanted == 0) & (found > 0)).sum())
            counts["more than once"] += int((found > 1).sum())
        print(edges, counts)
        wrong[edges] = sum(counts.values()) - counts["pixels"]
    assert wrong["exact"] == 0 < wrong["subpixel"] < wrong["integer"]


def mesh_scene() -> tuple[scene_file.Scene, list[str]]:
    """A mesh a frame, each triangle in its own colour, under every setting of edges and
    clip; and what each frame is."""
    scene = scene_file.Scene(WIDTH, HEIGHT, 0, 0, np.zeros((256, 3), np.uint8), [], [], [],
                             np.zeros((0, 5), int), np.array([random_polygons.IDENTITY]))
    vertices, about = [], []
    for k, mesh in enumerate(random_meshes("guest", 3)):
        for edges in EDGES:
            clip = scene_file.SETTINGS["clip"][k % 2]
            for colour, triangle in enumerate(mesh.triangles, 1):
                material = scene_file.Material(edges=edges, clip=clip, colour=colour)
                if material not in scene.materials:
                    scene.materials.append(material)
                scene.objects.append(scene_file.Object(scene.materials.index(material),
                                                       len(vertices), 3, 0, 1, scene.frames))
                vertices += [(*p, 0, 0, 0) for p in triangle]
            scene.frames += 1
            about.append(f"{mesh.kind} {k}, edges {edges}, clip {clip}, {mesh.triangles}")
    return replace(scene, vertices=np.array(vertices)), about


def test_meshes_are_the_models() -> None:
    """The 68020 draws the meshes as the model does, byte for byte."""
    scene, about = mesh_scene()
    with emulator.workspace() as directory:
        done = emulator.run("render", "input.scene FORM addx",
                            {"input.scene": scene_file.write(scene)}, "a1200-fast", directory)
        assert done.code == 0, done.output.splitlines()[-1]
        for number, what in enumerate(about):
            found = np.fromfile(done.directory / f"frame_{number:03}.chunky", np.uint8)
            wrong = np.argwhere(found.reshape(HEIGHT, WIDTH) != model.render(scene, number))
            assert not len(wrong), f"{what}: (x, y) {wrong[0][::-1]} and {len(wrong) - 1} more"
