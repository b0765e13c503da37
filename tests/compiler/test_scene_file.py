"""Scene files: bytes and names are those of the C headers; what may not be is not written."""

import dataclasses
import zlib

import numpy as np
import pytest

from tests.compiler.scene_examples import LIGHT, example
from tmap.base import maps
from tmap.base.errors import UserError
from tmap.base.pixel_formats import FORMATS
from tmap.build import layout
from tmap.scene_file import meshes, scene_file, units
from tmap.scene_file.scene_file import Material, Object, Texture


@pytest.mark.parametrize("name, mapper", [("rgb565", "columns"), ("rgb565", "affine"),
                                          ("rgba5551", "affine"), ("rgba8888", "affine")])
def test_wide_texels(name, mapper):
    """Texels are big-endian in the file: rows of a page, or columns 4 texels wide."""
    pixel, layout_of = FORMATS[name], "page" if mapper == "affine" else mapper
    most = 256**pixel.bytes - 1
    texels = np.random.default_rng(1).integers(0, most + 1, (16, 32), dtype=pixel.dtype)
    data = scene_file.write(dataclasses.replace(
        example(), format=name, background=most, textures=[Texture(texels, layout_of)],
        materials=[Material(colour=most), Material(mapper, texture=0)]))
    in_order = texels if layout_of == "page" else texels.reshape(16, 8, 4).swapaxes(0, 1)
    assert data.endswith(in_order.astype(pixel.dtype.newbyteorder(">")).tobytes())


def test_formats_are_the_headers():
    """Names and numbers are those of enum pixel_format."""
    constants = layout.load().constants
    numbers = [constants[f"PIXEL_{name}".upper()] for name in FORMATS]
    assert numbers == list(range(constants["PIXEL_FORMATS"]))


def test_mesh_columns_are_the_headers():
    """The columns and flags of tools/tmap/scene_file/meshes.py are the fields of the structs."""
    built = layout.load()
    for table, columns in meshes.COLUMNS.items():
        assert tuple(built.struct(scene_file.TABLES[table]).fields) == columns
    assert built.constants["MESH_ENVIRONMENT"] == meshes.ENVIRONMENT
    assert built.constants["MESH_LIT"] == meshes.LIT
    assert built.constants["MESH_FOG"] == meshes.FOG


def test_names_are_the_headers():
    """Names of settings and layouts have the numbers of their enumerators."""
    constants = layout.load().constants
    for kind, names in (scene_file.SETTINGS | {"map": scene_file.LAYOUTS}).items():
        numbers = [constants[f"{kind}_{name}".upper()] for name in names]
        last = constants["MAP_LAYOUTS" if kind == "map" else f"{kind}_KINDS".upper()]
        assert numbers == list(range(last)), kind
    assert constants["UNIT_PRIMITIVES"] == len(units.PRIMITIVES)
    assert [constants[f"UNIT_{name.upper()}"] for name in units.PRIMITIVES] == [0, 1, 2, 3]


def test_565():
    """Some numbers computed by hand; tests/compiler/test_convert.py has all of them."""
    numbers = np.array([0, 65535, 0xf800, 0x07e0, 0x8410], np.uint16)
    assert maps.from_rgb565(numbers).tolist() == [
        [0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 255, 0], [132, 130, 132]]


def test_bytes_are_the_headers():
    """Spot checks of the format that do not use the layout."""
    scene = example()
    data = scene_file.write(scene)
    assert data[:8] == b"TMAP\0\0\0\x11"
    assert int.from_bytes(data[8:12], "big") == len(data)
    assert int.from_bytes(data[12:16], "big") == zlib.crc32(data[16:])
    assert data[240:244] == b"\0" + scene.palette[0].tobytes()
    assert data[-65536:] == scene.textures[0].texels.tobytes()


def test_vertices_at_rounds_every_product_down():
    """Both products of x and of y are rounded separately; the object is absent before and after its
    frames."""
    scene = example()
    one, s, t = 65536, 5, 6
    scene.vertices[:3] = [[1, 1, s, t, 8, 9], [-1, 1, s, t, 8, 9], [3, -1, s, t, 8, 9]]
    scene.poses[:3] = [one // 2, -one // 2, -1, one // 4, 7, 9]
    assert scene_file.vertices_at(scene, scene.objects[0], 2) == [
        (0 - 1 + 7, -1 + 0 + 9, s, t, 8, 9), (-1 - 1 + 7, 0 + 0 + 9, s, t, 8, 9),
        (1 + 0 + 7, -1 - 1 + 9, s, t, 8, 9)]
    assert scene_file.vertices_at(scene, scene.objects[1], 0) == []  # not there yet
    assert scene_file.vertices_at(scene, scene.objects[0], 3) == []  # gone


@pytest.mark.parametrize("change, message", [
    ({"width": 7}, "scene: width"),
    ({"pixel_width": 3}, "scene: pixel_width"),
    ({"pixel_height": 0}, "scene: pixel_height"),
    ({"frames": 0}, "scene: frames"),
    ({"background": -1}, "scene: background"),
    ({"cleared": 2}, "scene: cleared"),
    ({"once": 2}, "scene: once"),
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
      "materials": [Material(), Material("dithered", perspective="fine", texture=0)]},
     r"materials\[1\].perspective: 'fine' needs mapper"),
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
     r"materials\[0\].perspective: 'pixel' needs mapper 'affine' or 'lit' or 'lit_gouraud', gradients"),
    ({"textures": [Texture(np.zeros((256, 256), np.uint8)), LIGHT],
      "materials": [Material(), Material("lit_gouraud", texture=0, light=1)],
      "vertices": np.full((6, 6), -1)}, r"objects\[1\]: shade: -1 is not from 0 to 16777215"),
    ({"objects": [Object(0, 0, 3, 0, 5, 0)]}, r"scene: objects\[0\].pose"),
    ({"vertices": np.full((6, 6), 2**31)}, "vertex.x does not fit 32 bits"),
    ({"poses": np.full((4, 6), -2**31 - 1)}, "scene_pose.xx does not fit 32 bits"),
])
def test_bad_scenes_are_not_written(change, message):
    """Scenes in which one field cannot be: it is named, and no file is written."""
    with pytest.raises(UserError, match=message):
        scene_file.write(dataclasses.replace(example(), **change))
