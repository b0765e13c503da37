"""Writes and reads scene files: the host's half of c/scene/scene_file.h."""

import zlib
from dataclasses import dataclass, field

import numpy as np

from . import layout, scene_meshes, scene_pipes, scene_units
from .errors import UserError
from .fixed import ONE
from .model_shading import LIT
from .pixel_formats import FORMATS, PixelFormat
from .scene_meshes import Instance, Mesh
from .scene_textures import (LAYOUTS, MAPPER_LAYOUT, MAPPERS, ON_PLANE, UNIT_FORMATS, UNITS, Texture,
                             check_texture, linear, ordered, size_fault)

#: (count and offset field, struct of an entry) of each table, in file order; texels
#: follow. The palette has no count: it is always whole.
TABLES = {"textures": "scene_texture", "materials": "scene_material",
          "objects": "scene_object", "vertices": "vertex", "poses": "scene_pose",
          "points": "scene_point", "normals": "scene_normal", "corners": "scene_corner",
          "faces": "scene_face", "meshes": "scene_mesh", "instances": "scene_instance",
          "views": "scene_view", "units": "scene_unit", "lists": "scene_list",
          "words": "tx_word", "tmus": "scene_tmu", "pipes": "scene_pipe"}
BYTES = ("dram", "tmu_memory")  # behind the tables, without a structure
HEADER = ("width", "height", "frames", "background", "near_plane", "guard")
PALETTE_BYTES = 256 * 4
#: The settings of a material by their names, and the prefix of each one's enumerators.
SETTINGS = {"mapper": tuple(MAPPER_LAYOUT), "edges": ("integer", "subpixel", "exact"),
            "gradients": ("scanline", "polygon", "plane"), "start": ("truncated", "subtexel"),
            "clip": ("scissor", "vertices"),
            "perspective": ("none", "every16", "every8", "pixel", "fine")}
IDENTITY = (ONE, 0, 0, ONE, 0, 0)  # the pose that moves nothing: xx, xy, yx, yy, x0, y0


@dataclass(frozen=True)
class Material:
    """What a polygon is drawn with: struct scene_material, enumerators by name."""

    mapper: str = "flat"
    edges: str = "subpixel"
    gradients: str = "plane"
    start: str = "subtexel"
    clip: str = "scissor"
    perspective: str = "none"
    texture: int = -1  # index, or NO_TEXTURE
    colour: int = 0  # pixel
    light: int = -1  # index of a light table, or NO_TEXTURE
    tolerance: int = 0  # 16.16 texels that less perspective may cost
    unit: int = -1  # index of a texture engine or a pipe, or NO_UNIT
    primitive: str = "polygons"  # what an engine's objects are: of scene_units.PRIMITIVES


@dataclass
class Object:
    """One moving polygon or rectangle: indices and counts, as struct scene_object."""

    material: int
    vertex: int
    vertices: int
    pose: int
    poses: int
    first_frame: int


#: Tables whose entries are dataclasses with the struct's fields.
RECORDS = {"objects": Object, "meshes": Mesh, "instances": Instance}


@dataclass(eq=False)
class Scene:
    """The exact content of a scene file; every number is an integer."""

    width: int
    height: int
    frames: int
    background: int  # pixel
    palette: np.ndarray = field(repr=False)  # uint8 (256, 3): red, green, blue
    textures: list[Texture]
    materials: list[Material]
    objects: list[Object]
    vertices: np.ndarray = field(repr=False)  # int64 (n, 6): x, y, s, t, shade, w; 16.16
    poses: np.ndarray = field(repr=False)  # int64 (n, 6): xx, xy, yx, yy, x0, y0; 16.16
    format: str = "chunky"  # of FORMATS
    near_plane: int = ONE  # 16.16; it and guard count where instances are
    guard: int = 9
    points: np.ndarray = field(default_factory=lambda: scene_meshes.empty("points"), repr=False)
    normals: np.ndarray = field(default_factory=lambda: scene_meshes.empty("normals"), repr=False)
    corners: np.ndarray = field(default_factory=lambda: scene_meshes.empty("corners"), repr=False)
    faces: np.ndarray = field(default_factory=lambda: scene_meshes.empty("faces"), repr=False)
    meshes: list[Mesh] = field(default_factory=list)
    instances: list[Instance] = field(default_factory=list)
    views: np.ndarray = field(default_factory=lambda: scene_meshes.empty("views"), repr=False)
    units: np.ndarray = field(default_factory=lambda: scene_units.empty("units"), repr=False)
    lists: np.ndarray = field(default_factory=lambda: scene_units.empty("lists"), repr=False)
    words: np.ndarray = field(default_factory=lambda: scene_units.empty("words"), repr=False)
    dram: bytes = field(default=b"", repr=False)  # what the lists load from
    tmus: np.ndarray = field(default_factory=lambda: scene_pipes.empty("tmus"), repr=False)
    pipes: np.ndarray = field(default_factory=lambda: scene_pipes.empty("pipes"), repr=False)
    tmu_memory: bytes = field(default=b"", repr=False)  # of all Glide's units

    @property
    def pixel(self) -> PixelFormat:
        """What a pixel is."""
        return FORMATS[self.format]


def vertices_at(scene: Scene, obj: Object, frame: int) -> list[tuple[int, int, int, int, int, int]]:
    """(x, y, s, t, shade, w) of the object in a frame, x, y on the screen; empty when not there."""
    age = frame - obj.first_frame
    if not 0 <= age < obj.poses:
        return []
    xx, xy, yx, yy, x0, y0 = (int(n) for n in scene.poses[obj.pose + age])
    corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices].tolist()
    return [((xx * x >> 16) + (xy * y >> 16) + x0, (yx * x >> 16) + (yy * y >> 16) + y0, *rest)
            for x, y, *rest in corners]


def require(name: str, where: str, value: int, low: int, high: int, unit: str = "") -> None:
    """Refuses a value outside low..high."""
    if not low <= value <= high:
        raise UserError(f"{name}: {where}: {value} is not from {low} to {high}{unit}")


def name_of(kind: str, number: int, name: str, where: str) -> str:
    """The setting with this number."""
    require(name, where, number, 0, len(SETTINGS[kind]) - 1)
    return SETTINGS[kind][number]


def number_of(kind: str, value: str, name: str, where: str) -> int:
    """The number of a setting."""
    if value not in SETTINGS[kind]:
        raise UserError(f"{name}: {where}: {value!r} is not one of {', '.join(SETTINGS[kind])}")
    return SETTINGS[kind].index(value)


def check_material(scene: Scene, material: Material, name: str, where: str) -> None:
    """Refuses unknown settings and a texture that is not the mapper's."""
    for kind in SETTINGS:
        number_of(kind, getattr(material, kind), name, f"{where}.{kind}")
    if material.perspective != "none" and (material.mapper, material.gradients, material.start) != (
            "affine", "plane", "subtexel"):
        raise UserError(f"{name}: {where}.perspective: {material.perspective!r} needs mapper "
                        "'affine', gradients 'plane' and start 'subtexel'")
    if material.mapper in ON_PLANE and (material.gradients, material.start) != (
            "plane", "subtexel"):
        raise UserError(f"{name}: {where}.mapper: {material.mapper!r} needs gradients 'plane' and "
                        "start 'subtexel'")
    none = layout.load().constants["NO_UNIT"]
    if material.mapper in UNITS:
        there = scene.units if material.mapper == "unit" else scene.pipes
        require(name, f"{where}.unit", material.unit, 0, len(there) - 1)
        if material.edges == "integer":
            raise UserError(f"{name}: {where}.edges: 'integer' is not for a texture unit")
    else:
        require(name, f"{where}.unit", material.unit, none, none)
    if material.primitive not in scene_units.PRIMITIVES[:None if material.mapper == "unit" else 1]:
        raise UserError(f"{name}: {where}.primitive: {material.primitive!r} is not for mapper "
                        f"{material.mapper!r}")
    if scene.pixel.bytes == 2 and scene.format != UNIT_FORMATS.get(material.mapper, scene.format):
        raise UserError(f"{name}: {where}.mapper: {material.mapper!r} is not for {scene.format}")
    if material.mapper not in MAPPERS[scene.pixel.bytes]:
        raise UserError(f"{name}: {where}.mapper: {material.mapper!r} is not for pixels of "
                        f"{scene.pixel.bytes} bytes")
    if scene.pixel.bytes > 1 and material.perspective != "none":
        raise UserError(f"{name}: {where}.perspective: {material.perspective!r} is for pixels of "
                        "one byte")
    wanted = MAPPER_LAYOUT[material.mapper]
    none = layout.load().constants["NO_TEXTURE"]
    light = "light" if material.mapper in LIT else None
    for kind, index, layout_wanted in (("texture", material.texture, wanted),
                                       ("light", material.light, light)):
        if layout_wanted is None:
            require(name, f"{where}.{kind}", index, none, none)
            continue
        require(name, f"{where}.{kind}", index, 0, len(scene.textures) - 1)
        found = scene.textures[index].layout
        if found != layout_wanted:
            raise UserError(f"{name}: {where}.{kind}: its layout is {found}, not {layout_wanted}")
    most = layout.load().constants["TOLERANCE_MAX"] if material.perspective != "none" else 0
    require(name, f"{where}.tolerance", material.tolerance, 0, most)
    require(name, f"{where}.colour", material.colour, 0, 256**scene.pixel.bytes - 1)


def check_vertices(scene: Scene, obj: Object, name: str, where: str) -> None:
    """Refuses vertices the material cannot have: what leaves the map or the palette."""
    material = scene.materials[obj.material]
    if material.primitive in scene_units.RECTANGLES:
        scene_units.check_rectangle(scene.vertices[obj.vertex:obj.vertex + 2],
                                    scene.poses[obj.pose:obj.pose + obj.poses], name, where)
    if obj.vertices > 3 and material.mapper != "flat" and material.gradients == "polygon":
        raise UserError(f"{name}: {where}.vertices: {obj.vertices}, but gradients 'polygon' "
                        "are for triangles")
    corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices]
    if material.mapper in ("gouraud", *LIT):
        require(name, f"{where}: shade", int(corners[:, 4].min()), 0, (256 << 16) - 1)
        require(name, f"{where}: shade", int(corners[:, 4].max()), 0, (256 << 16) - 1)
    has_own = scene_pipes.has_own(scene, material)
    if has_own:
        scene_pipes.check_own(corners, name, where)
    if material.perspective != "none" or material.mapper in UNITS:
        limits = layout.load().constants
        for w in corners[:len(corners) // (2 if has_own else 1), 5].tolist():
            require(name, f"{where}: w", w, limits["W_MIN"], limits["W_MAX"])
    if material.mapper == "arbitrary":
        height, width = scene.textures[material.texture].texels.shape
        for noun, column, side in (("s", 2, width), ("t", 3, height)):
            for value in corners[:, column].tolist():
                require(name, f"{where}: {noun}", value, 0, 256 << 16)
                require(name, f"{where}: texel of {noun}", value * max(width, height) >> 8, 0,
                        side << 16)


def check(scene: Scene, name: str) -> None:
    """Refuses a scene whose values or indices are out of range."""
    limits = layout.load().constants
    require(name, "width", scene.width, 4, limits["SCENE_SIDE_MAX"], " pixels")
    require(name, "height", scene.height, 1, limits["SCENE_SIDE_MAX"], " pixels")
    if scene.width % 4:
        raise UserError(f"{name}: width: {scene.width} is not a multiple of 4")
    require(name, "frames", scene.frames, 1, limits["SCENE_FRAMES_MAX"])
    require(name, "background", scene.background, 0, 256**scene.pixel.bytes - 1)
    for table in TABLES:
        require(name, table, len(getattr(scene, table)), 0, limits["SCENE_COUNT_MAX"], " entries")
    for i, texture in enumerate(scene.textures):
        check_texture(texture, scene.pixel, name, f"textures[{i}]")
    scene_units.check(scene, name)
    scene_pipes.check(scene, name)
    for i, material in enumerate(scene.materials):
        check_material(scene, material, name, f"materials[{i}]")
    for i, obj in enumerate(scene.objects):
        where = f"objects[{i}]"
        require(name, f"{where}.material", obj.material, 0, len(scene.materials) - 1)
        is_rectangle = scene.materials[obj.material].primitive in scene_units.RECTANGLES
        require(name, f"{where}.vertices", obj.vertices,
                *((2, 2) if is_rectangle else (3, limits["POLYGON_VERTICES_MAX"])))
        require(name, f"{where}.vertex", obj.vertex, 0, len(scene.vertices) - obj.vertices)
        require(name, f"{where}.poses", obj.poses, 1, limits["SCENE_FRAMES_MAX"])
        require(name, f"{where}.pose", obj.pose, 0, len(scene.poses) - obj.poses)
        require(name, f"{where}.first_frame", obj.first_frame, 0, scene.frames - 1)
        check_vertices(scene, obj, name, where)
    scene_meshes.check(scene, name)


def records(table, struct: layout.Struct) -> bytes:
    """A table's bytes, from rows of one number a field."""
    rows = np.asarray(table, np.int64).reshape(-1, len(struct.fields))
    out = np.zeros(len(rows), struct.dtype)
    for column, (field_name, entry) in enumerate(struct.fields.items()):
        bits = 8 * entry["size"]
        low = -(1 << bits - 1) if entry["signed"] else 0
        if len(rows) and not low <= rows[:, column].min() <= rows[:, column].max() < low + 2**bits:
            raise UserError(f"{struct.name}.{field_name} does not fit {bits} bits")
        out[field_name] = rows[:, column]
    return out.tobytes()


def write(scene: Scene, with_palette: bool = True) -> bytes:
    """The scene as a scene file; without a palette it is for programs that hold it."""
    check(scene, "scene")
    built = layout.load()
    header = built.struct("scene_header")
    palette = np.zeros((256, 4), np.uint8)
    palette[:, 1:] = scene.palette
    tables = {t: getattr(scene, t)
              for t in ("vertices", "poses", *scene_meshes.COLUMNS, *scene_units.COLUMNS,
                        *scene_pipes.COLUMNS)}
    for table in RECORDS:
        fields = built.struct(TABLES[table]).fields
        tables[table] = [[getattr(o, f) for f in fields] for o in getattr(scene, table)]
    tables["materials"] = [
        [*(SETTINGS[kind].index(getattr(m, kind)) for kind in SETTINGS), m.texture, m.colour,
         m.light, m.tolerance, m.unit, scene_units.PRIMITIVES.index(m.primitive)]
        for m in scene.materials]
    texels = [ordered(texture) for texture in scene.textures]
    texels = [data + bytes(-len(data) % 4) for data in texels]
    count = {table: len(getattr(scene, table)) for table in TABLES}
    at = header.size + PALETTE_BYTES * with_palette + sum(
        count[t] * built.struct(s).size for t, s in TABLES.items())
    blocks = {}
    for block in BYTES:
        blocks |= {block: len(getattr(scene, block)), f"{block}_at": at}
        at += blocks[block]
    tables["textures"] = []
    for texture, data in zip(scene.textures, texels):
        height, width = texture.texels.shape
        tables["textures"].append([width, height, LAYOUTS.index(texture.layout),
                                   scene.pixel.bytes, at])
        at += len(data)
    values = count | {"size": at, "magic": built.constants["SCENE_MAGIC"],
                      "version": built.constants["SCENE_VERSION"]}
    values |= blocks | {f: getattr(scene, f) for f in HEADER}
    values["format"] = list(FORMATS).index(scene.format)
    parts = {"palette": palette.tobytes() if with_palette else b""}
    parts |= {t: records(tables[t], built.struct(s)) for t, s in TABLES.items()}
    at = header.size
    for part, data in parts.items():
        values[f"{part}_at"] = at
        at += len(data)
    body = b"".join([*parts.values(), *(getattr(scene, block) for block in BYTES), *texels])
    summed = header.fields["width"]["offset"]
    checksum = zlib.crc32(header.pack(**values, checksum=0)[summed:] + body)
    return header.pack(**values, checksum=checksum) + body


def read(data: bytes, name: str) -> Scene:
    """The scene in a scene file's bytes; ``name`` is for messages only."""
    built = layout.load()
    header = built.struct("scene_header")
    if len(data) < header.size:
        raise UserError(f"{name}: {len(data)} bytes is too short for a scene file")
    values = header.unpack(data)
    summed = header.fields["width"]["offset"]
    for part, expected in (("magic", built.constants["SCENE_MAGIC"]),
                           ("version", built.constants["SCENE_VERSION"]),
                           ("size", len(data)), ("checksum", zlib.crc32(data[summed:]))):
        if values[part] != expected:
            raise UserError(f"{name}: {part}: {values[part]:#x} where {expected:#x} is right")

    def part(where: str, at: int, size: int) -> bytes:
        require(name, where, at, header.size, len(data) - size)
        if at % 4:
            raise UserError(f"{name}: {where}: {at} is not a multiple of 4")
        return data[at:at + size]

    rows = {}
    for table, struct_name in TABLES.items():
        struct, count = built.struct(struct_name), values[table]
        require(name, table, count, 0, built.constants["SCENE_COUNT_MAX"], " entries")
        found = np.frombuffer(part(f"{table}_at", values[f"{table}_at"], count * struct.size),
                              struct.dtype)
        rows[table] = np.stack([found[f].astype(np.int64) for f in struct.fields], axis=1)
    require(name, "format", values["format"], 0, len(FORMATS) - 1)
    pixel = list(FORMATS.values())[values["format"]]
    textures = []
    for i, (width, height, kind, texel_bytes, at) in enumerate(rows["textures"].tolist()):
        where = f"textures[{i}]"
        require(name, f"{where}.layout", kind, 0, len(LAYOUTS) - 1)
        require(name, f"{where}.texel_bytes", texel_bytes, *[pixel.bytes] * 2)
        needs = size_fault(LAYOUTS[kind], width, height)
        if needs:
            raise UserError(f"{name}: {where}.width or height: {width}x{height} is not {needs}")
        texels = part(f"{where}.at", at, width * height * texel_bytes)
        textures.append(linear(texels, width, height, LAYOUTS[kind], pixel.dtype))
    materials = []
    for i, (*row, primitive) in enumerate(rows["materials"].tolist()):
        require(name, f"materials[{i}].primitive", primitive, 0, len(scene_units.PRIMITIVES) - 1)
        materials.append(Material(*(name_of(kind, number, name, f"materials[{i}].{kind}")
                                    for kind, number in zip(SETTINGS, row)),
                                  *row[len(SETTINGS):], scene_units.PRIMITIVES[primitive]))
    palette = np.frombuffer(part("palette_at", values["palette_at"], PALETTE_BYTES), np.uint8)
    for table, kind in RECORDS.items():
        rows[table] = [kind(*row) for row in rows[table].tolist()]
    for block in BYTES:
        rows[block] = part(f"{block}_at", values[f"{block}_at"], values[block])
    scene = Scene(
        **{f: values[f] for f in HEADER}, format=pixel.name,
        **rows | {"textures": textures, "materials": materials},
        palette=palette.reshape(256, 4)[:, 1:].copy())
    check(scene, name)
    return scene
