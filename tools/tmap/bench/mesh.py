"""Bench rows of meshes: cycles a point, a normal, a face or a cut vertex."""

from types import SimpleNamespace

import numpy as np

from tmap.base.fixed import M32, mul_div
from tmap.base.linear import length, product
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result
from tmap.model import mesh
from tmap.scene_file.scene_file import records

COUNT = 64
ABOUT = SimpleNamespace(near_plane=1 << 16, guard=9, width=320, height=256)


def table(arena: Arena, struct: str, rows) -> int:
    """Appends rows of a table of the scene file; returns the offset."""
    return arena.add(records(rows, layout.load().struct(struct)))


def view(depth: int) -> list[int]:
    """A turned view from ``depth`` units away, in 16.16."""
    axes: list[np.ndarray] = []
    for sign, column in zip((-1, 1, -1), np.random.default_rng(3).normal(size=(3, 3)).T):
        rest = column - sum(product(axis, column) * axis for axis in axes)
        axes.append(sign * rest / length(rest))
    turn = np.array(axes).T
    return [*np.rint(turn * (1 << 30)).astype(int).ravel().tolist(), 0, 0, depth, *([0] * 13)]


def longs(result: Result, at: int, count: int) -> list[int]:
    """Longwords of the memory that a call left."""
    return np.frombuffer(result.memory, ">i4", count, at).tolist()


def transform_case(is_inside: bool):
    """COUNT points, all inside the borders or all outside."""
    rng, row = np.random.default_rng(1), view(9 << 16 if is_inside else -9 << 16)
    points = rng.integers(-1 << 17, 1 << 17, (COUNT, 3)).tolist()
    arena, size = Arena(), layout.load().struct("mesh_point").size // 4
    to = arena.add(bytes(4 * size * COUNT))
    plan_at = arena.struct("transform_plan", {
        "from": table(arena, "scene_point", points), "view": table(arena, "scene_view", [row]),
        "to": to}, count=COUNT, near_plane=ABOUT.near_plane, guard=ABOUT.guard,
        middle_x=ABOUT.width << 15, middle_y=ABOUT.height << 15)
    made = mesh.transform(ABOUT, points, row)
    assert all(bool(p.screen) == is_inside for p in made)

    def check(result: Result) -> str | None:
        for k, p in enumerate(made):
            found = longs(result, to + 4 * size * k, 5 if is_inside else 3)
            if found != [p.x, p.y, p.w, *(p.screen or ())]:
                return f"point {k}: {found}, expected {p}"
        return None

    return COUNT, Case("mesh_transform", arena, pointers={"a0": plan_at}), check


def looks_case():
    """COUNT normals, one of s, t and shade."""
    rng, arena = np.random.default_rng(2), Arena()
    normals = [(*n, 0) for n in rng.integers(-9000, 9000, (COUNT, 3)).tolist()]
    factors, size = [9000, -7000, 11000], layout.load().struct("mesh_look").size // 4
    to = arena.add(bytes(4 * size * COUNT))
    plan_at = arena.struct("look_plan", {
        "from": table(arena, "scene_normal", normals), "to": to,
        "factors": arena.add(np.array(factors, ">i2").tobytes())},
        count=COUNT, base=128 << 16, low=0, high=256 << 16)
    made = mesh.looks(normals, factors, 128 << 16, 0, 256 << 16)

    def check(result: Result) -> str | None:
        found = longs(result, to, size * COUNT)[::size]
        return None if found == made else f"{found}, expected {made}"

    return COUNT, Case("mesh_looks", arena, pointers={"a0": plan_at}), check


def faces_case(is_seen: bool):
    """COUNT quadrilaterals, all seen or all from the back."""
    arena = Arena()
    points = [[0, 0, (k + 1) << 16, 0, 0, 0, 0, 0] for k in range(4)]
    points_at = arena.add(np.array(points, ">i4").tobytes())
    corners_at = table(arena, "scene_corner", [(k % 4, 0, 0, 0) for k in range(4 * COUNT)])
    sign = 1 if is_seen else -1
    faces_at = table(arena, "scene_face", [[sign << 29, sign << 28, sign << 29, 0, 4 * k, 4]
                                           for k in range(COUNT)])
    row = view(0)
    row[12:15] = 3 << 16, 5 << 16, 4 << 16
    placed = arena.struct("mesh_placed", {"corners": corners_at, "points": points_at},
                          mesh=0, material=0, looks=0, flags=0)
    to = arena.add(bytes(layout.load().struct("mesh_face").size * COUNT))
    plan_at = arena.struct("faces_plan", {"from": faces_at, "placed": placed, "to": to,
                                          "view": table(arena, "scene_view", [row])}, count=COUNT)

    def check(result: Result) -> str | None:
        seen = result.registers["d0"]
        orders = [value & M32 for value in longs(result, to, 3 * seen)[::3]]
        wanted = [~(4 << 16) & M32] * (COUNT if is_seen else 0)
        return None if orders == wanted else f"{orders}, expected {wanted}"

    return COUNT, Case("mesh_faces", arena, pointers={"a0": plan_at}), check


def cut_case():
    """One vertex: all six values differ."""
    arena = Arena()
    inside, outside = [k << 18 for k in range(1, 7)], [(9 - 2 * k) << 17 for k in range(6)]
    part, whole = 12345 << 4, 99999 << 4
    ends = [arena.add(np.array(v, ">i4").tobytes()) for v in (inside, outside)]
    to = arena.add(bytes(24))
    plan_at = arena.struct("cut_plan", {"to": to, "inside": ends[0], "outside": ends[1]},
                           part=part, whole=whole)
    moves = [mul_div(abs(b - a), part, whole) for a, b in zip(inside, outside)]
    made = [a + (move if b > a else -move) for a, b, move in zip(inside, outside, moves)]

    def check(result: Result) -> str | None:
        found = longs(result, to, 6)
        return None if found == made else f"{found}, expected {made}"

    return 1, Case("mesh_cut", arena, pointers={"a0": plan_at}), check


#: Names of rows and what makes each: units, case and check.
CASES = {"mesh_transform": lambda: transform_case(True),
         "mesh_transform_outside": lambda: transform_case(False), "mesh_looks": looks_case,
         "mesh_faces": lambda: faces_case(True), "mesh_faces_back": lambda: faces_case(False),
         "mesh_cut": cut_case}
