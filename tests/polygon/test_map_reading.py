"""Maps read from scene files: pixels of every shape, layout and format are the model's, bit for bit."""

import numpy as np
import pytest

from tmap.base.pixel_formats import FORMATS
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene
from tmap.scene_file.textures import Texture

SIDE = 40
SHAPES = ((8, 8), (64, 64), (8, 256), (256, 8), (128, 256), (256, 128), (256, 256))  # width, height
#: Layouts other than pages, their mappers and shapes; odd numbers of bytes are padded in the file.
OTHERS = (("linear", "arbitrary", (7, 9)), ("linear", "arbitrary", (256, 256)), ("tiled", "tiled", (256, 256)),
          ("margins", "generated", (256, 256)), ("columns", "columns", (16, 64)), ("margins", "generated", (256, 256)))


def scene_of(name: str) -> Scene:
    """A row of squares, one a map; each shows some texels of the whole map, far ones too."""
    pixel, random = FORMATS[name], np.random.default_rng(7)
    shapes = [("page", "affine", shape) for shape in SHAPES]
    shapes += [each for each in OTHERS if pixel.bytes == 1 or pixel.bytes == 2 and each[0] == "columns"]
    textures, materials, objects, vertices = [], [], [], []
    for number, (layout, mapper, (width, height)) in enumerate(shapes):
        textures.append(Texture(random.integers(0, 256**pixel.bytes, (height, width), pixel.dtype), layout))
        materials.append(Material(mapper, "exact", "plane", "subtexel", texture=number))
        left, longer = number * SIDE << 16, max(width, height)
        right, s, t = left + (SIDE << 16), 256 * width / longer, 256 * height / longer
        corners = [(left, 0, 0.1, 0.1), (right, 0, s - 0.1, 0.1), (right, SIDE << 16, s - 0.1, t - 0.1),
                   (left, SIDE << 16, 0.1, t - 0.1)]
        objects.append(Object(number, 4 * number, 4, number, 1, 0))
        vertices += [[x, y, round(s * 65536), round(t * 65536), 0, 65536] for x, y, s, t in corners]
    return Scene(SIDE * len(shapes), SIDE, 1, 0, np.zeros((256, 3), np.uint8), textures, materials, objects,
                 np.array(vertices), np.array([IDENTITY] * len(shapes)), name)


@pytest.mark.parametrize("name, machine", [("chunky", "a1200"), *((name, "a1200-fast") for name in FORMATS)])
def test_maps_are_the_models(name: str, machine: str) -> None:
    scene = scene_of(name)
    found, expected = run.render(scene, machine, "addx", timed=False).frames[0], model.render(scene, 0)
    wrong = [number for number in range(len(scene.textures))
             if (found != expected)[:, number * SIDE:(number + 1) * SIDE].any()]
    assert not wrong, f"{name}: maps {wrong}"
