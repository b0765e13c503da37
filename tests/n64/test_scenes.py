"""Scenes with texture engines: valid TOML, its compiled form, and the guest's frames."""

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.n64.texts import ONE, SQUARE, TILE, make, scene_of
from tests.helpers.engine_scenes import HEAD, check_refused, folder, shown  # noqa: F401
from tmap.base.errors import UserError
from tmap.base.paths import ROOT, SCENES
from tmap.compiler.n64 import TEXELS
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.n64 import images
from tmap.run import run
from tmap.scene_file import scene_file, units

NAMES = ("n64_room", "n64_wall", "n64_ocean", "n64_floor", "n64_palettes", "n64_yuv", "n64_rectangles")
MOVING = ("n64_ocean", "n64_palettes")  # with a display list for each frame


def test_frames_are_the_models() -> None:
    """With all rules of lowering, two frames if lists run each frame; the middle of the first without rules."""
    asked = {}
    for name in NAMES:
        for off, frames in ((None, 1 + (name in MOVING)), ("all", 1)):
            scene = shown(name, off) if off else compile_scene(SCENES / f"{name}.toml", frames)
            asked[guest_runs.command(name, frames, off)] = Asked(scene, off, counted=False)
    guest_runs.check_all(asked, colours=30)


def test_a_frame_of_one_colour_fails():
    """A frame of one colour is an error if the model shows more."""
    scene = compile_scene(SCENES / "n64_wall.toml", 1)
    empty = np.full((scene.height, scene.width), scene.background, np.uint16)
    with pytest.raises(UserError, match="frame 0: one colour only"):
        run.check_frame(empty, scene, 0)


@pytest.mark.parametrize("texels", TEXELS)
@pytest.mark.parametrize("load", ["block", "tile"])
def test_every_format_shows_its_picture(folder, texels, load):
    """One texel a pixel: the expected picture is read back by tmap.n64.images, which uses neither
    display lists nor TMEM."""
    side = 16 if texels == "yuv16" else 32 if texels != "rgba32" else 16
    tile = (f'image = "noise.png", format = "{texels}", width = {side}, height = {side}, '
            f'load = "{load}"')
    more = 'convert = "convert", combine = "convert", ' if texels == "yuv16" else ""
    scene = make(folder, f"{more}tiles = [{{ {tile} }}]")
    scene_file.write(scene)
    picture = images.read("noise.png", folder, "x", side, side)
    expected = images.decode(images.encode(picture, *TEXELS[texels]))
    found = scene.pixel.colours(model.render(scene, 0)[:side, :side])
    assert np.array_equal(found, expected)


def test_odd_sizes_and_parts(folder):
    """A clamped tile of 20 columns, whose rows end in the middle of a word, from 2 texels on."""
    tile = ('image = "odd.png", format = "i4", s = { wrap = "clamp", low = 2 }, '
            't = { wrap = "clamp", low = 2 }')
    scene = make(folder, f"tiles = [{{ {tile} }}]")
    picture = images.read("odd.png", folder, "x", 24, 20)
    full = images.decode(images.encode(picture, *TEXELS["i4"]))
    found = scene.pixel.colours(model.render(scene, 0)[:32, :32])
    at = (np.arange(32) - 2).clip(0)
    assert np.array_equal(found, full[at.clip(0, 19)][:, at.clip(0, 23)])


def test_a_tile_slides_and_palettes_change(folder):
    """The tile slides by whole texels: each frame is the first one, moved. Palettes follow the
    frame."""
    scene = make(folder, f"tiles = [{{ {TILE}, slide = [3, -2] }}]", frames=40)
    first = model.render(scene, 0)[:32, :32]
    for number in (1, 7, 39):
        moved = np.roll(first, (-2 * number, 3 * number), (0, 1))
        assert np.array_equal(model.render(scene, number)[:32, :32], moved), number
    tile = 'image = "noise.png", format = "ci4", colours = 0, palette = [0, 5]'
    scene = make(folder, f'palettes = "palettes.png", tiles = [{{ {tile} }}]', frames=4)
    frames = [model.render(scene, number) for number in range(4)]
    assert np.array_equal(frames[0], frames[2]) and np.array_equal(frames[1], frames[3])
    colours = images.to_rgba16(images.read("palettes.png", folder, "x", 16, 16))
    for number, row in ((0, 0), (1, 5)):
        shown = scene.pixel.colours(frames[number][:32, :32]).reshape(-1, 4)
        assert {int(n) for n in images.to_rgba16(shown[None])[0]} <= set(colours[row].tolist())


def test_levels_are_means(folder):
    """Level 2 drawn alone: each texel covers 4x4 texels of the picture, and differs from their mean
    by two roundings and 5 bits of quantisation: at most 2 * 0.5 + 255 / 62."""
    scene = make(folder, f"tile = 2, tiles = [{{ {TILE}, levels = 4 }}]")
    found = scene.pixel.colours(model.render(scene, 0)[:32, :32])[..., :3].astype(float)
    picture = images.read("noise.png", folder, "x", 32, 32)[..., :3].astype(float)
    mean = picture.reshape(8, 4, 8, 4, 3).mean((1, 3))
    assert np.array_equal(found, np.kron(found[::4, ::4], np.ones((4, 4, 1))))
    assert abs(found[::4, ::4] - mean).max() <= 1 + 255 / 62


def test_equal_engines_and_texels_are_there_once(folder):
    """Two materials share one engine; tiles share DRAM and TMEM."""
    engine = f"cycles = 2, combine = 'interference', tiles = [{{ {TILE} }}, {{ {TILE}, s.shift = 1 }}]"
    text = scene_of(engine) + SQUARE.replace("vertices", '[[objects]]\nmaterial = "other"\nvertices')
    other = f'[materials.other]\nedges = "exact"\nn64 = {{ {engine} }}\n'
    (folder / "scene.toml").write_text(text.replace("[[objects]]", other + "[[objects]]", 1))
    scene = compile_scene(folder / "scene.toml")
    assert [m.unit for m in scene.materials] == [0, 0] and len(scene.units) == 1
    assert [m.edges for m in scene.materials] == ["exact", "exact"]
    assert len(scene.dram) == 32 * 32 * 2
    tiles = units.state_at(scene, 0, 0).tiles
    assert tiles[0].tmem == tiles[1].tmem == 0 and tiles[1].s.shift == 1


def test_tiles_have_places_of_their_own(folder):
    """Split texels are in both halves, others where there is room, and one at its given place."""
    kinds = ['format = "i8", height = 8, width = 16', 'format = "rgba32", height = 8, width = 8',
             'format = "ia16", height = 8, tmem = 40', 'format = "i4", height = 16']
    tiles = ", ".join(f'{{ image = "noise.png", {kind} }}' for kind in kinds)
    scene = make(folder, f"tiles = [{tiles}]")
    found = units.state_at(scene, 0, 0).tiles
    assert [tile.tmem for tile in found[:4]] == [16, 0, 40, 104]
    assert [tile.line for tile in found[:4]] == [2, 2, 8, 2]


def one(tile: str) -> str:
    return f"tiles = [{{ {tile} }}]"


def two(tile: str, other: str = TILE) -> str:
    return f"tiles = [{{ {tile} }}, {{ {other} }}]"


CI = 'image = "noise.png", format = "ci4"'
MESSAGES = [
    ("cycles = 3, " + ONE, "cycles: must be from 1 to 2"),
    ("mode = 1, " + ONE, "mode: unknown field; known are cycles, combine, "),
    ("combine = 'decals', " + ONE, "combine: 'decals' is not one of primitive, shade, decal, "),
    ("combine = ['decal', 'pass'], " + ONE, 'combine: has two cycles: "cycles" must be 2'),
    ("combine = { rgb = [['noise', '0', '0', '0']], alpha = [['0', '0', '0', '0']] }, " + ONE,
     "combine.rgb[0][0]: 'noise' is no input A; known are combined, texel0"),
    ("combine = { rgb = [['0', '0', '0', '0']], alpha = [['0', '0', '0']] }, " + ONE,
     "combine.alpha[0]: must have 4 entries, not 3"),
    ("combine = { rgb = [['0', '0', '0', '0']], alpha = [['0', '0', '0', 'k5']] }, " + ONE,
     "combine.alpha[0][3]: 'k5' is no input D"),
    ("lod = true, " + ONE, 'lod: the level of detail needs "cycles" 2'),
    ("convert = 'filter, convert', " + ONE, 'convert: "filter, convert" needs "cycles" 2'),
    ("k = [1, 2, 3], " + ONE, "k: must have 6 entries, not 3"),
    ("primitive = '#12', " + ONE, 'primitive: must be a colour like "#8040ff"'),
    ("filter = 'bilinear', " + ONE, "filter: 'bilinear' is not one of point, bilerp, average"),
    ("perspective = 1, " + ONE, "perspective: must be true or false"),
    ("tlut = 'ia16', " + ONE, 'tlut: "ia16", but no tile is CI'),
    ("palettes = 'palettes.png', " + ONE, "palettes: there is no tile that is CI"),
    ("tile = 1, " + ONE, "tiles: tile 1 would be drawn; there are tiles 0 to 0"),
    ("cycles = 2, combine = 'trilinear', " + ONE,
     "tiles: tile 1 would be drawn; there are tiles 0 to 0"),
    ("cycles = 2, lod = true, max_level = 2, " + two(TILE),
     "tiles: tile 2 would be drawn; there are tiles 0 to 1"),
    ("tiles = []", "tiles: must have 1 to 8 entries, not 0"),
    (two(TILE, TILE.replace("rgba16", "rgba8")),
     "tiles[1].format: 'rgba8' is not one of rgba16, rgba32, yuv16, ci4, ci8, ia4"),
    (two(TILE, CI), 'tiles[1].format: "ci4": with a TLUT all tiles are CI, without it none'),
    ("tlut = 'none', " + one(CI), 'tlut: "none", but tiles[0] is ci4'),
    (two(CI, CI.replace("ci4", "ci8")),
     'palettes: is missing: "ci4" and "ci8" tiles share one TLUT'),
    (one(CI + ", palette = [0, 3]"), "tiles[0].palette: palette 3 has no colours"),
    ("palettes = 'half.png', " + one(CI + ", colours = 9"),
     "tiles[0].colours: half.png has no row 9"),
    ("palettes = 'odd.png', " + one(CI),
     "palettes: odd.png: 24x20 pixels; palettes are 1 to 16 rows of 16"),
    (one(TILE + ", palette = 1"), 'tiles[0].palette: is for "ci4", not "rgba16"'),
    (one("image = 'no.png', format = 'i8'"), "tiles[0].image: no.png: no such file"),
    (one("image = 'wide.png', format = 'i8'"),
     "tiles[0].image: wide.png: 1030x4 pixels; a tile has 1024x256 texels at most"),
    (one("image = 'odd.png', format = 'i8'"),
     'tiles[0].s.wrap: "wrap", but 24 texels are not a power of two'),
    (one(TILE + ", s.mask = 6"), "tiles[0].s.mask: the tile shows 64 texels, its picture has 32"),
    (one(TILE + ", t = { wrap = 'clamp', high = 40 }"),
     "tiles[0].t.high: the tile shows 41 texels, its picture has 32"),
    (one(TILE + ", t = { wrap = 'clamp', low = 9, high = 4 }"), "tiles[0].t.high: lies before low"),
    (one(TILE + ", s = { low = 1000 }"),
     "tiles[0].s.low: the tile would end at 1031; 1023.75 at most"),
    (one(TILE + ", s.wrap = 'clamp', slide = [1, 0]"),
     "tiles[0].slide: s clamps; only what wraps or mirrors can slide"),
    (one(TILE + ", width = 24, levels = 2"), "tiles[0].levels: 24x32 texels are not powers of two"),
    (one(TILE + ", levels = 7"), "tiles[0].levels: 32x32 texels have 6 levels"),
    (two(TILE + ", levels = 5", TILE + ", levels = 4"),
     "tiles[1].levels: makes 9 tiles; an engine has 8"),
    (one(TILE + ", levels = 4, s.shift = 9"), "tiles[0].s.shift: is more than 10 at level 2"),
    (one(TILE + ", width = 64, height = 40, load = 'block', t.wrap = 'clamp'"),
     "tiles[0]: TMEM is full: 64x40 texels of rgba16 need 640 words; free are 512"),
    ("tiles = [{ image = 'noise.png', format = 'i4', width = 176, height = 40, load = 'block', "
     "s.wrap = 'clamp', t.wrap = 'clamp' }]",
     'tiles[0].load: "block", but 176x40 texels are too many, or their rows drift; "tile" can '
     "load them"),
    (two(TILE + ", tmem = 400"),
     "tiles[0]: TMEM is full: 32x32 texels of rgba16 need 256 words at word 400; free are 512"),
    (two("image = 'noise.png', format = 'rgba32', width = 64, height = 16",
         "image = 'odd.png', format = 'rgba32', s.wrap = 'clamp', t.wrap = 'clamp'"),
     "tiles[1]: TMEM is full: 24x20 texels of rgba32 need 120 words in each half; free are 0 "
     "there"),
    (one(CI.replace("ci4", "ci8") + ", width = 64, height = 64"),
     "tiles[0]: TMEM is full: 64x64 texels of ci8 need 512 words; free are 256 there"),
]


@pytest.mark.parametrize("engine, message", MESSAGES)
def test_refused(folder, engine, message):
    check_refused(folder, scene_of(engine), f"materials.it.n64.{message}")


def test_old_words_name_the_new_ones(folder):
    """A table ``tx`` and the mapper "unit" are from older scene files."""
    text = scene_of(f"tiles = [{{ {TILE} }}]")
    check_refused(folder, text.replace("n64 = {", "tx = {"), "materials.it.tx: is called n64 now")
    check_refused(folder, text.replace("n64 = {", 'mapper = "unit", n64 = {'),
                  'materials.it.mapper: "unit" is called "n64" now')


@pytest.mark.parametrize("kinds, message", [
    ({"pixels": "rgb565"}, "materials.it.n64: a scene in rgb565 has no texture engine of this kind; "
                           "one in rgba5551 or rgba8888 has"),
    ({"pixels": "chunky"}, "materials.it.n64: a scene in chunky has no texture engine of this kind"),
    ({"more": 'edges = "integer", '}, 'materials.it.edges: "integer" is not for a texture engine'),
    ({"more": 'gradients = "scanline", '}, "materials.it.gradients: is not for a texture engine"),
    ({"more": 'perspective = "fine", '}, "materials.it.perspective: "),
    ({"more": 'mapper = "affine", '}, "materials.it.mapper: 'affine' is not one of n64"),
    ({"obj": SQUARE.replace("32, 0]", "32, 0, 1]")},
     "objects[0].vertices[1]: must be [x, y, s, t]"),
    ({"obj": SQUARE.replace("32, 0]", "1200, 0]")},
     "objects[0].vertices: s must be from -1024 to 1023.96875 texels"),
    ({"obj": "vertices = [[0, 0, 0, -600], [32, 0, 32, 0], [32, 32, 32, 500]]"},
     "objects[0].vertices: t of two corners: 1024 texels apart or more"),
])
def test_refused_besides(folder, kinds, message):
    """Values that do not fit the scene, the material or the vertices."""
    check_refused(folder, scene_of(ONE, **kinds), message)


def test_the_pages_example(folder):
    """The example compiles, and its vertices are as the page describes."""
    text = (ROOT / "c" / "n64" / "README.md").read_text()
    example = text.split("```")[1].removeprefix("toml")
    example = example.replace("n64/pavement.png", "noise.png")
    corners = [[0, 0, 0, 0, 4, 0], [64, 0, 90, 0, 4, 255], [64, 48, 90, 90, 1, 255]]
    (folder / "scene.toml").write_text(
        HEAD.format(frames=2, pixels="").replace('format = ""', "") + example
        + f'[[objects]]\nmaterial = "floor"\nvertices = {corners}\n')
    scene = compile_scene(folder / "scene.toml")
    frames = [model.render(scene, number) for number in range(2)]
    assert len(np.unique(frames[0])) > 100 and (frames[0] != frames[1]).any()


def test_vertices_have_what_the_engine_takes(folder):
    """w with perspective, a shade from 0 to 255 if the combiner reads it."""
    corners = [[0, 0, 0, 0, 1, 0], [32, 0, 32, 0, 2, 255], [32, 32, 32, 32, 2, 255]]
    engine = "perspective = true, combine = 'modulate', " + ONE
    scene = make(folder, engine, f"vertices = {corners}")
    assert scene.vertices[:, 4:].tolist() == [[32768, 65536], [255 * 65536 + 32768, 131072],
                                              [255 * 65536 + 32768, 131072]]
    corners[1][5] = 256
    with pytest.raises(UserError, match=r"vertices\[1\]\[5\]: must be from 0 to 255"):
        make(folder, engine, f"vertices = {corners}")
    scene = make(folder, "combine = 'modulate', " + ONE, "sides = 4\nradius = 20")
    assert set(scene.vertices[:, 4].tolist()) == {255 * 65536 + 32768}
    assert scene.vertices[:, 2].max() == 32 << 16  # the whole picture
