"""Every mesh and picture of the scenes has its maker, and a scene that reads it."""

import io

import numpy as np
import pytest
from PIL import Image

from tests.screen import pictures
from tmap import assets
from tmap.base.paths import SCENES
from tmap.guest import cache
from tmap.report import readme
from tmap.shapes import mesh_file

AGAIN = "PYTHONPATH=tools .deps/venv/bin/python -m tmap.assets"


@pytest.mark.parametrize("name", assets.FILES)
def test_committed_file_is_what_its_maker_makes(name: str) -> None:
    """Meshes are compared byte for byte, pictures by their texels: another zlib may compress them
    differently."""
    made, committed = assets.FILES[name](), (SCENES / name).read_bytes()
    if name.endswith(".obj"):
        assert made == committed, f"{name} is not what its maker makes: {AGAIN}"
        return
    found, expected = (Image.open(io.BytesIO(file)) for file in (committed, made))
    assert (found.mode, found.size) == (expected.mode, expected.size), name
    found, expected = (np.asarray(image.convert("RGB")) for image in (found, expected))
    wrong = np.argwhere((found != expected).any(-1))
    assert not len(wrong), (
        f"{name}: texel y, x {tuple(wrong[0])} is {found[tuple(wrong[0])]}, its maker's "
        f"{expected[tuple(wrong[0])]}, and {len(wrong) - 1} more: {AGAIN}")


def test_every_picture_and_mesh_has_a_maker_and_a_reader() -> None:
    """Pictures that show results belong to the pages and are left out."""
    drawn = {readme.PICTURE, readme.ANIMATION, readme.METHODS, readme.LEVEL,
             SCENES / "terrace.gif",  # tests/mipmap/shimmer.py
             pictures.SHEET}
    there = {path for path in SCENES.rglob("*") if path.suffix in (".png", ".gif", ".obj")}
    assert there - drawn == {SCENES / name for name in assets.FILES}
    read = {file.resolve() for path in SCENES.rglob("*.toml") for file in cache.scene_files(path)}
    assert there - drawn == {file for file in read if file.suffix != ".toml"}


@pytest.mark.parametrize("name", assets.meshes.FILES | assets.rooms.FILES)
def test_meshes_are_closed_and_face_outwards(name: str) -> None:
    """Each edge belongs to two faces, with opposite directions; the enclosed volume is positive, by
    the divergence theorem."""
    mesh = mesh_file.load(name, SCENES, name, (1, 1))
    edges = [(face[k - 1], face[k]) for face in mesh.faces for k in range(len(face))]
    assert len(edges) == len(set(edges)), name
    assert set(edges) == {(b, a) for a, b in edges}, name
    corners = [mesh.points[list(face)] for face in mesh.faces]
    volume = sum(np.linalg.det([face[0], face[k], face[k + 1]])
                 for face in corners for k in range(1, len(face) - 1)) / 6
    assert volume > 0, name
