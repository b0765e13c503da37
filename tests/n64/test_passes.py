"""Which polygons of a texture engine are drawn by passes, and that they are the model's: YUV in its
modes, texels written directly to 16-bit pixels, the second cycle's texel alone. Pages of the plain
mappers: rows are made when polygons need them, and are the model's."""

import numpy as np
import pytest
from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.engine_scenes import compiled, batch_text, save_noise

PIXELS = ("rgba5551", "rgba8888")
COLUMNS, SIDE, GAP = 5, 22, 26  # engines a row; pixels of a triangle, of its cell
YUV = 'image = "noise.png", format = "yuv16", width = 16, height = 16'
RGBA = 'image = "noise.png", format = "rgba16", width = 16, height = 16'
SHADE = '{ rgb = [["0", "0", "0", "combined"], ["texel0", "environment", "shade", "texel1"]], ' \
    'alpha = [["0", "0", "0", "combined"], ["texel0", "0", "shade", "0"]] }'
FILTERED = 'cycles = 2, convert = "filter, convert", combine = ["pass", "convert"]'
BOTH = '{ rgb = [["texel0", "k4", "texel1", "texel1"], ["texel0", "combined", "k5", "texel1"]], ' \
    'alpha = [["texel0", "0", "texel1", "0"], ["texel0", "texel1", "0", "combined"]] }'
SWAPPED = '{ rgb = [["texel0", "texel1", "primitive.a", "texel1"], ["0", "0", "0", "combined"]], ' \
    'alpha = [["texel0", "texel1", "primitive", "texel1"], ["0", "0", "0", "combined"]] }'
WILD = "k = [255, -256, -256, 255, -200, 255]"


def tiles(tile: str, other: str | None = None) -> str:
    """Two tiles; the second equals the first unless given."""
    return f"tiles = [{{ {tile} }}, {{ {other or tile} }}]"


#: Name: engine, 1 if it must be drawn by passes.
ENGINES = {
    "point": ('perspective = true, convert = "convert", combine = "convert", ' + tiles(YUV), 1),
    "wild": (f'perspective = true, convert = "convert", combine = "convert", {WILD}, '
             + tiles(YUV), 1),
    "bilerp": (f'{FILTERED}, filter = "bilerp", ' + tiles(YUV), 1),
    "bilerp wild": (f'{FILTERED}, filter = "bilerp", perspective = true, {WILD}, ' + tiles(YUV), 1),
    "average": (f'{FILTERED}, filter = "average", ' + tiles(YUV), 1),
    "clamp": (f'{FILTERED}, filter = "bilerp", '
              + tiles(YUV + ', s = { wrap = "clamp", low = 2.5, high = 12 }, t.wrap = "clamp"'), 1),
    "clamp, even": (f'{FILTERED}, filter = "average", '
                    + tiles(YUV + ', s = { wrap = "clamp", high = 11 }, t.wrap = "mirror"'), 1),
    "shift": (f'{FILTERED}, filter = "bilerp", '
              + tiles(YUV + ", s = { shift = 1, low = 3 }, t.shift = 15"), 1),
    "mirror": (f'{FILTERED}, filter = "bilerp", ' + tiles(YUV + ', s.wrap = "mirror"'), 0),
    "mirror, point": (f"{FILTERED}, perspective = true, " + tiles(YUV + ', s.wrap = "mirror"'), 1),
    "filter": (f'filter = "bilerp", combine = "decal", {WILD}, ' + tiles(YUV), 1),
    "corner": ('filter = "bilerp", convert = "convert", combine = "convert", ' + tiles(YUV), 0),
    "convert both": (f'cycles = 2, convert = "convert", combine = {BOTH}, {WILD}, '
                     + tiles(YUV, YUV + ", s.shift = 1"), 1),
    "filter both": (f'cycles = 2, filter = "bilerp", combine = {BOTH}, '
                    + tiles(YUV, YUV + ", s.shift = 1"), 1),
    "filter, convert both": (f'cycles = 2, filter = "average", convert = "filter, convert", '
                             f"combine = {BOTH}, {WILD}, " + tiles(YUV), 1),
    "mix": ('cycles = 2, filter = "bilerp", combine = "mix", primitive_lod_fraction = 77, '
            + tiles(YUV, YUV + ", t.shift = 1"), 1),
    "shade": (f'cycles = 2, filter = "bilerp", convert = "filter, convert", combine = {SHADE}, '
              f"{WILD}, " + tiles(YUV), 1),
    "levels": (f'{FILTERED}, filter = "bilerp", lod = true, '
               f"tiles = [{{ {YUV}, levels = 2 }}]", 1),
    "beside RGBA": (f"{FILTERED}, perspective = true, " + tiles(YUV, RGBA), 0),
    "converted RGBA": ('perspective = true, convert = "convert", ' + tiles(RGBA), 0),
    "direct": ('filter = "bilerp", perspective = true, ' + tiles(RGBA), 1),
    "direct levels": ('cycles = 2, filter = "bilerp", lod = true, perspective = true, '
                      f"tiles = [{{ {RGBA}, levels = 4 }}]", 1),
    "direct texel 1": ('cycles = 2, filter = "bilerp", combine = ["pass", "decal"], '
                       + tiles(RGBA, RGBA + ", s.shift = 1"), 1),
    "any": (f'cycles = 2, filter = "bilerp", combine = {BOTH}, '
            + tiles(RGBA, RGBA + ", s.shift = 1"), 1),
    "any, shade": (f'cycles = 2, combine = {SHADE}, perspective = true, '
                   + tiles(RGBA, RGBA + ", s.shift = 1"), 1),
    "product": ('cycles = 2, filter = "bilerp", combine = ["modulate primitive", "pass"], '
                'primitive = "#c0f04080", ' + tiles(RGBA, RGBA + ", s.shift = 1"), 1),
    "swapped blend": (f'cycles = 2, filter = "bilerp", combine = {SWAPPED}, '
                      'primitive = "#c0f04060", ' + tiles(RGBA, RGBA + ", s.shift = 1"), 1),
    "tables of texel 1": ('cycles = 2, filter = "average", combine = ["pass", "modulate primitive"]'
                          ', primitive = "#80c040f0", ' + tiles(RGBA, RGBA + ", t.shift = 1"), 1),
}


PAGE = 40  # pixels of a polygon's cell
PAGED = 'image = "noise.png", width = 12, height = 16'
CLAMPED = 's.wrap = "clamp", t.wrap = "clamp"'
#: First and last t of successive polygons: the rows grow on both sides, stay, and exceed the memory
#: reserved before; pages that repeat finally need all rows.
ENDING = ((5, 9), (2, 6), (6, 14), (5, 9), (-9, 6), (4, 40), (-80, 70))
FOR_EVER = (*ENDING, (-300, 200), (5, 9))
CONVERTED = 'convert = "convert", combine = "convert"'
#: Name: engine, ranges of t.
PAGES = {
    "wrap": (f'tiles = [{{ {PAGED}, format = "rgba16", s.wrap = "clamp" }}]', FOR_EVER),
    "mirror": (f'tiles = [{{ {PAGED}, format = "i8", s.wrap = "clamp", t.wrap = "mirror" }}]',
               FOR_EVER),
    "clamp": (f'tiles = [{{ {PAGED}, format = "rgba32", {CLAMPED} }}]', ENDING),
    "odd edges": (
        f'tiles = [{{ {PAGED}, format = "ia8", s = {{ wrap = "clamp", low = 2, high = 9.5 }}, '
        't = { wrap = "clamp", low = 3.25, high = 11.75 } }]', ENDING),
    "tables": (f'combine = "modulate primitive", primitive = "#80c040f0", tiles = [{{ {PAGED}, '
               'format = "rgba16", s.wrap = "clamp", t.wrap = "mirror" }]', FOR_EVER),
    "converted": (f'{CONVERTED}, tiles = [{{ {PAGED}, format = "yuv16", {CLAMPED} }}]', ENDING),
    "converted RGBA": (f'{CONVERTED}, tiles = [{{ {PAGED}, format = "rgba16", s.wrap = "clamp" }}]',
                       FOR_EVER),
}


def corners(n: int, engine: str) -> str:
    """Vertices of the engine's triangle, with w and shade if the engine reads them."""
    left, top = 3 + GAP * (n % COLUMNS), 2 + GAP * (n // COLUMNS)
    rows = [[left + 0.3, top, -5.3, 3.1], [left + SIDE, top + 1.6, 22.4, -7.7],
            [left + 4.2, top + SIDE, 21.9, 38.2]]
    for row, w, shade in zip(rows, (1, 1.5, 2.1), (255, 30, 128)):
        row += [w] * ("perspective" in engine) + [shade] * ("shade" in engine)
    return f"vertices = {rows}"


def passes_text(pixels: str) -> str:
    """One frame of all engines."""
    lines = -(-len(ENGINES) // COLUMNS)
    engines = [engine for engine, _ in ENGINES.values()]
    text = batch_text(GAP * COLUMNS + 6, GAP * lines + 4, pixels, engines)
    for n, engine in enumerate(engines):
        text += f'[[objects]]\nmaterial = "m{n}"\n{corners(n, engine)}\n'
    return text


def pages_text(pixels: str) -> str:
    """Polygons of one engine are beside each other, drawn one after the other; each engine has a
    separate row of cells."""
    columns = max(len(ranges) for _, ranges in PAGES.values())
    engines = [engine for engine, _ in PAGES.values()]
    text = batch_text(PAGE * columns, PAGE * len(PAGES), pixels, engines)
    for n, (_, ranges) in enumerate(PAGES.values()):
        for k, (low, high) in enumerate(ranges):
            left, top = PAGE * k + 1, PAGE * n + 1
            rows = [[left, top, -1.3, low], [left + 37, top + 4.6, 13.4, low + 0.4],
                    [left + 9, top + 37.2, 5.5, high]]
            text += f'[[objects]]\nmaterial = "m{n}"\nvertices = {rows}\n'
    return text


@pytest.fixture(scope="module")
def drawn(tmp_path_factory):
    """By frame format and kind: a scene of all engines and its result, from one boot."""
    folders = [tmp_path_factory.mktemp(name) for name in ("passes", "pages")]
    for folder, seed, size in zip(folders, (9, 6), ((16, 16), (16, 12))):
        save_noise(folder, seed, noise=size)
    asked = {(pixels, text_of): Asked(compiled(folder, text_of(pixels)))
             for folder, text_of in zip(folders, (passes_text, pages_text)) for pixels in PIXELS}
    return dict(zip(asked, zip(asked.values(), guest_runs.draw([*asked.values()]))))


@pytest.mark.parametrize("pixels", PIXELS)
def test_passes_are_the_models(drawn, pixels):
    """Each triangle is the model's, and is drawn by passes only if it should be."""
    asked, done = drawn[pixels, passes_text]
    places = {name: (GAP * (n % COLUMNS), GAP * (n // COLUMNS)) for n, name in enumerate(ENGINES)}
    frame, = guest_runs.check(f"{pixels}; from these pixels on {places}", asked, done)
    for (name, (left, top)), (_, by_passes), material in zip(places.items(), ENGINES.values(),
                                                             done.executed):
        part = frame[top:top + GAP, left:left + GAP]
        assert len(np.unique(part)) > 20, f"{name}: hardly any colours"
        spans = list(material["spans"])
        assert spans == [("n64_pixels", "n64_passes")[by_passes]], f"{name}: drawn by {spans}"


@pytest.mark.parametrize("pixels", PIXELS)
def test_rows_of_pages_are_made_as_they_are_needed(drawn, pixels):
    """The pictures are the model's, drawn by the plain mappers alone."""
    asked, done = drawn[pixels, pages_text]
    guest_runs.check(f"{pixels}; {PAGE} lines each of {', '.join(PAGES)}", asked, done)
    for name, material in zip(PAGES, done.executed):
        spans = list(material["spans"])
        assert spans and all(span.startswith("affine") for span in spans), f"{name}: by {spans}"
