"""Invalid scene files, and the expected error of each."""

import numpy as np

from tests.compiler.scene_examples import example
from tests.helpers.wrong_fields import M32, Row, WrongFields, changed, lengths
from tests.glide.bad_files import wrong_pipes
from tests.helpers import mesh_cases
from tests.mesh.mesh_bad_files import wrong_meshes
from tests.n64.bad_files import wrong_primitives
from tmap.scene_file import scene_file
from tmap.scene_file.meshes import Instance
from tmap.scene_file.scene_file import Material, Object, Scene, Texture
from tmap.scene_file.textures import LAYOUTS, ON_PLANE

W_MIN, W_MAX = 1 << 8, 1 << 30  # 1/256 and 16,384, in 16.16
NOT_USABLE = ": not a usable scene file: "


def large_with(perspective: str) -> Scene:
    """A scene that leaves about 600 KB of chip RAM free, with polygons in perspective."""
    scene = example(8)
    scene.materials = [Material("affine", perspective=perspective, texture=0)] * 2
    scene.vertices[:, 5] = 65536 << np.arange(len(scene.vertices))
    return scene


#: Layouts of maps, and a valid size for each.
SIZES = {"page": (16, 8), "linear": (7, 30), "tiled": (256, 256), "columns": (8, 64),
         "margins": (256, 256), "light": (256, 64)}


def mipmapped() -> Scene:
    """A scene whose first material has two levels."""
    scene = example(0)
    scene.textures = [Texture(np.zeros((64 >> level, 32 >> level), np.uint8)) for level in range(3)]
    scene.materials = [Material("affine", texture=0, levels=2, level=1), Material("affine", texture=1),
                       Material("affine", texture=2)]
    scene.objects = [Object(0, 0, 3, 0, 3, 0)]
    return scene


def mapped(*mappers: str) -> Scene:
    """A scene with a triangle for each of these mappers, in order. Each has the only map of its
    layout; lit ones have the only light table."""
    scene = example(0)
    layouts = list(dict.fromkeys(filter(None, map(scene_file.MAPPER_LAYOUT.get, mappers))))
    layouts += ["light"] if any(mapper.startswith("lit") for mapper in mappers) else []
    scene.textures = [Texture(np.zeros(SIZES[name][::-1], np.uint8), name) for name in layouts]
    scene.materials = []
    for mapper in mappers:
        layout = scene_file.MAPPER_LAYOUT.get(mapper)
        is_lit = mapper.startswith("lit")
        scene.materials.append(Material(
            mapper, gradients="plane" if is_lit or mapper in ON_PLANE else "polygon",
            texture=layouts.index(layout) if layout else -1,
            light=layouts.index("light") if is_lit else -1))
    scene.vertices = np.full((6, 6), 65536)
    scene.objects = [Object(n, 0, 3, 0, 3, 0) for n in range(len(mappers))]
    return scene


def wide_pixels(pixels: str, mapper: str) -> Scene:
    """A scene in a wide format: a flat triangle and one with a map."""
    scene = example(0)
    scene.format, scene.background, layout = pixels, 0xFFFF, scene_file.MAPPER_LAYOUT[mapper]
    scene.textures = [Texture(np.zeros((8, 16), scene.pixel.dtype), layout)]
    scene.materials = [Material(colour=0xFFFF), Material(mapper, texture=0)]
    return scene


def with_depth() -> Scene:
    """A scene with a triangle in perspective, with depths at the ends of their range."""
    scene = mapped("affine")
    scene.materials = [Material("affine", gradients="plane", perspective="pixel", texture=0)]
    scene.vertices[:, 5] = [W_MIN, W_MAX] * 3
    return scene


def wrong_mappers() -> list[Row]:
    """Textures, materials and vertices that do not fit each other: file, offset, value, field."""
    rows: list[Row] = []
    every, large, wide, widest, light_only, deep = (WrongFields(scene, rows) for scene in (
        mapped("flat", "gouraud", "affine", "arbitrary", "columns", "lit", "lit_gouraud", "dithered"),
        mapped("tiled", "generated"), wide_pixels("rgb565", "columns"),
        wide_pixels("rgba8888", "affine"), mapped("lit"), with_depth()))
    size = "texture.width or texture.height"
    flat, gouraud, affine, arbitrary, columns_mapper, lit_flat, lit_gouraud, dithered = range(8)
    page, linear, columns, light, past_all = range(5)
    tiled, margins = range(2)  # of the large ones
    layouts = {name: number for number, name in enumerate(LAYOUTS)}
    mappers = {name: number for number, name in enumerate(scene_file.SETTINGS["mapper"])}
    every.entry("textures", page, "layout", len(LAYOUTS), M32)
    every.entry("textures", page, "layout", layouts["linear"], said="material.texture")
    every.entry("textures", page, "texel_bytes", 0, 2, M32)
    every.entry("textures", page, "at", 0, 82, len(every.data) - 124, M32 - 3)
    for wrong, index, widths in (
            (every, page, (0, 4, 12, 512, M32, 2**31)), (every, linear, (0, 1025, M32, 2**31)),
            (large, tiled, (0, 255, 512, M32)), (every, columns, (4, 48, 2**16, M32, 2**31)),
            (large, margins, (8, 512, M32)), (every, light, (255, 128, M32))):
        wrong.entry("textures", index, "width", *widths, said=size)
        wrong.entry("textures", index, "height", *widths, said=size)
    wide.entry("textures", 0, "layout", *(layouts[name] for name in ("linear", "tiled", "light")))
    wide.entry("textures", 0, "texel_bytes", 1, 4)
    widest.entry("textures", 0, "layout", layouts["columns"])
    deep.entry("vertices", 1, "w", W_MIN - 1, W_MAX + 1, 0, M32, 2**31)
    widest.entry("materials", 1, "mapper", *(mappers[name] for name in (
        "gouraud", "arbitrary", "tiled", "columns", "generated", "lit", "lit_gouraud")))
    wide.entry("materials", 1, "perspective", 1, 4)
    every.entry("materials", flat, "mapper", mappers["n64"], mappers["glide"], M32)
    every.entry("materials", flat, "texture", 0)
    every.entry("materials", gouraud, "texture", 0)
    every.entry("materials", affine, "texture", linear, light, -1, past_all)
    for field, past in (("edges", 4), ("gradients", 3), ("start", 2), ("clip", 2)):
        every.entry("materials", affine, field, past, M32)
    every.entry("materials", affine, "light", 0, light)
    for index in lit_flat, lit_gouraud:
        every.entry("materials", index, "texture", linear, light, -1)
        every.entry("materials", index, "light", page, -1, past_all, M32)
    for index in lit_gouraud, dithered:
        every.entry("materials", index, "gradients", 0, 1)
        every.entry("materials", index, "start", 0)
    every.entry("materials", dithered, "texture", linear, light, -1)
    every.entry("materials", affine, "levels", 1, M32)  # the materials behind it are not its levels
    every.entry("materials", flat, "level", 1, said="material.levels")
    for field, values in (("levels", (4, 6, M32)), ("level", (0, 2, M32))):
        WrongFields(mipmapped(), rows).entry("materials", 0, field, *values, said="material.levels")
    for field, value in (("edges", 0), ("clip", 1), ("perspective", 1), ("texture", 0), ("levels", 1), ("mapper", 9)):
        WrongFields(mipmapped(), rows).entry("materials", 2, field, value, said="material.levels")
    for index in flat, gouraud, arbitrary, columns_mapper, dithered:
        every.entry("materials", index, "perspective", 1, 4)
    for index in lit_flat, lit_gouraud:
        every.entry("materials", index, "perspective", 5, M32)
    light_only.entry("vertices", 0, "shade", -1, 256 << 16, 2**31)
    wide.entry("materials", 0, "colour", 65536)
    every.entry("objects", gouraud, "vertices", 4)
    every.entry("objects", arbitrary, "vertices", 4)
    every.entry("vertices", 1, "shade", -1, 256 << 16, 2**31)
    every.entry("vertices", 2, "s", -1, (256 << 16) + 1, 61 << 16, 2**31, 2**31 - 1)
    every.entry("vertices", 2, "t", -1, (256 << 16) + 1, 2**31)
    return rows


def wrong_tables() -> list[Row]:
    """Headers, and entries that do not fit each other, of scenes with plain materials."""
    rows: list[Row] = []
    small = example(1)
    small.textures = [Texture(np.zeros((8, 16), np.uint8))]
    plain, textured = WrongFields(example(0), rows), WrongFields(small, rows)
    for name in ("magic", "version", "size", "checksum"):
        plain.header(name, 0, M32)
    for name in ("width", "height", "frames"):
        plain.header(name, 0, 1025, M32, 2**31 - 1)
    plain.header("width", 6)
    plain.header("background", 256, M32)
    plain.header("pixel_width", 0, 3, M32)
    plain.header("pixel_height", 0, 3, M32)
    plain.header("cleared", 2, M32)
    plain.header("once", 2, M32)
    plain.header("format", 4, M32)
    plain.header("palette_at", 0, 78, len(plain.data), M32 - 3)
    for name in scene_file.TABLES:
        wrong = textured if "texture" in name else plain
        wrong.header(name, 65537, 2**28, M32, said=f"{name} or {name}_at")
        wrong.header(f"{name}_at", 0, 78, len(textured.data), M32 - 3, said=f"{name} or {name}_at")
    textured.header("textures", 0, said="material.texture")
    plain.header("materials", 1, said="object.material")
    plain.header("vertices", 5, said="object.vertices")
    plain.header("poses", 3, said="object.poses")
    textured.entry("materials", 0, "texture", 0, -2, 2**31 - 1)
    plain.entry("materials", 0, "colour", 256, M32)
    for name, values, said in (
            ("material", (2, M32), ""), ("vertices", (2, 65, 7, M32), ""),
            ("vertex", (4, 6, M32, M32 - 1), "object.vertices"),
            ("pose", (2, 4, M32 - 1), "object.poses"), ("poses", (0, 5, M32), ""),
            ("first_frame", (3, M32), ""), ("planar", (16, M32), "")):
        plain.entry("objects", 0, name, *values, said=said)
    return rows


def bad_scenes() -> list[tuple[bytes, str]]:
    """Returns files and the expected error of each."""
    data = scene_file.write(example(0))
    cases = [(b"", ": is empty"), (data + b"\0", NOT_USABLE + "size")]
    cases += [(data[:length], NOT_USABLE + "size") for length in lengths("scene_header", data)]
    cases += [(changed(source, at, value, "scene_header", "width"), NOT_USABLE + said)
              for source, at, value, said in (wrong_tables() + wrong_mappers() + wrong_meshes()
                                              + wrong_primitives() + wrong_pipes())]
    many = mesh_cases.boxes(1)
    many.points = np.zeros((4096, 3), np.int64)
    many.meshes[0].points, many.meshes[1].point, many.textures = 4096, 0, many.textures[:0]
    many.materials, many.instances = [Material()], [Instance(0, 0, 0, 0, 1, 0)] * 17
    cases.append((scene_file.write(many), NOT_USABLE + "points, normals or faces of meshes"))
    long = example(0)
    long.dram = bytes(3 << 20)
    cases += [(scene_file.write(long), ": not enough memory for the tables: 31"),
              (scene_file.write(example(30)), ": not enough memory for the textures: ")]
    return cases
