"""Faces in space whose second unit has separate coordinates: listed, or computed by a projector."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers.arrays import check_equal, check_within
from tests.helpers.engine_scenes import check_refused, compiled, folder  # noqa: F401
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.bench.scenes import some_frames
from tmap.compiler.projectors import CONE
from tmap.compiler.scene import compile_scene
from tmap.ideal.mesh import CUT, camera_error, off_screen, screen_error
from tmap.model import model

ONE = 65536
CLAMP_W = 8  # bit of a unit's mode
GUARD = 6  # for 64x48 pixels and a field of view of 60 degrees
WIDTH, HEIGHT = 64, 48
HEAD = f"""\
width = {WIDTH}
height = {HEIGHT}
frames = {{frames}}
format = "rgba8888"
background = "#102030"
[camera]
eye = [0, 0, 4]
"""
MATERIAL = """\
[materials.it.glide]
perspective = true
[[materials.it.glide.units]]
image = "noise.png"
format = "rgb565"
combine = {{ function = "scale_other", factor = "one" }}
[[materials.it.glide.units]]
image = "noise.png"
format = "rgb565"
s = "clamp"
t = "clamp"
{unit}
[[objects]]
material = "it"
"""
WALL = """\
points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
faces = [[0, 1, 2, 3]]
uvs = [[[0, 256], [256, 256], [256, 0], [0, 0]]]
"""
RIGHT = WALL.replace("[-1,", "[0,")  # the wall's right half
OWN = 'own = true\nmipmap = "none"'
CLAMPED = OWN + "\nclamp_w = true"
SIDEWAYS = "[projectors.lamp]\neye = [0, 0, 1]\ntarget = [1, 0, 1]\nfov = 90\n"
LAMP = 'projector = "lamp"'


def text_of(obj: str, projector: str = "", unit: str = OWN, frames: int = 1) -> str:
    return HEAD.format(frames=frames) + projector + MATERIAL.format(unit=unit) + obj


def make(folder, *args, **kinds):
    return compiled(folder, text_of(*args, **kinds))


def halves(scene, obj) -> tuple[np.ndarray, np.ndarray]:
    """An object's corners and those of its second unit, in the units of the TOML file."""
    corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices] / ONE
    return corners[:obj.vertices // 2], corners[obj.vertices // 2:]


def area(corners: np.ndarray) -> float:
    """The area of a polygon on the screen, in pixels."""
    x, y = corners[:, 0], corners[:, 1]
    return abs(x @ np.roll(y, 1) - y @ np.roll(x, 1)) / 2


def border(corners: np.ndarray) -> float:
    """The length of a polygon's outline, in pixels."""
    return np.hypot(*(corners[:, :2] - np.roll(corners[:, :2], 1, axis=0)).T).sum()


def test_listed_coordinates(folder):
    """A wall at right angles to the view: the corners are where geometry puts them, w is the
    camera's; within the bound of meshes on the screen plus half a unit of the file."""
    scene = make(folder, WALL + "uvs1 = [[[0, 64], [32, 64], [32, 0], [0, 0]]]")
    first, second = halves(scene, scene.objects[0])
    focal = WIDTH / 2 / np.tan(np.pi / 6)  # 60 degrees
    signs = np.array([[-1, 1], [1, 1], [1, -1], [-1, -1]])
    expected = signs * focal / 4 + [WIDTH / 2, HEIGHT / 2]
    check_within(first[:, :2], expected, screen_error(GUARD, 4, 1) + 0.5 / ONE, "corner, axis")
    for found, wide, high in ((first, 256, 256), (second, 32, 64)):
        places = ((0, high), (wide, high), (wide, 0), (0, 0))
        assert found[:, 2:].tolist() == [[s, t, 0, 4] for s, t in places]


def test_a_projector_in_the_camera_shows_its_picture_undistorted(folder):
    """However the face is turned, cut at the borders: s and t are proportional to x and y, and w is
    1. x and y have the bound of meshes, s and t four times that; S Q, T Q and Q are rounded six
    times to 2^-24, so s is off by 6/2^25 (1 + |s|) / Q, and the file's numbers by half a unit."""
    tilted = "points = [[-9, -2, 1], [3, -2, 3], [5, 2, -7], [-9, 2, -6]]\nfaces = [[0, 1, 2]]\n" \
             "uvs = [[[0, 0], [256, 0], [256, 256]]]\n"
    camera = "[projectors.lamp]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\n"
    scene = make(folder, tilted + LAMP, camera)
    first, second = halves(scene, scene.objects[0])
    assert len(first) > 3
    error = camera_error(9) + CUT
    for (x, y, *_, w), (_, _, s, t, _, w1) in zip(first, second):
        for at, value in ((x, s), (y - HEIGHT / 2 + WIDTH / 2, t)):
            bound = 4 * off_screen(GUARD, w, error) + 6 / 2 ** 25 * (1 + abs(value)) / w + 2.5 / ONE
            assert abs(value - at * 256 / WIDTH) <= bound, (x, y)
        assert abs(w1 - 1) <= (error + 6 / 2 ** 25) / (w - error) + 0.5 / ONE


def test_nothing_is_shown_behind_a_projector(folder):
    """The projector looks to the right in front of the middle of a wall: left of it the wall shows
    the first texel."""
    scene = make(folder, WALL + LAMP, SIDEWAYS, CLAMPED)
    _, second = halves(scene, scene.objects[0])
    assert np.sign(second[:, 5]).tolist() == [-1, 1, 1, -1]
    seen = model.render(scene, 0)
    wall = seen[12:36, 20:44]  # of focal length / 4 to each side of (32, 24)
    assert len(np.unique(wall[:, :12])) == 1 < len(np.unique(wall[:, 12:]))
    mirrored = model.render(make(folder, WALL + LAMP, SIDEWAYS, OWN), 0)
    check_equal(mirrored[:, 32:], seen[:, 32:], "row, column - 32")
    assert len(np.unique(mirrored[12:36, 20:32])) > 1


def test_the_window_needs_its_clamp():
    """Without clamp_w the scene's first frame would show a second window where w is below 0."""
    scene = compile_scene(SCENES / "glide_window.toml", 1)
    words = scene.glide_units.copy()
    words[:, 0] &= ~CLAMP_W
    assert np.count_nonzero(model.render(scene, 0) != model.render(replace(scene, glide_units=words), 0)) \
        > 1000


def test_a_face_is_cut_next_to_the_plane_of_its_projector(folder):
    """The parts cover the face, up to the rounding of all corners: 1/65536 times the length of the
    sides."""
    scene = make(folder, WALL + "uvs1 = [[[0, 0], [1, 0], [1, 1], [0, 1]]]")
    whole, _ = halves(scene, scene.objects[0])
    scene = make(folder, RIGHT + LAMP, SIDEWAYS, CLAMPED)
    parts = [halves(scene, obj) for obj in scene.objects]
    assert len(parts) > 1
    sides = border(whole) / 2 + sum(border(first) for first, _ in parts)
    check_within(sum(area(first) for first, _ in parts), area(whole) / 2, sides / ONE, "area")
    for _, second in parts:
        assert (second[:, 5] > 0).all() and abs(second[:, 2:4]).max() <= CONE + 1 / ONE \
            or (second[:, 5] < 0).all() and not second[:, 2:4].any()


def test_what_moves(folder):
    """The camera, the projector or the object moves from frame to frame; each frame is one
    polygon."""
    lamp = "[projectors.lamp]\neye = [0, 0, 3]\ntarget = [0, 0, 0]\n" \
           "keys = [{ frame = 0 }, { frame = 2, target = [2, 0, 0] }]\n"
    scene = make(folder, WALL + LAMP, lamp, frames=3)
    own = [halves(scene, obj)[1][:, 2].mean() for obj in scene.objects]
    assert len(own) == 3 and own[0] > own[1] > own[2]
    turned = make(folder, WALL + LAMP + "\nturns = 1\nrotation = [0, 20, 0]", lamp, frames=4)
    assert [obj.first_frame for obj in turned.objects] == [0, 3], "from the back it is not seen"
    both = make(folder, WALL + LAMP + "\nturns = 1\ntwo_sided = true", lamp, frames=5)
    assert len({halves(both, obj)[0].tobytes() for obj in both.objects}) == len(both.objects) == 5
    some = some_frames(both, [0, 0, 2])
    for k, number in enumerate([0, 0, 2]):
        check_equal(model.render(some, k), model.render(both, number), f"frame {number}: row, column")


def test_far_faces_are_drawn_first(folder):
    """The faces of one object are sorted by their greatest depth."""
    two = "points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, -1, -1], [1, -1, -1], [1, 1, -1]]\n" \
          "faces = [[0, 1, 2], [3, 4, 5]]\nuvs = [[[0, 0], [1, 0], [1, 1]]]\n"
    scene = make(folder, two + "uvs1 = [[[0, 0], [1, 0], [1, 1]]]")
    assert [halves(scene, obj)[0][0, 5] for obj in scene.objects] == [5, 4]


def test_uneven_coordinates_make_triangles(folder):
    """Coordinates of either unit that are not planar cut the face for both units."""
    uneven = "[[[0, 256], [256, 256], [100, 0], [0, 0]]]"
    for obj in (WALL + f"uvs1 = {uneven}",
                WALL.replace(WALL[WALL.index("[[["):-1], uneven)
                + "uvs1 = [[[0, 1], [1, 1], [1, 0], [0, 0]]]"):
        scene = make(folder, obj)
        assert [obj.vertices for obj in scene.objects] == [6, 6]


def test_faces_meet_those_of_meshes():
    """Of the wall's halves one is a mesh. From frame 8 on the wall fills the frame: no background
    shows between the halves."""
    scene = compile_scene(SCENES / "glide_wall.toml")
    for number in range(8, scene.frames):
        found = np.argwhere(model.render(scene, number) == scene.background).tolist()
        assert not found, f"frame {number}: background at (y, x) {found[:4]}"


def test_meshes_keep_their_place_among_some_frames():
    """Meshes stay between polygons that differ from frame to frame."""
    whole = compile_scene(SCENES / "glide_lightmap.toml", 3)
    some = some_frames(whole, [0, 2])
    assert len(some.objects) < len(whole.objects) and some.instances
    for k, number in enumerate((0, 2)):
        check_equal(model.render(some, k), model.render(whole, number), f"frame {number}: row, column")


RING = [[round(turn(k * math.pi / 16), 6) for turn in (math.cos, math.sin)] for k in range(32)]


def test_too_many_corners(folder):
    """A face of 32 corners; each corner just beyond a border becomes two."""
    points = [[9 * x, 9 * y, 0] for x, y in RING]
    obj = f"points = {points}\nfaces = [{list(range(32))}]\nuvs = [{RING}]\nuvs1 = [{RING}]"
    far = make(folder, obj.replace(", 0]", ", -30]"))
    assert [obj.vertices for obj in far.objects] == [64]
    near = [[4.65 * x, 4.65 * y, 0] for x, y in RING]
    with pytest.raises(UserError, match=r"faces\[0\]: has 36 corners on the screen in frame 0; with "
                                        "coordinates of their own 32 at most"):
        make(folder, obj.replace(str(points), str(near)))


@pytest.mark.parametrize("obj, projector, unit, message", [
    (WALL, "", OWN, ": material 'it' has a unit with coordinates of its own: needs "
                    "exactly one of uvs1, projector"),
    (WALL + LAMP + "\nuvs1 = [[[0, 0], [1, 0], [1, 1], [0, 1]]]", SIDEWAYS, OWN,
     ": material 'it' has a unit with coordinates of its own: needs exactly one of"),
    (WALL + LAMP, "", OWN, ".projector: there is no projector 'lamp'"),
    (WALL + LAMP, SIDEWAYS, "", ".projector: material 'it' has no second unit with "
                                "coordinates of its own"),
    (WALL + "uvs1 = [[[0, 0], [1, 0], [1, 1]]]", "", OWN,
     ".uvs1[0]: must have 4 entries, one a corner of face 0; not 3"),
    (WALL + "uvs1 = [[[0, 0], [9000, 0], [1, 1], [0, 1]]]", "", OWN,
     ".uvs1: s must be above -8192 and below 8192"),
    (WALL + LAMP + '\nmapping = "environment"', SIDEWAYS, OWN,
     ".mapping: material 'it' has a unit with coordinates of its own, which go with"),
    (RIGHT + LAMP, SIDEWAYS, OWN,
     ".faces[0]: a corner is too near the plane that 'lamp' stands on, in "
     "frame 0: its s or t reaches 8192; clamp_w of the second unit would let it be cut there"),
    (WALL + LAMP, SIDEWAYS.replace("90", "180"), OWN, "projectors.lamp.fov: must be from 1 to 170"),
    (WALL + LAMP, SIDEWAYS.replace("target", "aim"), OWN, "projectors.lamp.aim: unknown field; "),
    (WALL + LAMP, SIDEWAYS + "up = [2, 0, 0]\n", OWN,
     "projectors.lamp: eye, target and up are on one line in frame 0"),
    (WALL + LAMP, SIDEWAYS + "keys = [{ frame = 3 }, { frame = 3 }]\n", OWN,
     "projectors.lamp.keys[1].frame: must be above 3, the key's before"),
])
def test_refused(folder, obj, projector, unit, message):
    place = "" if message.startswith("projectors") else "objects[0]"
    check_refused(folder, text_of(obj, projector, unit), place + message)


def test_projectors_cut_and_zoom(folder):  # noqa: F811
    """Each frame of a projector with a cut and another lens has the coordinates of one that rests there;
    it needs no eye or target beside its keys."""
    places = ("eye = [0, 0, 1]\ntarget = [1, 0, 1]\nfov = 90\n",
              "eye = [0, 0, 2]\ntarget = [0.5, 0, 0]\nfov = 50\nup = [1, 1, 0]\n")
    keys = ", ".join(f"{{ frame = {n}, cut = true, {place.strip()} }}".replace("\n", ", ")
                     for n, place in enumerate(places))
    moving = make(folder, RIGHT + LAMP, f"[projectors.lamp]\nkeys = [{keys}]\n", CLAMPED, frames=2)
    for frame, place in enumerate(places):
        still = make(folder, RIGHT + LAMP, "[projectors.lamp]\n" + place, CLAMPED)
        found, wanted = (np.concatenate([half for obj in scene.objects if obj.first_frame == at
                                         for half in halves(scene, obj)])
                         for scene, at in ((moving, frame), (still, 0)))
        check_equal(found, wanted, f"frame {frame}: corner, value")
    check_refused(folder, text_of(RIGHT + LAMP, "[projectors.lamp]\neye = [0, 0, 1]\n"),
                  "projectors.lamp.target: is missing")
