"""Scenes in which one field cannot be: it is named, and no file is written."""

import dataclasses

import numpy as np
import pytest

from tests.compiler.scene_examples import LIGHT, example
from tmap.base.errors import UserError
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material, Object, Texture


@pytest.mark.parametrize("change, message", [
    ({"width": 7}, "scene: width"),
    ({"frames": 0}, "scene: frames"),
    ({"background": -1}, "scene: background"),
    ({"materials": [Material("affine", texture=1), Material()]}, r"scene: materials\[0\].texture"),
    ({"materials": [Material("cubic"), Material()]},
     r"scene: materials\[0\].mapper: 'cubic' is not one of flat, gouraud"),
    ({"materials": [Material(), Material("affine", gradients="polygon", texture=0)]},
     r"objects\[1\].vertices: 4, but gradients 'polygon' are for triangles"),
    ({"materials": [Material(), Material("gouraud")], "vertices": np.full((6, 6), 256 << 16)},
     r"objects\[1\]: shade: 16777216 is not from 0 to 16777215"),
    ({"textures": [Texture(np.zeros((9, 7), np.uint8), "linear")], "vertices": np.full((6, 6), -1),
      "materials": [Material(), Material("arbitrary", texture=0)]},
     r"objects\[1\]: s: -1 is not from 0 to 16777216"),
    ({"textures": [Texture(np.zeros((8, 4), np.uint8), "linear")],
      "vertices": np.full((6, 6), 256 << 16),
      "materials": [Material(), Material("arbitrary", texture=0)]},
     r"objects\[1\]: texel of s: 524288 is not from 0 to 262144"),
    ({"textures": [Texture(np.zeros((8, 8), np.uint16), "columns")]}, r"textures\[0\].texel_bytes"),
    ({"format": "rgb565", "textures": [Texture(np.zeros((256, 256), np.uint16), "tiled")]},
     r"textures\[0\].layout: 'tiled' is not for these pixels"),
    ({"format": "rgba8888", "textures": [Texture(np.zeros((8, 8), np.uint32), "columns")]},
     r"textures\[0\].layout: 'columns' is not for these pixels"),
    ({"format": "rgba8888", "textures": [Texture(np.zeros((8, 8), np.uint32))],
      "materials": [Material(), Material("affine", perspective="fine", texture=0)]},
     r"materials\[1\].perspective: 'fine' is for pixels of one byte"),
    ({"format": "rgba5551", "textures": [], "materials": [Material("gouraud"), Material()]},
     r"materials\[0\].mapper: 'gouraud' is not for pixels of 2 bytes"),
    ({"materials": [Material("lit", texture=0, light=0), Material()]},
     r"materials\[0\].light: its layout is page, not light"),
    ({"materials": [Material("lit", texture=0), Material()]},
     r"materials\[0\].light: -1 is not from 0 to 0"),
    ({"materials": [Material("lit_gouraud", gradients="scanline", texture=0), Material()]},
     r"materials\[0\].mapper: 'lit_gouraud' needs gradients 'plane' and start 'subtexel'"),
    ({"materials": [Material("dithered", start="truncated", texture=0), Material()]},
     r"materials\[0\].mapper: 'dithered' needs gradients 'plane' and start 'subtexel'"),
    ({"materials": [Material("dithered", perspective="pixel", texture=0), Material()]},
     r"materials\[0\].perspective: 'pixel' needs mapper 'affine'"),
    ({"textures": [Texture(np.zeros((256, 256), np.uint8)), LIGHT],
      "materials": [Material(), Material("lit_gouraud", texture=0, light=1)],
      "vertices": np.full((6, 6), -1)}, r"objects\[1\]: shade: -1 is not from 0 to 16777215"),
    ({"objects": [Object(0, 0, 3, 0, 5, 0)]}, r"scene: objects\[0\].pose"),
    ({"vertices": np.full((6, 6), 2**31)}, "vertex.x does not fit 32 bits"),
    ({"poses": np.full((4, 6), -2**31 - 1)}, "scene_pose.xx does not fit 32 bits"),
])
def test_bad_scenes_are_not_written(change, message):
    """The error is raised before a file is written."""
    with pytest.raises(UserError, match=message):
        scene_file.write(dataclasses.replace(example(), **change))
