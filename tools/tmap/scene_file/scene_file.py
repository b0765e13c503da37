"""Writes and reads scene files: the host's half of c/scene/scene_file.h."""

import zlib
from dataclasses import dataclass, field

import numpy as np

from tmap.base import c_lists
from tmap.base.errors import UserError, require
from tmap.base.fixed import ONE
from tmap.base.pixel_formats import FORMATS, PixelFormat
from tmap.build import layout
from tmap.scene_file import (materials as scene_materials, meshes as scene_meshes,
                             pipes as scene_pipes, units as scene_units)
from tmap.scene_file.materials import SETTINGS, Material
from tmap.scene_file.meshes import Instance, Mesh
from tmap.scene_file.textures import (LAYOUTS, MAPPERS, MAPPER_LAYOUT, ON_PLANE, UNITS, Texture,
                                      check_on_map, check_texture, ordered, size_fault)
from tmap.setup.planarity import ALL
from tmap.setup.shading import LIT

__all__ = ["IDENTITY", "LAYOUTS", "MAPPERS", "MAPPER_LAYOUT", "ONE", "ON_PLANE", "SETTINGS",
           "UNITS", "Material", "Object", "Scene", "Texture", "records", "size_fault", "vertices_at", "write"]

#: Tables in file order: name, which is also the count and offset field, and struct of an entry.
#: Texels follow. The palette has no count: it is always whole.
TABLES = dict(c_lists.rows("scene/table_list.h", "TABLE"))
#: After the tables, without a structure.
BYTES = tuple(name for name, in c_lists.rows("scene/table_list.h", "BLOCK", "TABLE"))
HEADER = ("width", "height", "pixel_width", "pixel_height", "frames", "background", "cleared", "once", "near_plane", "guard")
PALETTE_BYTES = 256 * 4
IDENTITY = (ONE, 0, 0, ONE, 0, 0)  # the pose that moves nothing: xx, xy, yx, yy, x0, y0


@dataclass
class Object:
    """One moving polygon or rectangle: indices and counts, as struct scene_object."""

    material: int
    vertex: int
    vertices: int
    pose: int
    poses: int
    first_frame: int
    planar: int = ALL


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
    cleared: int = 1  # 0: pixels that no polygon covers keep what was there
    once: int = 0  # 1: meshes' pixels are drawn once, front to back
    pixel_width: int = 1  # of a pixel on the screen, in pixels of low resolution
    pixel_height: int = 1
    near_plane: int = ONE  # 16.16; like guard, only used if there are instances
    guard: int = 9
    points: np.ndarray = field(default_factory=lambda: scene_meshes.empty("points"), repr=False)
    normals: np.ndarray = field(default_factory=lambda: scene_meshes.empty("normals"), repr=False)
    corners: np.ndarray = field(default_factory=lambda: scene_meshes.empty("corners"), repr=False)
    faces: np.ndarray = field(default_factory=lambda: scene_meshes.empty("faces"), repr=False)
    meshes: list[Mesh] = field(default_factory=list)
    instances: list[Instance] = field(default_factory=list)
    views: np.ndarray = field(default_factory=lambda: scene_meshes.empty("views"), repr=False)
    views16: np.ndarray = field(default_factory=lambda: scene_meshes.empty("views16"), repr=False)
    nodes: np.ndarray = field(default_factory=lambda: scene_meshes.empty("nodes"), repr=False)
    slots: np.ndarray = field(default_factory=lambda: scene_meshes.empty("slots"), repr=False)
    units: np.ndarray = field(default_factory=lambda: scene_units.empty("units"), repr=False)
    lists: np.ndarray = field(default_factory=lambda: scene_units.empty("lists"), repr=False)
    words: np.ndarray = field(default_factory=lambda: scene_units.empty("words"), repr=False)
    dram: bytes = field(default=b"", repr=False)  # the lists load from it
    glide_units: np.ndarray = field(default_factory=lambda: scene_pipes.empty("glide_units"), repr=False)
    pipes: np.ndarray = field(default_factory=lambda: scene_pipes.empty("pipes"), repr=False)
    glide_memory: bytes = field(default=b"", repr=False)  # of all Glide's units

    @property
    def pixel(self) -> PixelFormat:
        """The format of a pixel."""
        return FORMATS[self.format]

    @property
    def frame_shape(self) -> tuple[int, int, int]:
        """Width and height, and bytes of a pixel."""
        return self.width, self.height, self.pixel.bytes


def vertices_at(scene: Scene, obj: Object, frame: int) -> list[tuple[int, int, int, int, int, int]]:
    """Returns (x, y, s, t, shade, w) of the object in a frame, x, y on the screen; empty if the
    object is not in the frame."""
    age = frame - obj.first_frame
    if not 0 <= age < obj.poses:
        return []
    xx, xy, yx, yy, x0, y0 = (int(n) for n in scene.poses[obj.pose + age])
    corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices].tolist()
    return [((xx * x >> 16) + (xy * y >> 16) + x0, (yx * x >> 16) + (yy * y >> 16) + y0, *rest)
            for x, y, *rest in corners]


def check_vertices(scene: Scene, obj: Object, name: str, where: str) -> None:
    """Refuses vertices that the material cannot have, such as those outside the map or the
    palette."""
    material = scene.materials[obj.material]
    if material.primitive in scene_units.RECTANGLES:
        scene_units.check_rectangle(scene.vertices[obj.vertex:obj.vertex + 2],
                                    scene.poses[obj.pose:obj.pose + obj.poses], name, where)
    if obj.vertices > 3 and material.mapper != "flat" and material.gradients == "polygon":
        raise UserError(f"{name}: {where}.vertices: {obj.vertices}, but gradients 'polygon' "
                        "are for triangles")
    corners = scene.vertices[obj.vertex:obj.vertex + obj.vertices]
    if material.mapper in ("gouraud", *LIT):
        for shade in corners[:, 4].tolist():
            require(name, f"{where}: shade", shade, 0, (256 << 16) - 1)
    has_own = scene_pipes.has_own(scene, material)
    if has_own:
        scene_pipes.check_own(corners, name, where)
    if material.perspective != "none" or material.mapper in UNITS:
        limits = layout.load().constants
        for w in corners[:len(corners) // (2 if has_own else 1), 5].tolist():
            require(name, f"{where}: w", w, limits["W_MIN"], limits["W_MAX"])
    if material.mapper == "arbitrary":
        check_on_map(corners[:, 2:4], scene.textures[material.texture], name, where)


def check(scene: Scene, name: str) -> None:
    """Refuses a scene whose values or indices are out of range."""
    limits = layout.load().constants
    require(name, "width", scene.width, 4, limits["FRAME_SIDE_MAX"], " pixels")
    require(name, "height", scene.height, 1, limits["FRAME_SIDE_MAX"], " pixels")
    if scene.width % 4:
        raise UserError(f"{name}: width: {scene.width} is not a multiple of 4")
    require(name, "pixel_width", scene.pixel_width, 1, 2)
    require(name, "pixel_height", scene.pixel_height, 1, 2)
    require(name, "frames", scene.frames, 1, limits["SCENE_FRAMES_MAX"])
    require(name, "background", scene.background, 0, 256**scene.pixel.bytes - 1)
    require(name, "cleared", scene.cleared, 0, 1)
    require(name, "once", scene.once, 0, 1)
    for table in TABLES:
        require(name, table, len(getattr(scene, table)), 0, limits["SCENE_COUNT_MAX"], " entries")
    for i, texture in enumerate(scene.textures):
        check_texture(texture, scene.pixel, name, f"textures[{i}]")
    scene_units.check(scene, name)
    scene_pipes.check(scene, name)
    for i, material in enumerate(scene.materials):
        scene_materials.check(scene, material, name, f"materials[{i}]")
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
        require(name, f"{where}.planar", obj.planar, 0, ALL)
        check_vertices(scene, obj, name, where)
    scene_meshes.check(scene, name)
    if scene.once:
        scene_meshes.check_once(scene, name)


def records(table, struct: layout.Struct) -> bytes:
    """Converts rows with one number a field to a table's bytes."""
    rows = np.asarray(table, np.int64).reshape(-1, len(struct.fields))
    out = np.zeros(len(rows), struct.dtype)
    for column, (field_name, entry) in enumerate(struct.fields.items()):
        bits = 8 * entry["size"]
        low = -(1 << bits - 1) if entry["signed"] else 0
        if len(rows) and not low <= rows[:, column].min() <= rows[:, column].max() < low + 2**bits:
            raise UserError(f"{struct.name}.{field_name} does not fit {bits} bits")
        out[field_name] = rows[:, column]
    return out.tobytes()


def pose_rows(scene: Scene) -> tuple[list[int], np.ndarray]:
    """Returns the first pose of each object, NO_POSE for one that never moves, and the others' poses."""
    ranges = [slice(obj.pose, obj.pose + obj.poses) for obj in scene.objects]
    moves = [(scene.poses[each] != IDENTITY).any() for each in ranges]
    used = np.zeros(len(scene.poses), bool)
    for each, moving in zip(ranges, moves):
        used[each] |= moving
    place = np.cumsum(used) - 1
    return [int(place[each.start]) if moving else layout.load().constants["NO_POSE"]
            for each, moving in zip(ranges, moves)], scene.poses[used]


def rows_of(scene: Scene) -> dict[str, list | np.ndarray]:
    """Returns the rows of all tables except the textures', one number a field."""
    rows = {table: getattr(scene, table)
            for table in ("vertices", *scene_meshes.COLUMNS, *scene_units.COLUMNS,
                          *scene_pipes.COLUMNS)}
    for table in RECORDS:
        fields = layout.load().struct(TABLES[table]).fields
        rows[table] = [[getattr(each, name) for name in fields] for each in getattr(scene, table)]
    first, rows["poses"] = pose_rows(scene)
    at = list(layout.load().struct(TABLES["objects"]).fields).index("pose")
    rows["objects"] = [[*row[:at], pose, *row[at + 1:]] for row, pose in zip(rows["objects"], first)]
    rows["materials"] = [
        [*(SETTINGS[kind].index(getattr(m, kind)) for kind in SETTINGS), m.texture, m.colour,
         m.light, m.tolerance, m.unit, scene_units.PRIMITIVES.index(m.primitive), m.levels, m.level]
        for m in scene.materials]
    return rows


def write(scene: Scene, with_palette: bool = True) -> bytes:
    """Returns the scene as a scene file. Without a palette it is for programs that contain the
    scene.

    The order is: header, palette, TABLES, BYTES, texels of each texture, padded to whole longwords.
    """
    check(scene, "scene")
    built = layout.load()
    header, rows = built.struct("scene_header"), rows_of(scene)
    palette = np.zeros((256, 4), np.uint8)
    palette[:, 1:] = scene.palette
    texels = [data + bytes(-len(data) % 4) for data in map(ordered, scene.textures)]
    values = {table: len(rows.get(table, scene.textures)) for table in TABLES}
    at = header.size + PALETTE_BYTES * with_palette + sum(
        values[table] * built.struct(struct).size for table, struct in TABLES.items())
    for block in BYTES:
        values |= {block: len(getattr(scene, block)), f"{block}_at": at}
        at += values[block]
    rows["textures"] = []
    for texture, data in zip(scene.textures, texels):
        height, width = texture.texels.shape
        rows["textures"].append([width, height, LAYOUTS.index(texture.layout), scene.pixel.bytes,
                                 at])
        at += len(data)
    values |= {"size": at, "magic": built.constants["SCENE_MAGIC"],
               "version": built.constants["SCENE_VERSION"],
               "format": list(FORMATS).index(scene.format)}
    values |= {name: getattr(scene, name) for name in HEADER}
    parts = {"palette": palette.tobytes() if with_palette else b""}
    parts |= {table: records(rows[table], built.struct(struct))
              for table, struct in TABLES.items()}
    at = header.size
    for part, data in parts.items():
        values[f"{part}_at"] = at
        at += len(data)
    body = b"".join([*parts.values(), *(getattr(scene, block) for block in BYTES), *texels])
    summed = header.fields["width"]["offset"]
    checksum = zlib.crc32(header.pack(**values, checksum=0)[summed:] + body)
    return header.pack(**values, checksum=checksum) + body
