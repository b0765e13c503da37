"""Random polygons, drawn by the 68020: bit for bit the model, and near the ideal.

2,000 polygons of 3 to 8 vertices, many thin, many partly off screen, one a frame.
The guest itself checks the guard bands round the frame (4,096 bytes each side).
"""

from functools import cache

import numpy as np
import pytest
from PIL import Image

from tools import emulator, ideal, model, random_polygons, scene_file
from tools.diff import Frame, panels
from tools.paths import BUILD

#: seed: (polygons, width, height)
SCENES = {1: (1000, 320, 256), 2: (1000, 192, 144)}
RUNS = [("addx", "a1200-fast", 1), ("addx", "a1200-fast", 2), ("swap", "a1200-fast", 1),
        ("swap", "a1200-fast", 2), ("addx", "a1200", 2), ("c", "a1200-fast", 2)]


@cache
def scene(seed: int) -> scene_file.Scene:
    """The scene of a seed."""
    return random_polygons.scene(seed, *SCENES[seed])


@cache
def expected(seed: int) -> list[np.ndarray]:
    """The model's frames of a seed."""
    return [model.render(scene(seed), k) for k in range(scene(seed).frames)]


def explain(seed: int, number: int, found: np.ndarray, again: str) -> str:
    """All a person needs to find the cause of one wrong frame."""
    this, right = scene(seed), expected(seed)[number]
    y, x = np.argwhere(right != found)[0]
    vertices = scene_file.vertices_at(this, this.objects[number], number)
    polygon = model.set_up(vertices, this.width, this.height, True)
    picture = BUILD / "failed" / f"polygon_{seed}_{number}.png"
    picture.parent.mkdir(parents=True, exist_ok=True)
    both = Frame(right, this.palette), Frame(found, this.palette)
    Image.fromarray(panels(*both)).save(picture)
    lines = [f"seed {seed}, polygon {number}: {np.count_nonzero(right != found)} pixels differ, "
             f"the first at (x {x}, y {y}): expected {right[y, x]}, found {found[y, x]}",
             *(f"  vertex {k}: " + ", ".join(f"{n} {c / 65536:.6f} ({c & model.M32:#010x})"
                                             for n, c in zip("xyst", vertex))
               for k, vertex in enumerate(vertices))]
    for name, edges in (("left", polygon.left_edges), ("right", polygon.right_edges)):
        lines += [f"  {name} edge, lines {e.top} to {e.end - 1}: slope {e.slope / 65536:.6f} "
                  f"({e.slope & model.M32:#010x})" for e in edges]
    if polygon.texturing:
        lines += [f"  {k}: {model.signed(v) / 65536:.6f} ({v:#010x})"
                  for k, v in vars(polygon.texturing).items() if k.startswith("d")]
    return "\n".join([*lines, f"  picture (expected, found, difference): {picture}",
                      f"  again: {again}"])


@pytest.mark.parametrize("form, machine, seed", RUNS)
def test_every_polygon_is_the_models(form: str, machine: str, seed: int) -> None:
    """No byte differs, none outside the frame is touched, whatever the form."""
    this = scene(seed)
    with emulator.workspace() as directory:
        done = emulator.run("render", f"input.scene FORM {form}",
                            {"input.scene": scene_file.write(this)}, machine, directory)
        assert done.code == 0, done.output.splitlines()[-1]
        wrong = []
        for number, right in enumerate(expected(seed)):
            found = np.fromfile(done.directory / f"frame_{number:03}.chunky", np.uint8)
            if not np.array_equal(found, right.reshape(-1)):
                wrong.append((number, found.reshape(right.shape)))
    again = (".deps/venv/bin/python -m pytest -q 'tests/test_polygons.py::"
             f"test_every_polygon_is_the_models[{form}-{machine}-{seed}]'")
    assert not wrong, f"{len(wrong)} polygons are wrong\n" + explain(seed, *wrong[0], again)


@pytest.mark.parametrize("seed", SCENES)
def test_error_is_within_the_derived_bounds(seed: int) -> None:
    """Edges and texels are off the exact rational ideal by no more than tools/ideal.py derives."""
    this, worst = scene(seed), ideal.Deviation()
    for number, obj in enumerate(this.objects):
        vertices = scene_file.vertices_at(this, obj, number)
        polygon = model.set_up(vertices, this.width, this.height, True)
        if polygon:
            found = ideal.deviation(vertices, polygon, this.width)
            assert found.edge_ratio <= 1 and found.texel_ratio <= 1, (
                f"seed {seed}, polygon {number}: {found}, vertices {vertices}")
            worst.merge(found)
    # The scene is what it claims to be: much is drawn, and the bounds are nearly reached.
    assert worst.pixels > 1_000_000
    assert worst.edge_ratio > 0.9 and worst.texel_ratio > 0.9


def test_scenes_hold_what_they_promise() -> None:
    """Many thin ones, many partly off screen, both wrap modes, every vertex count."""
    this = scene(1)
    counts, off, thin, wraps = set(), 0, 0, 0
    for number, obj in enumerate(this.objects):
        vertices = scene_file.vertices_at(this, obj, number)
        polygon = model.set_up(vertices, this.width, this.height, True)
        counts.add(len(vertices))
        off += any(not (0 <= x < this.width << 16 and 0 <= y < this.height << 16)
                   for x, y, *_ in vertices)
        if polygon:
            widths = [line.right - line.left for line in polygon.lines]
            thin += max(widths) <= 2
            wraps += polygon.texturing.wraps
    assert counts == set(range(3, 9))
    assert off > 300 and thin > 50 and wraps > 20, (off, thin, wraps)
