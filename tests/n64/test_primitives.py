"""Rectangles and vertex colours of scenes with texture engines: valid TOML, and its compiled
form."""

from dataclasses import replace

import numpy as np
import pytest

from tests.n64.texts import ONE, SQUARE, TILE, make, scene_of
from tests.helpers.engine_scenes import (HEAD, check_refused, compiled, folder,  # noqa: F401
                                         scene_text)
from tmap.base.errors import UserError
from tmap.base.paths import ROOT
from tmap.compiler.scene import compile_scene, parse
from tmap.guest import emulator
from tmap.model import model
from tmap.n64 import images
from tmap.scene_file import scene_file

SHADED = "combine = 'modulate', " + ONE
COPY = "cycles = 'copy', " + ONE
CORNERS = "vertices = [[0, 0, 0, 0], [32, 0, 32, 0], [32, 32, 32, 32]]"
COLOURS = "colours = ['#ff0000', '#00ff0080', '#0000ff']"
BOX = "rectangle = [4, 6, 24, 22]"


def picture(folder) -> np.ndarray:
    """The noise as shown by RGBA 16, uint8 [32, 32, 4]."""
    return images.decode(images.encode(images.read("noise.png", folder, "x", 32, 32), 0, 2))


def shown(scene, number: int = 0) -> np.ndarray:
    """A frame's colours as drawn by the model, uint8 [48, 64, 4]."""
    return scene.pixel.colours(model.render(scene, number))


@pytest.mark.parametrize("flip", [False, True])
def test_a_rectangle_shows_its_texels(folder, flip):
    """Half a texel a pixel across, two down, from a texel inside the picture."""
    obj = BOX + "\ntexel = [3, 5]\nstep = [0.5, 2]\nflip = " + str(flip).lower()
    scene = make(folder, ONE, obj)
    y, x = np.mgrid[:16, :20]
    s, t = (3 + y // 2, 5 + 2 * x) if flip else (3 + x // 2, 5 + 2 * y)
    assert np.array_equal(shown(scene)[6:22, 4:24], picture(folder)[t % 32, s % 32])
    assert scene.vertices[:, :4].tolist() == [[4 << 16, 6 << 16, 96, 160],
                                              [24 << 16, 22 << 16, 512, 2048]]
    assert scene.materials[0].primitive == ("flipped" if flip else "rectangles")
    scene_file.write(scene)


def test_a_copied_rectangle_shows_its_texels(folder):
    """One texel a pixel, in the frame's own format; the file stores the step of four pixels."""
    scene = make(folder, COPY, BOX + "\ntexel = [-2, 7]", pixels="rgba5551")
    y, x = np.mgrid[:16, :20]
    assert np.array_equal(shown(scene)[6:22, 4:24], picture(folder)[y + 7, (x - 2) % 32])
    assert scene.vertices[1, 2:4].tolist() == [4096, 1024]


def test_rectangles_move_by_whole_pixels(folder):
    """Positions are rounded to the nearest pixel; the texture moves with the rectangle."""
    scene = make(folder, ONE, BOX + "\nmove = [1.4, -0.5]\ncentre = [0.25, 0]", frames=4)
    assert (scene.poses[:, 4:] >> 16).tolist() == [[0, 0], [2, 0], [3, -1], [4, -1]]
    first = shown(scene)[6:22, 4:24]
    assert np.array_equal(shown(scene, 3)[5:21, 8:28], first)


def test_colours_of_corners(folder):
    """Each channel is a byte in the file; a triangle of one colour looks like one of that shade."""
    scene = make(folder, SHADED, CORNERS + "\n" + COLOURS)
    assert [value & 0xFFFFFFFF for value in scene.vertices[:, 4].tolist()] == [
        0xFF0000FF, 0x00FF0080, 0x0000FFFF]
    corner = shown(scene)[1, 2].astype(int)  # near the red one
    assert corner[1] < 40 and corner[2] < 40
    white = "colours = ['#ffffff', '#ffffff', '#ffffff']"
    same = shown(make(folder, SHADED, f"{CORNERS}\n{white}"))
    grey = shown(make(folder, SHADED, CORNERS.replace("]]", ", 255]]").replace("], ", ", 255], ")))
    assert np.array_equal(same, grey)
    round_ = make(folder, SHADED, "sides = 3\nradius = 20\n" + COLOURS)
    assert round_.materials[0].primitive == "coloured"


def test_a_material_of_several_kinds_becomes_several(folder):
    """The materials share one engine; each has a different name in the figures."""
    text = scene_of(SHADED, CORNERS.replace("]]", ", 255]]").replace("], ", ", 255], "))
    for more in (CORNERS + "\n" + COLOURS, CORNERS + "\n" + COLOURS, "sides = 5\nradius = 9"):
        text += f'[[objects]]\nmaterial = "it"\n{more}\n'
    scene = compiled(folder, text)
    assert [(m.primitive, m.unit) for m in scene.materials] == [("polygons", 0), ("coloured", 0)]
    assert [o.material for o in scene.objects] == [0, 1, 1, 0]
    assert len(scene.units) == 1
    assert list(parse(folder / "scene.toml")["materials"]) == ["it", "it (coloured)"]


def rectangle(more: str = "", box: str = BOX) -> str:
    return f"{box}\n{more}"


@pytest.mark.parametrize("engine, obj, message", [
    (ONE, rectangle(box="rectangle = [4, 6, 4, 22]"), "rectangle: is empty: "),
    (ONE, rectangle(box="rectangle = [4, 6, 8]"), "rectangle: must have 4 entries, not 3"),
    (ONE, rectangle(box="rectangle = [4, 6, 8.5, 9]"), "rectangle[2]: must be a whole number"),
    (ONE, rectangle("angle = 90"), "angle: a texture rectangle is neither turned nor "),
    (ONE, rectangle("turns = 1"), "turns: a texture rectangle is neither turned nor "),
    (ONE, rectangle("scale = 2"), "scale: a texture rectangle is neither turned nor "),
    (ONE, rectangle("texel = [0, 0.01]"), "texel[1]: must be a multiple of 1/32 texel"),
    (ONE, rectangle("texel = [1024, 0]"), "texel[0]: must be from -1024 to 1023.96875"),
    (ONE, rectangle("step = [0.1, 1]"), "step[0]: must be a multiple of 1/1024 texel"),
    (ONE, rectangle("step = [1, 32]"), "step[1]: must be from -32 to 31.9990234375"),
    (ONE, rectangle("texel = [1020, 0]"), "step: s is not from -1,024 to 1,023.97 texels"),
    (ONE, rectangle("step = [1, 30]", "rectangle = [0, 0, 9, 40]"), "step: t is not from"),
    (ONE, rectangle("colours = ['#ffffff']"), "colours: unknown field; known are "),
    ("perspective = true, " + ONE, rectangle(),
     "rectangle: material 'it' has perspective, but a texture rectangle no depth"),
    (SHADED, rectangle(),
     "rectangle: material 'it' reads shade, which a texture rectangle has not"),
    (COPY, rectangle("flip = true"), "flip: copy mode does not flip"),
    (COPY, rectangle("step = [8, 1]"), "step[0]: copy mode's must be less than 8 texels"),
    (COPY, SQUARE, "material: 'it' is in copy mode, which draws texture rectangles only"),
    (ONE, CORNERS + "\n" + COLOURS, "colours: material 'it' reads no shade"),
    (SHADED, CORNERS + "\ncolours = ['#ffffff']", "colours: must have 3 entries, not 1"),
    (SHADED, CORNERS + "\n" + COLOURS.replace("ff00", "fg00"), "colours[0]: must be a colour like"),
    (SHADED, "sides = 3\nradius = 9\nshades = [3]\n" + COLOURS,
     "shades: there are colours instead"),
    (SHADED, CORNERS.replace("]]", ", 255]]") + "\n" + COLOURS,
     "vertices[2]: must be [x, y, s, t]"),
    ("cycles = 'fill', " + ONE, SQUARE, "materials.it.n64.cycles: 'fill' is not one of copy"),
    ("filter = 'bilerp', " + COPY, SQUARE,
     "materials.it.n64.filter: is not for copy mode, which leaves texels as they are"),
    ("combine = 'primitive', " + COPY, SQUARE, "materials.it.n64.combine: is not for copy mode"),
    ("cycles = 'copy', tiles = [{ " + TILE.replace("rgba16", "i8") + " }]", rectangle(),
     'materials.it.n64.tiles[0].format: "i8": copy mode is for rgba16, ia16, ci4, ci8'),
])
def test_refused(folder, engine, obj, message):
    place = "" if message.startswith("materials") else "objects[0]."
    check_refused(folder, scene_of(engine, obj, pixels="rgba5551"), place + message)


def test_refused_by_other_scenes(folder):
    """Copy mode needs 16-bit frames; other materials have neither colours nor rectangles."""
    with pytest.raises(UserError, match='n64.cycles: "copy" is for scenes in rgba5551'):
        make(folder, COPY, BOX)
    for obj, field in ((BOX, "rectangle"), (CORNERS + "\n" + COLOURS, "colours")):
        check_refused(folder, scene_text('colour = "#ffffff"', obj),
                      f"objects[0].{field}: material 'it' has no text")


def test_the_pages_example(folder):
    """The page's example compiles unchanged, and its picture moves."""
    text = (ROOT / "c" / "n64" / "README.md").read_text()
    example = text.split("```")[3].removeprefix("toml")
    (folder / "scene.toml").write_text(HEAD.format(frames=2, pixels="rgba5551")
                                       + example.replace("n64/letter.png", "noise.png"))
    frames = [shown(compile_scene(folder / "scene.toml"), number) for number in range(2)]
    assert np.array_equal(frames[0][8:40, 8:54], frames[1][8:40, 10:56])


def test_the_guest_refuses_what_the_compiler_does(folder):
    """A scene file with rectangles that an engine does not draw: the error is one line with the
    reason."""
    good = make(folder, ONE, BOX)
    deep = make(folder, "perspective = true, " + ONE, CORNERS.replace("]]", ", 1]]").replace(
        "], ", ", 1], "))
    shaded = make(folder, SHADED, CORNERS + "\n" + COLOURS)
    copied = make(folder, COPY, BOX, pixels="rgba5551")
    far = good.vertices.copy()
    far[0, 2] = 1020 << 5
    flipped = [replace(good.materials[0], primitive="flipped")]
    parts = {"materials": good.materials, "objects": good.objects, "vertices": good.vertices,
             "poses": good.poses}
    cycle = "cycle type does not draw this"
    scenes = {
        "deep": (replace(deep, **parts), "texture rectangle in perspective or with shade"),
        "shaded": (replace(shaded, **parts), "texture rectangle in perspective or with shade"),
        "far": (replace(good, vertices=far), "texture coordinate is not within -1024 to 1023.96875"),
        "copy32": (replace(copied, format="rgba8888"), cycle),
        "flip": (replace(copied, materials=flipped), cycle),
        "polygon": (replace(copied, materials=deep.materials, objects=deep.objects,
                            vertices=deep.vertices, poses=deep.poses), cycle)}
    files = {name: scene_file.write(scene) for name, (scene, _) in scenes.items()}
    found = emulator.run_batch([f"render {name} FRAMES 1" for name in files], files, "a1200",
                              folder / "run")
    for (name, (_, why)), result in zip(scenes.items(), found, strict=True):
        said = result.output.splitlines()
        assert f"render: not all could be drawn: {why}" in said, f"{name}: {result.output}"
        assert result.code == 5, f"{name}: {result.code}"
