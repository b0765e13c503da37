"""Materials and textures of scenes: the compiler's output and its error messages."""

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from tests.helpers.refusals import without_line
from tmap.base import maps
from tmap.base.errors import UserError
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material

ONE = 65536
HEAD = """\
width = 64
height = 48
frames = 2
background = "#102030"
[textures]
square.image = "wall.png"
small = {image = "wall.png", width = 16, height = 8}
odd = {image = "wall.png", width = 100, height = 60}
tall = {image = "wall.png", width = 128, height = 2048}
[materials]
"""
TRIANGLE = """
[[objects]]
material = "it"
sides = 3
radius = 10
"""


@pytest.fixture
def folder(tmp_path):
    """A directory with a picture: left half dark, right half bright."""
    pixels = np.zeros((40, 60, 3), np.uint8)
    pixels[:, 30:] = (200, 220, 240)
    Image.fromarray(pixels).save(tmp_path / "wall.png")
    return tmp_path


def make(folder, material: str, objects: str = TRIANGLE, head: str = HEAD):
    (folder / "scene.toml").write_text(f"{head}it = {{{material}}}\n{objects}")
    return compile_scene(folder / "scene.toml")


def refusal(folder, *text: str) -> str:
    with pytest.raises(UserError) as caught:
        make(folder, *text)
    return without_line(str(caught.value), folder / "scene.toml").removeprefix(str(folder) + "/scene.toml: ")


def shaped(line: str, sides: int = 3) -> str:
    """The object with another number of sides and one more line."""
    return TRIANGLE.replace("sides = 3", f"sides = {sides}") + line


def listed(vertices: str) -> str:
    """The object as a list of vertices."""
    return f'[[objects]]\nmaterial = "it"\nvertices = {vertices}\n'


FLAT, RAMP = 'colour = "#ff0000"', 'shades = ["#000000", "#ff8000"]'
SQUARE = "[[0, 0, 0, 0], [8, 0, {0}, 0], [8, 8, {0}, {1}], [0, 8, 0, {1}]]"
HEAD_16 = HEAD.replace("frames", 'format = "rgb565"\nframes')
HEAD_32 = HEAD.replace("frames", 'format = "rgba8888"\nframes')


@pytest.mark.parametrize("text, material", [
    (FLAT, Material("flat", "snapped", colour=1)),
    (FLAT + ', edges = "exact", gradients = "polygon", start = "truncated"',
     Material("flat", "exact", "polygon", "truncated", colour=1)),
    (RAMP + ', edges = "integer"', Material("gouraud", "integer")),
    (FLAT + ', clip = "vertices"', Material("flat", "snapped", clip="vertices", colour=1)),
    ('texture = "square"', Material("affine", "snapped", texture=0)),
    ('texture = "square", gradients = "scanline"', Material("affine", "exact", gradients="scanline", texture=0)),
    ('texture = "small", mapper = "columns"', Material("columns", "exact", texture=0)),
    ('texture = "odd", mapper = "arbitrary"', Material("arbitrary", "exact", texture=0)),
    ('texture = "square", mapper = "tiled"', Material("tiled", "exact", texture=0)),
    ('texture = "square", mapper = "generated"', Material("generated", "exact", texture=0)),
    ('texture = "tall", mapper = "columns"', Material("columns", "exact", texture=0)),
    ('texture = "small", mapper = "lit", gradients = "scanline"',
     Material("lit", "exact", gradients="scanline", texture=0, light=1)),
    ('texture = "square", mapper = "lit_gouraud"', Material("lit_gouraud", "snapped", texture=0, light=1)),
    ('texture = "small", mapper = "dithered"', Material("dithered", "exact", texture=0)),
])
def test_settings(folder, text, material):
    made = make(folder, text)
    if material.light >= 0:
        assert made.textures.pop().layout == "light"
    assert made.materials == [material]
    if material.texture >= 0:
        assert [texture.layout for texture in made.textures] == [
            scene_file.MAPPER_LAYOUT[material.mapper]]


def test_a_texture_is_stored_once_a_layout(folder):
    more = "".join(f'm{n} = {{texture = "square", mapper = "{mapper}"}}\n' for n, mapper in
                   enumerate(("tiled", "affine", "columns", "affine", "tiled")))
    made = make(folder, 'texture = "small"', head='pages = "own"\n' + HEAD + more)
    assert [texture.layout for texture in made.textures] == ["page", "tiled", "columns", "page"]
    assert [m.texture for m in made.materials] == [1, 0, 2, 0, 1, 3]
    assert made.textures[3].texels.shape == (8, 16)
    for texture in made.textures[:3]:
        assert made.palette[texture.texels[128, 10]].tolist() == [0, 0, 0]
        assert made.palette[texture.texels[128, 245]].tolist() == [200, 220, 240]


def test_ramp(folder):
    again = f"same = {{{RAMP}, steps = 5}}\nother = {{{RAMP}}}\n"
    made = make(folder, RAMP + ", steps = 5", head=HEAD + again)
    assert made.palette[1:6].tolist() == [[0, 0, 0], [64, 32, 0], [128, 64, 0], [191, 96, 0],
                                          [255, 128, 0]]
    assert made.palette[6:70, 0].tolist() == [round(255 * n / 63) for n in range(64)]
    assert made.vertices[:, 4].tolist() == [3 * ONE // 2, 11 * ONE // 2, 3 * ONE // 2]


def test_shades_of_corners(folder):
    steps = RAMP + ", steps = 128"
    at = [(1 * 2 + 1) * ONE // 2, (128 * 2 + 1) * ONE // 2]  # middles of first and last entry
    cyclic = make(folder, steps, shaped("shades = [255, 0]")).vertices[:, 4].tolist()
    assert cyclic == [at[1], at[0], at[1]]
    down = make(folder, steps, shaped("", sides=6)).vertices[:, 4].tolist()
    assert (down[0], down[3]) == tuple(at) and down[1] == down[5] and down[2] == down[4]
    given = make(folder, steps, listed("[[0, 0, 0], [8, 0, 255], [0, 8, 0]]")).vertices
    assert given[:, 4].tolist() == [at[0], at[1], at[0]]
    plane = make(folder, steps, shaped("shades = [0, 0, 255, 255]", sides=4)).vertices
    assert plane[:, 4].tolist() == [at[0], at[0], at[1], at[1]]


def test_ramp_is_drawn_by_the_model(folder):
    """The model draws all of the ramp, in its order, and nothing else."""
    square = listed("[[4, 4, 0], [60, 4, 255], [60, 40, 255], [4, 40, 0]]")
    made = make(folder, RAMP + ", steps = 9", square)
    row = model.render(made, 0)[20].tolist()
    assert row[:4] == [0] * 4 and row[60:] == [0] * 4
    assert row[4:60] == sorted(row[4:60]) and set(row[4:60]) == set(range(1, 10))


def test_small_maps_repeat(folder):
    """s, t of a 16x8 map run to 256, 128; the model draws it as texels[t % 8, s % 16]."""
    square = listed("[[0, 0, 0, 0], [64, 0, 1024, 0], [64, 48, 1024, 768], [0, 48, 0, 768]]")
    made = make(folder, 'texture = "small"', square)
    (texture,) = made.textures
    assert np.array_equal(model.render(made, 0), np.tile(texture.texels, (6, 4)))


@pytest.mark.parametrize("name, extent", [("small", (256, 128)), ("odd", (256, 153.6)),
                                          ("tall", (16, 256))])
def test_sides_show_the_whole_map(folder, name, extent):
    mapper = "affine" if name == "small" else "columns" if name == "tall" else "arbitrary"
    made = make(folder, f'texture = "{name}", mapper = "{mapper}"', shaped("", sides=4))
    s, t = (made.vertices[:, column] / ONE for column in (2, 3))
    assert abs(s.min()) < 1e-4 and abs(s.max() - extent[0]) < 1e-4
    assert abs(t.min()) < 1e-4 and abs(t.max() - extent[1]) < 1e-4


def test_arbitrary_maps_are_not_left(folder):
    """Rounding to 16.16 does not move a corner off the map."""
    for width in range(1, 1025, 31):
        head = HEAD.replace("width = 100", f"width = {width}")
        text = SQUARE.format(256 * width / max(width, 60), 256 * 60 / max(width, 60))
        scene_file.write(make(folder, 'texture = "odd", mapper = "arbitrary"', listed(text), head))


def test_light_of_corners(folder):
    """Each level has four shades. Each pixel is its texel in the light table's row of that level;
    at full light a lit map is unchanged, at none it is black. (That rows are the nearest colours is
    tested elsewhere.)"""
    light = 'texture = "square", mapper = "{0}"'
    corners = listed("[[0, 0, 0, 0, {0}], [64, 0, 256, 0, {0}], [64, 48, 256, 192, {0}], "
                     "[0, 48, 0, 192, {0}]]")
    for mapper in "lit", "lit_gouraud":
        for shade, level in ((255, 63), (0, 0), (127, 31), (128, 32)):
            made = make(folder, light.format(mapper), corners.format(shade))
            assert set(made.vertices[:, 4].tolist()) == {shade * ONE + ONE // 2}
            found, rows = model.render(made, 0), made.textures[made.materials[0].light].texels
            texels = model.render(replace(made, materials=[Material("affine", texture=0)]), 0)
            drawn = np.s_[:48, :64]
            assert (found[drawn] == rows[level, texels[drawn]]).all()
            assert len(np.unique(texels[drawn])) > 4
            if level == 63:
                assert (found == texels).all()
            elif not level:
                assert (made.palette[found[drawn]] == 0).all()
    sides = make(folder, light.format("lit"), shaped("", 5)).vertices[:, 4].tolist()
    assert set(sides) == {255 * ONE + ONE // 2}  # the default: full light


def test_rgb565(folder):
    made = make(folder, 'texture = "small", mapper = "columns"',
                head=HEAD_16 + 'red.colour = "#ff0000"\n')
    assert (made.format, made.background) == ("rgb565", 0x1106)
    assert made.materials == [Material(edges="exact", colour=0xF800), Material("columns", "exact", texture=0)]
    texels = made.textures[0].texels
    assert texels.dtype == np.uint16 and maps.from_rgb565(texels[4, 2]).tolist() == [0, 0, 0]
    assert abs(maps.from_rgb565(texels[4, 13]).astype(int) - [200, 220, 240]).max() <= 4


@pytest.mark.parametrize("name, background, red, white", [
    ("rgba5551", 2 << 11 | 4 << 6 | 6 << 1 | 1, 0xF801, 0xFFFF),
    ("rgba8888", 0x102030FF, 0xFF0000FF, 0xFFFFFFFF)])
def test_formats_with_alpha(folder, name, background, red, white):
    """Colours are opaque; a texture keeps its alpha."""
    picture = np.full((8, 8, 4), 255, np.uint8)
    picture[4:, :, 3] = 0
    Image.fromarray(picture).save(folder / "alpha.png")
    head = HEAD_32.replace("rgba8888", name).replace(
        "[textures]", '[textures]\nalpha = {image = "alpha.png", width = 8, height = 8}', 1)
    made = make(folder, 'texture = "alpha"', head=head + 'red.colour = "#ff0000"\n')
    assert (made.format, made.background) == (name, background)
    assert made.materials == [Material("flat", "snapped", colour=red), Material("affine", "snapped", texture=0)]
    texels = made.textures[0].texels
    assert texels.dtype == made.pixel.dtype and (texels[:4] == white).all()
    assert not (texels[4:] & (1 if name == "rgba5551" else 255)).any()


def test_16_bit_frames_of_the_model(folder):
    made = make(folder, FLAT, listed("[[0, 0], [8, 0], [8, 8], [0, 8]]"), HEAD_16)
    frame = model.render(made, 0)
    assert frame.dtype == np.uint16 and (frame[:8, :8] == 0xF800).all()
    assert (frame[8:] == 0x1106).all()


@pytest.mark.parametrize("text, message", [
    (["mapper = 3"], "materials.it: needs exactly one of texture, colour, n64, glide, shades"),
    ([FLAT + ', mapper = "affine"'], "materials.it.mapper: unknown field; known are colour, edges"),
    ([FLAT + ", steps = 4"], "materials.it.steps: unknown field"),
    ([FLAT + ', edges = "sharp"'],
     "materials.it.edges: 'sharp' is not one of integer, subpixel, snapped, exact"),
    ([FLAT + ', gradients = 3'], "materials.it.gradients: must be text, not a number"),
    ([FLAT + ', start = "a\\nb"'], "materials.it.start: must be text on one line"),
    (['texture = "square", mapper = "cubic"'],
     "materials.it.mapper: 'cubic' is not one of affine, arbitrary, tiled, columns, generated, lit, "
     "lit_gouraud, dithered, keyed"),
    (['texture = "odd", mapper = "lit"'], 'materials.it.mapper: "lit" needs sides that are powers'),
    (['texture = "square", mapper = "lit_gouraud", gradients = "polygon"'],
     'materials.it.mapper: "lit_gouraud" needs gradients "plane" and start "subtexel"'),
    (['texture = "square", mapper = "lit_gouraud", start = "truncated"'],
     'materials.it.mapper: "lit_gouraud" needs gradients "plane" and start "subtexel"'),
    (['texture = "square", mapper = "dithered", gradients = "scanline"'],
     'materials.it.mapper: "dithered" needs gradients "plane" and start "subtexel"'),
    (['texture = "square", mapper = "dithered", start = "truncated"'],
     'materials.it.mapper: "dithered" needs gradients "plane" and start "subtexel"'),
    (['texture = "square", mapper = "dithered", perspective = "every16"'],
     'materials.it.perspective: "every16" needs the mapper "affine" or "lit" or "lit_gouraud", '),
    *(([f'texture = "square", mapper = "{mapper}", perspective = "pixel"'],
       'materials.it.perspective: "pixel" needs the mapper "affine" or "lit" or "lit_gouraud", ')
      for mapper in ("arbitrary", "tiled", "columns", "generated")),
    (['shades = ["#000000", "#ffffff"], perspective = "fine"'],
     'materials.it.perspective: "fine" needs the mapper "affine" or "lit" or "lit_gouraud", '),
    (['texture = "square", mapper = "lit", perspective = "fine", start = "truncated"'],
     'materials.it.perspective: "fine" needs the mapper "affine" or "lit" or "lit_gouraud", '),
    (['texture = "square", mapper = "lit", perspective = "pixel"',
      listed("[[0, 0, 0, 0, 9], [8, 0, 9, 0, 9], [8, 8, 1, 1, 9]]")],
     "objects[0].vertices[0]: must be [x, y, s, t, w, shade]"),
    (['texture = "square", perspective = "fine", gradients = "scanline"'],
     'materials.it.perspective: "fine" needs the mapper "affine" or "lit" or "lit_gouraud", '),
    (['texture = "square", perspective = "fine", start = "truncated"'],
     'materials.it.perspective: "fine" needs the mapper "affine" or "lit" or "lit_gouraud", '),
    (['texture = "square", perspective = "hyper"'],
     "materials.it.perspective: 'hyper' is not one of none"),
    (['texture = "square", perspective = "pixel"', listed(SQUARE.format(9, 9))],
     "objects[0].vertices[0]: must be [x, y, s, t, w]"),
    (['texture = "square"', listed("[[0, 0, 0, 0, 1], [8, 0, 9, 0, 1], [8, 8, 1, 1, 1]]")],
     "objects[0].vertices[0]: must be [x, y, s, t]"),
    (['texture = "square", mapper = "keyed", gradients = "scanline"'],
     'materials.it.mapper: "keyed" needs gradients "plane" and start "subtexel"'),
    (['texture = "square", mapper = "keyed", perspective = "pixel"'],
     'materials.it.perspective: "pixel" needs the mapper "affine" or "lit" or "lit_gouraud", '),
    (['texture = "square", mapper = "keyed"', TRIANGLE, HEAD_16], "materials.it.mapper: a scene in rgb565"),
    (['texture = "odd", mapper = "dithered"'],
     'materials.it.mapper: "dithered" needs sides that are powers'),
    (['texture = "square", mapper = "lit"', TRIANGLE, HEAD_16], "materials.it.mapper: a scene in rgb565"),
    (['texture = "square", mapper = "lit"', shaped("shades = [256]")],
     "objects[0].shades[0]: must be from 0 to 255"),
    (['texture = "square", mapper = "lit"', listed("[[0, 0, 0, 0], [8, 0, 9, 0], [8, 8, 1, 1]]")],
     "objects[0].vertices[0]: must be [x, y, s, t, shade]"),
    (['texture = "square", mapper = "lit_gouraud"',
      listed("[[0, 0, 0, 0, 1], [8, 0, 9, 0, 2], [8, 8, 1, 1, 256]]")],
     "objects[0].vertices[2][4]: must be from 0 to 255"),
    ([RAMP.replace("]", ', "#000000"]')], "materials.it.shades: must have 2 entries, not 3"),
    ([RAMP + ", steps = 1"], "materials.it.steps: must be from 2 to 128"),
    ([RAMP + ", steps = 129"], "materials.it.steps: must be from 2 to 128"),
    (['texture = "odd"'], 'materials.it.mapper: "affine" needs sides that are powers of two from '
                          "8 to 256; texture 'odd' is 100x60"),
    (['texture = "tall"'], "texture 'tall' is 128x2048"),
    (['texture = "tall", mapper = "arbitrary"'], '"arbitrary" needs sides from 1 to 1024; '),
    (['texture = "small", mapper = "tiled"'], '"tiled" needs 256x256; texture \'small\' is 16x8'),
    (['texture = "small", mapper = "generated"'], '"generated" needs 256x256; '),
    (['texture = "odd", mapper = "columns"'],
     '"columns" needs sides that are powers of two from 8 and at most 262144 texels; '),
    ([FLAT, TRIANGLE, HEAD.replace("2048", "32768")],
     "textures.tall.width: 128x32768 is more than 1048576 texels"),
    ([FLAT, TRIANGLE, HEAD.replace("2048", "0")], "textures.tall.height: must be from 1 to 32768"),
    ([FLAT, TRIANGLE, HEAD_16.replace("rgb565", "rgb555")],
     "format: 'rgb555' is not one of chunky, rgb565, rgba5551, rgba8888"),
    ([RAMP, TRIANGLE, HEAD_16], "materials.it.shades: a scene in rgb565 has flat colours and the "
                                'mapper "affine" or "columns" or "dithered" only'),
    (['texture = "square", mapper = "tiled"', TRIANGLE, HEAD_16],
     "materials.it.mapper: a scene in rgb565 has"),
    (['texture = "small", mapper = "columns"', TRIANGLE, HEAD_32],
     'materials.it.mapper: a scene in rgba8888 has flat colours and the mapper "affine" or "dithered" only'),
    (['texture = "square", mapper = "dithered", perspective = "every16"', TRIANGLE, HEAD_16],
     'materials.it.perspective: "every16" needs the mapper "affine" or'),
    (['texture = "square", gradients = "polygon"', shaped("", 4)],
     "objects[0].sides: 4 corners, but material 'it' has gradients \"polygon\", which are for"),
    (['texture = "square", gradients = "polygon"', listed(SQUARE.format(9, 9))],
     "objects[0].vertices: 4 corners, but material"),
    ([FLAT + ', clip = "none"'], "materials.it.clip: 'none' is not one of scissor, vertices"),
    ([RAMP + ', gradients = "polygon"', shaped("", 5)], "objects[0].sides: 5 corners, but"),
    ([FLAT, shaped("shades = [1]")], "objects[0].shades: material 'it' has no shades"),
    ([RAMP, shaped("shades = []")], "objects[0].shades: must have 1 to 64 entries, not 0"),
    ([RAMP, shaped("shades = [1, 2, 3, 4]")], "objects[0].shades: must have 1 to 3 entries, not 4"),
    ([RAMP, shaped("shades = [256]")], "objects[0].shades[0]: must be from 0 to 255"),
    ([RAMP, listed("[[0, 0, 0], [8, 0, 9], [8, 8]]")],
     "objects[0].vertices[2]: must be [x, y, shade]"),
    ([RAMP, listed("[[0, 0, 0], [8, 0, 9], [8, 8, -1]]")],
     "objects[0].vertices[2][2]: must be from 0 to 255"),
    ([FLAT, listed("[[0, 0, 0], [8, 0, 9], [8, 8, 1]]")], "objects[0].vertices[0]: must be [x, y, s"),
    (['texture = "odd", mapper = "arbitrary"', shaped("map_radius = 129")],
     'objects[0].map_radius: mapper "arbitrary" does not repeat: s must be from 0 to 256, t from '
     "0 to 153.6"),
    (['texture = "odd", mapper = "arbitrary"', listed(SQUARE.format(256, 154))],
     'objects[0].vertices: mapper "arbitrary" does not repeat'),
    (['texture = "tall", mapper = "columns"', listed("[[0, 0, 0, 0], [8, 0, 2048, 0], [8, 8, 0, 9]]")],
     "objects[0].vertices: s or t is 16384 texels or more from the map's corner"),
])
def test_refused(folder, text, message):
    assert message in refusal(folder, *text)
