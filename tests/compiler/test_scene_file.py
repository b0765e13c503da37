"""Scene files: they are read back as written, and damaged files are refused."""

import dataclasses
import zlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compiler.scene_examples import LIGHT, TEXTURED, WRITTEN, example, vertices
from tests.helpers import mesh_cases
from tmap.base import maps
from tmap.base.errors import UserError
from tmap.base.pixel_formats import FORMATS
from tmap.build import layout
from tmap.scene_file import meshes, scene_file, units
from tmap.scene_file.scene_file import Material, Object, Scene, Texture


def assert_equal(a: Scene, b: Scene):
    """Compares two scenes field by field."""
    __tracebackhide__ = True
    for field in dataclasses.fields(Scene):
        one, other = getattr(a, field.name), getattr(b, field.name)
        same = np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other
        assert same, f"{field.name}: {one} became {other}"


@pytest.mark.parametrize("textures", [0, 1, 3])
def test_round_trip(textures):
    """The scene is the same, and writing it again gives the same bytes."""
    scene = example(textures=textures)
    data = scene_file.write(scene)
    again = scene_file.read(data, "x")
    assert_equal(scene, again)
    assert scene_file.write(again) == data
    assert again.palette.dtype == np.uint8
    assert all(texture.texels.dtype == np.uint8 for texture in again.textures)


@settings(deadline=None)
@given(st.integers(0, 2**32), st.integers(4, 64), st.integers(3, 64))
def test_round_trip_of_any_numbers(seed, side, corners):
    """Of vertices and poses, in frames of any height."""
    scene = example(seed, 0)
    scene.width, scene.height = side // 4 * 4, side
    scene.vertices = vertices(np.random.default_rng(seed), corners)
    scene.objects = [Object(0, 0, corners, 1, 3, 2)]
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


LAYOUT_SIZES = [("page", 8, 256), ("page", 256, 16), ("linear", 1, 1), ("linear", 7, 1024),
                ("tiled", 256, 256), ("columns", 8, 32768), ("columns", 512, 512),
                ("margins", 256, 256)]


@pytest.mark.parametrize("kind, width, height", LAYOUT_SIZES)
def test_round_trip_of_every_layout(kind, width, height):
    """Maps of several sizes, the smallest and the largest ones."""
    texels = np.random.default_rng(1).integers(0, 256, (height, width)).astype(np.uint8)
    mapper = next(m for m, wanted in scene_file.MAPPER_LAYOUT.items() if wanted == kind)
    scene = dataclasses.replace(example(), textures=[Texture(texels, kind)] * 2,
                                materials=[Material(), Material(mapper, texture=1)])
    scene.vertices[:, 2:4] = 0
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


def test_round_trip_of_16_bits():
    """In columns; checks the bytes of the texels."""
    texels = np.random.default_rng(1).integers(0, 65536, (16, 32)).astype(np.uint16)
    scene = dataclasses.replace(
        example(), format="rgb565", background=65535, textures=[Texture(texels, "columns")],
        materials=[Material(colour=65535), Material("columns", texture=0)])
    data = scene_file.write(scene)
    assert_equal(scene, scene_file.read(data, "x"))
    # u 0 to 3 of the first row, then of the second: columns are 4 texels wide.
    assert data[-1024:-1008] == texels[:2, :4].astype(">u2").tobytes()


@pytest.mark.parametrize("name", ["rgb565", "rgba5551", "rgba8888"])
def test_round_trip_of_wide_pages(name):
    """Texels are big-endian in the file."""
    pixel = FORMATS[name]
    most = 256**pixel.bytes - 1
    texels = np.random.default_rng(1).integers(0, most + 1, (16, 32), dtype=pixel.dtype)
    scene = dataclasses.replace(
        example(), format=name, background=most, textures=[Texture(texels)],
        materials=[Material(colour=most), Material("affine", texture=0)])
    data = scene_file.write(scene)
    assert_equal(scene, scene_file.read(data, "x"))
    assert data.endswith(texels.astype(pixel.dtype.newbyteorder(">")).tobytes())


def test_formats_are_the_headers():
    """Names and numbers are those of enum pixel_format."""
    constants = layout.load().constants
    numbers = [constants[f"PIXEL_{name}".upper()] for name in FORMATS]
    assert numbers == list(range(constants["PIXEL_FORMATS"]))


def test_round_trip_of_a_light_table():
    """The light table follows the texture that it lights."""
    scene = example()
    scene.textures.append(LIGHT)
    scene.materials = [Material("lit", gradients="scanline", texture=0, light=1),
                       Material("lit_gouraud", texture=0, light=1)]
    scene.vertices[:, 4] &= 0xFFFFFF
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


@pytest.mark.parametrize("seed", range(3))
def test_round_trip_of_meshes(seed):
    """Boxes, and meshes that are hard to draw."""
    for scene in (mesh_cases.boxes(seed), mesh_cases.hostile(seed)):
        data = scene_file.write(scene)
        again = scene_file.read(data, "x")
        assert_equal(scene, again)
        assert scene_file.write(again) == data


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


def test_empty_tables():
    """A scene in which nothing is drawn."""
    scene = dataclasses.replace(example(textures=0), materials=[], objects=[],
                                vertices=np.zeros((0, 6), int), poses=np.zeros((0, 6), int))
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


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


@settings(deadline=None)
@given(st.sampled_from([WRITTEN, TEXTURED]), st.data(), st.integers(1, 255))
def test_any_flipped_byte_is_refused(data, draw, flip):
    """Anywhere, whatever the byte becomes."""
    at = draw.draw(st.integers(0, len(data) - 1))
    damaged = bytearray(data)
    damaged[at] ^= flip
    with pytest.raises(UserError, match="^x: "):
        scene_file.read(bytes(damaged), "x")


def test_every_byte_counts():
    """One bit of each byte."""
    for at in range(len(WRITTEN)):
        damaged = WRITTEN[:at] + bytes([WRITTEN[at] ^ 1 << at % 8]) + WRITTEN[at + 1:]
        with pytest.raises(UserError, match="^x: "):
            scene_file.read(damaged, "x")


@settings(deadline=None)
@given(st.binary(max_size=200), st.integers(0, len(WRITTEN) - 1))
def test_cut_and_foreign_files_are_refused(rubbish, cut):
    """Noise, the beginning of a file, the same with noise after it, one byte too many."""
    for data in (rubbish, WRITTEN[:cut], WRITTEN[:cut] + rubbish[:len(WRITTEN) - cut - 1],
                 WRITTEN + b"\0"):
        with pytest.raises(UserError, match="^x: "):
            scene_file.read(data, "x")
