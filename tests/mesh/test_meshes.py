"""Meshes on the emulated A1200 are the model's frames, bit for bit; scenes are compared with exact
numbers.

``make test`` takes some frames of each scene, spread over its length; SCENES=all takes every one.
"""

import os
from fractions import Fraction

import numpy as np
import pytest

from tests.helpers import mesh_cases
from tmap.base.paths import SCENES
from tmap.compiler import objects
from tmap.compiler.scene import compile_scene
from tmap.guest import guest_frames
from tmap.ideal import faces as ideal_faces
from tmap.ideal.faces import Camera
from tmap.model import mesh, model
from tmap.scene_file.scene_file import ONE

MACHINE = "a1200-fast"
PLAIN = 4  # random scenes that are drawn in the plain forms too
NAMES = ("cube", "face", "floor", "corridor", "environment", "shaded", "crane", "grove", "lamps")
FOGGY = ("mist",)
SPLIT = ("rooms",)  # new corners are rounded, so its faces are not exactly flat: tests/mesh/test_trees.py
EVERY = 1 if os.environ.get("SCENES") == "all" else 13


def assert_models(scenes: dict, results: tuple = (0,), part: float = 0.75,
                  more: tuple = ()) -> dict[str, list[np.ndarray]]:
    """Asserts that each frame of each scene is the model's, and that at least a fraction ``part``
    of them shows more than one colour; returns the model's frames. ``more``: (name, form) of
    further drawings."""
    right = {name: [model.render(scene, number) for number in range(scene.frames)]
             for name, scene in scenes.items()}
    drawings = [*((name, "addx") for name in scenes), *more]
    drawn = guest_frames.draw([(scenes[name], form) for name, form in drawings], MACHINE,
                              timed=False)
    for (name, form), digests in zip(drawings, drawn, strict=True):
        for number, (frame, digest) in enumerate(zip(right[name], digests, strict=True)):
            which = f"{name}, frame {number}, form {form}"
            assert guest_frames.is_models(frame, digest), f"{which} is not the model's"
            assert int(digest["result"]) in results, f"{which}: result {digest['result']}"
    shown = [(frame != frame[0, 0]).any() for frames in right.values() for frame in frames]
    assert sum(shown) >= part * len(shown)
    return right


def test_scenes_are_the_models():
    """The scenes with meshes; every frame shows something different."""
    scenes = {}
    for name in (*NAMES, *SPLIT):
        scene = compile_scene(SCENES / f"{name}.toml")
        kept = range(0, scene.frames, EVERY)
        for instance in scene.instances:
            assert (instance.first_frame, instance.views) == (0, scene.frames)
            scene.views[[instance.view + k for k in range(len(kept))]] = \
                scene.views[[instance.view + number for number in kept]]
        scene.frames = len(kept)
        scenes[name] = scene
    for name, frames in assert_models(scenes).items():
        assert len({frame.tobytes() for frame in frames}) == scenes[name].frames
        assert all(len(np.unique(frame)) > 4 for frame in frames)


def test_mirrored_maps_of_any_size_are_the_models(tmp_path):
    """Points have u and v in the map's texels; faces that a border cuts have those of their normals."""
    text = (SCENES / "environment.toml").read_text().replace('"knot.obj"', f'"{SCENES / "knot.obj"}"')
    text = text.replace("frames = 40", "frames = 2").replace("eye = [0, 0, 8]", "eye = [1.5, 0, 5]")
    scenes = {}
    for size in ((128, 128), (16, 64), (8, 8)):
        path = tmp_path / f"map{size[0]}.toml"
        path.write_text(text.replace("[materials]", "room.width = {}\nroom.height = {}\n\n[materials]".format(*size)))
        scene = scenes[path.stem] = compile_scene(path)
        assert scene.textures[0].texels.shape == size[::-1]
        sides = [[v[0] < scene.width << 16 for v in vertices] for _, vertices, _ in mesh.placed_at(scene, 0)]
        assert sum(any(side) and not all(side) for side in sides) > 5 and sum(map(all, sides)) > 100
    assert_models(scenes)


def fractions(rows) -> list:
    """Numbers as fractions; rows of them as lists."""
    return [Fraction(row) if np.ndim(row) == 0 else fractions(row) for row in rows]


@pytest.mark.parametrize("name", (*NAMES, *FOGGY))
def test_scenes_are_as_exact_as_is_derived(name: str, monkeypatch) -> None:
    """Every pixel, texel and shade of their faces is compared with exact faces before the camera,
    before its numbers were rounded."""
    seen, rounding = [], objects.Space.view

    def view(self, *arguments):
        seen.append(self.seen(*arguments[:-1]))
        return rounding(self, *arguments)

    monkeypatch.setattr(objects.Space, "view", view)
    scene = compile_scene(SCENES / f"{name}.toml")
    total, near = ideal_faces.Verdict(), Fraction(scene.near_plane, ONE)
    for number in range(0, scene.frames, 20 if EVERY > 1 else 1):
        for instance in scene.instances:
            if not 0 <= number - instance.first_frame < instance.views:
                continue
            numbers = map(fractions, seen[instance.view + number - instance.first_frame])
            camera = Camera(*numbers, scene.guard, scene.width, scene.height, near)
            material = scene.materials[instance.material]
            longer = max(scene.textures[material.texture].texels.shape) if material.texture >= 0 else 256
            faces = ideal_faces.exact_faces(scene, instance, camera, longer)
            found = ideal_faces.judge(scene, number, instance, faces)
            assert not found.complaint, f"frame {number}: {found.complaint}"
            total.merge(found)
    assert total.faces >= 4 and total.pixels > 10000 and not total.unsure
    assert total.texel_ratio > 0.1  # the bounds are not too wide to test anything


def test_random_meshes_are_the_models():
    """Cubes of every kind of material, before, around and behind the camera, some with 16-bit operands;
    some in plain forms too."""
    scenes = {f"seed {seed}": mesh_cases.boxes(seed) for seed in range(12)}
    scenes |= {f"before, seed {seed}": mesh_cases.before(seed) for seed in range(6)}
    plain = list(scenes)[:PLAIN]
    cut = sum(len(vertices) > 4 for name in plain for number in range(scenes[name].frames)
              for _, vertices in mesh.polygons_at(scenes[name], number))
    assert cut > 20
    assert_models(scenes, more=tuple((name, form) for form in ("swap", "c") for name in plain))


def test_random_trees_are_the_models():
    """Trees of any planes, of one instance and of two, before others that have none."""
    assert_models({f"seed {seed}": mesh_cases.trees(seed) for seed in range(8)})


def test_hostile_meshes_are_the_models():
    """Faces of random points, concave and bent, with numbers of any size; many are behind the
    camera."""
    assert_models({f"seed {seed}": mesh_cases.hostile(seed) for seed in range(24)},
                  results=(0, 2, 3), part=0.25)


def test_meshes_and_polygons_take_turns():
    """Instances are drawn before the object they name, whatever their depth."""
    scene = mesh_cases.boxes(1)
    drawn = mesh.polygons_at(scene, 1)
    shown = [material for material, _ in drawn]
    flat = [k for k, (material, vertices) in enumerate(drawn)
            if vertices[0][:2] == (0, 0) and len(vertices) == 3 and material == 0]
    assert len(flat) == 2 and set(shown[:flat[0]]) <= {0, 1, 2}
    assert set(shown[flat[0] + 1:flat[1]]) <= {3, 4, 5} and set(shown[flat[1] + 1:]) <= {6, 7, 8}


def test_crowded_depths_are_in_order():
    """Faces of one depth are drawn as they come, and many of almost one depth from the farthest."""
    scenes = {f"seed {seed}": mesh_cases.crowd(seed) for seed in range(6)}
    depths = [{max(p.w for p in mesh.transform(scene, scene.points[3 * k:3 * k + 3].tolist(),
                                               scene.views[0].tolist()))
               for k in range(200)} for scene in scenes.values()]
    assert {len(some) > 100 for some in depths} == {False, True}
    assert_models(scenes)
