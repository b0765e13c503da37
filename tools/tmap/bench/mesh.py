"""Calls of the meshes' routines: of points, normals, faces and cut vertices. Batches of triangles:
mesh_batches.py."""

from types import SimpleNamespace

import numpy as np

from tmap.base.linear import length, product
from tmap.bench.examples.example import longs
from tmap.bench.trial import Trial, Write, anything, fields, long_write
from tmap.build import layout
from tmap.compiler import views16
from tmap.guest.kernels import Arena, Case
from tmap.model import mesh, mesh16, model, trees
from tmap.scene_file.scene_file import records
from tmap.setup import snapped
from tmap.setup.texturing import Settings

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


def wide_trial(arena: Arena, about, points, row, title: str = "") -> Trial:
    """A mesh's points in a view. ``about``: the scene's near plane, guard, width and height."""
    to, size = arena.room("mesh_point", len(points)), layout.load().struct("mesh_point").size
    plan_at = arena.struct("wide_plan", {
        "from": table(arena, "scene_point", points), "view": table(arena, "scene_view", [row]),
        "to": to}, count=len(points), near_plane=about.near_plane, guard=about.guard,
        middle_x=about.width << 15, middle_y=about.height << 15)
    writes = []
    for at, p in zip(range(to, to + size * len(points), size), mesh.transform(about, points, row)):
        writes += [Write(at, longs((p.x, p.y, p.w, *(p.screen or ())))),
                   long_write(at + 20, outside(p, about.near_plane))]
    return Trial(Case("mesh_transform_wide", arena, pointers={"a0": plan_at}), title, writes=writes)


def wide_case(is_inside: bool):
    """COUNT points, all inside the borders or all outside."""
    rng, row = np.random.default_rng(1), view(9 << 16 if is_inside else -9 << 16)
    points = rng.integers(-1 << 17, 1 << 17, (COUNT, 3)).tolist()
    assert all(bool(p.screen) == is_inside for p in mesh.transform(ABOUT, points, row))
    return wide_trial(Arena(), ABOUT, points, row).row(COUNT)


def marks_of(arena: Arena, marked) -> int:
    """Appends marks of points, and what is behind the last; ``marked``: true for each that is needed."""
    known = layout.load().constants
    return arena.add(bytes([known["MARKED"] * bool(mark) for mark in marked] + [known["MARKS_END"]]), name="marks")


def row16(about, row, points) -> list[int]:
    """The view's factors for 16-bit operands."""
    made = views16.row_of(about, row, mesh16.reach(np.array(points)))
    assert made
    return made


def transform_trial(arena: Arena, frame: tuple[int, int], points, marked, row, title: str = "") -> Trial:
    """A mesh's points, 16-bit, those that are marked, in a view16. ``frame``: width and height."""
    points = np.array(points, np.int64)
    numbers = np.flatnonzero(marked)
    places = mesh16.transform(points[numbers], row, frame)
    size, to = layout.load().struct("mesh_place").size, arena.room("mesh_place", len(points))
    stored = np.column_stack([points[:, 0] * points[:, 1], points[:, :2], 0 * points[:, 0], points[:, 2]])
    plan_at = arena.struct("transform_plan", {
        "from": table(arena, "mesh_point16", stored), "view": table(arena, "scene_view16", [row]),
        "marks": marks_of(arena, marked), "to": to}, right=16 * min(frame[0], snapped.WIDTH), bottom=16 * frame[1])
    writes = [anything(to, size * len(points))] if places is None else [
        long_write(to + size * k + at, value)
        for k, x, y, w, is_shown in zip(numbers.tolist(), *(column.tolist() for column in vars(places).values()))
        for at, value in ((0, (x + 16 << 16 | y + 15) if is_shown else -1), (12, w))]
    return Trial(Case("mesh_transform", arena, pointers={"a0": plan_at}), title,
                 {"d0": -1 if places is None else int((~places.shown).sum())}, writes=writes)


def transform_case():
    """COUNT points, all on the screen."""
    points = np.random.default_rng(1).integers(-1 << 17, 1 << 17, (COUNT, 3))
    row, frame = row16(ABOUT, view(16 << 16), points), (ABOUT.width, ABOUT.height)
    places = mesh16.transform(mesh16.points_of(points), row, frame)
    assert places and places.shown.all()
    return transform_trial(Arena(), frame, mesh16.points_of(points), [True] * COUNT, row).row(COUNT)


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


def shade_of(value: int) -> int:
    """Returns a Gouraud shade, 16.16, as it is drawn: kept inside its whole shade's range."""
    return model.adapt([(0, 0, 0, 0, value)], Settings("snapped", mapper="gouraud"), 256)[0][2]


def values_trial(arena: Arena, kernel: str, normals, marked, factors: list[int], low: int, high: int,
                 title: str = "", shift: int = 0) -> Trial:
    """u and v or shades of normals, those of marked points, to places. ``low``, ``high``: of mesh_shade; ``shift``: of
    mesh_mirror."""
    size, to = layout.load().struct("mesh_place").size, arena.room("mesh_place", len(normals))
    plan_at = arena.struct("values_plan", {
        "from": table(arena, "scene_normal", normals), "marks": marks_of(arena, marked), "to": to,
        "factors": arena.add(np.array(factors, ">i2").tobytes(), name="factors")}, low=low, high=high, shift=shift)
    columns = [[(value << 1 >> shift) + 1 >> 1
                for value in mesh.looks(normals, factors[k:k + 3], 128 << 16, 0, 256 << 16)] for k in (0, 3)] \
        if kernel == "mesh_mirror" else [map(shade_of, mesh.looks(normals, factors[:3], low, low, high))]
    return Trial(Case(kernel, arena, pointers={"a0": plan_at}), title, writes=[
        long_write(to + size * k + at, value + snapped.RAISED << 4)
        for at, column in zip((4, 8), columns) for k, value in enumerate(column) if marked[k]])


def values_case(kernel: str, shift: int = 0):
    """COUNT normals."""
    normals = [(*n, 0) for n in np.random.default_rng(2).integers(-9000, 9000, (COUNT, 3)).tolist()]
    return values_trial(Arena(), kernel, normals, [True] * COUNT, [9000, -7000, 11000, 7000, 9000, 100],
                        20 << 16, 220 << 16, "", shift).row(COUNT)


def faces_wide_trial(arena: Arena, points, corners, faces, row, title: str = "") -> Trial:
    """Faces in a view: those that are seen. ``points``: x, y, w and the borders that each is
    outside of; ``corners``: numbers of points."""
    size, face_size = (layout.load().struct(name).size for name in ("mesh_face", "scene_face"))
    stored = [(x, y, w, 0, 0, borders, 0, 0) for x, y, w, borders in points]
    points_at = arena.add(b"".join(map(longs, stored)), name="points")
    corners_at = table(arena, "scene_corner", [(number, 0, 0, 0) for number in corners])
    faces_at = table(arena, "scene_face", faces)
    placed = arena.struct("mesh_placed", {"corners": corners_at, "points": points_at,
                                          "view": table(arena, "scene_view", [row])},
                          mesh=0, material=0, places=0, view16=0, attributes=0, flags=0, fog=0)
    to = arena.room("mesh_face", len(faces))
    plan_at = arena.struct("faces_plan", {"from": faces_at, "placed": placed, "to": to}, count=len(faces), marks=0)
    writes, seen = [], 0
    for k, face in enumerate(faces):
        first, count = face[4:]
        used = [points[number] for number in corners[first:first + count]]
        if mesh.is_seen(face, row) and not np.bitwise_and.reduce([borders for *_, borders in used]):
            order = ~max(0, *(w for *_, w, _ in used))
            writes += fields(to + seen * size, "mesh_face", {"order": order},
                             {"face": faces_at + k * face_size, "placed": placed})
            seen += 1
    return Trial(Case("mesh_faces_wide", arena, pointers={"a0": plan_at}), title, {"d0": seen}, writes=writes)


def faces_trial(arena: Arena, corners, faces, row, title: str = "") -> Trial:
    """Faces in a view16: those that are seen, and their points. ``corners``: numbers of points."""
    size, face_size = (layout.load().struct(name).size for name in ("mesh_face", "scene_face"))
    marks = marks_of(arena, [False] * (max(corners) + 1))
    corners_at = table(arena, "scene_corner", [(number, 0, 0, 0) for number in corners])
    faces_at = table(arena, "scene_face", faces)
    placed = arena.struct("mesh_placed", {"corners": corners_at, "view16": table(arena, "scene_view16", [row])},
                          mesh=0, material=0, view=0, points=0, places=0, attributes=0, flags=0, fog=0)
    to = arena.room("mesh_face", len(faces))
    plan_at = arena.struct("faces_plan", {"from": faces_at, "placed": placed, "to": to, "marks": marks},
                           count=len(faces))
    seen = [k for k, face in enumerate(faces) if mesh16.is_seen(face, row)]
    writes = [each for n, k in enumerate(seen)
              for each in fields(to + n * size, "mesh_face", {}, {"face": faces_at + k * face_size, "placed": placed})]
    needed = {number for k in seen for number in corners[faces[k][4]:sum(faces[k][4:])]}
    writes += [Write(marks + number, bytes([layout.load().constants["MARKED"]])) for number in sorted(needed)]
    return Trial(Case("mesh_faces", arena, pointers={"a0": plan_at}), title, {"d0": len(seen)}, writes=writes)


def orders_trial(arena: Arena, places, faces, shift: int, title: str = "") -> Trial:
    """Orders and corners of faces. ``places``: x and y in 1/16 pixel, None: out of range, and the depth;
    ``faces``: numbers of their points; ``shift``: of depths."""
    size, face_size, place_size = (layout.load().struct(name).size for name in ("mesh_face", "scene_face", "mesh_place"))
    places_at = arena.add(b"".join(longs((-1 if place is None else place[0] + 16 << 16 | place[1] + 15, 0, 0, depth))
                                   for place, depth in places), name="places")
    sizes = list(map(len, faces))
    corners_at = table(arena, "scene_corner", [(number, 0, 0, 0) for face in faces for number in face])
    faces_at = table(arena, "scene_face", [(0, 0, 0, 0, sum(sizes[:k]), count) for k, count in enumerate(sizes)])
    placed = arena.struct("mesh_placed", {"corners": corners_at, "places": places_at},
                          mesh=0, material=0, view=0, view16=0, points=0, attributes=0, flags=0, fog=0)
    to = arena.add(b"".join(longs((0, 0, faces_at + k * face_size, placed, 1, 1, 1, 1)) for k in range(len(faces))),
                   name="faces")
    arena.pointers += [to + size * k + at for k in range(len(faces)) for at in (8, 12)]
    plan_at = arena.struct("orders_plan", {"faces": to, "placed": placed}, count=len(faces), depth_shift=shift)
    writes = []
    for at, face in zip(range(to, to + size * len(faces), size), faces):
        used = [places[number] for number in face]
        ys = [place[1] for place, _ in used if place]
        order = ~(max(0, *(depth for _, depth in used)) << shift) & 0xFFFFFFFF
        pointers = {name: places_at + place_size * number for name, number in zip("abcd", face)}
        numbers = {"order": order} | {"d": 0 for _ in range(len(face) == 3)}
        if len(face) > snapped.CORNERS or len(ys) < len(face) or max(ys) - min(ys) >= 16 * snapped.LINES:
            del pointers["a"]
            numbers["a"] = 0
        writes += fields(at, "mesh_face", numbers, pointers)
    return Trial(Case("mesh_orders", arena, pointers={"a0": plan_at}), title, writes=writes)


def faces_input(is_seen: bool) -> tuple:
    """COUNT quadrilaterals, all seen or all from the back; numbers of corners, the view."""
    sign, row = 1 if is_seen else -1, view(0)
    row[12:15] = 3 << 16, 5 << 16, 4 << 16
    return [k % 4 for k in range(4 * COUNT)], [
        [sign << 29, sign << 28, sign << 29, 0, 4 * k, 4] for k in range(COUNT)], row


def faces_wide_case(is_seen: bool):
    """Quadrilaterals with 32-bit operands."""
    return faces_wide_trial(Arena(), [(0, 0, (k + 1) << 16, 0) for k in range(4)],
                            *faces_input(is_seen)).row(COUNT)


def faces_case(is_seen: bool):
    """The same with 16-bit operands."""
    corners, faces, row = faces_input(is_seen)
    return faces_trial(Arena(), corners, faces, row16(ABOUT, row, [[1 << 18] * 3])).row(COUNT)


def orders_case(corners: int):
    """COUNT faces of the same points, on the screen."""
    places = [((100, 200), 1 << 16), ((300, 250), 3 << 16), ((150, 500), 2 << 16), ((90, 300), 4 << 16)]
    return orders_trial(Arena(), places, [list(range(corners))] * COUNT, 1).row(COUNT)


def snap_trial(arena: Arena, points, right: int, bottom: int, title: str = "") -> Trial:
    """Points on the screen snapped to 1/16 pixel. ``points``: x, y in 16.16, and the borders that each
    is outside of; ``right``, ``bottom``: the largest x and y, 1/16 pixel."""
    points_at = arena.add(b"".join(longs((0, 0, k, x, y, borders, 0, 0)) for k, (x, y, borders) in enumerate(points)),
                          name="points")
    to = arena.room("mesh_place", len(points))
    plan_at = arena.struct("snap_plan", {"points": points_at, "to": to}, count=len(points), right=right, bottom=bottom)
    places = [place_of(x, y) if not borders and 0 <= snapped.snap(x) <= right
              and 0 <= snapped.snap(y) <= bottom else -1 for x, y, borders in points]
    return Trial(Case("mesh_snap", arena, pointers={"a0": plan_at}), title, writes=[
        long_write(to + 16 * k + at, value) for k, place in enumerate(places) for at, value in ((0, place), (12, k))])


def place_of(x: int, y: int) -> int:
    """Returns a point's x and y as struct snapped_vertex packs them."""
    return snapped.snap(x) + 16 << 16 | snapped.snap(y) + 15


def snap_case():
    """COUNT points, all in range."""
    points = [(*p, 0) for p in np.random.default_rng(4).integers(0, 200 << 16, (COUNT, 2)).tolist()]
    return snap_trial(Arena(), points, 320 * 16, 256 * 16).row(COUNT)


def spread_trial(arena: Arena, orders: list[int], title: str = "", is_crowded: bool = False) -> Trial:
    """Faces sorted by their orders."""
    size = layout.load().struct("mesh_face").size
    faces = arena.add(b"".join(longs((order, *[0] * (size // 4 - 1))) for order in orders), name="faces")
    buckets = layout.load().constants["MESH_SORT_BUCKETS"]
    at = arena.blank(4 * buckets, "buckets")
    case = Case("mesh_spread", arena, {"d0": len(orders)}, pointers={"a0": faces, "a1": at})
    nexts = [faces + size * k + 4 for k in range(len(orders))]
    if is_crowded:
        return Trial(case, title, {"d0": 0}, writes=[anything(at, 4 * buckets),
                                                     *(anything(place, 4) for place in nexts)])
    ways = sorted(range(len(orders)), key=lambda k: orders[k])
    writes = [Write(nexts[a], longs((faces + size * b,)), pointer=True) for a, b in zip(ways, ways[1:])]
    return Trial(case, title, near_ends={"d0": faces + size * ways[0]}, writes=[
        *writes, long_write(nexts[ways[-1]], 0), anything(at, 4 * buckets)])


def spread_case():
    """Four times COUNT faces of any depth in a range."""
    orders = np.random.default_rng(5).integers(1 << 31, (1 << 31) + (1 << 18), 4 * COUNT).tolist()
    return spread_trial(Arena(), orders).row(4 * COUNT)


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


def project_trial(arena: Arena, vertices: list[list[int]], frame: list[int], guard: int, title: str = "") -> Trial:
    """Vertices in the camera's space, x to w, on the screen."""
    at = arena.add(b"".join(map(longs, vertices)), name="vertices")
    plan = arena.struct("near_frame", {}, width=frame[0], height=frame[1], guard=guard, near_plane=0)
    places = [[(2 * (c << 16 + guard) + v[5]) // (2 * v[5]) + (side << 15) for c, side in zip(v, frame)] for v in vertices]
    return Trial(Case("mesh_project", arena, {"d0": len(vertices)}, pointers={"a0": at, "a1": plan}), title,
                 writes=[Write(at + 24 * k, longs(place)) for k, place in enumerate(places)])


def cut_case():
    """One vertex: all six values differ."""
    return cut_trial(Arena(), [k << 18 for k in range(1, 7)], [(9 - 2 * k) << 17 for k in range(6)],
                     12345 << 4, 99999 << 4).row(1)


#: Names of rows and what makes each: units, case and check.
def walk_trial(arena: Arena, nodes: list[list[int]], seen: list[int | None], eye: list[int], title: str = "") -> Trial:
    """The faces in a tree's slots as a list. ``seen``: the number of the face in each slot; None: it is empty."""
    size = layout.load().struct("mesh_face").size
    faces = arena.add(b"".join(longs([0] * (size // 4)) for _ in range(len(seen) + 1)), name="faces")
    places = [0 if number is None else faces + size * number for number in seen]
    slots = arena.add(b"".join(longs((place,)) for place in (*places, 0)), name="slots")
    filled = [slots + 4 * k for k, place in enumerate(places) if place]
    arena.pointers += filled
    steps = arena.blank(8 * len(nodes), "steps")
    plan = arena.struct("walk_plan", {
        "root": table(arena, "scene_node", nodes), "slots": slots, "steps": steps,
        "view": table(arena, "scene_view", [[*[0] * 12, *eye, *[0] * 10]])})
    order = [places[slot] for slot in trees.walk(nodes, 0, eye) if places[slot]]
    writes = [anything(steps, 8 * len(nodes)), *(long_write(at, 0) for at in filled)]
    writes += [Write(a + 4, longs((b,)), pointer=True) for a, b in zip(order, order[1:])]
    case = Case("mesh_walk", arena, pointers={"a0": plan})
    if not order:
        return Trial(case, title, {"d0": 0}, writes=writes)
    return Trial(case, title, near_ends={"d0": order[0]}, writes=[*writes, long_write(order[-1] + 4, 0)])


def walk_case():
    """COUNT nodes one below the other, in turn behind and in front, each with an empty slot."""
    nodes = [[1 << 29, 1 << 28, -1 << 29, 7 << 16, *((COUNT - k - 1) * (k % 2 == side) for side in (0, 1)), k, 1]
             for k in range(COUNT)]
    return walk_trial(Arena(), nodes, [None] * COUNT, [3 << 16, 5 << 16, 4 << 16]).row(COUNT)


CASES = {"mesh_transform": transform_case,
         "mesh_transform_wide": lambda: wide_case(True),
         "mesh_transform_wide_outside": lambda: wide_case(False),
         "mesh_attributes": attributes_case,
         "mesh_mirror": lambda: values_case("mesh_mirror"),
         "mesh_mirror_shifted": lambda: values_case("mesh_mirror", 1), "mesh_shade": lambda: values_case("mesh_shade"),
         "mesh_faces": lambda: faces_case(True), "mesh_faces_back": lambda: faces_case(False),
         "mesh_faces_wide": lambda: faces_wide_case(True),
         "mesh_faces_wide_back": lambda: faces_wide_case(False),
         "mesh_orders": lambda: orders_case(3), "mesh_orders_quads": lambda: orders_case(4),
         "mesh_spread": spread_case, "mesh_walk": walk_case, "mesh_snap": snap_case, "mesh_cut": cut_case}
