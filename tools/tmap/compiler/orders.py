"""Trees of a scene's objects with ``order = "bsp"``: their faces are split where needed, and get the
order in which the Amiga draws them, for every place of the eye.

Neighbours in the scene are in one tree. They are still, or all move as one: then the tree is made in
their own space, in which only the eye moves. Still objects at different places are put to those
places before their points are rounded, around the middle of all of them.
"""

from dataclasses import dataclass, replace

import numpy as np

from tmap.base.fields import fail
from tmap.base.linear import product
from tmap.build import layout
from tmap.compiler import materials, mesh_build, space
from tmap.compiler.map_range import inside_map, map_of
from tmap.compiler.mesh_build import Tables, Wishes
from tmap.scene_file.meshes import UNIT_30
from tmap.shapes import cutting
from tmap.shapes.mesh_file import Shape
from tmap.trees import bsp, polygons

MOTION = ("position", "rotation", "axis", "turns", "keys", "first")  # fields of a motion
FAR = 1e12  # a coordinate in a file that no size brings near enough
Placing = tuple[np.ndarray, np.ndarray]  # rotation and move


@dataclass
class Member:
    """An object of a tree, as given to Space.place."""

    obj: dict
    look: tuple
    where: str
    tables: Tables | None = None
    first: int = 0  # number of its first face in the tree

    @property
    def moves(self) -> bool:
        """Returns True if the object has a motion of its own."""
        return bool(self.obj["keys"]) or self.obj["turns"] != 0

    @property
    def place(self) -> tuple:
        """Returns position and rotation of a still object, comparable."""
        return tuple(self.obj["position"]), tuple(self.obj["rotation"])

    @property
    def motion(self):
        """Returns the motion, comparable; None of a still object."""
        return [self.obj[name] for name in MOTION] if self.moves else None


def used_of(shape: Shape) -> list[int]:
    """Returns the numbers of the points that faces have, those that are there."""
    return sorted({point for face in shape.faces for point in face if point < len(shape.points)})


def in_place(shape: Shape, size: float, placing: Placing) -> np.ndarray:
    """Returns a mesh's points put to their places."""
    turn, move = placing
    return product(np.nan_to_num(shape.points).clip(-FAR, FAR) * size, turn.T) + move


def placed(shape: Shape, wishes: Wishes, placing: Placing, where: str) -> tuple[Shape, Wishes]:
    """Returns a mesh put to its place in a tree's space, and the wishes that it then needs; refuses one that
    is too far from the tree's middle."""
    (turn, move), most = placing, layout.load().constants["MESH_REACH"]
    normals = shape.normals and [face and [tuple(product(turn, np.array(n))) for n in face]
                                 for face in shape.normals]
    points = in_place(shape, wishes.size, placing)
    if (abs(points[used_of(shape)]) > most).any():
        fail(where, f"a point is more than {most} units from the middle of its tree")
    return replace(shape, points=points, normals=normals), \
        replace(wishes, size=1.0, baking=wishes.baking and wishes.baking.without(move))


def faces_of(tables: Tables, first: int, two_sided: bool, where: str) -> list[polygons.Polygon]:
    """Returns a mesh's faces for a tree, numbered from ``first`` on: corners are x, y, z, s, t and the
    normal's x, y, z."""
    made = []
    for number, (*_, corner, count) in enumerate(tables.faces.tolist()):
        rows = tables.corners[corner:corner + count].tolist()
        corners = [(*tables.points[p].tolist(), s, t, *tables.normals[n][:3].tolist()) for p, n, s, t in rows]
        plane = polygons.plane_of([each[:3] for each in corners])
        if plane is None:
            fail(where, f"{tables.sources[number]}: has no area once its corners are rounded")
        made.append(polygons.polygon_of(corners, plane, first + number, two_sided))
    return made


def cut(corners: list[tuple], plane: tuple, triangles: bool) -> list[list[tuple]]:
    """Returns a face, or its triangles if its material needs them or if it has too many corners."""
    if len(corners) == 3 or not triangles and len(corners) <= layout.load().constants["MESH_CORNERS_MAX"]:
        return [corners]
    places = np.array([corner[:3] for corner in corners])
    parts = cutting.triangles_in_space(places, np.array(plane[:3]) / UNIT_30) or cutting.fan(len(corners))
    return [part for part in ([corners[k] for k in kept] for kept in parts)
            if polygons.plane_of([corner[:3] for corner in part])]


def tables_of(found: list[tuple[list[tuple], tuple, str]], two_sided: bool) -> Tables:
    """Returns the rows of a mesh. ``found``: corners, plane and source of each face."""
    corners = [corner for each, *_ in found for corner in each]
    points, normals, point_of, normal_of = mesh_build.vertices(
        [corner[:3] for corner in corners], [(*corner[5:], 0) for corner in corners])
    rows, first = [], 0
    for each, plane, _ in found:
        rows.append([*((0, 0, 0, -1) if two_sided else plane), first, len(each)])
        first += len(each)
    return Tables(points, normals,
                  np.array([[p, n, *c[3:5]] for p, n, c in zip(point_of, normal_of, corners)], np.int64),
                  np.array(rows, np.int64), [source for *_, source in found], [])


class Trees:
    """Collects the trees of a scene. ``space``: its objects.Space, to which the meshes go."""

    def __init__(self, to) -> None:
        self.space = to
        self.members: list[Member] = []  # of the tree that is not made yet
        self.before = 0
        self.nodes: list[list[int]] = []
        self.slots: list[list[int]] = []

    def add(self, obj: dict, look: tuple, before: int, where: str) -> None:
        """Adds an object to the tree of the one before it; begins a new one if others are between."""
        if before != self.before:
            self.close()
        member = Member(obj, look, where)
        if self.members and member.motion != self.members[0].motion:
            one = member if member.moves else self.members[0]
            fail(f"{one.where}.{'keys' if one.obj['keys'] else 'turns'}",
                 'moves, but the neighbour with order "bsp" not the same way: they cannot be in one tree')
        self.before = before
        self.members.append(member)

    def placings(self) -> tuple[list[Placing | None], np.ndarray]:
        """Returns where the members are put in the tree's space, and the origin of that; None if it is
        their own space."""
        if self.members[0].moves or len({member.place for member in self.members}) == 1:
            return [None] * len(self.members), np.zeros(3)
        places, ends = [], []
        for member in self.members:
            obj, (_, material, texture, _) = member.obj, member.look
            shape = self.space.shape_of(obj["mesh"], f"{member.where}.mesh", map_of(material, texture).extent) \
                if "mesh" in obj else Shape(np.array(obj["points"], float), obj["faces"])
            turn, position = space.rotated(obj["rotation"]), np.array(obj["position"])
            places.append((turn, position))
            ends += [*in_place(shape, obj["size"], places[-1])[used_of(shape)]]
        origin = np.rint((np.min(ends, axis=0) + np.max(ends, axis=0)) / 2) if ends else np.zeros(3)
        return [(turn, position - origin) for turn, position in places], origin

    def build(self, member: Member, placing: Placing | None) -> Tables | None:
        """Returns the tables of an object before its faces are split."""
        _, material, texture, _ = member.look
        mapper, shown = materials.mapper_of(material), map_of(material, texture)
        made = self.space.build(member.obj, mapper, shown, self.space.wishes_of(member.obj, material),
                                member.where, placing=placing)
        if made and mapper == "arbitrary":
            made.corners[:, 2:4] = inside_map(made.corners[:, 2:4], texture)
        return made

    def close(self) -> None:
        """Makes the tree of the objects that were added since the last one, if there are any."""
        if not self.members:
            return
        placings, origin = self.placings()
        faces: list[polygons.Polygon] = []
        owners: list[Member] = []
        for member, placing in zip(self.members, placings):
            member.tables = self.build(member, placing)
            member.first = len(faces)
            if member.tables:
                made = faces_of(member.tables, len(faces), member.obj["two_sided"], member.where)
                faces += made
                owners += [member] * len(made)
            if placing:
                member.obj = member.obj | {"position": origin.tolist(), "rotation": [0.0, 0.0, 0.0]}
        if faces:
            self.store(faces, owners)
        self.members = []

    def store(self, faces: list[polygons.Polygon], owners: list[Member]) -> None:
        """Builds the tree and adds its nodes, slots, meshes and instances."""
        limits, where = layout.load().constants, self.members[0].where
        tree = bsp.build(faces, limits["SCENE_COUNT_MAX"])
        if tree is None:
            fail(f"{where}.order", f"more than {limits['SCENE_COUNT_MAX']} faces in a tree, those counted that "
                                   "splits make")
        root, slot = len(self.nodes), 0
        found: dict[int, list] = {id(member): [] for member in self.members}
        for node, counts in zip(tree.nodes, tree.counts):
            first = slot
            for face in node.faces:
                member = owners[face.source]
                number = face.source - member.first
                corners = polygons.in_file(polygons.with_cuts(face, tree.cuts))
                wishes = self.space.wishes_of(member.obj, member.look[1])
                for part in cut(corners, face.plane, wishes.triangles) if corners else []:
                    found[id(member)].append((part, face.plane, member.tables.sources[number], slot))
                    slot += 1
            self.nodes.append([*(node.plane or (0, 0, 0, 0)), *counts, first, slot - first])
        if slot > limits["SCENE_COUNT_MAX"] or len(self.nodes) > limits["SCENE_COUNT_MAX"]:
            fail(f"{where}.order", f"more than {limits['SCENE_COUNT_MAX']} faces or nodes of trees")
        for member in self.members:
            if found[id(member)]:
                self.store_mesh(member, found[id(member)], root)
        parts = sum(len(node.faces) for node in tree.nodes)
        self.space.notes[f"tree {root}"] = f"{where}: a tree of {len(faces)} faces: {parts - len(faces)} more by " \
                                           f"splits, {len(tree.nodes)} nodes"

    def store_mesh(self, member: Member, found: list, root: int) -> None:
        """Adds an object's mesh with the faces that splits made, and its instance."""
        limits = layout.load().constants
        made = tables_of([each[:3] for each in found], member.obj["two_sided"])
        for noun in ("points", "faces", "normals"):
            count = len(getattr(made, noun))
            if count > limits["MESH_COUNT_MAX"]:
                fail(f"{member.where}.order", f"{count} {noun} with those that splits make; "
                                              f"{limits['MESH_COUNT_MAX']} at most")
        first = len(self.slots)
        self.slots += [[slot] for *_, slot in found]
        if len(self.slots) > limits["SCENE_COUNT_MAX"]:
            fail(f"{member.where}.order", f"more than {limits['SCENE_COUNT_MAX']} faces in trees")
        mesh = self.space.store(made, member.where)
        self.space.add_instance(mesh, member.obj, member.look, self.before, member.where, root, first)
