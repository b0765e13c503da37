"""OBJ files as modelling programs write them: slivers, several materials, creases, other formats."""

import numpy as np
import pytest
from PIL import Image

from tests.helpers.refusals import without_line
from tmap.base.errors import UserError
from tmap.compiler.scene import compile_scene
from tmap.scene_file import scene_file

HEAD = """\
width = 64
height = 48
frames = 2
background = "#102030"

[textures]
wall = { image = "wall.png", width = 64, height = 32 }

[materials]
red.colour = "#ff0000"
blue.colour = "#0000ff"
wall = { texture = "wall" }
glow = { shades = ["#000000", "#ffffff"] }

[camera]
eye = [0, 0, 10]
"""


@pytest.fixture
def folder(tmp_path):
    Image.fromarray(np.full((40, 60, 3), 99, np.uint8)).save(tmp_path / "wall.png")
    return tmp_path


def make(folder, mesh: str, fields: str = 'material = "red"'):
    """Compiles a scene with one object, whose mesh has this text."""
    (folder / "x.obj").write_text(mesh)
    (folder / "scene.toml").write_text(f'{HEAD}\n[[objects]]\nmesh = "x.obj"\n{fields}\n')
    made = compile_scene(folder / "scene.toml")
    scene_file.write(made)  # write checks the whole scene
    return made


def refusal(folder, mesh: str, fields: str = 'material = "red"') -> str:
    """Returns the one line, without the scene's name, with which the object is refused."""
    with pytest.raises(UserError) as caught:
        make(folder, mesh, fields)
    said, start = without_line(str(caught.value), folder / "scene.toml"), f"{folder / 'scene.toml'}: objects[0]"
    assert said.startswith(start), said
    return said.removeprefix(start)


SQUARE = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 0 0\nv 1 1e-6 0\n"


def test_slivers_are_left_out(folder, capsys):
    """No area, also after rounding to 16.16; two corners; one point twice; there and back. The scene
    is what it is without them, and one line says how many there were and where the first is."""
    slivers = ["f 1 5 2", "f 1 2 6", "f 1 2", "f 1 1 2", "f 1 2 1 2", "f 1 2 3 2", "f 1"]
    made = make(folder, SQUARE + "\n".join([slivers[0], "f 1 2 3 4", *slivers[1:]]) + "\n")
    said = capsys.readouterr().err
    assert said == (f"tmap: {folder / 'scene.toml'}:19: objects[0].mesh: x.obj: line 7: has no area and is left out, "
                    f"the first of {len(slivers)} such faces\n")
    plain = make(folder, SQUARE + "f 1 2 3 4\n")
    assert not capsys.readouterr().err and scene_file.write(made) == scene_file.write(plain)


def test_slivers_of_lists_are_left_out(folder, capsys):
    (folder / "scene.toml").write_text(
        f'{HEAD}\n[[objects]]\nmaterial = "red"\npoints = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]]\n'
        "faces = [[0, 1, 3], [0, 1, 2]]\n")
    assert compile_scene(folder / "scene.toml").meshes[0].faces == 1
    assert capsys.readouterr().err.endswith("objects[0].faces[1]: has no area and is left out\n")


@pytest.mark.parametrize("faces", ["f 1 5 2", "f 1 2\nf 1 2 6"])
def test_a_mesh_of_slivers_is_refused(folder, capsys, faces):
    assert refusal(folder, SQUARE + faces) == ".mesh: x.obj: no face has an area"
    assert not capsys.readouterr().err


#: A roof: two squares with an edge in common, and a triangle without coordinates, each of a material.
ROOF = """\
v 0 0 0
v 2 0 0
v 2 2 -2
v 0 2 -2
v 2 -2 -2
v 0 -2 -2
v 5 0 0
v 6 0 0
v 5 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl red brick
f 1/1 2/2 3/3 4/4
usemtl glass
f 2/1 1/2 6/3 5/4
usemtl steel
f 7 8 9
"""
THREE = 'materials = {{ "red brick" = "{}", glass = "{}", steel = "{}" }}\n'


def test_one_instance_for_each_material(folder):
    """Each material of the scene gets the faces of the file's; position, size and turns are of all;
    the parts of one object are sorted together."""
    made = make(folder, ROOF, THREE.format("wall", "red", "red") + "position = [0, 0, 4]\nsize = 0.5\nturns = 1")
    wall, red = made.instances
    assert (wall.material, red.material, wall.before, red.before) == (2, 0, 0, 0)
    assert [(made.meshes[i.mesh].faces, made.meshes[i.mesh].points) for i in (wall, red)] == [(1, 4), (2, 7)]
    views = [made.views[i.view:i.view + i.views] for i in (wall, red)]
    assert len(views[0]) == 2 and (views[0] == views[1]).all() and views[0][0, 11] == 6 << 16
    assert made.points[:, 0].max() == 3 << 16
    # The triangle has no coordinates and needs none: it is red.
    corners = made.corners[made.meshes[wall.mesh].corner:][:4, 2:]
    assert (corners == [[0, 128 << 16], [256 << 16, 128 << 16], [256 << 16, 0], [0, 0]]).all()


def test_one_material_for_all_faces(folder):
    """The file's materials do not count then."""
    made = make(folder, ROOF)
    assert len(made.instances) == 1 and made.meshes[0].faces == 3


def test_smooth_normals_have_no_seam(folder):
    """On the common edge of two materials both parts have the mean of their normals; a part whose
    material has no use for normals or mapping is drawn without."""
    fields = THREE.format("glow", "glow2", "red") + 'normals = "smooth"\nmapping = "shade"'
    (folder / "x.obj").write_text(ROOF)
    (folder / "scene.toml").write_text(HEAD.replace("glow =", 'glow2 = { shades = ["#000000", "#00ff00"] }\nglow =')
                                       + f'\n[[objects]]\nmesh = "x.obj"\n{fields}\n')
    made = compile_scene(folder / "scene.toml")
    assert len(made.instances) == 3
    for instance in made.instances[:2]:
        mesh = made.meshes[instance.mesh]
        corners = made.corners[mesh.corner:mesh.corner + mesh.corners]
        for point, normal, *_ in corners.tolist():
            x, y, z = made.points[mesh.point + point, :3] / 65536
            expected = [0, 0, 1] if y == 0 else np.array([0, np.sign(y), 1]) / np.sqrt(2)
            assert abs(made.normals[mesh.normal + normal, :3] / 16384 - expected).max() < 1e-4


def test_tables_may_have_more_than_a_file(folder, capsys):
    """Entries without faces make no instance, also if all their faces are slivers."""
    fields = THREE.format("wall", "red", "blue") + 'last = 1'
    text = ROOF.replace("f 7 8 9", "f 7 8 8").replace("usemtl glass\n", "")
    assert len(make(folder, text, fields).instances) == 1
    assert "line 18: has no area" in capsys.readouterr().err
    made = make(folder, "f 1 2 3\n" + ROOF, 'materials = { "" = "blue", "red brick" = "red", glass = "red", '
                                            'steel = "red" }')
    assert [made.meshes[i.mesh].faces for i in made.instances] == [1, 3]


@pytest.mark.parametrize("fields, message", [
    ("", ".material: is missing"),
    ("materials = {}", ".materials: names no material"),
    ('material = "red"\nmaterials = { glass = "red" }',
     ".materials: there is a material for the whole object too"),
    ('materials = "red"', '.materials: must be a table or "file"'),
    ("materials = { glass = 3 }", ".materials.glass: must be text, not a number"),
    ('materials = { glass = "pane" }', ".materials.glass: there is no material 'pane'"),
    ('materials = { glass = "red" }',
     ".materials: x.obj: line 15: a face of material 'red brick', which has no entry"),
    (THREE.format("glow", "red", "red") + 'mapping = "uv"',
     ".mapping: \"uv\", but material 'glow' takes shade"),
    (THREE.format("wall", "red", "wall"), '.mapping: "uv" needs texture coordinates at every corner'),
    (THREE.format("blue", "red", "red") + 'normals = "smooth"', ".normals: material 'blue' has no use for them"),
])
def test_materials_are_refused(folder, fields, message):
    assert refusal(folder, ROOF, fields) == message


def test_faces_before_the_first_usemtl_are_named(folder):
    assert refusal(folder, "v 0 0 0\nf 1 1 1\n" + ROOF, THREE.format("red", "red", "red")) == (
        '.materials: x.obj: line 2: a face before the first usemtl, which needs the entry ""')


#: Three squares in a row, each turned by 30 degrees from the one before, from left to right.
ARC = "".join(f"v {x} {y} {z}\n" for x, z in ((0, 0), (2, 0), (2 + 3 ** 0.5, -1), (3 + 3 ** 0.5, -1 - 3 ** 0.5))
              for y in (0, 2)) + "f 1 3 4 2\nf 3 5 6 4\nf 5 7 8 6\n"


SMOOTH = {(0, 0), (1, 15), (2, 45), (3, 60)}  # column of points, angle of a normal there
SHARP = {(0, 0), (1, 0), (1, 30), (2, 30), (2, 60), (3, 60)}


@pytest.mark.parametrize("crease, expected", [(None, SMOOTH), (180, SMOOTH), (31, SMOOTH), (29, SHARP), (0, SHARP)])
def test_creases(folder, crease, expected):
    """Edges of 30 degrees are smooth or sharp. Normals turn about y, clockwise from z."""
    made = make(folder, ARC, 'material = "glow"' + (f"\ncrease = {crease}" if crease is not None else ""))
    columns = sorted(set(made.points[:, 0].tolist()))
    found = set()
    for point, normal, *_ in made.corners.tolist():
        x, y, z = made.normals[normal, :3] / 16384
        assert y == 0
        found.add((columns.index(made.points[point, 0]), round(np.degrees(np.arctan2(x, z)))))
    assert found == expected


def test_a_cube_keeps_its_edges(folder):
    """Faces at the angle itself are smooth; below it, each face has its own normal; a file's normals
    do not count."""
    points = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1)) + "vn 1 2 3\n"
    sides = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
    cube = points + "".join("f " + " ".join(f"{k}//1" for k in side) + "\n" for side in sides)
    counts = [len(make(folder, cube, f'material = "glow"\n{field}').normals)
              for field in ("crease = 89", "crease = 90", 'normals = "file"')]
    assert counts == [6, 8, 1]


@pytest.mark.parametrize("fields, message", [
    ('material = "glow"\ncrease = 181', ".crease: must be from 0 to 180"),
    ('material = "glow"\ncrease = 40\nnormals = "faces"', '.crease: goes with normals "smooth", not "faces"'),
    ('material = "red"\ncrease = 40', ".crease: material 'red' has no use for them"),
])
def test_creases_are_refused(folder, fields, message):
    assert refusal(folder, ARC, fields) == message


@pytest.mark.parametrize("name, kind", [
    ("x.glb", "glTF"), ("x.gltf", "glTF"), ("a.b/X.STL", "STL"), ("x.ply", "PLY"), ("x.3ds", "3D Studio"),
    ("x.mtl", "a material library")])
def test_other_formats_are_named(folder, name, kind):
    """Whether the file is there or not."""
    fields = f'material = "red"\n[[objects]]\nmaterial = "red"\nmesh = "{name}"'
    with pytest.raises(UserError) as caught:
        make(folder, ARC, fields)
    assert str(caught.value) == (f"{folder / 'scene.toml'}:23: objects[1].mesh: {name}: is {kind}; meshes are read "
                                 "from Wavefront OBJ files (.obj)")


def test_a_part_lit_by_a_projector(folder):
    """One part's material has a unit with a projector's coordinates, and becomes polygons of the
    scene; the projector is not of the other parts. A part without faces is no fault there either."""
    unit = '[[materials.it.glide.units]]\nimage = "wall.png"\nwidth = 64\nheight = 32\nformat = "rgb565"\n'
    (folder / "x.obj").write_text(ROOF)
    text = f"""\
width = 64
height = 48
frames = 1
format = "rgba8888"
background = "#102030"
[projectors.lamp]
eye = [1, 1, 9]
target = [1, 1, 0]
[camera]
eye = [1, 1, 10]
[materials]
red.colour = "#ff0000"
[materials.it.glide]
perspective = true
{unit}combine = {{ function = "scale_other", factor = "one" }}
{unit}s = "clamp"
t = "clamp"
own = true
[[objects]]
mesh = "x.obj"
projector = "lamp"
"""
    for fields, polygons, faces in ((THREE.format("it", "red", "red"), 1, [2]),
                                    (THREE.format("red", "red", "red").replace("}", ', spare = "it" }'), 0, [3])):
        (folder / "scene.toml").write_text(text + fields)
        made = compile_scene(folder / "scene.toml")
        scene_file.write(made)
        assert len(made.objects) == polygons and [mesh.faces for mesh in made.meshes] == faces
