"""Scene files and scenes with one invalid field: the error names it."""

import dataclasses
import zlib

import numpy as np
import pytest

from tests.compiler.scene_examples import LIGHT, TEXTURED, example
from tests.helpers import mesh_cases
from tmap.base.errors import UserError
from tmap.build import layout
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material, Object, Texture


def patched(struct: str, field: str, value: int, index: int = 0, data: bytes = TEXTURED) -> bytes:
    """The file with one field replaced, and the right checksum."""
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
    ("scene_header", "version", 1, "version: 0x1 where 0xb is right"),
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
    ("scene_object", "planar", 16, "objects[0].planar: 16 is not from 0 to 15"),
])
def test_wrong_field_is_named(struct, field, value, message):
    """The error has its place in the file, its value and the valid range."""
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
    """Fields of points, faces, views and instances."""
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
    """The error is raised before a file is written."""
    with pytest.raises(UserError, match=message):
        scene_file.write(dataclasses.replace(example(), **change))
