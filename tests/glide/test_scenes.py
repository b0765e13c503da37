"""Scenes with Glide's texture units: valid TOML, its compiled form, and the guest's frames."""

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.engine_scenes import check_refused, compiled, folder, scene_text, shown  # noqa: F401
from tmap.glide import images
from tmap.glide.mipmap import levels
from tmap.glide.words import FORMATS
from tmap.model import model
from tmap.n64.images import read
from tmap.scene_file import pipes, scene_file

NAMES = ("dithered", "glide_aspects", "glide_floor", "glide_lightmap", "glide_wall", "glide_window")

SQUARE = "vertices = [[0, 0, 0, 0], [32, 0, 256, 0], [32, 32, 256, 256], [0, 32, 0, 256]]"
UNIT = 'image = "noise.png", format = "rgb565"'
OWN = "st1 = [[0, 0], [8, 0], [8, 8], [0, 8]]"


def text_of(glide: str, obj: str = SQUARE, more: str = "", **kinds) -> str:
    """A scene of one material, one object."""
    return scene_text(f"{more}glide = {{ {glide} }}", obj, **kinds)


def make(folder, *args, **kinds):
    return compiled(folder, text_of(*args, **kinds))


def units(*each: str) -> str:
    return "units = [" + ", ".join(f"{{ {unit} }}" for unit in each) + "]"


def test_frames_are_the_models() -> None:
    """The first frame of each scene, with all rules of lowering and with none."""
    guest_runs.check_all({
        guest_runs.command(name, 1, off): Asked(shown(name, off), off, counted=False)
        for name in NAMES for off in (None, "all")}, colours=30)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("size", [(32, 32), (32, 4), (4, 16)])
def test_every_format_shows_its_picture(folder, form, size):
    """One texel a pixel: the expected picture is read back by tmap.glide.images, which uses neither
    registers nor texture memory."""
    width, height = size
    s, t = (256 * side // max(size) for side in size)
    square = (f"vertices = [[0, 0, 0, 0], [{width}, 0, {s}, 0], [{width}, {height}, {s}, {t}], "
              f"[0, {height}, 0, {t}]]")
    scene = make(folder, units(f'image = "noise.png", format = "{form}", width = {width}, '
                               f"height = {height}"), square)
    scene_file.write(scene)
    chain = levels(read("noise.png", folder, "x", width, height), "box")
    expected = images.decode(images.encode(chain, FORMATS[form]))[0]
    found = scene.pixel.colours(model.render(scene, 0)[:height, :width])
    assert np.array_equal(found, expected)


def test_levels_that_a_unit_shows(folder):
    """From level 5 on: 8 texels for 32 pixels, each four pixels wide."""
    scene = make(folder, units(UNIT + ", min_level = 5, max_level = 6"))
    found = scene.pixel.colours(model.render(scene, 0)[:32, :32])
    chain = levels(read("noise.png", folder, "x", 32, 32), "box")
    expected = images.decode(images.encode(chain, FORMATS["rgb565"]))[2]
    assert np.array_equal(found, np.kron(expected, np.ones((4, 4, 1), np.uint8)))


def test_units_divide_where_they_are_told_to(folder):
    """Two units of one material have different subdivisions, the second its own w: the file has the
    scene's settings. That the guest draws such units as the model does: test_polygons.py."""
    both = units(UNIT + ', combine = { function = "blend", factor = "one_minus_local" }, '
                 'subdivision = 8', UNIT + ", own = true, subdivision = 16")
    deep = SQUARE.replace(", 0]", ", 0, 1]").replace(", 256]", ", 256, 5]") + "\n" + OWN
    scene = make(folder, "perspective = true, " + both, deep + "\nw1 = [1, 6, 9, 2]")
    assert [pipes.unit_of(scene, n).modes.subdivision for n in (0, 1)] == [8, 16]


def test_a_second_unit_has_its_own_coordinates(folder):
    """The first unit shows the second one's colours; the second map is magnified eight times
    more."""
    both = units(UNIT + ', combine = { function = "scale_other", factor = "one" }',
                 UNIT + ", own = true")
    scene = make(folder, both, SQUARE + "\n" + OWN.replace("8", "32"))
    found = scene.pixel.colours(model.render(scene, 0)[:32, :32])
    chain = levels(read("noise.png", folder, "x", 32, 32), "box")
    expected = images.decode(images.encode(chain, FORMATS["rgb565"]))[0][:4, :4]
    assert np.array_equal(found, np.kron(expected, np.ones((8, 8, 1), np.uint8)))
    assert len(scene.vertices) == 8 and scene.objects[0].vertices == 8


def test_large_maps_with_chip_ram_alone(folder):
    """The quads of 256x256 texels, 2 MB, do not fit: texels are filtered while drawing, still by a
    pass, to the same picture, with weights of 4 and 8 bits."""
    asked = {}
    for bits in (4, 8):
        unit = units('image = "noise.png", format = "rgb565", width = 256, height = 256, '
                     f'mipmap = "none", min = "bilinear", mag = "bilinear", weights = {bits}')
        asked[f"weights of {bits} bits"] = Asked(make(folder, unit, SQUARE.replace("256", "250")))
    for name, drawn in guest_runs.check_all(asked, "a1200", 30).items():
        assert drawn.spans == {"glide_passes"}, (name, drawn.spans)


def test_slide(folder):
    """Both units' coordinates move, each at its own speed, and nothing else."""
    both = units(UNIT + ', combine = { function = "blend", factor = "local" }',
                 UNIT + ", own = true")
    scene = make(folder, both, SQUARE + "\n" + OWN + "\nslide = [8, -16]\nslide1 = [0.5, 1]",
                 frames=3)
    corners = scene.vertices.reshape(3, 8, 6)
    moved = np.repeat([[8, -16], [0.5, 1]], 4, axis=0) * 65536
    for age in range(3):
        assert np.array_equal(corners[age, :, 2:4], corners[0, :, 2:4] + age * moved), age
    assert np.array_equal(np.delete(corners, [2, 3], 2), np.delete(corners[[0] * 3], [2, 3], 2))
    assert [(obj.first_frame, obj.poses) for obj in scene.objects] == [(0, 1), (1, 1), (2, 1)]


def test_equal_units_and_texels_are_there_once(folder):
    """Two units of one map: separate rows, one copy of the texels."""
    scene = make(folder, units(UNIT, UNIT))
    assert len(scene.glide_units) == 2 and len(scene.glide_memory) == 4096
    assert pipes.unit_of(scene, 0).memory.size == 4096


MESSAGES = [
    ("units = []", "glide.units: must have 1 to 2 entries, not 0"),
    (units(UNIT, UNIT, UNIT), "glide.units: must have 1 to 2 entries, not 3"),
    ("perspective = 1, " + units(UNIT), "glide.perspective: must be true or false"),
    ('blend = "multiply", ' + units(UNIT), "glide.blend: 'multiply' is not one of replace, add"),
    (units('format = "p8"'), "image: is missing"),
    (units('image = "noise.png", format = "rgb555"'),
     "format: 'rgb555' is not one of rgb332, yiq422"),
    (units('image = "no.png", format = "p8"'), "image: no.png: no such file"),
    (units('image = "odd.png", format = "p8"'),
     "image: odd.png: 24x20 pixels; a map's sides are powers of two up to 256, one "
     "at most 8 times the other"),
    (units('image = "long.png", format = "p8"'), "image: long.png: 64x4 pixels; "),
    (units(UNIT + ", width = 512"), "width: must be from 1 to 256"),
    (units(UNIT + ', mipmap = "cubic"'),
     "mipmap: 'cubic' is not one of none, box, lanczos, kaiser"),
    (units(UNIT + ', mipmap = "none", levels = "even"'), 'mipmap: "none": there is one level only'),
    (units(UNIT + ', min = "trilinear"'), "min: 'trilinear' is not one of point, bilinear"),
    (units(UNIT + ', s = "mirror"'), "s: 'mirror' is not one of wrap, clamp"),
    (units(UNIT + ", lod_bias = 8"), "lod_bias: must be from -8 to 7.75"),
    (units(UNIT + ", lod_bias = 0.3"), "lod_bias: must be a multiple of 1/4"),
    (units(UNIT + ", min_level = 9"), "min_level: must be from 0 to 8"),
    (units(UNIT + ", min_level = 2"), "min_level: 32x32 texels have levels 3 to 8"),
    (units(UNIT + ", min_level = 5, max_level = 4"), "max_level: is below min_level, 5"),
    (units(UNIT + ", detail = { bias = 40 }"), "detail.bias: must be from -32 to 31"),
    (units(UNIT + ", detail = { scale = 8 }"), "detail.scale: must be from 0 to 7"),
    (units(UNIT + ", detail = { max = 2 }"), "detail.max: must be from 0 to 1"),
    (units(UNIT + ', combine = { function = "mix" }'),
     "combine.function: 'mix' is not one of zero, local"),
    (units(UNIT + ', combine = { factor = "half" }'),
     "combine.factor: 'half' is not one of zero, local"),
    (units(UNIT + ", weights = 5"), "weights: must be 4 or 8"),
    (units(UNIT + ", subdivision = 4"), "subdivision: must be 0 or 8 or 16"),
    (units(UNIT + ', levels = "all"'), "levels: 'all' is not one of even, odd"),
    (units(UNIT + ", trilinear = true"),
     'trilinear: needs "levels" even or odd: another unit blends the others in'),
    (units(UNIT + ", own = true"), "own: is for the second unit: the first goes by the vertices"),
    (units(UNIT + ', width = 1, height = 1, levels = "odd"'),
     'levels: "odd": there is level 8 only'),
    (units(UNIT + ", filter = 1"), "filter: unknown field; known are image, "),
]


@pytest.mark.parametrize("glide, message", MESSAGES)
def test_refused(folder, glide, message):
    place = "" if message.startswith("glide.") else "glide.units[0]."
    check_refused(folder, text_of(glide), f"materials.it.{place}{message}")


@pytest.mark.parametrize("kinds, message", [
    ({"pixels": "rgba5551"}, "materials.it.glide: a scene in rgba5551 has no texture engine of "
                             "this kind; one in rgb565 or rgba8888 has"),
    ({"more": 'edges = "integer", '}, 'materials.it.edges: "integer" is not for a texture engine'),
    ({"more": 'mapper = "n64", '}, "materials.it.mapper: 'n64' is not one of glide"),
    ({"obj": SQUARE.replace("32, 0,", "32, 0, 1,")},
     "objects[0].vertices[1]: must be [x, y, s, t]"),
    ({"obj": SQUARE.replace("256", "9000")},
     "objects[0].vertices: s must be above -8192 and below 8192"),
    ({"obj": SQUARE.replace("[0, 0, 0, 0]", "[0, 0, -8000, 0]")},
     "objects[0].vertices: s of two corners: 8192 apart or more"),
    ({"obj": SQUARE + "\n" + OWN},
     "objects[0].st1: material 'it' has no second unit with coordinates of its own"),
    ({"obj": SQUARE + "\nslide1 = [1, 0]"},
     "objects[0].slide1: material 'it' has no second unit with coordinates of its own"),
    ({"obj": SQUARE + "\nslide = [0, 8000]", "frames": 2},
     "objects[0].slide: frame 1: t must be above -8192 and below 8192"),
])
def test_objects_refused(folder, kinds, message):
    """Values that do not fit the scene, the material or the vertices."""
    check_refused(folder, text_of(units(UNIT), **kinds), message)


@pytest.mark.parametrize("obj, message", [
    (SQUARE, "st1: is missing: material 'it' has a unit with coordinates of its own"),
    (SQUARE + "\nst1 = [[0, 0], [8, 0], [8, 8]]", "st1: must have 4 entries, not 3"),
    (SQUARE + "\n" + OWN + "\nw1 = [1, 1, 0, 1]", "w1[2]: must be 1/65536 or more away from 0"),
    (SQUARE + "\n" + OWN.replace("8", "8192"), "st1[1][0]: must be from -8191.99609375 to 8191.99609375"),
])
def test_coordinates_refused(folder, obj, message):
    check_refused(folder, text_of(units(UNIT, UNIT + ", own = true"), obj), f"objects[0].{message}")
