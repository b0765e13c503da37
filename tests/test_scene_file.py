"""Scene files: what is written is read again, and nothing damaged is."""

import dataclasses
import zlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import mesh_cases
from tools import layout, maps, scene_file, scene_meshes, scene_units
from tools.errors import UserError
from tools.pixel_formats import FORMATS
from tools.scene_file import Material, Object, Scene, Texture


def vertices(random, count: int) -> np.ndarray:
    """Any numbers (w too: nothing has a perspective), shades inside the palette."""
    rows = random.integers(-2**31, 2**31, (count, 6))
    rows[:, 4] = random.integers(0, 256 << 16, count)
    return rows


def example(seed: int = 1, textures: int = 1) -> Scene:
    """A small scene of random numbers, with every table in use."""
    random = np.random.default_rng(seed)
    return Scene(
        width=8, height=5, frames=3, background=7,
        palette=random.integers(0, 256, (256, 3)).astype(np.uint8),
        textures=[Texture(random.integers(0, 256, (256, 256)).astype(np.uint8))
                  for _ in range(textures)],
        materials=[Material(colour=255), Material("affine", texture=textures - 1) if textures
                   else Material("gouraud", "exact", "plane", "truncated")],
        objects=[Object(0, 0, 3, 0, 3, 0), Object(1, 2, 4, 2, 2, 1)],
        vertices=vertices(random, 6),
        poses=random.integers(-2**31, 2**31, (4, 6)))


def assert_equal(a: Scene, b: Scene):
    for field in dataclasses.fields(Scene):
        one, other = getattr(a, field.name), getattr(b, field.name)
        assert np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other


@pytest.mark.parametrize("textures", [0, 1, 3])
def test_round_trip(textures):
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
    texels = np.random.default_rng(1).integers(0, 256, (height, width)).astype(np.uint8)
    mapper = next(m for m, wanted in scene_file.MAPPER_LAYOUT.items() if wanted == kind)
    scene = dataclasses.replace(example(), textures=[Texture(texels, kind)] * 2,
                                materials=[Material(), Material(mapper, texture=1)])
    scene.vertices[:, 2:4] = 0
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


def test_round_trip_of_16_bits():
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


LIGHT = Texture(np.arange(64 * 256, dtype=np.uint32).reshape(64, 256).astype(np.uint8), "light")


def test_round_trip_of_a_light_table():
    scene = example()
    scene.textures.append(LIGHT)
    scene.materials = [Material("lit", gradients="scanline", texture=0, light=1),
                       Material("lit_gouraud", texture=0, light=1)]
    scene.vertices[:, 4] &= 0xFFFFFF
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


@pytest.mark.parametrize("seed", range(3))
def test_round_trip_of_meshes(seed):
    for scene in (mesh_cases.boxes(seed), mesh_cases.hostile(seed)):
        data = scene_file.write(scene)
        again = scene_file.read(data, "x")
        assert_equal(scene, again)
        assert scene_file.write(again) == data


def test_mesh_columns_are_the_headers():
    """The columns and flags of tools/scene_meshes.py are the fields of the structs."""
    built = layout.load()
    for table, columns in scene_meshes.COLUMNS.items():
        assert tuple(built.struct(scene_file.TABLES[table]).fields) == columns
    assert built.constants["MESH_ENVIRONMENT"] == scene_meshes.ENVIRONMENT
    assert built.constants["MESH_LIT"] == scene_meshes.LIT


def test_names_are_the_headers():
    """The names of settings and layouts stand at the numbers of their enumerators."""
    constants = layout.load().constants
    for kind, names in (scene_file.SETTINGS | {"map": scene_file.LAYOUTS}).items():
        numbers = [constants[f"{kind}_{name}".upper()] for name in names]
        last = constants["MAP_LAYOUTS" if kind == "map" else f"{kind}_KINDS".upper()]
        assert numbers == list(range(last)), kind
    assert constants["UNIT_PRIMITIVES"] == len(scene_units.PRIMITIVES)
    assert [constants[f"UNIT_{name.upper()}"] for name in scene_units.PRIMITIVES] == [0, 1, 2, 3]


def test_orders_are_the_headers():
    """Where texel (u, v) lies, by the formulas in c/texture/map.h."""
    array = np.arange(65536).reshape(256, 256)
    tiled, columns = maps.to_tiled(array), maps.to_columns(array[:32])
    for u, v in ((0, 0), (7, 0), (8, 0), (255, 31), (100, 17), (13, 5)):
        assert tiled[2048 * (u // 8) + 8 * v + u % 8] == 256 * v + u
        assert columns[4 * 32 * (u // 4) + 4 * v + u % 4] == 256 * v + u


def test_565():
    numbers = np.arange(65536, dtype=np.uint16)
    assert (maps.to_rgb565(maps.from_rgb565(numbers)) == numbers).all()
    assert maps.from_rgb565(numbers[[0, 65535, 0xf800, 0x07e0, 0x8410]]).tolist() == [
        [0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 255, 0], [132, 130, 132]]


def test_empty_tables():
    scene = dataclasses.replace(example(textures=0), materials=[], objects=[],
                                vertices=np.zeros((0, 6), int), poses=np.zeros((0, 6), int))
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


def test_bytes_are_the_headers():
    """Spot checks of the format that do not go through the layout."""
    scene = example()
    data = scene_file.write(scene)
    assert data[:8] == b"TMAP\0\0\0\x0a"
    assert int.from_bytes(data[8:12], "big") == len(data)
    assert int.from_bytes(data[12:16], "big") == zlib.crc32(data[16:])
    assert data[200:204] == b"\0" + scene.palette[0].tobytes()
    assert data[-65536:] == scene.textures[0].texels.tobytes()


def test_vertices_at_rounds_every_product_down():
    scene = example()
    one, s, t = 65536, 5, 6
    scene.vertices[:3] = [[1, 1, s, t, 8, 9], [-1, 1, s, t, 8, 9], [3, -1, s, t, 8, 9]]
    scene.poses[:3] = [one // 2, -one // 2, -1, one // 4, 7, 9]
    assert scene_file.vertices_at(scene, scene.objects[0], 2) == [
        (0 - 1 + 7, -1 + 0 + 9, s, t, 8, 9), (-1 - 1 + 7, 0 + 0 + 9, s, t, 8, 9),
        (1 + 0 + 7, -1 - 1 + 9, s, t, 8, 9)]
    assert scene_file.vertices_at(scene, scene.objects[1], 0) == []  # not there yet
    assert scene_file.vertices_at(scene, scene.objects[0], 3) == []  # gone


WRITTEN = scene_file.write(example(textures=0))
TEXTURED = scene_file.write(example(textures=1))


@settings(deadline=None)
@given(st.sampled_from([WRITTEN, TEXTURED]), st.data(), st.integers(1, 255))
def test_any_flipped_byte_is_refused(data, draw, flip):
    at = draw.draw(st.integers(0, len(data) - 1))
    damaged = bytearray(data)
    damaged[at] ^= flip
    with pytest.raises(UserError, match="^x: "):
        scene_file.read(bytes(damaged), "x")


def test_every_byte_counts():
    for at in range(len(WRITTEN)):
        damaged = WRITTEN[:at] + bytes([WRITTEN[at] ^ 1 << at % 8]) + WRITTEN[at + 1:]
        with pytest.raises(UserError):
            scene_file.read(damaged, "x")


@settings(deadline=None)
@given(st.binary(max_size=200), st.integers(0, len(WRITTEN) - 1))
def test_cut_and_foreign_files_are_refused(rubbish, cut):
    for data in (rubbish, WRITTEN[:cut], WRITTEN[:cut] + rubbish[:len(WRITTEN) - cut - 1],
                 WRITTEN + b"\0"):
        with pytest.raises(UserError, match="^x: "):
            scene_file.read(data, "x")


def patched(struct: str, field: str, value: int, index: int = 0, data: bytes = TEXTURED) -> bytes:
    """The file with one field replaced, and a checksum that fits."""
    built = layout.load()
    header = built.struct("scene_header")
    where = {kind: f"{table}_at" for table, kind in scene_file.TABLES.items()}
    kind = built.struct(struct)
    at = header.unpack(data)[where[struct]] + index * kind.size if struct in where else 0
    at += kind.fields[field]["offset"]
    out = bytearray(data)
    out[at:at + 4] = (value & 0xFFFFFFFF).to_bytes(4, "big")
    if field not in ("magic", "version", "size", "checksum"):
        out[12:16] = zlib.crc32(out[16:]).to_bytes(4, "big")
    return bytes(out)


@pytest.mark.parametrize("struct, field, value, message", [
    ("scene_header", "magic", 0, "magic: 0x0 where 0x544d4150 is right"),
    ("scene_header", "version", 1, "version: 0x1 where 0xa is right"),
    ("scene_header", "size", 5, "size: 0x5 where"),
    ("scene_header", "checksum", 0, "checksum: 0x0 where"),
    ("scene_header", "width", 0, "width: 0 is not from 4 to 1024 pixels"),
    ("scene_header", "width", 6, "width: 6 is not a multiple of 4"),
    ("scene_header", "width", 1028, "width: 1028 is not from"),
    ("scene_header", "height", -1, "height: -1 is not from 1 to 1024 pixels"),
    ("scene_header", "frames", 0, "frames: 0 is not from 1 to"),
    ("scene_header", "frames", 2**31 - 1, "frames: 2147483647 is not from 1 to"),
    ("scene_header", "background", 256, "background: 256 is not from 0 to 255"),
    ("scene_header", "textures", 0, "materials[1].texture: 0 is not from 0 to -1"),
    ("scene_header", "textures", 2, "textures[1]."),
    ("scene_header", "textures", 2**32 - 1, "textures: 4294967295 is not from 0 to 65536 entries"),
    ("scene_header", "materials", 65537, "materials: 65537 is not from"),
    ("scene_header", "materials", 1, "objects[1].material: 1 is not from 0 to 0"),
    ("scene_header", "objects", 65536, "objects_at: "),
    ("scene_header", "vertices", 5, "objects[1].vertex: 2 is not from 0 to 1"),
    ("scene_header", "poses", 3, "objects[1].pose: 2 is not from 0 to 1"),
    ("scene_header", "palette_at", 0, "palette_at: 0 is not from 200 to"),
    ("scene_header", "textures_at", 2**32 - 4, "textures_at: 4294967292 is not from"),
    ("scene_header", "materials_at", 202, "materials_at: 202 is not a multiple of 4"),
    ("scene_header", "objects_at", 72, "objects_at: 72 is not from"),
    ("scene_header", "vertices_at", len(TEXTURED) - 116, "vertices_at: "),
    ("scene_header", "poses_at", len(TEXTURED), "poses_at: "),
    ("scene_header", "format", 4, "format: 4 is not from 0 to 3"),
    ("scene_header", "format", 3, "textures[0].texel_bytes: 1 is not from 4 to 4"),
    ("scene_header", "format", 1, "textures[0].texel_bytes: 1 is not from 2 to 2"),
    ("scene_texture", "width", 0, "textures[0].width or height: 0x256 is not sides that are"),
    ("scene_texture", "width", -256, "textures[0].width or height: -256x256 is not sides"),
    ("scene_texture", "width", 512, "textures[0].width or height: 512x256 is not sides"),
    ("scene_texture", "height", 255, "textures[0].width or height: 256x255 is not sides"),
    ("scene_texture", "layout", 6, "textures[0].layout: 6 is not from 0 to 5"),
    ("scene_texture", "layout", 5, "textures[0].width or height: 256x256 is not 256x64"),
    ("scene_texture", "layout", 2, "materials[1].texture: its layout is tiled, not page"),
    ("scene_texture", "texel_bytes", 2, "textures[0].texel_bytes: 2 is not from 1 to 1"),
    ("scene_texture", "at", 0, "textures[0].at: 0 is not from 200 to"),
    ("scene_texture", "at", len(TEXTURED) - 4, "textures[0].at: "),
    ("scene_texture", "at", 202, "textures[0].at: 202 is not a multiple of 4"),
    ("scene_material", "texture", 0, "materials[0].texture: 0 is not from -1 to -1"),
    ("scene_material", "texture", -2, "materials[0].texture: -2 is not from -1 to -1"),
    ("scene_material", "mapper", 12, "materials[0].mapper: 12 is not from 0 to 11"),
    ("scene_material", "mapper", 11, "materials[0].unit: -1 is not from 0 to -1"),
    ("scene_material", "mapper", 10, "materials[0].unit: -1 is not from 0 to -1"),
    ("scene_material", "unit", 0, "materials[0].unit: 0 is not from -1 to -1"),
    ("scene_material", "mapper", 2, "materials[0].texture: -1 is not from 0 to 0"),
    ("scene_material", "light", 0, "materials[0].light: 0 is not from -1 to -1"),
    ("scene_material", "primitive", 1,
     "materials[0].primitive: 'coloured' is not for mapper 'flat'"),
    ("scene_material", "primitive", 4, "materials[0].primitive: 4 is not from 0 to 3"),
    ("scene_material", "edges", 3, "materials[0].edges: 3 is not from 0 to 2"),
    ("scene_material", "gradients", 3, "materials[0].gradients: 3 is not from 0 to 2"),
    ("scene_material", "start", 2, "materials[0].start: 2 is not from 0 to 1"),
    ("scene_material", "clip", 2, "materials[0].clip: 2 is not from 0 to 1"),
    ("scene_material", "colour", 256, "materials[0].colour: 256 is not from 0 to 255"),
    ("scene_object", "material", 2, "objects[0].material: 2 is not from 0 to 1"),
    ("scene_object", "vertices", 2, "objects[0].vertices: 2 is not from 3 to 64"),
    ("scene_object", "vertices", 65, "objects[0].vertices: 65 is not from 3 to 64"),
    ("scene_object", "vertex", 4, "objects[0].vertex: 4 is not from 0 to 3"),
    ("scene_object", "vertex", 2**32 - 1, "objects[0].vertex: 4294967295 is not from"),
    ("scene_object", "poses", 0, "objects[0].poses: 0 is not from 1 to"),
    ("scene_object", "pose", 2, "objects[0].pose: 2 is not from 0 to 1"),
    ("scene_object", "first_frame", 3, "objects[0].first_frame: 3 is not from 0 to 2"),
])
def test_wrong_field_is_named(struct, field, value, message):
    with pytest.raises(UserError) as caught:
        scene_file.read(patched(struct, field, value), "show.scene")
    assert str(caught.value).startswith("show.scene: " + message)


MESHES = scene_file.write(mesh_cases.boxes(1))


@pytest.mark.parametrize("struct, field, value, message", [
    ("scene_header", "near_plane", 255, "near_plane: 255 is not from 256 to 1073741823"),
    ("scene_header", "guard", 14, "guard: 14 is not from 6 to 13"),
    ("scene_header", "meshes", 1, "instances["),
    ("scene_header", "views", 35, "instances[8].view"),
    ("scene_point", "x", (2048 << 16) + 1, "points[0].x: 134217729 is not from"),
    ("scene_view", "zz", (1 << 30) + 1, "views[0].zz: 1073741825 is not from"),
    ("scene_view", "y0", -10240 << 16, "views[0].y0: -671088640 is not from"),
    ("scene_face", "x", 1 << 31, "faces[0].x: -2147483648 is not from"),
    ("scene_face", "corners", 2, "meshes[0]: face.corners: 2 is not from 3 to 32"),
    ("scene_face", "corner", 21, "meshes[0]: face.corner: 21 is not from 0 to 20"),
    ("scene_mesh", "points", 0, "meshes[0].points: 0 is not from 1 to 4096"),
    ("scene_mesh", "face", 15, "meshes[0].face: 15 is not from 0 to 12"),
    ("scene_instance", "mesh", 2, "instances[0].mesh: 2 is not from 0 to 1"),
    ("scene_instance", "material", 6, "instances[0].material: 6 is not from 0 to 5"),
    ("scene_instance", "before", 3, "instances[0].before: 3 is not from 0 to 2"),
    ("scene_instance", "before", 1, "instances[1].before: 0 is not from 1 to 2"),
    ("scene_instance", "views", 0, "instances[0].views: 0 is not from 1"),
    ("scene_instance", "view", 33, "instances[0].view: 33 is not from 0 to 32"),
    ("scene_instance", "first_frame", 4, "instances[0].first_frame: 4 is not from 0 to 3"),
    ("scene_instance", "flags", 4, "instances[0].flags: 4 is not from 0 to 3"),
])
def test_wrong_field_of_a_mesh_is_named(struct, field, value, message):
    with pytest.raises(UserError) as caught:
        scene_file.read(patched(struct, field, value, data=MESHES), "show.scene")
    assert str(caught.value).startswith("show.scene: " + message)


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
    with pytest.raises(UserError, match=message):
        scene_file.write(dataclasses.replace(example(), **change))
