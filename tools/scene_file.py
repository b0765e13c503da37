"""Writes and reads scene files: the host's half of c/scene/scene_file.h."""

import zlib
from dataclasses import dataclass, field

import numpy as np

from . import layout
from .errors import UserError

#: (count and offset field, struct of an entry) of each table, in file order. The
#: palette has no count: it is always whole; both it and maps are plain bytes.
TABLES = {"materials": "scene_material", "objects": "scene_object",
          "vertices": "scene_vertex", "poses": "scene_pose"}
PALETTE_BYTES = 256 * 4


@dataclass
class Object:
    """One moving polygon: indices and counts, as struct scene_object."""

    material: int
    vertex: int
    vertices: int
    pose: int
    poses: int
    first_frame: int


@dataclass(eq=False)
class Scene:
    """The exact content of a scene file; every number is an integer."""

    width: int
    height: int
    frames: int
    background: int  # palette index
    palette: np.ndarray = field(repr=False)  # uint8 (256, 3): red, green, blue
    textures: np.ndarray = field(repr=False)  # uint8 (n, 256, 256): [texture][t][s]
    materials: list[tuple[int, int]]  # (texture or NO_TEXTURE, palette index)
    objects: list[Object]
    vertices: np.ndarray = field(repr=False)  # int64 (n, 4): x, y, s, t; 16.16
    poses: np.ndarray = field(repr=False)  # int64 (n, 6): xx, xy, yx, yy, x0, y0; 16.16


def vertices_at(scene: Scene, obj: Object, frame: int) -> list[tuple[int, int, int, int]]:
    """The object's (x, y, s, t) on the screen in a frame, 16.16; empty when it is not there."""
    age = frame - obj.first_frame
    if not 0 <= age < obj.poses:
        return []
    xx, xy, yx, yy, x0, y0 = (int(n) for n in scene.poses[obj.pose + age])
    corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices].tolist()
    return [((xx * x >> 16) + (xy * y >> 16) + x0, (yx * x >> 16) + (yy * y >> 16) + y0, s, t)
            for x, y, s, t in corners]


def require(name: str, where: str, value: int, low: int, high: int, unit: str = "") -> None:
    """Refuses a value outside low..high."""
    if not low <= value <= high:
        raise UserError(f"{name}: {where}: {value} is not from {low} to {high}{unit}")


def check(scene: Scene, name: str) -> None:
    """Refuses a scene whose values or indices are out of range."""
    limits = layout.load().constants
    require(name, "width", scene.width, 4, limits["SCENE_SIDE_MAX"], " pixels")
    require(name, "height", scene.height, 1, limits["SCENE_SIDE_MAX"], " pixels")
    if scene.width % 4:
        raise UserError(f"{name}: width: {scene.width} is not a multiple of 4")
    require(name, "frames", scene.frames, 1, limits["SCENE_FRAMES_MAX"])
    require(name, "background", scene.background, 0, 255)
    for table in ("textures", *TABLES):
        require(name, table, len(getattr(scene, table)), 0, limits["SCENE_COUNT_MAX"], " entries")
    for i, (texture, colour) in enumerate(scene.materials):
        require(name, f"materials[{i}].texture", texture, limits["NO_TEXTURE"],
                len(scene.textures) - 1)
        require(name, f"materials[{i}].colour", colour, 0, 255)
    for i, obj in enumerate(scene.objects):
        where = f"objects[{i}]"
        require(name, f"{where}.material", obj.material, 0, len(scene.materials) - 1)
        require(name, f"{where}.vertices", obj.vertices, 3, limits["POLYGON_VERTICES_MAX"])
        require(name, f"{where}.vertex", obj.vertex, 0, len(scene.vertices) - obj.vertices)
        require(name, f"{where}.poses", obj.poses, 1, limits["SCENE_FRAMES_MAX"])
        require(name, f"{where}.pose", obj.pose, 0, len(scene.poses) - obj.poses)
        require(name, f"{where}.first_frame", obj.first_frame, 0, scene.frames - 1)


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


def write(scene: Scene) -> bytes:
    """The scene as a scene file."""
    check(scene, "scene")
    built = layout.load()
    header = built.struct("scene_header")
    palette = np.zeros((256, 4), np.uint8)
    palette[:, 1:] = scene.palette
    objects = [[getattr(o, f) for f in built.struct("scene_object").fields] for o in scene.objects]
    tables = {"materials": scene.materials, "objects": objects,
              "vertices": scene.vertices, "poses": scene.poses}
    parts = {"palette": palette.tobytes()}
    parts |= {t: records(tables[t], built.struct(s)) for t, s in TABLES.items()}
    parts["textures"] = np.asarray(scene.textures, np.uint8).tobytes()
    values, at = {}, header.size
    for part, data in parts.items():
        values[f"{part}_at"] = at
        at += len(data)
    values |= {t: len(getattr(scene, t)) for t in ("textures", *TABLES)}
    values |= {f: getattr(scene, f) for f in ("width", "height", "frames", "background")}
    values |= {"magic": built.constants["SCENE_MAGIC"], "size": at,
               "version": built.constants["SCENE_VERSION"]}
    body = b"".join(parts.values())
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

    def part(table: str, count: int, size: int) -> bytes:
        at = values[f"{table}_at"]
        require(name, table, count, 0, built.constants["SCENE_COUNT_MAX"], " entries")
        require(name, f"{table}_at", at, header.size, len(data) - count * size)
        if at % 4:
            raise UserError(f"{name}: {table}_at: {at} is not a multiple of 4")
        return data[at:at + count * size]

    rows = {}
    for table, struct_name in TABLES.items():
        struct = built.struct(struct_name)
        found = np.frombuffer(part(table, values[table], struct.size), struct.dtype)
        rows[table] = np.stack([found[f].astype(np.int64) for f in struct.fields], axis=1)
    palette = np.frombuffer(part("palette", 1, PALETTE_BYTES), np.uint8).reshape(256, 4)
    textures = np.frombuffer(
        part("textures", values["textures"], built.constants["MAP_BYTES"]), np.uint8)
    object_fields = list(built.struct("scene_object").fields)
    scene = Scene(
        *(values[f] for f in ("width", "height", "frames", "background")),
        palette=palette[:, 1:].copy(), textures=textures.reshape(-1, 256, 256).copy(),
        materials=[tuple(row) for row in rows["materials"].tolist()],
        objects=[Object(**dict(zip(object_fields, row))) for row in rows["objects"].tolist()],
        vertices=rows["vertices"], poses=rows["poses"])
    check(scene, name)
    return scene
