"""Scene files: bytes and names are those of the C headers; what may not be is not written."""

import dataclasses
import zlib

import numpy as np
import pytest

from tests.compiler.scene_examples import example
from tmap.base import maps
from tmap.base.pixel_formats import FORMATS
from tmap.build import layout
from tmap.scene_file import meshes, scene_file, units
from tmap.scene_file.scene_file import Material, Texture


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
    assert data[:8] == b"TMAP\0\0\0\x0b"
    assert int.from_bytes(data[8:12], "big") == len(data)
    assert int.from_bytes(data[12:16], "big") == zlib.crc32(data[16:])
    assert data[200:204] == b"\0" + scene.palette[0].tobytes()
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
