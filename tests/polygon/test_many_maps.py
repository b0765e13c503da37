"""Levels of many small textures: they fit, and are bit for bit the model's. Those that polygons repeat all over have
pages of their own, those that they show once share pages."""

import numpy as np
import pytest

from tmap.compiler import pages
from tmap.model import model
from tmap.run import memory, run
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene
from tmap.scene_file.textures import Texture

WIDTH, HEIGHT, COLUMNS, SIDE = 320, 200, 16, 20
#: Textures of 64x64 that a level with a frame of 320x200 has on each machine.
MOST = {"a1200": 19, "a1200-fast": 134}


#: Textures that are shown once, and the pages that they share.
SHARED = {"a1200": (144, 16), "a1200-fast": (160, 18)}


def level(count: int, wide: int = 700, high: int = 500) -> Scene:
    """Squares in perspective, drawn as triangles, each with a texture of its own, of which it shows s from 0 to
    ``wide`` and t from 0 to ``high``."""
    random = np.random.default_rng(3)
    vertices = []
    for number in range(count):
        x, y = number % COLUMNS * SIDE, number // COLUMNS * SIDE
        for dx, dy, s, t, depth in ((0, 0, 0, 0, 2), (SIDE, 0, wide, 0, 3), (SIDE, SIDE, wide, high, 2),
                                    (0, SIDE, 0, high, 1)):
            vertices.append([x + dx << 16, y + dy << 16, s << 16, t << 16, 0, depth << 16])
    return Scene(WIDTH, HEIGHT, 1, 0, random.integers(0, 256, (256, 3)).astype(np.uint8),
                 [Texture(random.integers(0, 256, (64, 64)).astype(np.uint8), name=str(n)) for n in range(count)],
                 [Material("affine", "exact", "plane", "subtexel", perspective="every16", texture=n)
                  for n in range(count)],
                 [Object(n, 4 * n, 4, n, 1, 0, 0) for n in range(count)], np.array(vertices),
                 np.array([IDENTITY] * count))


@pytest.mark.parametrize("machine", MOST)
def test_most_textures(machine: str) -> None:
    scene = level(MOST[machine])
    assert memory.fits(scene, machine) and not memory.fits(level(MOST[machine] + 1), machine)
    assert np.array_equal(run.render(scene, machine, "addx", timed=False).frames[0], model.render(scene, 0))


@pytest.mark.parametrize("machine", SHARED)
def test_shared_pages(machine: str) -> None:
    """Nine textures of 64x64 share a page. 160 squares fill the frame."""
    count, shared = SHARED[machine]
    own = level(count, 256, 256)
    scene = pages.share(own)
    assert memory.shared(scene) == {"maps": count, "pages": shared}
    assert memory.fits(scene, machine) and not memory.fits(own, machine)
    frame = run.render(scene, machine, "addx", timed=False).frames[0]
    assert np.array_equal(frame, model.render(scene, 0)) and np.array_equal(frame, model.render(own, 0))
