"""Scene files: what is written is read again, and nothing damaged is."""

import dataclasses
import zlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tools import layout, scene_file
from tools.errors import UserError
from tools.scene_file import Object, Scene


def example(seed: int = 1, textures: int = 1) -> Scene:
    """A small scene of random numbers, with every table in use."""
    random = np.random.default_rng(seed)
    return Scene(
        width=8, height=5, frames=3, background=7,
        palette=random.integers(0, 256, (256, 3)).astype(np.uint8),
        textures=random.integers(0, 256, (textures, 256, 256)).astype(np.uint8),
        materials=[(-1, 255), (textures - 1, 0)],
        objects=[Object(0, 0, 3, 0, 3, 0), Object(1, 2, 4, 2, 2, 1)],
        vertices=random.integers(-2**31, 2**31, (6, 4)),
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
    assert again.palette.dtype == again.textures.dtype == np.uint8


@settings(deadline=None)
@given(st.integers(0, 2**32), st.integers(4, 64), st.integers(3, 64))
def test_round_trip_of_any_numbers(seed, side, corners):
    scene = example(seed, 0)
    scene.width, scene.height = side // 4 * 4, side
    scene.vertices = np.random.default_rng(seed).integers(-2**31, 2**31, (corners, 4))
    scene.objects = [Object(0, 0, corners, 1, 3, 2)]
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


def test_empty_tables():
    scene = dataclasses.replace(example(textures=0), materials=[], objects=[],
                                vertices=np.zeros((0, 4), int), poses=np.zeros((0, 6), int))
    assert_equal(scene, scene_file.read(scene_file.write(scene), "x"))


def test_bytes_are_the_headers():
    """Spot checks of the format that do not go through the layout."""
    scene = example()
    data = scene_file.write(scene)
    assert data[:8] == b"TMAP\0\0\0\1"
    assert int.from_bytes(data[8:12], "big") == len(data)
    assert int.from_bytes(data[12:16], "big") == zlib.crc32(data[16:])
    assert data[76:80] == b"\0" + scene.palette[0].tobytes()
    assert data[-65536:] == scene.textures[0].tobytes()


def test_vertices_at_rounds_every_product_down():
    scene = example()
    one, s, t = 65536, 5, 6
    scene.vertices[:3] = [[1, 1, s, t], [-1, 1, s, t], [3, -1, s, t]]
    scene.poses[:3] = [one // 2, -one // 2, -1, one // 4, 7, 9]
    assert scene_file.vertices_at(scene, scene.objects[0], 2) == [
        (0 - 1 + 7, -1 + 0 + 9, s, t), (-1 - 1 + 7, 0 + 0 + 9, s, t), (1 + 0 + 7, -1 - 1 + 9, s, t)]
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
    where = {"scene_material": "materials_at", "scene_object": "objects_at"}
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
    ("scene_header", "version", 2, "version: 0x2 where 0x1 is right"),
    ("scene_header", "size", 5, "size: 0x5 where"),
    ("scene_header", "checksum", 0, "checksum: 0x0 where"),
    ("scene_header", "width", 0, "width: 0 is not from 4 to 1024 pixels"),
    ("scene_header", "width", 6, "width: 6 is not a multiple of 4"),
    ("scene_header", "width", 1028, "width: 1028 is not from"),
    ("scene_header", "height", -1, "height: -1 is not from 1 to 1024 pixels"),
    ("scene_header", "frames", 0, "frames: 0 is not from 1 to"),
    ("scene_header", "frames", 2**31 - 1, "frames: 2147483647 is not from 1 to"),
    ("scene_header", "background", 256, "background: 256 is not from 0 to 255"),
    ("scene_header", "textures", 0, "materials[1].texture: 0 is not from -1 to -1"),
    ("scene_header", "textures", 2, "textures_at: "),
    ("scene_header", "textures", 2**32 - 1, "textures: 4294967295 is not from 0 to 65536 entries"),
    ("scene_header", "materials", 65537, "materials: 65537 is not from"),
    ("scene_header", "materials", 1, "objects[1].material: 1 is not from 0 to 0"),
    ("scene_header", "objects", 65536, "objects_at: "),
    ("scene_header", "vertices", 5, "objects[1].vertex: 2 is not from 0 to 1"),
    ("scene_header", "poses", 3, "objects[1].pose: 2 is not from 0 to 1"),
    ("scene_header", "palette_at", 0, "palette_at: 0 is not from 76 to"),
    ("scene_header", "textures_at", 2**32 - 4, "textures_at: 4294967292 is not from"),
    ("scene_header", "materials_at", 78, "materials_at: 78 is not a multiple of 4"),
    ("scene_header", "objects_at", 72, "objects_at: 72 is not from"),
    ("scene_header", "vertices_at", len(TEXTURED) - 92, "vertices_at: "),
    ("scene_header", "poses_at", len(TEXTURED), "poses_at: "),
    ("scene_material", "texture", 1, "materials[0].texture: 1 is not from -1 to 0"),
    ("scene_material", "texture", -2, "materials[0].texture: -2 is not from -1 to 0"),
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


@pytest.mark.parametrize("change, message", [
    ({"width": 7}, "scene: width"),
    ({"frames": 0}, "scene: frames"),
    ({"background": -1}, "scene: background"),
    ({"materials": [(1, 0), (0, 0)]}, r"scene: materials\[0\].texture"),
    ({"objects": [Object(0, 0, 3, 0, 5, 0)]}, r"scene: objects\[0\].pose"),
    ({"vertices": np.full((6, 4), 2**31)}, "scene_vertex.x does not fit 32 bits"),
    ({"poses": np.full((4, 6), -2**31 - 1)}, "scene_pose.xx does not fit 32 bits"),
])
def test_bad_scenes_are_not_written(change, message):
    with pytest.raises(UserError, match=message):
        scene_file.write(dataclasses.replace(example(), **change))
