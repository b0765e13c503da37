"""Pages of the plain mappers: rows are made when polygons need them, and are the model's."""

import numpy as np
import pytest
from engine_scenes import compiled, explain, many_text, save_noise

from tools import model, run

SIDE = 40  # pixels of a polygon's place
TILE = 'image = "noise.png", width = 12, height = 16'
CLAMPED = 's.wrap = "clamp", t.wrap = "clamp"'
#: First and last t of the polygons drawn one after the other: the rows grow on both sides, stay,
#: and are more than memory was there for; of pages that repeat at last all.
ENDING = ((5, 9), (2, 6), (6, 14), (5, 9), (-9, 6), (4, 40), (-80, 70))
FOR_EVER = (*ENDING, (-300, 200), (5, 9))
CONVERTED = 'convert = "convert", combine = "convert"'
#: Name to engine, and what is shown of it.
ENGINES = {
    "wrap": (f'tiles = [{{ {TILE}, format = "rgba16", s.wrap = "clamp" }}]', FOR_EVER),
    "mirror": (f'tiles = [{{ {TILE}, format = "i8", s.wrap = "clamp", t.wrap = "mirror" }}]',
               FOR_EVER),
    "clamp": (f'tiles = [{{ {TILE}, format = "rgba32", {CLAMPED} }}]', ENDING),
    "odd edges": (
        f'tiles = [{{ {TILE}, format = "ia8", s = {{ wrap = "clamp", low = 2, high = 9.5 }}, '
        't = { wrap = "clamp", low = 3.25, high = 11.75 } }]', ENDING),
    "tables": (f'combine = "modulate primitive", primitive = "#80c040f0", tiles = [{{ {TILE}, '
               'format = "rgba16", s.wrap = "clamp", t.wrap = "mirror" }]', FOR_EVER),
    "converted": (f'{CONVERTED}, tiles = [{{ {TILE}, format = "yuv16", {CLAMPED} }}]', ENDING),
    "converted RGBA": (f'{CONVERTED}, tiles = [{{ {TILE}, format = "rgba16", s.wrap = "clamp" }}]',
                       FOR_EVER),
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A directory with noise, 12x16."""
    path = tmp_path_factory.mktemp("pages")
    save_noise(path, 6, noise=(16, 12))
    return path


@pytest.mark.parametrize("pixels", ["rgba5551", "rgba8888"])
def test_rows_are_made_as_they_are_needed(folder, pixels):
    """Polygons of one engine after the other, each at rows of its own: the model's pictures."""
    columns = max(len(ranges) for _, ranges in ENGINES.values())
    text = many_text(SIDE * columns, SIDE * len(ENGINES), pixels, (tx for tx, _ in ENGINES.values()))
    for n, (_, ranges) in enumerate(ENGINES.values()):
        for k, (low, high) in enumerate(ranges):
            left, top = SIDE * k + 1, SIDE * n + 1
            rows = [[left, top, -1.3, low], [left + 37, top + 4.6, 13.4, low + 0.4],
                    [left + 9, top + 37.2, 5.5, high]]
            text += f'[[objects]]\nmaterial = "m{n}"\nvertices = {rows}\n'
    scene = compiled(folder, text)
    done = run.render(scene, "a1200-fast", "addx")
    expected = model.render(scene, 0)
    for n, (name, (_, ranges)) in enumerate(ENGINES.items()):
        for k, (low, high) in enumerate(ranges):
            part = np.s_[SIDE * n:SIDE * (n + 1), SIDE * k:SIDE * (k + 1)]
            found = done.frames[0][part]
            assert np.array_equal(found, expected[part]), explain(
                f"{name}, t from {low} to {high}, polygon {k}", expected[part], found,
                f".deps/venv/bin/python -m pytest tests/test_tx_pages.py -k {pixels}")
        assert all(span.startswith("affine") for span in done.executed[n]["spans"]), \
            f"{name}: drawn by {list(done.executed[n]['spans'])}, not by the plain mappers"
