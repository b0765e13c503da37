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


def test_columns_of_16_bits():
    """Texels are big-endian, in columns."""
    texels = np.random.default_rng(1).integers(0, 65536, (16, 32)).astype(np.uint16)
    scene = dataclasses.replace(
        example(), format="rgb565", background=65535, textures=[Texture(texels, "columns")],
        materials=[Material(colour=65535), Material("columns", texture=0)])
    data = scene_file.write(scene)
    # u 0 to 3 of the first row, then of the second: columns are 4 texels wide.
    assert data[-1024:-1008] == texels[:2, :4].astype(">u2").tobytes()


@pytest.mark.parametrize("name", ["rgb565", "rgba5551", "rgba8888"])
def test_wide_pages(name):
    """Texels are big-endian in the file."""
    pixel = FORMATS[name]
    most = 256**pixel.bytes - 1
    texels = np.random.default_rng(1).integers(0, most + 1, (16, 32), dtype=pixel.dtype)
    scene = dataclasses.replace(
        example(), format=name, background=most, textures=[Texture(texels)],
        materials=[Material(colour=most), Material("affine", texture=0)])
    data = scene_file.write(scene)
    assert data.endswith(texels.astype(pixel.dtype.newbyteorder(">")).tobytes())


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


def test_orders_are_the_headers():
    """Texel (u, v) is where the formulas in c/texture/map.h put it."""
    array = np.arange(65536).reshape(256, 256)
    tiled, columns = maps.to_tiled(array), maps.to_columns(array[:32])
    for u, v in ((0, 0), (7, 0), (8, 0), (255, 31), (100, 17), (13, 5)):
        assert tiled[2048 * (u // 8) + 8 * v + u % 8] == 256 * v + u
        assert columns[4 * 32 * (u // 4) + 4 * v + u % 4] == 256 * v + u


def test_565():
    """All numbers in both directions, some computed by hand."""
    numbers = np.arange(65536, dtype=np.uint16)
    assert (maps.to_rgb565(maps.from_rgb565(numbers)) == numbers).all()
    assert maps.from_rgb565(numbers[[0, 65535, 0xf800, 0x07e0, 0x8410]]).tolist() == [
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
