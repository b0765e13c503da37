"""materials = "file": what an OBJ file's material libraries say becomes materials of the scene."""

import numpy as np
import pytest
from PIL import Image

from tests.helpers.refusals import without_line
from tmap.base.errors import UserError
from tmap.compiler.scene import compile_scene, parse
from tmap.scene_file import scene_file

SCENE = """\
width = 64
height = 48
frames = 1
background = "#102030"

[camera]
eye = [0, 0, 10]

[[objects]]
mesh = "models/x.obj"
materials = "file"
"""
OBJ = """\
mtllib x.mtl
v 0 0 0
v 2 0 0
v 2 2 0
v 0 2 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl red brick
f 1/1 2/2 3/3 4/4
usemtl glass
f 1 2 3
usemtl steel
f 2 3 4
"""
MTL = """\
# made by hand
newmtl glass
\tKd\t0.5 0.25 \\
 2
Ks 1 1 1
newmtl red brick
Kd 1 1 1
map_Kd -s 1 1 1 -clamp on -o 0 0 -mm 0 1 old pictures\\wall 1.png
newmtl steel
newmtl unused
Kd 0 0 0
"""


@pytest.fixture
def folder(tmp_path):
    pictures = tmp_path / "models" / "old pictures"
    pictures.mkdir(parents=True)
    Image.fromarray(np.full((40, 60, 3), 99, np.uint8)).save(pictures / "wall 1.png")
    (tmp_path / "models" / "x.obj").write_text(OBJ)
    (tmp_path / "models" / "x.mtl").write_text(MTL)
    (tmp_path / "scene.toml").write_text(SCENE)
    return tmp_path


def test_colours_and_pictures(folder):
    """A texture, a colour, and a material that states nothing, in the file's order; unused ones are
    left out."""
    spec = parse(folder / "scene.toml")
    assert {name: each.get("colour") or each["texture"] for name, each in spec["materials"].items()} == {
        "models/x.obj red brick": "models/x.obj red brick", "models/x.obj glass": (128, 64, 255),
        "models/x.obj steel": (204, 204, 204)}
    assert [each["image"] for each in spec["textures"].values()] == ["models/old pictures/wall 1.png"]
    made = compile_scene(folder / "scene.toml")
    scene_file.write(made)
    assert [(i.material, made.meshes[i.mesh].faces) for i in made.instances] == [(0, 1), (1, 1), (2, 1)]
    assert (made.palette[made.textures[0].texels] == 99).all()
    assert made.palette[made.materials[1].colour].tolist() == [128, 64, 255]


def test_coordinates_are_on_the_whole_picture(folder):
    """Three times as wide as high: nothing is cut from a map of half the height."""
    pixels = np.zeros((30, 90, 3), np.uint8)
    pixels[:, :15] = 200
    Image.fromarray(pixels).save(folder / "models" / "old pictures" / "wall 1.png")
    made = compile_scene(folder / "scene.toml")
    assert made.textures[0].texels.shape == (128, 256)
    assert (made.palette[made.textures[0].texels[:, 10]] == 200).all()
    assert made.corners[:4, 2:4].max(axis=0).tolist() == [256 << 16, 128 << 16]


def test_objects_share_a_file(folder):
    """Two objects of one file have the same materials, and one more library changes one of them."""
    (folder / "scene.toml").write_text(SCENE + SCENE[SCENE.index("[[objects]]"):])
    (folder / "models" / "my x.mtl").write_text("newmtl steel\nKd 1\n")
    (folder / "models" / "x.obj").write_text("mtllib my x.mtl\n" + OBJ.replace("mtllib x.mtl", ""))
    with pytest.raises(UserError, match="line 12: a face of material 'red brick', which is in no library"):
        compile_scene(folder / "scene.toml")
    (folder / "models" / "x.obj").write_text(OBJ.replace("x.mtl", "x.mtl x.mtl\nmtllib my x.mtl"))
    made = compile_scene(folder / "scene.toml")
    assert len(made.materials) == 3 and len(made.instances) == 6 and len(made.meshes) == 3
    assert made.palette[made.materials[2].colour].tolist() == [255, 255, 255]


def test_names_in_latin_1(folder):
    """Old programs write names so; later ones in UTF-8. Names that are not text are refused."""
    for text in ("b\xfcrste", "b\u00fcrste \u2116 2"):
        for name, content in (("x.obj", OBJ), ("x.mtl", MTL)):
            encoding = "utf-8" if "\u2116" in text else "latin-1"
            (folder / "models" / name).write_bytes(content.replace("steel", text).encode(encoding))
        assert f"models/x.obj {text}" in parse(folder / "scene.toml")["materials"]
    (folder / "models" / "x.obj").write_text(OBJ.replace("steel", "\x1b[31m"))
    with pytest.raises(UserError, match="models/x.obj: line 14: must be text"):
        compile_scene(folder / "scene.toml")


@pytest.mark.parametrize("name", ["/home/me/wall.png", "C:\\art\\wall.png", "d:wall.png", "./wall.png"])
def test_paths_of_other_machines(folder, name):
    """Only the last part counts."""
    (folder / "models" / "old pictures" / "wall 1.png").rename(folder / "models" / "wall.png")
    (folder / "models" / "x.mtl").write_text(MTL.replace("old pictures\\wall 1.png", name))
    assert len(compile_scene(folder / "scene.toml").textures) == 1


@pytest.mark.parametrize("old, new, message", [
    ("newmtl steel", "newmtl iron", ".materials: models/x.obj: line 15: a face of material 'steel', which is in no "
                                    "library that the file names"),
    ("0.25", "green", ".materials: models/x.mtl: line 3: Kd must be one number or three"),
    ("-s 1 1 1", "-s 2 2", ".materials: models/x.mtl: line 8: map_Kd's option -s is not read; change the texture "
                           "coordinates in its place"),
    ("old pictures\\wall 1.png", "", ".materials: models/x.mtl: line 8: map_Kd names no picture"),
    ("wall 1", "roof", ".materials: models/x.mtl: line 8: models/old pictures/roof.png: no such file"),
    ("mtllib x", "mtllib y", ".materials: models/y.mtl: no such file"),
    ("mtllib x.mtl", "", ".materials: models/x.obj: line 11: a face of material 'red brick', which is in no library "
                         "that the file names"),
    ("usemtl red brick", "", ".materials: models/x.obj: line 11: a face before the first usemtl; it has no material"),
    ("f 2 3 4", "f 2 3 9", ".mesh: models/x.obj: line 15: the face names a point that is not there"),
    ("x.obj", "x.stl", ".mesh: models/x.stl: is STL; meshes are read from Wavefront OBJ files (.obj)"),
    ("x.obj", "y.obj", ".mesh: models/y.obj: no such file"),
])
def test_refused(folder, old, new, message):
    """One line that names the line of the file that is at fault."""
    files = [path for path in (folder / "scene.toml", *(folder / "models").glob("x.*")) if old in path.read_text()]
    files[0].write_text(files[0].read_text().replace(old, new, 1))
    with pytest.raises(UserError) as caught:
        compile_scene(folder / "scene.toml")
    said = without_line(str(caught.value), folder / "scene.toml")
    assert said == f"{folder / 'scene.toml'}: objects[0]{message}"


def test_a_picture_that_cannot_be_read(folder):
    """The message names the library's line, and the scene's line that takes the library."""
    (folder / "models" / "old pictures" / "wall 1.png").write_text("no picture")
    with pytest.raises(UserError) as caught:
        compile_scene(folder / "scene.toml")
    assert str(caught.value) == (f"{folder / 'scene.toml'}:11: objects[0].materials: models/x.mtl: line 8: "
                                 "models/old pictures/wall 1.png: not a PNG or JPEG picture")


@pytest.mark.parametrize("seed", range(2))
def test_any_bytes_as_a_library_are_read_or_refused(folder, seed):
    random = np.random.default_rng(seed)
    words = np.array(["newmtl", "Kd", "map_Kd", "steel", "1", "0.5", "-s", "-mm", "wall.png", "\n", "\n", "\\", "nan",
                      "..", "\0"])
    for k in range(30):
        text = " ".join(random.choice(words, 60)) if k % 4 else random.bytes(200).decode("latin-1")
        (folder / "models" / "x.mtl").write_bytes((MTL * (k % 2) + text).encode("latin-1"))
        try:
            compile_scene(folder / "scene.toml")
        except UserError as error:
            assert without_line(str(error), folder / "scene.toml"), f"library {k}"
