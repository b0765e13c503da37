"""The scene compiler: its output for good scenes, and its errors for bad ones."""

import math
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from tests.helpers.arrays import check_within
from tests.helpers.refusals import without_line
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.build import layout
from tmap.compiler import scene, space
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material

ONE = 65536
GOOD = """\
title = "test"
width = 64
height = 48
frames = 8
background = "#102030"

[textures.wall]
image = "wall.png"

[materials]
red.colour = "#ff0000"
wall.texture = "wall"

[[objects]]
material = "red"
sides = 3
radius = 10

[[objects]]
material = "wall"
sides = 4
radius = 20
centre = [30, 20]

[[objects]]
material = "wall"
vertices = [[0, 0, 0, 0], [8, 0, 256, 0], [8, 8, 256, 256], [0, 8, 0, 256]]
"""


@pytest.fixture
def folder(tmp_path):
    """A directory with the picture GOOD names: left half dark, right half bright."""
    pixels = np.zeros((40, 60, 3), np.uint8)
    pixels[:, 30:] = (200, 220, 240)
    Image.fromarray(pixels).save(tmp_path / "wall.png")
    return tmp_path


def make(folder, text=GOOD, frames=None):
    (folder / "scene.toml").write_text(text)
    return compile_scene(folder / "scene.toml", frames)


def refusal(folder, text) -> str:
    with pytest.raises(UserError) as caught:
        make(folder, text)
    return without_line(str(caught.value), folder / "scene.toml")


def changed(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new, 1)


def placed(line: str) -> str:
    """GOOD with one more line in its first object."""
    return changed("radius = 10", "radius = 10\n" + line)


def cornered(vertices: str) -> str:
    """GOOD with other vertices in its last object."""
    return GOOD[:GOOD.index("vertices =")] + f"vertices = {vertices}"


def test_a_scene_without_background(folder):
    """It needs no palette entry, and what no polygon covers is not drawn."""
    made = make(folder, changed('background = "#102030"', 'background = "none"'))
    assert (made.cleared, made.palette[0].tolist()) == (0, [255, 0, 0])
    assert make(folder).cleared == 1


@pytest.mark.parametrize("format", ["rgb565", "rgba8888"])
def test_a_scene_without_any_colour(folder, format):
    """No background and only a textured material: no pixel is known before the pictures."""
    text = f'width = 8\nheight = 8\nframes = 1\nformat = "{format}"\nbackground = "none"\n' + GOOD[
        GOOD.index("[textures"):].replace('red.colour = "#ff0000"\n', "").replace('"red"', '"wall"')
    assert not make(folder, text).cleared


def test_a_fault_in_a_picture_is_found_before_objects_are_placed(folder, monkeypatch):
    """Places of a thousand frames may take many seconds."""
    monkeypatch.setattr(scene, "place_objects", lambda *_: pytest.fail("objects are placed first"))
    (folder / "wall.png").write_bytes(b"no picture")
    assert ": textures.wall.image: " in refusal(folder, GOOD)


def test_a_frames_camera_is_found_once(monkeypatch):
    """However many objects ask for it."""
    found, camera_at = [], space.camera_at
    monkeypatch.setattr(space, "camera_at", lambda spec, frame, where: (
        found.append(frame) or camera_at(spec, frame, where)))
    compile_scene(SCENES / "crane.toml", 4)
    assert sorted(found) == [0, 1, 2, 3]


@pytest.mark.parametrize("path", [path for path in sorted(SCENES.glob("*.toml"))
                                  if 'background = "none"' in path.read_text()], ids=lambda path: path.stem)
def test_scenes_without_background_cover_their_frames(path):
    """The first frame, the last and four between are the same on any background."""
    made = compile_scene(path)
    for number in np.linspace(0, made.frames - 1, 6).astype(int):
        on = [model.render(replace(made, background=pixel), int(number)) for pixel in (0, 255)]
        assert np.array_equal(*on), f"frame {number}: {(on[0] != on[1]).sum()} pixels are not covered"


def test_content(folder):
    """The compiled GOOD: sizes, colours, materials, places of objects' corners and poses."""
    made = make(folder)
    assert (made.width, made.height, made.frames, made.background) == (64, 48, 8, 0)
    assert made.palette[0].tolist() == [16, 32, 48] and made.palette[1].tolist() == [255, 0, 0]
    assert made.materials == [Material(edges="snapped", colour=1), Material("affine", "snapped", texture=0)]
    assert [(o.material, o.vertex, o.vertices, o.pose, o.poses) for o in made.objects] == [
        (0, 0, 3, 0, 8), (1, 3, 4, 8, 8), (1, 7, 4, 0, 8)]  # equal poses are there once
    assert made.vertices.shape == (11, 6) and made.poses.shape == (16, 6)
    (texture,) = made.textures
    left, right = texture.texels[128, 10], texture.texels[128, 245]
    assert made.palette[left].tolist() == [0, 0, 0]
    assert made.palette[right].tolist() == [200, 220, 240]


def test_picture_is_upright_and_not_mirrored(folder):
    """Up on the screen is a smaller t, right on the screen a larger s."""
    corners = scene_file.vertices_at(made := make(folder), made.objects[1], 0)
    top, right, bottom, left = corners
    assert top[:4] == (30 * ONE, 0, 128 * ONE, 0)
    assert bottom[1] == 40 * ONE and bottom[3] == 256 * ONE
    assert right[0] == 50 * ONE and right[2] == 256 * ONE
    assert left[0] == 10 * ONE and left[2] == 0


UNITS = ('wall.glide.units = [{ image = "wall.png", format = "argb4444", width = 64, height = 64 }]',
         'wall.n64.tiles = [{ image = "wall.png", format = "ia8", width = 32, height = 32 }]')


@pytest.mark.parametrize("alpha, old, new, count", [
    (0, "", "", 1), (254, "", "", 1), (255, "", "", 0), (None, "", "", 0),
    (0, 'wall.texture = "wall"', 'wall.texture = "wall"\nother.texture = "wall"', 1),
    (0, 'wall.texture = "wall"', 'wall.colour = "#00ff00"', 0),  # the texture is not used
    (0, "frames = 8", 'frames = 8\nformat = "rgba8888"', 1),  # its pixels have alpha, which shows nowhere
    *((0, 'wall.texture = "wall"', unit, 0) for unit in UNITS)])
def test_alpha_that_does_not_show_is_said(folder, capsys, alpha, old, new, count):
    """In one line, of the textures of plain mappers alone."""
    if alpha is not None:
        with Image.open(folder / "wall.png") as picture:
            changing = picture.convert("RGBA")
        changing.putpixel((30, 20), (9, 9, 9, alpha))
        changing.save(folder / "wall.png")
    frames = "\nformat = \"rgba5551\"" if "n64" in new else "\nformat = \"rgb565\"" if "glide" in new else ""
    make(folder, changed(old, new).replace("frames = 8", "frames = 8" + frames))
    line = (folder / "scene.toml").read_text().split("\n").index('image = "wall.png"') + 1
    assert capsys.readouterr().err == (
        f"tmap: {folder / 'scene.toml'}:{line}: textures.wall.image: wall.png has transparent pixels, which are "
        "drawn as they are\n") * count


def test_map_turn_turns_the_map_clockwise(folder):
    """map_turn is in degrees; map_radius is the size of the visible part."""
    text = changed("radius = 20", "radius = 20\nmap_turn = 90\nmap_radius = 64")
    made = make(folder, text)
    top, right, *_ = scene_file.vertices_at(made, made.objects[1], 0)
    assert (top[2], top[3]) == (64 * ONE, 128 * ONE)  # the map's left is now at the top
    assert (right[2], right[3]) == (128 * ONE, 64 * ONE)


def test_angle_is_clockwise_and_turns_go_round_once(folder):
    """Angles are measured from the right; a whole turn takes all frames."""
    made = make(folder, placed("angle = 90\nturns = 1"))
    at = [scene_file.vertices_at(made, made.objects[0], frame)[0][:2] for frame in range(8)]
    assert at[0] == (10 * ONE, 0) and at[2] == (0, 10 * ONE) and at[4] == (-10 * ONE, 0)


def test_motion(folder):
    """Moves from its first frame on, orbits, scales; it is absent before."""
    made = make(folder, placed("centre = [5, 6]\nmove = [2, -1]\n"
                               "orbit = {radius = [100, 50], turns = 1, phase = 0.25}\n"
                               "scale = [1, 3]\nfirst = 2"))
    obj = made.objects[0]
    assert (obj.first_frame, obj.poses) == (2, 6)
    assert scene_file.vertices_at(made, obj, 1) == []
    assert scene_file.vertices_at(made, obj, 8) == []
    poses = made.poses[obj.pose:obj.pose + obj.poses]
    assert poses[0].tolist() == [ONE, 0, 0, ONE, 5 * ONE, 56 * ONE]
    # Two frames later is a quarter of the loop: scale 2, orbit at the left.
    assert poses[2].tolist() == [2 * ONE, 0, 0, 2 * ONE, (5 + 4 - 100) * ONE, (6 - 2) * ONE]


def test_last_frame_and_fewer_frames(folder):
    """Poses exist only for visible frames; with fewer frames the first ones are the same."""
    text = placed("first = 3\nlast = 5\nturns = 1")
    whole, cut, early = make(folder, text), make(folder, text, 5), make(folder, text, 2)
    assert [o.poses for o in whole.objects] == [3, 8, 8]
    assert [o.poses for o in cut.objects] == [2, 5, 5]
    assert [o.poses for o in early.objects] == [2, 2]  # the first object has not appeared yet
    assert whole.poses[:2].tolist() == cut.poses[:2].tolist()


def test_more_frames_go_on(folder):
    """Beyond the end of the loop it starts again."""
    made = make(folder, placed("turns = 1"), 12)
    assert made.frames == 12
    assert made.poses[8].tolist() == made.poses[0].tolist()


@pytest.mark.parametrize("frames", [0, -1, 10**6, 2.5, True])
def test_bad_number_of_frames(folder, frames):
    """The caller's number of frames is checked too."""
    with pytest.raises(UserError, match="^frames: must be "):
        make(folder, frames=frames)


@pytest.mark.parametrize("vertices", [
    "[[0, 0, 0, 0], [8, 0, 9, 0], [0, 8, 0, 9]]",  # clockwise
    "[[0, 0, 0, 0], [0, 8, 9, 0], [8, 0, 0, 9]]",  # the other way round
    "[[0, 0, 0, 0], [4, 0, 0, 0], [8, 0, 9, 0], [0, 8, 0, 9]]",  # a corner on a side
    "[[0, 0, 0, 0], [8, 0, 9, 0], [8, 0, 9, 0], [0, 8, 0, 9]]",  # one corner twice
    "[[0, 0, 0, 0], [33.33, 33.34, 0, 0], [100, 100, 9, 0], [0, 100, 0, 9]]",  # rounded
])
def test_convex_lists_are_taken(folder, vertices):
    """Either winding, with corners on a side or repeated."""
    make(folder, cornered(vertices))


def test_flat_vertices_need_no_map(folder):
    """x and y are enough."""
    text = changed('sides = 3\nradius = 10', "vertices = [[0, 0], [8, 0], [0, 8]]")
    assert make(folder, text).vertices[1].tolist() == [8 * ONE, 0, 0, 0, 0, ONE]


STAR = [[round(50 * math.cos(angle), 3), round(50 * math.sin(angle), 3), 0, 0]
        for angle in (math.tau * 2 / 5 * i for i in range(5))]


@pytest.mark.parametrize("text, message", [
    (changed("width = 64\n", ""), "scene.toml: width: is missing"),
    (changed("width = 64", 'pages = "both"\nwidth = 64'),
     "scene.toml: pages: 'both' is not one of shared, own"),
    (changed('image = "wall.png"', 'image = "wall.png"\nfit = "fill"'),
     "scene.toml: textures.wall.fit: 'fill' is not one of cut, whole"),
    (changed("width = 64", "width = 66"),
     "scene.toml: width: must be from 4 to 1024 and a multiple of 4"),
    (changed("width = 64", "width = 2048"), "width: must be from 4 to 1024"),
    (changed("height = 48", "height = 0"), "height: must be from 1 to 1024"),
    (changed("height = 48", "height = 48.0"), "height: must be a whole number, not a number"),
    (changed("height = 48", "height = true"), "height: must be a whole number, not true or false"),
    (changed("frames = 8", "frames = 1979-05-27"), "frames: must be a whole number, not a date"),
    (changed("frames = 8", "frames = 100000"), "scene.toml: frames: must be from 1 to "),
    (changed("#102030", "#10203"), "background: must be a colour like"),
    (changed("#102030", "red"), "background: must be a colour like"),
    (changed('"test"', '"a\\nb"'), "title: must be text on one line"),
    (changed("height = 48", "height = 48\ndepth = 1"), "scene.toml: depth: unknown field"),
    (changed("height = 48", 'height = 48\n"a\\nb" = 1'), "scene.toml: 'a\\nb': unknown field"),
    (changed('image = "wall.png"', "image = 3"), "textures.wall.image: must be text, not a number"),
    (changed('image = "wall.png"', 'file = "wall.png"'), "textures.wall.file: unknown field"),
    (changed('image = "wall.png"', ""), "textures.wall.image: is missing"),
    (changed('red.colour = "#ff0000"', "red = 3"), "materials.red: must be a table, not a number"),
    (changed('red.colour = "#ff0000"', 'red = {}'),
     "materials.red: needs exactly one of texture, colour"),
    (changed('red.colour = "#ff0000"', 'red = {colour = "#ff0000", texture = "wall"}'),
     "materials.red: needs exactly one of texture, colour"),
    (changed('wall.texture = "wall"', 'wall.texture = "roof"'),
     "materials.wall.texture: there is no texture 'roof'"),
    (changed('material = "red"', 'material = "blue"'),
     "scene.toml: objects[0].material: there is no material 'blue'"),
    (changed('material = "wall"\n', ""), "objects[1].material: is missing"),
    (GOOD[:GOOD.index("[[objects]]")], "scene.toml: objects: is missing"),
    (changed("sides = 3", "sides = 2"), "objects[0].sides: must be from 3 to 64"),
    (changed("sides = 3", "sides = 65"), "objects[0].sides: must be from 3 to 64"),
    (changed("sides = 3\n", ""), "objects[0]: needs exactly one of sides, vertices"),
    (changed("sides = 3", "sides = 3\nvertices = []"),
     "objects[0]: needs exactly one of sides, vertices"),
    (changed("radius = 20", "radius = nan"), "objects[1].radius: must be from 0.01 to 16383"),
    (changed("radius = 20", "radius = inf"), "objects[1].radius: must be from"),
    (changed("radius = 20", "radius = -1"), "objects[1].radius: must be from"),
    (changed("radius = 20", 'radius = "20"'), "objects[1].radius: must be a number, not text"),
    (changed("radius = 20", f"radius = 0x1{'0' * 5000}"), "objects[1].radius: must be from"),
    (changed("radius = 20\n", ""), "objects[1].radius: is missing"),
    (changed("centre = [30, 20]", "centre = [30]"),
     "objects[1].centre: must have 2 entries, not 1"),
    (changed("centre = [30, 20]", 'centre = [30, "a"]'), "objects[1].centre[1]: must be a number"),
    (changed("centre = [30, 20]", "centre = 30"), "objects[1].centre: must be a list"),
    (placed("color = 3"), "objects[0].color: unknown field; known are sides, radius"),
    (placed("orbit = {turns = 1}"), "objects[0].orbit.radius: is missing"),
    (placed("orbit = {radius = [1, 2], turns = 1, speed = 2}"), "orbit.speed: unknown field"),
    (placed("scale = [1, 2, 3]"), "objects[0].scale: must have 2 entries"),
    (placed("scale = -1"), "objects[0].scale: must be from 0 to 256"),
    (placed("first = 8"), "objects[0].first: the scene ends with frame 7"),
    (placed("first = 4\nlast = 3"), "objects[0].last: must be from 4 to 7"),
    (placed("last = 8"), "objects[0].last: must be from 0 to 7"),
    (placed("move = [9000, 0]"),
     "objects[0]: reaches 16384 pixels or more from the corner of the screen in frame 2"),
    (placed("first = 2\nmove = [9000, 0]"), "in frame 4"),
    (placed("centre = [16380, 0]"), "objects[0]: reaches 16384 pixels"),
    (placed("centre = [0, 9000]\nscale = [1, 256]\norbit = {radius = [16000, 9000], turns = 9}"),
     "objects[0]: reaches 16384 pixels"),
    (cornered("[[0, 0, 0, 0], [8, 0, 0, 0]]"), "objects[2].vertices: must have 3 to 64 entries"),
    (cornered("[[0, 0], [8, 0], [0, 8]]"), "objects[2].vertices[0]: must be [x, y, s, t]"),
    (cornered("[[0, 0, 0], [8, 0, 0], [0, 8, 0]]"), "objects[2].vertices[0]: must be [x, y, s, t]"),
    (cornered("[[0, 0, 0, 0], [8, 0, nan, 0], [0, 8, 0, 0]]"),
     "objects[2].vertices[1][2]: must be from"),
    (cornered("[[0,0,0,0], [8,0,0,0], [2,2,0,0], [0,8,0,0]]"),
     "objects[2].vertices: the polygon is not convex"),
    (cornered("[[0,0,0,0], [8,8,0,0], [8,0,0,0], [0,8,0,0]]"),
     "objects[2].vertices: the polygon is not convex"),
    (cornered(str(STAR)), "objects[2].vertices: the polygon crosses itself"),
    (changed("wall.png", "roof.png"), "scene.toml: textures.wall.image: roof.png: no such file"),
    (changed("wall.png", "a\\u0000b"), "textures.wall.image: must be text on one line"),
])
def test_refused(folder, text, message):
    """The error is one line that names file and field."""
    assert message in refusal(folder, text)


def test_other_files_are_refused(tmp_path):
    """A missing file, a directory, bytes that are not text."""
    with pytest.raises(UserError, match="scene.toml: No such file"):
        compile_scene(tmp_path / "scene.toml")
    with pytest.raises(UserError, match="Is a directory"):
        compile_scene(tmp_path)
    for data, message in ((b"title = '\xff'", "scene.toml: is not UTF-8"),
                          (b"width = 4\nheight =\n", "scene.toml:2: is not TOML: Invalid value$"),
                          (b"width = [\n", "scene.toml:1: is not TOML: Invalid value$"),
                          (b"a = 0x" + b"f" * 9999 + b".", "scene.toml:1: is not TOML: "),
                          (b"a = " + b"[" * 9999, "scene.toml: is not TOML: ")):
        (tmp_path / "scene.toml").write_bytes(data)
        with pytest.raises(UserError, match=message):
            compile_scene(tmp_path / "scene.toml")


def test_too_many_poses(folder):
    """The error names the first object that exceeds the limit. Two of the first three share their poses."""
    limits = layout.load().constants
    most, frames = limits["SCENE_COUNT_MAX"], limits["SCENE_FRAMES_MAX"]
    text = changed("frames = 8", f"frames = {frames}") + "".join(
        f'[[objects]]\nmaterial = "red"\nsides = 3\nradius = 9\ncentre = [{k}, 9]\n' for k in range(most // frames))
    assert f"objects[{most // frames + 1}]: more than {most} frames of objects" in refusal(folder, text)


def test_too_many_flat_colours(folder):
    """Textures need palette entries too."""
    colours = "".join(f'c{i}.colour = "#0000{i:02x}"\n' for i in range(200))
    message = refusal(folder, changed("[materials]\n", "[materials]\n" + colours))
    assert ("scene.toml: materials: 202 palette entries for flat colours, ramps and the "
            "background; 192 at most beside textures") in message


def test_default_scene_is_a_loop():
    """One frame past the end looks like the first; crossing objects are off the screen at both.
    Each number of both poses is rounded by half a unit, multiplied by a corner's pixels, and two
    products are rounded down by less than one each: at most |x| + |y| + 1 + 2 units apart."""
    made = compile_scene(SCENES / "default.toml", 51)
    assert (made.width, made.height, made.frames) == (320, 256, 51)
    assert len(made.textures) == 5 and 10 <= len(made.objects) <= 16
    flat = sum(made.materials[obj.material].mapper == "flat" for obj in made.objects)
    assert 0 < flat < len(made.objects)
    for obj in made.objects:
        ends = [scene_file.vertices_at(made, obj, frame) for frame in (0, 50)]
        if not any(ends):
            for frame in (obj.first_frame, obj.first_frame + obj.poses - 1):
                xs = [v[0] for v in scene_file.vertices_at(made, obj, frame)]
                assert max(xs) <= 0 or min(xs) >= 320 * ONE
            continue
        first, last = (sorted(v[:2] for v in end) for end in ends)
        if made.materials[obj.material].texture >= 0:  # textured corners keep their order
            first, last = ([v[:2] for v in end] for end in ends)
        corners = made.vertices[obj.vertex:obj.vertex + obj.vertices, :2]
        check_within(last, first, abs(corners).sum(1).max() / ONE + 3, f"object {obj}")
