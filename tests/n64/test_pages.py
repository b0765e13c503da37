"""Pages of the plain mappers: rows are made when polygons need them, and are the model's."""

import pytest
from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.engine_scenes import compiled, many_text, save_noise

PIXELS = ("rgba5551", "rgba8888")
SIDE = 40  # pixels of a polygon's cell
TILE = 'image = "noise.png", width = 12, height = 16'
CLAMPED = 's.wrap = "clamp", t.wrap = "clamp"'
#: First and last t of successive polygons: the rows grow on both sides, stay, and exceed the memory
#: reserved before; pages that repeat finally need all rows.
ENDING = ((5, 9), (2, 6), (6, 14), (5, 9), (-9, 6), (4, 40), (-80, 70))
FOR_EVER = (*ENDING, (-300, 200), (5, 9))
CONVERTED = 'convert = "convert", combine = "convert"'
#: Name: engine, ranges of t.
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
def drawn(tmp_path_factory):
    """By frame format: a scene of all engines and its result, from one boot."""
    folder = tmp_path_factory.mktemp("pages")
    save_noise(folder, 6, noise=(16, 12))
    asked = {pixels: Asked(compiled(folder, text_of(pixels))) for pixels in PIXELS}
    return dict(zip(asked, zip(asked.values(), guest_runs.draw([*asked.values()]))))


def text_of(pixels: str) -> str:
    """Polygons of one engine are beside each other, drawn one after the other; each engine has a
    separate row of cells."""
    columns = max(len(ranges) for _, ranges in ENGINES.values())
    text = many_text(SIDE * columns, SIDE * len(ENGINES), pixels, (engine for engine, _ in ENGINES.values()))
    for n, (_, ranges) in enumerate(ENGINES.values()):
        for k, (low, high) in enumerate(ranges):
            left, top = SIDE * k + 1, SIDE * n + 1
            rows = [[left, top, -1.3, low], [left + 37, top + 4.6, 13.4, low + 0.4],
                    [left + 9, top + 37.2, 5.5, high]]
            text += f'[[objects]]\nmaterial = "m{n}"\nvertices = {rows}\n'
    return text


@pytest.mark.parametrize("pixels", PIXELS)
def test_rows_are_made_as_they_are_needed(drawn, pixels):
    """The pictures are the model's, drawn by the plain mappers alone."""
    asked, done = drawn[pixels]
    guest_runs.check(f"{pixels}; {SIDE} lines each of {', '.join(ENGINES)}", asked, done)
    for name, material in zip(ENGINES, done.executed):
        spans = list(material["spans"])
        assert spans and all(span.startswith("affine") for span in spans), f"{name}: drawn by {spans}"
