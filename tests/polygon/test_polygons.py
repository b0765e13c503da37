"""Random polygons drawn by the 68020: bit for bit the model, and near the ideal.

1,000 polygons of 3 to 8 vertices, many thin, many partly off screen, one a frame; test_wide.py has
those of 16 and 32 bits, tests/accuracy/test_fuzz.py all other settings. All runs of one machine
share a boot. The guest itself checks the guard bands round the frame (4,096 bytes each side).
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tmap.bench import scenes
from tmap.corpus import random_polygons
from tmap.guest import guest_frames
from tmap.ideal import ideal
from tmap.ideal.bounds_coverage import check_coverage
from tmap.model import model
from tmap.run.polygon_report import explain
from tmap.scene_file import scene_file

#: seed: (polygons, width, height)
SCENES = {1: (500, 320, 256), 2: (500, 192, 144)}
USUAL = model.Settings()
EXACT = model.Settings("exact")
RUNS = [("addx", "a1200-fast", 1, USUAL), ("swap", "a1200-fast", 2, USUAL),
        ("addx", "a1200", 2, USUAL), ("c", "a1200-fast", 2, USUAL),
        ("addx", "a1200-fast", 1, EXACT),
        ("addx", "a1200-fast", 2, replace(EXACT, clip="vertices")),
        ("addx", "a1200-fast", 2, replace(USUAL, clip="vertices"))]


def called(run: tuple) -> str:
    form, machine, seed, settings = run
    return f"{form}-{machine}-{seed}-{settings.edges}-{settings.clip}"


@cache
def scene(seed: int, settings: model.Settings = USUAL) -> scene_file.Scene:
    made = random_polygons.scene(seed, *SCENES[seed])
    made.materials = [replace(m, edges=settings.edges, clip=settings.clip) for m in made.materials]
    return made


@cache
def expected(seed: int, settings: model.Settings) -> list[tuple[int, int]]:
    """The digests of the model's frames of a seed."""
    this = scene(seed, settings)
    return [guest_frames.digest_of(model.render(this, k)) for k in range(this.frames)]


@pytest.fixture(scope="module")
def drawn(request) -> dict[str, np.ndarray]:
    """The guest's digests of all runs, by name."""
    names = {item.name.partition("[")[2].removesuffix("]") for item in request.session.items}
    asked = [run for run in RUNS if called(run) in names]
    found = {}
    for machine in dict.fromkeys(run[1] for run in asked):
        runs = [run for run in asked if run[1] == machine]
        digests = guest_frames.draw([(scene(seed, settings), form) for form, _, seed, settings in runs],
                            machine, timed=False)
        found |= dict(zip(map(called, runs), digests, strict=True))
    return found


@pytest.mark.parametrize("run", RUNS, ids=called)
def test_every_polygon_is_the_models(run: tuple, drawn) -> None:
    """No byte differs and none outside the frame is written, in any form."""
    form, machine, seed, settings = run
    this = scene(seed, settings)
    found = [(int(d["result"]), int(d["sum"]), int(d["hash"])) for d in drawn[called(run)]]
    wrong = [k for k, (digest, right) in enumerate(zip(found, expected(seed, settings), strict=True))
             if digest != (0, *right)]
    if wrong:
        again = (".deps/venv/bin/python -m pytest -q 'tests/polygon/test_polygons.py::"
                 f"test_every_polygon_is_the_models[{called(run)}]'")
        frame = guest_frames.frame_of(scenes.some_frames(this, wrong[:1]), form, machine)
        pytest.fail(f"{len(wrong)} polygons are wrong; the first one's result is "
                    f"{found[wrong[0]][0]}, which must be 0\n"
                    + explain(this, wrong[0], frame, f"seed {seed}, polygon {wrong[0]}", again))


@pytest.mark.parametrize("seed", SCENES)
def test_error_is_within_the_derived_bounds(seed: int) -> None:
    """Edges and texels are off the exact rational ideal by no more than tools/tmap/ideal/ideal.py
    derives. With exact edges the pixels are those of the rational polygon, however long, thin or
    steep it is."""
    this = scene(seed)
    drawn, worst = {USUAL: 0, EXACT: 0}, {"edge": 0.0, "texel": 0.0}
    for number, obj in enumerate(this.objects):
        vertices = scene_file.vertices_at(this, obj, number)
        for settings in drawn:
            polygon = model.set_up(vertices, this.width, this.height, True, settings)
            if not polygon:
                continue
            what = f"seed {seed}, polygon {number}, edges {settings.edges}, vertices {vertices}"
            errors = [("texel", *each[-2:]) for each in ideal.texel_errors(vertices, polygon)]
            if settings is USUAL:
                errors += [("edge", *each[-2:]) for each in ideal.edge_errors(vertices, polygon)]
            else:
                size = this.width, this.height
                assert not check_coverage(vertices, polygon, settings, *size)[0], what
            for name, error, bound in errors:
                assert 0 <= error <= bound, f"{name}: {what}"
                if settings is USUAL:
                    worst[name] = max(worst[name], error / bound)
            drawn[settings] += polygon.pixels
    # The scene tests what it should: much is drawn, and the bounds are nearly reached.
    assert min(drawn.values()) > 500_000
    assert min(worst.values()) > 0.9


def test_scenes_hold_what_they_promise() -> None:
    """The scenes have many thin polygons, many partly off screen, both wrap modes and every vertex
    count."""
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
    assert off > 150 and thin > 25 and wraps > 10, (off, thin, wraps)
