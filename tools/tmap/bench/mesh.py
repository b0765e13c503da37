"""Calls of the meshes' routines: of points, normals, faces and cut vertices."""

from types import SimpleNamespace

import numpy as np

from tmap.base.linear import length, product
from tmap.bench.examples.example import longs
from tmap.bench.trial import Trial, Write, fields, long_write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.model import mesh
from tmap.scene_file.scene_file import records

COUNT = 64
ABOUT = SimpleNamespace(near_plane=1 << 16, guard=9, width=320, height=256)


def table(arena: Arena, struct: str, rows) -> int:
    """Appends rows of a table of the scene file; returns the offset."""
    return arena.add(records(rows, layout.load().struct(struct)), name=struct)


def view(depth: int) -> list[int]:
    """A turned view from ``depth`` units away, in 16.16."""
    axes: list[np.ndarray] = []
    for sign, column in zip((-1, 1, -1), np.random.default_rng(3).normal(size=(3, 3)).T):
        rest = column - sum(product(axis, column) * axis for axis in axes)
        axes.append(sign * rest / length(rest))
    turn = np.array(axes).T
    return [*np.rint(turn * (1 << 30)).astype(int).ravel().tolist(), 0, 0, depth, *([0] * 13)]


def outside(point, near: int) -> int:
    """Bits of the borders that a point is outside of."""
    depths = mesh.depths(point.x, point.y, point.w, near)
    return sum(1 << k for k, depth in enumerate(depths) if depth < 0)


def transform_trial(arena: Arena, about, points, row, title: str = "") -> Trial:
    """A mesh's points in a view. ``about``: the scene's near plane, guard, width and height."""
    to, size = arena.room("mesh_point", len(points)), layout.load().struct("mesh_point").size
    plan_at = arena.struct("transform_plan", {
        "from": table(arena, "scene_point", points), "view": table(arena, "scene_view", [row]),
        "to": to}, count=len(points), near_plane=about.near_plane, guard=about.guard,
        middle_x=about.width << 15, middle_y=about.height << 15)
    writes = []
    for at, p in zip(range(to, to + size * len(points), size), mesh.transform(about, points, row)):
        writes += [Write(at, longs((p.x, p.y, p.w, *(p.screen or ())))),
                   long_write(at + 20, outside(p, about.near_plane))]
    return Trial(Case("mesh_transform", arena, pointers={"a0": plan_at}), title, writes=writes)


def transform_case(is_inside: bool):
    """COUNT points, all inside the borders or all outside."""
    rng, row = np.random.default_rng(1), view(9 << 16 if is_inside else -9 << 16)
    points = rng.integers(-1 << 17, 1 << 17, (COUNT, 3)).tolist()
    assert all(bool(p.screen) == is_inside for p in mesh.transform(ABOUT, points, row))
    return transform_trial(Arena(), ABOUT, points, row).row(COUNT)


def attributes_trial(arena: Arena, normals, factors: list[int], base: int, low: int, high: int,
                title: str = "", offset: int = 0) -> Trial:
    """One of s, t and shade of normals; ``offset``: of it in struct mesh_attributes."""
    size = layout.load().struct("mesh_attributes").size
    to = arena.room("mesh_attributes", len(normals)) + offset
    plan_at = arena.struct("attribute_plan", {
        "from": table(arena, "scene_normal", normals), "to": to,
        "factors": arena.add(np.array(factors, ">i2").tobytes(), name="factors")},
        count=len(normals), base=base, low=low, high=high)
    made = mesh.looks(normals, factors, base, low, high)
    return Trial(Case("mesh_attributes", arena, pointers={"a0": plan_at}), title,
                 writes=[long_write(to + size * k, value) for k, value in enumerate(made)])


def attributes_case():
    """COUNT normals."""
    normals = [(*n, 0) for n in np.random.default_rng(2).integers(-9000, 9000, (COUNT, 3)).tolist()]
    return attributes_trial(Arena(), normals, [9000, -7000, 11000], 128 << 16, 0,
                            256 << 16).row(COUNT)


def faces_trial(arena: Arena, points, corners, faces, row, title: str = "") -> Trial:
    """Faces in a view: those that are seen. ``points``: x, y, w and the borders that each is
    outside of; ``corners``: numbers of points."""
    size, face_size = (layout.load().struct(name).size for name in ("mesh_face", "scene_face"))
    stored = [(x, y, w, 0, 0, borders, 0, 0) for x, y, w, borders in points]
    points_at = arena.add(b"".join(map(longs, stored)), name="points")
    corners_at = table(arena, "scene_corner", [(number, 0, 0, 0) for number in corners])
    faces_at = table(arena, "scene_face", faces)
    placed = arena.struct("mesh_placed", {"corners": corners_at, "points": points_at},
                          mesh=0, material=0, attributes=0, flags=0)
    to = arena.room("mesh_face", len(faces))
    plan_at = arena.struct("faces_plan", {"from": faces_at, "placed": placed, "to": to,
                                          "view": table(arena, "scene_view", [row])}, count=len(faces))
    writes, seen = [], 0
    for k, face in enumerate(faces):
        first, count = face[4:]
        used = [points[number] for number in corners[first:first + count]]
        if mesh.is_seen(face, row) and not np.bitwise_and.reduce([borders for *_, borders in used]):
            order = ~max(0, *(w for *_, w, _ in used))
            writes += fields(to + seen * size, "mesh_face", {"order": order},
                             {"face": faces_at + k * face_size, "placed": placed})
            seen += 1
    return Trial(Case("mesh_faces", arena, pointers={"a0": plan_at}), title, {"d0": seen}, writes=writes)


def faces_case(is_seen: bool):
    """COUNT quadrilaterals, all seen or all from the back."""
    sign, row = 1 if is_seen else -1, view(0)
    row[12:15] = 3 << 16, 5 << 16, 4 << 16
    return faces_trial(Arena(), [(0, 0, (k + 1) << 16, 0) for k in range(4)],
                       [k % 4 for k in range(4 * COUNT)], [[sign << 29, sign << 28, sign << 29, 0, 4 * k, 4]
                                                           for k in range(COUNT)], row).row(COUNT)


def cut_trial(arena: Arena, inside: list[int], beyond: list[int], part: int, whole: int,
              title: str = "") -> Trial:
    """The vertex that is ``part`` of ``whole`` on the way between two of six values each."""
    ends = {name: arena.add(longs(v), name=name)
            for name, v in (("inside", inside), ("outside", beyond))}
    to = arena.room("vertex", name="to")
    plan_at = arena.struct("cut_plan", {"to": to} | ends, part=part, whole=whole)
    way = [(abs(b - a) * part + (whole >> 1)) // whole for a, b in zip(inside, beyond)]
    made = [a + w if b > a else a - w for a, b, w in zip(inside, beyond, way)]
    return Trial(Case("mesh_cut", arena, pointers={"a0": plan_at}), title,
                 writes=[Write(to, longs(made))])


def cut_case():
    """One vertex: all six values differ."""
    return cut_trial(Arena(), [k << 18 for k in range(1, 7)], [(9 - 2 * k) << 17 for k in range(6)],
                     12345 << 4, 99999 << 4).row(1)


#: Names of rows and what makes each: units, case and check.
CASES = {"mesh_transform": lambda: transform_case(True),
         "mesh_transform_outside": lambda: transform_case(False),
         "mesh_attributes": attributes_case,
         "mesh_faces": lambda: faces_case(True), "mesh_faces_back": lambda: faces_case(False),
         "mesh_cut": cut_case}
