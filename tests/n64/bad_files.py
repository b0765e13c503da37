"""Scene files with invalid primitives of the texture engine: file, offset, value, field."""

import numpy as np

from tests.helpers.wrong_fields import M32, Row, WrongFields
from tests.helpers import mesh_cases
from tmap.scene_file.scene_file import ONE, Material, Object, Scene

KINDS = ("rectangles", "coloured")


def with_engine(scene: Scene) -> Scene:
    """The scene in 16-bit pixels, with a texture engine whose list has one word."""
    scene.format, scene.textures, scene.background = "rgba5551", [], 0
    scene.units, scene.lists = np.array([[0, 1]]), np.array([[0, 1]])
    scene.words = np.zeros((1, 2), np.int64)
    return scene


def primitives() -> Scene:
    vertices = np.full((6, 6), 65536)
    vertices[:, 2:4] = 7
    materials = [*(Material("n64", unit=0, primitive=kind) for kind in KINDS), Material()]
    return with_engine(Scene(
        8, 8, 3, 0, np.zeros((256, 3), np.uint8), [], materials,
        [Object(0, 0, 2, 0, 3, 0), Object(1, 2, 3, 0, 3, 0)], vertices,
        np.array([(ONE, 0, 0, ONE, k * ONE, 0) for k in range(4)])))


def boxes() -> Scene:
    """Meshes, and a material that meshes cannot have."""
    scene = with_engine(mesh_cases.boxes(1))
    scene.materials = [Material()] * 9 + [Material("n64", unit=0, primitive="coloured")]
    return scene


def wrong_primitives() -> list[Row]:
    """Returns rows like those of wrong_pipes in glide_bad_files."""
    rows: list[Row] = []
    entry = WrongFields(primitives(), rows).entry
    entry("materials", 0, "primitive", 4, M32)
    entry("materials", 2, "primitive", 1, 4)
    entry("objects", 0, "vertices", 1, 3, 65)
    entry("objects", 0, "material", 1, said="object.vertices")
    entry("objects", 1, "vertices", 2)
    for field in "xy":
        entry("vertices", 1, field, 1, M32)
    for field in "st":
        entry("vertices", 0, field, 32768, -32769, 2**31)
    for field in ("xx", "xy", "yx", "yy"):
        entry("poses", 1, field, 1, 65537, 2**31, said="pose.xx, xy, yx or yy")
    for field in ("x0", "y0"):
        entry("poses", 2, field, 1, M32, said="pose.x0 or y0")
    WrongFields(boxes(), rows).entry("instances", 0, "material", 9)
    return rows
