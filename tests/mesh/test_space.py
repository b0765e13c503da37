"""Meshes, camera and light in a scene's TOML: the compiler's output and its error messages."""

import numpy as np
import pytest
from PIL import Image

from tests.helpers.arrays import check_within
from tests.helpers.refusals import without_line
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler import objects, space
from tmap.compiler.scene import compile_scene
from tmap.ideal.mesh import look_error, screen_error
from tmap.model import mesh as model_mesh
from tmap.scene_file import scene_file

ONE, UNIT = 65536, 1 << 30
NOISE = 2.0 ** -50  # error of cosines and the like in floating point
GOOD = """\
width = 64
height = 48
frames = 8
background = "#102030"

[textures]
wall = { image = "wall.png", width = 64, height = 32 }

[materials]
red.colour = "#ff0000"
wall = { texture = "wall" }
odd = { texture = "wall", mapper = "arbitrary" }
fan = { texture = "wall", gradients = "polygon" }
glow = { shades = ["#000000", "#ffffff"], steps = 64 }

[camera]
eye = [0, 0, 10]

[[objects]]
material = "wall"
points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
faces = [[0, 1, 2, 3]]
uvs = [[[0, 128], [256, 128], [256, 0], [0, 0]]]

[[objects]]
material = "red"
mesh = "mesh.obj"
position = [2, 0, 0]
"""
#: A square with a triangle beside it, counterclockwise from the front.
OBJ = """\
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
v 3 0 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 2
f 1/1/1 2/2/1 3/3/1 4/4/1
f 2/1/1 5/2/1 3/3/1
"""


@pytest.fixture
def folder(tmp_path):
    Image.fromarray(np.full((40, 60, 3), 99, np.uint8)).save(tmp_path / "wall.png")
    (tmp_path / "mesh.obj").write_text(OBJ)
    return tmp_path


def make(folder, text=GOOD, frames=None):
    (folder / "scene.toml").write_text(text)
    made = compile_scene(folder / "scene.toml", frames)
    scene_file.write(made)  # write checks the whole scene
    return made


def changed(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new, 1)


def placed(line: str) -> str:
    """GOOD with another line in its last object, the one whose mesh is a file."""
    return GOOD + line + "\n"


def on_file(material: str, line: str = "") -> str:
    """GOOD with another material on the mesh from the file."""
    return changed('material = "red"', f'material = "{material}"') + line + "\n"


def test_content(folder):
    made = make(folder)
    assert (made.guard, made.near_plane) == (6, ONE // 8) and not made.objects
    square, mesh = made.meshes
    assert (square.points, square.corners, square.faces) == (4, 4, 1)
    assert (mesh.points, mesh.corners, mesh.faces) == (5, 7, 2)  # the square stays in one piece
    assert made.faces[0].tolist() == [0, 0, UNIT, 0, 0, 4]
    assert made.corners[:4, 2:].tolist() == [[0, 128 * ONE], [256 * ONE, 128 * ONE],
                                             [256 * ONE, 0], [0, 0]]
    first, second = made.instances
    assert (first.mesh, first.material, first.views, second.material) == (0, 1, 8, 0)
    right = made.views[second.view].tolist()
    focal = 32 / np.tan(np.pi / 6) / 64
    assert right[:3] == [round(focal * UNIT), 0, 0]
    assert right[4] == -right[0] and right[8] == -UNIT  # y runs down, z away
    assert right[9:15] == [round(focal * 2 * ONE), 0, 10 * ONE, -2 * ONE, 0, 10 * ONE]


def test_on_the_screen(folder):
    """On the screen up is up, right is right, and the map is upright."""
    (_, corners), *_ = model_mesh.polygons_at(make(folder), 0)
    low_left, low_right, high_right, _ = corners
    half = 64 / 2 / np.tan(np.pi / 6) / 10
    error = screen_error(6, 10, 1) + 0.5 / ONE  # the bound of meshes, and the file's rounding
    check_within(np.array(low_left[:2]) / ONE, (32 - half, 24 + half), error, "low left: x, y")
    check_within(np.array(high_right[:2]) / ONE, (32 + half, 24 - half), error, "high right: x, y")
    assert low_left[2:4] == (0, 128 * ONE) and high_right[2:4] == (256 * ONE, 0)
    assert low_right[5] == 10 * ONE


def test_texture_coordinates_of_a_file(folder):
    """v runs upwards; the shorter side of the map has fewer than 256 units."""
    made = make(folder, on_file("wall"))
    mesh = made.meshes[1]
    corners = made.corners[mesh.corner:mesh.corner + 4, 2:].tolist()
    assert corners == [[0, 128 * ONE], [256 * ONE, 128 * ONE], [256 * ONE, 0], [0, 0]]


def test_same_meshes_are_stored_once(folder):
    made = make(folder, GOOD + GOOD[GOOD.index("[[objects]]"):])
    assert len(made.instances) == 4 and len(made.meshes) == 2


def test_normals(folder):
    """Normals of the file, of faces, and the means of faces."""
    def normals(line):
        made = make(folder, on_file("glow", line))
        mesh = made.meshes[-1]
        return made.normals[mesh.normal:mesh.normal + mesh.normals].tolist()

    assert normals("") == normals('normals = "faces"') == [[0, 0, 16384, 0]]
    (folder / "mesh.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                     "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    assert sorted(normals('normals = "faces"'))[:3] == [
        [-16384, 0, 0, 0], [0, -16384, 0, 0], [0, 0, -16384, 0]]
    smooth = normals("")
    assert len(smooth) == 4 and smooth[0] == [-9459, -9459, -9459, 0]


def test_lit_faces_show_their_light(folder):
    """Seen from the direction of the light, faces have full brightness; half of it is ambient."""
    text = on_file("glow", 'normals = "faces"') + \
        "[light]\ndirection = [0, 0, -3]\nambient = 0.5\n"
    made = make(folder, text)
    instance = made.instances[1]
    steps, half = 63 * ONE, ONE // 2
    # red, the background and the dark end come first in the palette: entry 2 is shade 0.
    first = instance.bright - steps - half
    assert instance.dark == first + half + steps // 2
    shades = {v[4] for m, vertices in model_mesh.polygons_at(made, 0) if m == 4 for v in vertices}
    assert len(shades) == 1
    check_within(shades.pop() / ONE, instance.bright / ONE, look_error(31.5), "half of 63 shades")


def test_what_needs_triangles_gets_them(folder):
    """Faces become triangles on request, with gradients of triangles, or if s and t or the points
    are not on a plane."""
    def faces(text):
        made = make(folder, text)
        mesh = made.meshes[-1]
        return made.faces[mesh.face:mesh.face + mesh.faces, 5].tolist()

    assert faces(GOOD) == [4, 3] and faces(placed("triangles = true")) == [3, 3, 3]
    assert faces(on_file("fan")) == [3, 3, 3]
    (folder / "mesh.obj").write_text(OBJ.replace("vt 1 1", "vt 1 0.9"))
    assert faces(on_file("wall")) == [3, 3, 3]  # s and t are not on a plane
    scanline = changed('wall = { texture = "wall" }',
                       'wall = { texture = "wall", gradients = "scanline" }')
    assert faces(scanline.replace('material = "red"', 'material = "wall"')) == [4, 3]
    (folder / "mesh.obj").write_text(OBJ.replace("v 1 1 0", "v 1 1 0.2"))
    assert faces(GOOD) == [3, 3, 3]  # bent


def test_motion(folder):
    """Turns, and keys of places and rotations; the file rounds by half a unit."""
    made = make(folder, placed("turns = 1\nrotation = [0, 90, 0]\nfirst = 2"))
    instance = made.instances[1]
    assert (instance.first_frame, instance.views) == (2, 6)
    starts = [made.views[instance.view + k, 6].item() / UNIT for k in range(3)]  # depth of x
    check_within(starts, [1, np.cos(np.pi / 4), 0], 0.5 / UNIT + NOISE, "turned about y: frame")
    keys = "keys = [{ frame = 2, position = [0, 0, 4] }, { frame = 6, position = [0, 0, -4] }]"
    made = make(folder, placed(keys))
    depths = made.views[made.instances[1].view:, 11][:8] / ONE
    check_within(depths, [6, 6, 6, 8, 10, 12, 14, 14], 0.5 / ONE, "depth: frame")
    keys = "keys = [{ frame = 0 }, { frame = 7, rotation = [0, 180, 0] }]"
    made = make(folder, placed(keys))
    turns = made.views[made.instances[1].view:, 8][:8] / -UNIT
    check_within(turns, np.cos(np.pi * np.arange(8) / 7), 0.5 / UNIT + NOISE, "z's part: frame")


def test_camera_keys(folder):
    """The camera moves along straight lines between keys, which must be in order."""
    keys = "keys = [{ frame = 0 }, { frame = 4, eye = [0, 0, 6] }]"
    made = make(folder, changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\n" + keys))
    check_within(made.views[:8, 11] / ONE, [10, 9, 8, 7, 6, 6, 6, 6], 0.5 / ONE, "depth: frame")
    with pytest.raises(UserError, match=r"camera.keys\[1\].frame: must be above 4"):
        make(folder, changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\nkeys = [{frame = 4}, {frame = 4}]"))


def test_rotations_take_the_shortest_way():
    """Rotations go from one to the other by the shortest way, with the middle equally far from
    both; half a turn too."""
    random = np.random.default_rng(6)
    for _ in range(50):
        first, second = (space.rotated(random.uniform(-360, 360, 3)) for _ in range(2))
        assert np.allclose(space.between(first, second, 0), first)
        assert np.allclose(space.between(first, second, 1), second, atol=1e-7)
        middle = space.between(first, second, 0.5)
        assert np.allclose(middle @ first.T, second @ middle.T)
    half = space.between(np.eye(3), space.about((1, 2, 2), np.pi), 0.5)
    assert np.allclose(half @ half, space.about((1, 2, 2), np.pi))


def test_double_sided_faces_are_seen_from_behind(folder):
    behind = changed("eye = [0, 0, 10]", "eye = [0, 0, -10]")
    assert model_mesh.polygons_at(make(folder, behind), 0) == []
    both = make(folder, behind + "two_sided = true\n")
    assert len(model_mesh.polygons_at(both, 0)) == 2


def test_twisted_quadrilaterals_of_a_mesh_are_cut_in_two():
    """The knot of 384 points has two triangles for each."""
    made = compile_scene(SCENES / "environment.toml", 1)
    assert made.meshes[0].points == 384 and made.meshes[0].faces == 768


def obj(text: str):
    """Returns a function that changes the folder's OBJ file before the scene is made."""
    return lambda folder: (folder / "mesh.obj").write_text(text)


RING = "".join(f"v {np.cos(a):.6f} {np.sin(a):.6f} 0\n" for a in np.arange(129) * np.pi / 64.5)
ZIGZAG = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\n"
STAR = "".join(f"v {np.cos(a):.6f} {np.sin(a):.6f} 0\n" for a in np.arange(5) * np.pi * 0.8)


@pytest.mark.parametrize("text, prepare, message", [
    (changed("[camera]\neye = [0, 0, 10]\n", ""), None,
     "scene.toml: camera: is missing; objects[0] has a mesh"),
    (changed("eye = [0, 0, 10]", ""), None, "camera.eye: is missing"),
    (changed("eye = [0, 0, 10]", "eye = [0, 0, 0]"), None,
     "camera: eye and target are in one place in frame 0"),
    (changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\nup = [0, 0, 1]"), None,
     "camera: eye, target and up are on one line in frame 0"),
    (changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\nup = [0, 0, 0]"), None,
     "camera.up: must have a length"),
    (changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\nfov = 0.5"), None,
     "camera.fov: must be from 1 to 170"),
    (changed("width = 64", "width = 1024").replace("eye = [0, 0, 10]", "eye = [0, 0, 10]\nfov = 2"),
     None, "camera.fov: is too narrow for 1024 pixels: a focal length of 29"),
    (changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\nnear = 0"), None, "camera.near: must be from 0.0039"),
    (changed("eye = [0, 0, 10]", "eye = [0, 0, 10]\nzoom = 2"), None, "camera.zoom: unknown field"),
    (GOOD + "[light]\ndirection = [0, 0, 0]\n", None, "light.direction: must have a length"),
    (GOOD + "[light]\nambient = 0.5\n", None, "light.direction: is missing"),
    (placed("size = 0"), None, "objects[1].size: must be from 1e-06"),
    (placed("size = 1000"), None, "objects[1].mesh: mesh.obj: a point is more than 2048 units from"),
    (placed("axis = [0, 0, 0]"), None, "objects[1].axis: must have a length"),
    (placed("centre = [1, 2]"), None, "objects[1].centre: unknown field; known are mesh"),
    (placed("two_sided = 1"), None, "objects[1].two_sided: must be true or false"),
    (placed("position = [0, 0, -10230]").replace("position = [2, 0, 0]\n", ""), None,
     "objects[1]: is 10240 units or more from the camera in frame 0"),
    (changed("[0, 0, 10]", "[0, 0, 10]\nfov = 170") + "keys = [{ frame = 0, position = [9e4, 0, 0] }]\n",
     None, "objects[1]: is 10240 units or more from the camera in frame 0"),
    (placed("keys = [{ frame = 3 }, { frame = 3 }]"), None, "objects[1].keys[1].frame: must be above 3"),
    (placed("keys = [{ position = [0, 0, 0] }]"), None, "objects[1].keys[0].frame: is missing"),
    (placed('mapping = "sphere"'), None, "objects[1].mapping: 'sphere' is not one of uv, environment"),
    (placed('mapping = "uv"'), None, "objects[1].mapping: \"uv\", but material 'red' takes none"),
    (placed('normals = "faces"'), None, "objects[1].normals: material 'red' has no use for them"),
    (on_file("odd", 'mapping = "environment"'), None, "material 'odd' takes uv"),
    (on_file("glow", 'normals = "file"'), obj(OBJ.replace("/1 ", " ").replace("/1\n", "\n")),
     'objects[1].normals: "file", but not every corner has a normal there'),
    (on_file("wall"), obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
     'objects[1].mapping: "uv" needs texture coordinates at every corner'),
    (on_file("odd"), obj(OBJ.replace("vt 1 1", "vt 1.1 1")),
     'objects[1].mesh: mesh.obj: line 11: mapper "arbitrary" does not repeat: s must be from 0 to 256'),
    (on_file("wall"), obj(OBJ.replace("vt 1 1", "vt 900 1")), "16384 texels or more from the map's"),
    (changed('"mesh.obj"', '"none.obj"'), None, "objects[1].mesh: none.obj: no such file"),
    (changed('"mesh.obj"', '"wall.png"'), None, "objects[1].mesh: wall.png: "),
    (GOOD, obj(""), "objects[1].mesh: mesh.obj: has no faces"),
    (GOOD, obj("v 0 0 0\n"), "mesh.obj: has no faces"),
    (GOOD, obj("v 0 0 0\nv 1 0 0\nf 1 2 9\n"), "mesh.obj: line 3: the face names a point that is not there"),
    (GOOD, obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 x\n"), "mesh.obj: line 4: its corners cannot be read"),
    (GOOD, obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1/7 2/8 3/9\n"), "line 4: the face names a texture coordinate that is not"),
    (GOOD, obj("v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n"),
     "objects[1].mesh: mesh.obj: line 3: its numbers cannot be read"),
    (GOOD, obj("v 0 0 0\nv 1 0 0 # x\nv 1. .5\nf 1 2 3\n"), "line 3: its numbers cannot be read"),
    (GOOD, obj("v 0 0 0\nv 1 0 0\nv 1e30 1 0\nf 1 2 3\n"), "a point is more than 2048 units"),
    (GOOD, obj("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
     "objects[1].mesh: mesh.obj: no face has an area"),
    (GOOD, obj(ZIGZAG + "f 1 3 2 4 5\n"), "objects[1].mesh: mesh.obj: line 6: crosses itself"),
    (GOOD, obj(STAR + "f 1 2 3 4 5\n"), "objects[1].mesh: mesh.obj: line 6: crosses itself"),
    (GOOD, obj(RING + "f " + " ".join(map(str, range(1, 130))) + "\n"),
     "objects[1].mesh: mesh.obj: line 130: has 129 corners; 128 at most"),
    (GOOD, obj(OBJ + "f 1 2 3\n" * 4095), "mesh.obj: 4097 faces; 4096 at most"),
    (GOOD, obj("".join(f"v {k % 100} {k // 100} {k * k % 11}\n" for k in range(4098))
               + "".join(f"f {k} {k + 1} {k + 2}\n" for k in range(1, 4097))),
     "objects[1].mesh: mesh.obj: 4098 points; 4096 at most"),
    (changed("faces = [[0, 1, 2, 3]]", "faces = [[0, 1, 2, 4]]"), None,
     "objects[0].faces[0][3]: there is no point 4"),
    (changed("faces = [[0, 1, 2, 3]]", "faces = [[0, 1]]"), None,
     "objects[0].faces[0]: must have 3 to 32 entries"),
    (changed("faces = [[0, 1, 2, 3]]\n", ""), None, "objects[0].faces: is missing"),
    (changed("faces = [[0, 1, 2, 3]]", "faces = [[0, 1, 2, 3], [0, 2, 1, 3]]"), None,
     "objects[0].faces[1]: crosses itself"),
    (changed(", [0, 0]]]", "]]"), None, "objects[0].uvs[0]: must have 4 entries, one a corner of face 0"),
    (changed("uvs = [[[0, 128]", "uvs = [[[0, 0], [1, 1], [0, 1]], [[0, 128]"), None,
     "objects[0].uvs: must have 1 entries, one a face, or one for all; not 2"),
    (changed("uvs = [[[0, 128]", "uvs = [[[0, 99999]"), None, "objects[0].uvs[0][0][1]: must be from"),
    (GOOD[:GOOD.index("[[objects]]")] + '[[objects]]\nmaterial = "red"\n', None,
     "objects[0]: needs exactly one of sides, vertices, rectangle, mesh, points"),
])
def test_refused(folder, text, prepare, message):
    if prepare:
        prepare(folder)
    with pytest.raises(UserError) as caught:
        make(folder, text)
    assert message in without_line(str(caught.value), folder / "scene.toml")


def test_too_many_views(folder, monkeypatch):
    """The error names the first object that exceeds the limit."""
    monkeypatch.setattr(objects.Space, "view", lambda *_: [0] * 25)
    text = GOOD.replace("frames = 8", "frames = 1000") + \
        '[[objects]]\nmaterial = "red"\nmesh = "mesh.obj"\n' * 64
    with pytest.raises(UserError, match=r"objects\[65\]: more than 65536 frames of meshes in the scene"):
        make(folder, text)


def test_too_many_points_together(folder):
    """Sixteen meshes of 4,096 points are not too many, and a polygon separates them from the
    next."""
    points = "".join(f"v {k % 64} {k // 64} 0\n" for k in range(4096))
    faces = "".join(f"f {k} {k + 1} {k + 65} {k + 64}\n" for k in range(1, 4032) if k % 64)
    (folder / "mesh.obj").write_text(points + faces)
    mesh = '[[objects]]\nmaterial = "red"\nmesh = "mesh.obj"\n'
    polygon = '[[objects]]\nmaterial = "red"\nvertices = [[0, 0], [8, 0], [0, 8]]\n'
    head = GOOD[:GOOD.index("[[objects]]")]
    assert len(make(folder, head + mesh * 16 + polygon + mesh, 1).instances) == 17
    with pytest.raises(UserError, match=r"objects\[16\]: more than 65536 points in meshes one"):
        make(folder, head + mesh * 17, 1)


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
def test_lines_are_counted_as_in_the_file(folder, ending):
    """Continued statements, whose first line counts; comments, which do not continue; all endings."""
    text = ("# made in C:\\models\\\nv 0 0 0\nv 1 0 \\\n0\n\nv 1 1 0\nv 0 1 0 # back\n"
            "g side\nf 1 2 \\\n3 \\\n4 # all\nf 1// 2/ 3\nf -4 -3 -2\n")
    file = folder / "mesh.obj"
    file.write_bytes(text.replace("\n", ending).encode())
    made = make(folder)
    assert made.faces[made.meshes[1].face:, 5].tolist() == [4, 3, 3]
    for face, line in (("f 1 2 9", 14), ("f 1 2 \\\n0", 14), ("\n\nf 1 2 -5", 16), ("v 1 2 \\\n\\\nx", 14)):
        file.write_bytes((text + face).replace("\n", ending).encode())
        with pytest.raises(UserError, match=f"mesh.obj: line {line}: "):
            make(folder)


@pytest.mark.parametrize("seed", range(4))
def test_any_bytes_as_a_mesh_are_read_or_refused(folder, seed):
    """Text that resembles an OBJ file, and noise; some of it after a valid file."""
    random = np.random.default_rng(seed)
    words = np.array(["v", "f", "vt", "vn", "1", "-1", "2", "0.5", "1/1", "3//2", "1e9", "nan", "\n",
                      "\n", "x", "\\", "usemtl", "mtllib wall.png", "o", "l", "s", "9" * 30, "\0"])
    read = 0
    for k in range(40):
        text = " ".join(random.choice(words, 200)) if k % 4 else random.bytes(300).decode("latin-1")
        (folder / "mesh.obj").write_bytes((OBJ * int(k % 3) + text).encode("latin-1"))
        try:
            make(folder)
            read += 1
        except UserError as error:
            assert "\n" not in str(error) and "objects[1].mesh: " in str(error), f"file {k}: {error}"
    assert 0 < read < 40, f"{read} of 40 files are read"
