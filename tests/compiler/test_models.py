"""OBJ files as modelling programs write them: slivers, several materials, creases, other formats."""

import numpy as np
import pytest
from PIL import Image

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
    said, start = str(caught.value), f"{folder / 'scene.toml'}: objects[0]"
    assert said.startswith(start) and "\n" not in said, said
    return said.removeprefix(start)


SQUARE = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 0 0\nv 1 1e-6 0\n"


def test_slivers_are_left_out(folder, capsys):
    """No area, also after rounding to 16.16; two corners; one point twice; there and back. The scene
    is what it is without them, and one line says how many there were and where the first is."""
    slivers = ["f 1 5 2", "f 1 2 6", "f 1 2", "f 1 1 2", "f 1 2 1 2", "f 1 2 3 2", "f 1"]
    made = make(folder, SQUARE + "\n".join([slivers[0], "f 1 2 3 4", *slivers[1:]]) + "\n")
    said = capsys.readouterr().err
    assert said == (f"tmap: {folder / 'scene.toml'}: objects[0].mesh: x.obj: line 7: has no area and is left out, "
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
