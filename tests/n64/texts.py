"""Texts of scenes with one of the N64's texture engines."""

from tests.helpers.engine_scenes import compiled, scene_text
from tmap.scene_file.scene_file import Scene

SQUARE = "vertices = [[0, 0, 0, 0], [32, 0, 32, 0], [32, 32, 32, 32], [0, 32, 0, 32]]"
TILE = 'image = "noise.png", format = "rgba16"'
ONE = f"tiles = [{{ {TILE} }}]"


def scene_of(engine: str, obj: str = SQUARE, more: str = "", **kinds) -> str:
    return scene_text(f"{more}n64 = {{ {engine} }}", obj, **kinds)


def make(folder, *args, **kinds) -> Scene:
    return compiled(folder, scene_of(*args, **kinds))
