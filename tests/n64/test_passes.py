"""Which polygons of a texture engine are drawn by passes, and that they are the model's: YUV in its
modes, texels written directly to 16-bit pixels, the second cycle's texel alone."""

import numpy as np
import pytest
from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.engine_scenes import compiled, many_text, save_noise

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


def corners(n: int, engine: str) -> str:
    """Vertices of the engine's triangle, with w and shade if the engine reads them."""
    left, top = 3 + GAP * (n % COLUMNS), 2 + GAP * (n // COLUMNS)
    rows = [[left + 0.3, top, -5.3, 3.1], [left + SIDE, top + 1.6, 22.4, -7.7],
            [left + 4.2, top + SIDE, 21.9, 38.2]]
    for row, w, shade in zip(rows, (1, 1.5, 2.1), (255, 30, 128)):
        row += [w] * ("perspective" in engine) + [shade] * ("shade" in engine)
    return f"vertices = {rows}"


@pytest.fixture(scope="module")
def drawn(tmp_path_factory):
    """By frame format: a scene of all engines and its result, from one boot."""
    folder = tmp_path_factory.mktemp("passes")
    save_noise(folder, 9, noise=(16, 16))
    asked = {pixels: Asked(compiled(folder, text_of(pixels))) for pixels in PIXELS}
    return dict(zip(asked, zip(asked.values(), guest_runs.draw([*asked.values()]))))


def text_of(pixels: str) -> str:
    """One frame of all engines."""
    lines = -(-len(ENGINES) // COLUMNS)
    text = many_text(GAP * COLUMNS + 6, GAP * lines + 4, pixels, (engine for engine, _ in ENGINES.values()))
    for n, (engine, _) in enumerate(ENGINES.values()):
        text += f'[[objects]]\nmaterial = "m{n}"\n{corners(n, engine)}\n'
    return text


@pytest.mark.parametrize("pixels", PIXELS)
def test_passes_are_the_models(drawn, pixels):
    """Each triangle is the model's, and is drawn by passes only if it should be."""
    asked, done = drawn[pixels]
    places = {name: (GAP * (n % COLUMNS), GAP * (n // COLUMNS)) for n, name in enumerate(ENGINES)}
    frame, = guest_runs.check(f"{pixels}; from these pixels on {places}", asked, done)
    for (name, (left, top)), (_, by_passes), material in zip(places.items(), ENGINES.values(),
                                                             done.executed):
        part = frame[top:top + GAP, left:left + GAP]
        assert len(np.unique(part)) > 20, f"{name}: hardly any colours"
        spans = list(material["spans"])
        assert spans == [("n64_pixels", "n64_passes")[by_passes]], f"{name}: drawn by {spans}"
