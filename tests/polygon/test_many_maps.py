"""Levels of many small textures, each in a page of its own: they fit, and are bit for bit the model's."""

import numpy as np
import pytest

from tmap.model import model
from tmap.run import memory, run
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene
from tmap.scene_file.textures import Texture

WIDTH, HEIGHT, COLUMNS, SIDE = 320, 200, 16, 20
#: Textures of 64x64 that a level with a frame of 320x200 has on each machine.
MOST = {"a1200": 19, "a1200-fast": 134}


def level(count: int) -> Scene:
    """Squares in perspective, each with a texture of its own that repeats."""
    random = np.random.default_rng(3)
    vertices = []
    for number in range(count):
        x, y = number % COLUMNS * SIDE, number // COLUMNS * SIDE
        for dx, dy, s, t, depth in ((0, 0, 0, 0, 2), (SIDE, 0, 700, 0, 3), (SIDE, SIDE, 700, 500, 2),
                                    (0, SIDE, 0, 500, 1)):
            vertices.append([x + dx << 16, y + dy << 16, s << 16, t << 16, 0, depth << 16])
    return Scene(WIDTH, HEIGHT, 1, 0, random.integers(0, 256, (256, 3)).astype(np.uint8),
                 [Texture(random.integers(0, 256, (64, 64)).astype(np.uint8), name=str(n)) for n in range(count)],
                 [Material("affine", "exact", "plane", "subtexel", perspective="every16", texture=n)
                  for n in range(count)],
                 [Object(n, 4 * n, 4, n, 1, 0) for n in range(count)], np.array(vertices),
                 np.array([IDENTITY] * count))


@pytest.mark.parametrize("machine", MOST)
def test_most_textures(machine: str) -> None:
    scene = level(MOST[machine])
    assert memory.fits(scene, machine) and not memory.fits(level(MOST[machine] + 1), machine)
    assert np.array_equal(run.render(scene, machine, "addx").frames[0], model.render(scene, 0))
