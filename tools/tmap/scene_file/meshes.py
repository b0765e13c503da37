"""Meshes in scene files: their tables, and checks for everything the Amiga would refuse.

Formats and ranges are defined in c/scene/scene_file.h.
"""

from dataclasses import dataclass

import numpy as np

from tmap.base.errors import UserError, require
from tmap.base.fixed import ONE
from tmap.build import layout
from tmap.scene_file import pipes, trees
from tmap.scene_file.textures import UNITS, check_on_map

#: Tables of numbers, with their columns.
COLUMNS = {"points": ("x", "y", "z"), "normals": ("x", "y", "z", "spare"),
           "corners": ("point", "normal", "s", "t"),
           "faces": ("x", "y", "z", "distance", "corner", "corners"),
           "views": ("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz", "x0", "y0", "z0",
                     "eye_x", "eye_y", "eye_z", "s_x", "s_y", "s_z", "t_x", "t_y", "t_z",
                     "light_x", "light_y", "light_z", "spare"),
           "views16": ("w_move", "wx", "wy", "wz", "divisor_shift", "x_move", "xx", "xy", "xz", "depth_shift",
                       "y_move", "yx", "yy", "yz", "seen_shift", "eye_x", "eye_y", "eye_z", "is_used"),
           "nodes": ("x", "y", "z", "distance", "front", "back", "slot", "slots"), "slots": ("slot",)}
ENVIRONMENT, LIT, FOG = 1, 2, 4  # MESH_ENVIRONMENT, MESH_LIT, MESH_FOG
NOT_ONCE = ("keyed", *UNITS)  # mappers whose pixels nothing says whether they are opaque
UNIT_14, UNIT_30 = 1 << 14, 1 << 30  # 1.0 in 2.14 and 2.30


@dataclass
class Mesh:
    """First entries and counts, as struct scene_mesh."""

    point: int
    points: int
    normal: int
    normals: int
    corner: int
    corners: int
    face: int
    faces: int


@dataclass
class Instance:
    """A mesh that moves, as struct scene_instance."""

    mesh: int
    material: int
    before: int
    view: int
    views: int
    first_frame: int
    flags: int = 0
    dark: int = 0
    bright: int = 0
    view16: int = -1  # NO_VIEW16
    tree: int = -1  # NO_TREE
    slot: int = 0
    fog_near: int = 0
    fog_far: int = 0


def empty(table: str) -> np.ndarray:
    """Returns a table without entries."""
    return np.zeros((0, len(COLUMNS[table])), np.int64)


def require_all(name: str, table: str, rows: np.ndarray, columns, low: int, high: int) -> None:
    """Refuses a table with a value outside low..high in one of these columns."""
    for column in columns:
        values = rows[:, COLUMNS[table].index(column)]
        wrong = np.flatnonzero((values < low) | (values > high))
        if len(wrong):
            require(name, f"{table}[{wrong[0]}].{column}", int(values[wrong[0]]), low, high)


def check_mesh(scene, mesh: Mesh, name: str, where: str) -> None:
    """Refuses a mesh with entries outside its tables."""
    limits = layout.load().constants
    most = limits["MESH_COUNT_MAX"]
    for one, many, low, high in (("point", "points", 1, most), ("normal", "normals", 1, most),
                                 ("corner", "corners", 0, limits["SCENE_COUNT_MAX"]),
                                 ("face", "faces", 1, most)):
        count, first = getattr(mesh, many), getattr(mesh, one)
        require(name, f"{where}.{many}", count, low, high)
        require(name, f"{where}.{one}", first, 0, len(getattr(scene, many)) - count)
    corners = scene.corners[mesh.corner:mesh.corner + mesh.corners]
    for column, high in (("point", mesh.points), ("normal", mesh.normals)):
        require_all(name, "corners", corners, [column], 0, high - 1)
    for face in scene.faces[mesh.face:mesh.face + mesh.faces].tolist():
        require(name, f"{where}: face.corners", face[5], 3, limits["MESH_CORNERS_MAX"])
        require(name, f"{where}: face.corner", face[4], 0, mesh.corners - face[5])


def check_look(scene, instance: Instance, name: str, where: str) -> None:
    """Refuses an instance whose mesh or flags its material cannot draw."""
    material, mesh = scene.materials[instance.material], scene.meshes[instance.mesh]
    limits = layout.load().constants
    if instance.flags & (LIT | FOG):
        require(name, f"{where}.bright", instance.bright, 0, (256 << 16) - 1)
        require(name, f"{where}.dark", instance.dark, 0, instance.bright)
    if pipes.has_own(scene, material):
        raise UserError(f"{name}: {where}.material: a mesh has no coordinates for a second unit")
    if material.primitive != "polygons":
        raise UserError(f"{name}: {where}.material: a mesh's polygons are not "
                        f"{material.primitive!r}")
    if material.mapper == "gouraud" and not instance.flags & (LIT | FOG):
        raise UserError(f"{name}: {where}.flags: a Gouraud material needs light")
    if instance.flags & FOG:
        if instance.flags & LIT or material.light < 0 and material.mapper != "gouraud":
            raise UserError(f"{name}: {where}.flags: fog is for a light table, or Gouraud's, alone")
        require(name, f"{where}.fog_near", instance.fog_near, 0, limits["W_MAX"])
        require(name, f"{where}.fog_far", instance.fog_far, instance.fog_near + 1, limits["W_MAX"])
    if material.mapper != "flat" and material.gradients == "polygon":
        most = scene.faces[mesh.face:mesh.face + mesh.faces, 5].max()
        require(name, f"{where}: face.corners", int(most), 3, 3)
    if material.mapper == "arbitrary":
        if instance.flags & ENVIRONMENT:
            raise UserError(f"{name}: {where}.flags: 'arbitrary' does not repeat its map")
        corners = scene.corners[mesh.corner:mesh.corner + mesh.corners, 2:4]
        check_on_map(corners, scene.textures[material.texture], name, where)


def check_once(scene, name: str) -> None:
    """Refuses instances whose pixels cannot be drawn once."""
    for i, instance in enumerate(scene.instances):
        material = scene.materials[instance.material]
        if instance.tree != layout.load().constants["TREE_Z"] \
                and (material.edges != "exact" or material.mapper in NOT_ONCE):
            raise UserError(f"{name}: once: instances[{i}] has edges {material.edges!r}, mapper {material.mapper!r}")


def check(scene, name: str) -> None:
    """Refuses meshes, instances and views with values or indices out of range."""
    limits = layout.load().constants
    reach, away = limits["MESH_REACH"] * ONE, limits["MESH_AWAY"] * ONE - 1
    require_all(name, "points", scene.points, "xyz", -reach, reach)
    require_all(name, "normals", scene.normals, "xyz", -UNIT_14, UNIT_14)
    require_all(name, "faces", scene.faces, "xyz", -UNIT_30, UNIT_30)
    require_all(name, "views", scene.views, COLUMNS["views"][:9], -UNIT_30, UNIT_30)
    require_all(name, "views", scene.views, ("x0", "y0", "z0"), -away, away)
    factor, shift = limits["MESH_FACTOR16"], limits["MESH_SHIFT16"]
    require_all(name, "views16", scene.views16, [f"{row}{c}" for row in "wxy" for c in "xyz"], -factor, factor)
    require_all(name, "views16", scene.views16, ("divisor_shift", "depth_shift", "seen_shift"), 0, shift)
    for i, mesh in enumerate(scene.meshes):
        check_mesh(scene, mesh, name, f"meshes[{i}]")
    if scene.instances:
        require(name, "near_plane", scene.near_plane, limits["W_MIN"], limits["W_MAX"] - 1)
        require(name, "guard", scene.guard, limits["GUARD_MIN"], limits["GUARD_MAX"])
    before = 0
    for i, instance in enumerate(scene.instances):
        where = f"instances[{i}]"
        require(name, f"{where}.mesh", instance.mesh, 0, len(scene.meshes) - 1)
        require(name, f"{where}.material", instance.material, 0, len(scene.materials) - 1)
        require(name, f"{where}.before", instance.before, before, len(scene.objects))
        before = instance.before
        require(name, f"{where}.views", instance.views, 1, limits["SCENE_COUNT_MAX"])
        require(name, f"{where}.view", instance.view, 0, len(scene.views) - instance.views)
        if instance.view16 != limits["NO_VIEW16"]:
            require(name, f"{where}.view16", instance.view16, 0, len(scene.views16) - instance.views)
        require(name, f"{where}.first_frame", instance.first_frame, 0, scene.frames - 1)
        require(name, f"{where}.flags", instance.flags, 0, limits["MESH_FLAGS"] - 1)
        check_look(scene, instance, name, where)
    trees.check(scene, name)
