"""Calls of what finds visible pixels: depth_fill and depth_copy, z of lines and pixels by it; coverage_scan, which
finds the visible parts of a polygon's lines and covers them; mesh_near and mesh_near_face, which walk a tree from its
nearest faces on."""

from dataclasses import dataclass, field

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.bench import edges
from tmap.bench.examples.example import longs
from tmap.bench.mesh import ABOUT, COUNT, outside, table, view
from tmap.bench.spans import BIAS, table_of
from tmap.bench.trial import Trial, Write, anything, fields, long_write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result
from tmap.model import mesh, trees
from tmap.scene_file.scene_file import records

LENGTH, LINES = 64, 16
Lines = list[tuple[int, int]]  # of each line the first pixel and the last
END = 32767  # x of the gap behind all others
Gaps = list[tuple[int, int]]  # first and last x of each, from the left


@dataclass
class Slope:
    """q of a face, 32.32: at pixel -EDGE_BIAS of the first line, and its growth a pixel and a line."""

    at: int
    dx: int
    dy: int

    @property
    def step(self) -> int:
        """Growth a pixel, rounded to the nearest."""
        return self.dx + (1 << 31) >> 32

    def line(self, first: int, count: int, y: int) -> list[int]:
        """q of the pixels of a line."""
        start = self.at + (first + BIAS) * self.dx + y * self.dy >> 32
        return [signed(start + k * self.step) for k in range(count)]

    def fields(self) -> dict:
        """The plan's fields."""
        whole = {name: list((getattr(self, name) % (1 << 64)).to_bytes(8, "big")) for name in ("at", "dx", "dy")}
        return whole | {"step": signed(self.step)}


def depth_trial(kernel: str, lines: Lines, columns: tuple[int, int], slope: Slope, z: np.ndarray, arena: Arena,
                title: str = "") -> Trial:
    """One table. ``columns``: the first and the last that are filled; ``z``: q of the frame's pixels before, as many lines. Pixels aside have numbers, a third of them 0
    where 0 is transparent; the frame's are 0."""
    shape, (height, width) = layout.load().struct("scanline"), z.shape
    aside = (np.arange(z.size) % 255 + 1).astype(np.uint8).reshape(z.shape)
    if kernel == "depth_copy_keyed":
        aside[:, 2::3] = 0
    table = arena.add(table_of([{"left": BIAS + a, "last": BIAS + b} for a, b in lines]), name="lines", shape=shape)
    at = arena.add(z.astype(">i4").tobytes(), name="z")
    to, source = arena.add(bytes(z.size), name="frame"), arena.add(aside.tobytes(), name="aside")
    plan = arena.struct("depth_plan", {"lines": table, "row": at - 4 * BIAS, "from": source - BIAS, "to": to - BIAS},
                        count=height, pitch=4 * width, from_pitch=width, to_pitch=width, left=BIAS + columns[0], last=BIAS + columns[1],
                        **slope.fields())
    writes = []
    for y, (left, last) in enumerate(lines):
        if kernel == "depth_fill":
            left, last = max(left, columns[0]), min(last, columns[1])
        for x, q in enumerate(slope.line(left, last - left + 1, y), left):
            if kernel == "depth_fill" or q >= z[y, x] and aside[y, x]:
                place = y * width + x
                writes.append(Write(at + 4 * place, (q & M32).to_bytes(4, "big")))
                if kernel != "depth_fill":
                    writes.append(Write(to + place, aside[y, x:x + 1].tobytes()))
    return Trial(Case(kernel, arena, pointers={"a0": plan}), title, writes=writes)


def depth_case(kernel: str, before: int):
    """LINES lines of LENGTH pixels, all in the columns; ``before``: z of all of them."""
    slope = Slope(1 << 60, 1000 << 32 | 5, 300 << 32 | 7)
    z = np.full((LINES, LENGTH), before)
    return depth_trial(kernel, [(0, LENGTH - 1)] * LINES, (0, LENGTH - 1), slope, z, Arena()).row(LINES * LENGTH)


CASES = {"depth_fill": lambda: depth_case("depth_fill", 0), "depth_copy": lambda: depth_case("depth_copy", 0),
         "depth_copy_hidden": lambda: depth_case("depth_copy", 1 << 30),
         "depth_copy_keyed": lambda: depth_case("depth_copy_keyed", 0)}


def scanned(gaps: Gaps, left: int, last: int) -> tuple[Gaps, Gaps]:
    """Returns a line's gaps once pixels are covered, and the visible parts of these."""
    after, parts = [], []
    for first, end in gaps:
        if end < left or first > last:
            after.append((first, end))
            continue
        parts.append((max(first, left), min(end, last)))
        after += [(a, b) for a, b in ((first, left - 1), (last + 1, end)) if a <= b]
    return after, parts


def parts_of(number: int, line: tuple[int, int], visible: Gaps) -> list[tuple[int, int, int]]:
    """Returns the struct visible_part entries of a line."""
    if line[1] < line[0] or visible == [line]:
        return []
    return [(number, *part) for part in visible] or [(number, 1, 0)]


def gaps_of(memory: bytes, address: int, at: int) -> Gaps:
    """Returns the gaps of a line, whose first one's address is at an offset of memory."""
    found, shape = [], layout.load().struct("gap")
    while True:
        gap = int.from_bytes(memory[at:at + 4], "big") - address
        left, last = (int.from_bytes(memory[gap + k:gap + k + 2], "big") for k in (0, 2))
        if left == END or len(found) > len(memory):
            return found
        found.append((left, last))
        at = gap + shape.fields["next"]["offset"]


def scan_trial(lines: list[tuple[int, int]], gaps: list[Gaps], arena: Arena, title: str = "", unused: int = 0,
               fresh: int | None = None) -> Trial:
    """One table. ``lines``: first and last x of each, biased; ``gaps``: of each line; ``unused``: gaps in the list of
    unused ones, ``fresh``: those behind that, as many as needed if None."""
    shapes, count = layout.load(), len(lines)
    gap, part, whole = (shapes.struct(name) for name in ("gap", "visible_part", "coverage"))
    fresh = max(0, count - unused) if fresh is None else fresh
    table = arena.add(table_of([{"left": a, "last": b} for a, b in lines]), name="lines", shape=shapes.struct("scanline"))
    used = sum(map(len, gaps))
    pool = arena.room("gap", used + unused + fresh, "gaps")
    after, parts, opened = [], [], sum(map(bool, gaps))
    overflows = unused + fresh < count
    for number, (line, row) in enumerate(zip(lines, gaps)):
        now, visible = scanned(row, *line) if line[0] <= line[1] and not overflows else (row, [])
        after.append(now)
        parts += [] if overflows else parts_of(number, line, visible)
    room = arena.room("visible_part", max(count, len(parts)) + 1, "parts")
    coverage = arena.room("coverage")
    for name, value in {"parts": room, "fresh": pool + (used + unused) * gap.size,
                        "unused": pool + used * gap.size if unused else 0, "left": unused + fresh, "open": opened,
                        "overflow": 0}.items():
        field = coverage + whole.fields[name]["offset"]
        arena.data[field:field + 4] = value.to_bytes(4, "big")
        if name in ("parts", "fresh") or name == "unused" and unused:
            arena.pointers.append(field)
    end = coverage + whole.fields["end"]["offset"]
    heads, at = [], pool
    for row in gaps:
        heads.append(at if row else end)
        for number, (first, last) in enumerate(row):
            following = at + gap.size if number + 1 < len(row) else end
            fill(arena, at, first, last, following)
            at += gap.size
    for number in range(unused):
        fill(arena, at, 0, 0, at + gap.size if number + 1 < unused else None)
        at += gap.size
    fill(arena, end, END, END, end)
    rows = arena.add(b"".join(each.to_bytes(4, "big") for each in heads), name="rows")
    arena.pointers += [rows + 4 * k for k in range(count)]
    plan = arena.struct("scan_plan", {"lines": table, "rows": rows, "coverage": coverage}, count=count)
    left = unused + fresh - sum(len(now) - len(row) for now, row in zip(after, gaps))
    seen = any(a != b for a, b in zip(after, gaps))
    writes = [anything(pool, (used + unused + fresh) * gap.size), anything(rows, 4 * count),
              *(anything(coverage + whole.fields[name]["offset"], 4) for name in ("unused", "fresh")),
              *fields(coverage, "coverage", {"left": left, "open": opened - sum(bool(row) and not now for row, now
                                                                               in zip(gaps, after)),
                                             "seen": int(seen), "overflow": int(overflows)},
                      {"parts_end": room + len(parts) * part.size}),
              Write(room, b"".join(value.to_bytes(2, "big") for each in parts for value in each))]

    def also(result: Result) -> str | None:
        found = [gaps_of(result.memory, result.address, rows + 4 * k) for k in range(count)]
        wrong = [k for k in range(count) if found[k] != after[k]]
        return f"gaps of line {wrong[0]}: expected {after[wrong[0]]}, found {found[wrong[0]]}" if wrong else None

    return Trial(Case("coverage_scan", arena, pointers={"a0": plan}), title, writes=writes, also=also)


def fill(arena: Arena, at: int, left: int, last: int, following: int | None) -> None:
    """Writes a struct gap; ``following``: the offset of the next one, or None."""
    arena.data[at:at + 8] = left.to_bytes(2, "big") + last.to_bytes(2, "big") + (following or 0).to_bytes(4, "big")
    if following is not None:
        arena.pointers.append(at + 4)


def scan_case():
    """edges.LINES lines that are hidden between two gaps: calls that cover pixels would find them covered the next time."""
    gaps = [[(BIAS, BIAS + 9), (BIAS + 300, BIAS + 319)]] * edges.LINES
    return scan_trial([(BIAS + 160, BIAS + 239)] * edges.LINES, gaps, Arena()).row(edges.LINES)


@dataclass
class Near:
    """A walk of mesh_near. ``borders``: of each the places in a box (0 to 5: low x, y, z, high x, y, z), the factors and
    the limit; ``node``: where it goes on, or None; ``steps``: nodes and the first ones of their farther half spaces."""

    nodes: list[list[int]]
    boxes: list[list[int]]
    borders: list[tuple[tuple[int, ...], tuple[int, ...], int]]
    eye: list[int]
    node: int | None = 0
    steps: list[tuple[int, int | None]] = field(default_factory=list)

    def is_outside(self, node: int) -> bool:
        """Returns true if a node's box is outside a border."""
        return any(sum(self.boxes[node][k] * factor for k, factor in zip(at, factors)) < limit
                   for at, factors, limit in self.borders)

    def next(self) -> int | None:
        """Goes on to the next node with slots."""
        while self.node is not None or self.steps:
            if self.node is None:
                found, self.node = self.steps.pop()
                if self.nodes[found][7]:
                    return found
                continue
            number, self.node = self.node, None
            *_, front, back, _, slots = self.nodes[number]
            if self.is_outside(number):
                continue
            if not front and not back:
                if slots:
                    return number
                continue
            ways = [number + 1 if front else None, number + 1 + front if back else None]
            if not trees.is_in_front(self.nodes[number], self.eye):
                ways.reverse()
            self.node = ways[0]
            self.steps.append((number, ways[1]))
        return None


def eye_view(arena: Arena, eye: list[int]) -> int:
    """Appends a view of which only the eye counts."""
    return table(arena, "scene_view", [[*[0] * 12, *eye, *[0] * 10]])


def near_trial(arena: Arena, walk: Near, title: str = "") -> Trial:
    """The next node of a walk, which goes on."""
    shape, node_size = layout.load().struct("near_walk").fields, layout.load().struct("scene_node").size
    nodes = table(arena, "scene_node", walk.nodes)
    boxes = table(arena, "mesh_box", [[*box, 0, 0] for box in walk.boxes])
    borders = records([[n for pair in zip([2 * k for k in at], factors) for n in pair] + [limit]
                       for at, factors, limit in walk.borders], layout.load().struct("box_border"))
    def places() -> list[int | None]:
        return [None if number is None else nodes + node_size * number for step in walk.steps for number in step]
    room, before = 2 * len(walk.nodes), places()
    steps = arena.add(longs([place or 0 for place in before] + [0] * (room - len(before))), name="steps")
    arena.pointers += [steps + 4 * k for k, place in enumerate(before) if place is not None]
    pointers = {"last": steps + 4 * len(before), "steps": steps, "nodes": nodes, "boxes": boxes,
                "view": eye_view(arena, walk.eye)}
    numbers = {"is_hidden": 0, "borders": list(borders), "frame": [0] * 16}
    if walk.node is None:
        numbers["node"] = 0
    else:
        pointers["node"] = nodes + node_size * walk.node
    plan = arena.struct("near_walk", pointers, **numbers)
    found, after = walk.next(), places()
    writes = [long_write(steps + 4 * k, 0) if place is None else Write(steps + 4 * k, longs((place,)), pointer=True)
              for k, place in enumerate(after)]
    writes += [anything(steps + 4 * len(after), 4 * (room - len(after)))] if len(after) < room else []
    writes += [Write(plan + shape["last"]["offset"], longs((steps + 4 * len(after),)), pointer=True)]
    writes += [long_write(plan + shape["node"]["offset"], 0) if walk.node is None else Write(
        plan + shape["node"]["offset"], longs((nodes + node_size * walk.node,)), pointer=True)]
    case = Case("mesh_near", arena, pointers={"a0": plan})
    if found is None:
        return Trial(case, title, {"d0": 0}, writes=writes)
    return Trial(case, title, near_ends={"d0": nodes + node_size * found}, writes=writes)


def near_case():
    """COUNT nodes one in front of the other, inside all borders: the last one has a slot."""
    nodes = [[1 << 29, 1 << 28, -1 << 29, -7 << 16, COUNT - k - 1, 0, 0, int(k == COUNT - 1)] for k in range(COUNT)]
    walk = Near(nodes, [[0] * 6] * COUNT, [((0, 1, 2), (1, 1, 1), 0)] * 5, [3 << 16, 5 << 16, 4 << 16])
    return near_trial(Arena(), walk).row(COUNT)


@dataclass
class Faces:
    """What mesh_near_face chooses from."""

    faces: list[tuple[list[int], list[int]] | None]  # of each slot normal and distance, the points of its corners
    points: list[list[int]]
    stamped: list[bool]  # those that are transformed already
    row: list[int]  # of a view
    gaps: list[list[tuple[int, int]]]  # of each line of the frame, biased
    off: int = 1024  # units by which edges may be beyond points


def place_of(point, about, borders: int) -> tuple[int, int] | None:
    """Where mesh_near_face places a point on the screen: beyond borders far away; None: it is before the near plane."""
    far = layout.load().constants["NEAR_FAR"] << 16
    if borders & 1:
        return None
    def along(at: int, low: int, high: int, side: int) -> int:
        if borders & (low | high):
            return -far if borders & low else far
        return side + (2 * (at << 16 + about.guard) + point.w) // (2 * point.w)
    return along(point.x, 2, 4, about.width << 15), along(point.y, 8, 16, about.height << 15)


def box_of(places: list[tuple[int, int]], off: int, more: int) -> tuple[int, ...]:
    """Returns left, right, top, bottom of what edges `off` units beyond places cover, and `more` pixels beside it."""
    return tuple(-(-(pick(at[k] for at in places) + side * off) >> 16) - (side > 0) + side * more
                 for k in range(2) for pick, side in ((min, -1), (max, 1)))


def is_in_gap(box: tuple[int, ...], gaps: list[list[tuple[int, int]]], about) -> bool:
    """Returns true if a pixel of the frame in a box is in a gap of its line."""
    left, right, top, bottom = box
    columns = range(max(left, 0), min(right, about.width - 1) + 1)
    lines = range(max(top, 0), min(bottom, about.height - 1) + 1)
    return bool(columns) and any(first <= columns[-1] + BIAS and last >= columns[0] + BIAS
                                 for y in lines for first, last in gaps[y])


def near_face_trial(arena: Arena, about, these: Faces, title: str = "") -> Trial:
    """The last face that is seen and may be visible."""
    known, row = layout.load(), these.row
    size, slot_size, face_size, corner_size = (
        known.struct(name).size for name in ("mesh_point", "near_slot", "scene_face", "scene_corner"))
    made = mesh.transform(about, these.points, row)
    outsides = [outside(p, about.near_plane) for p in made]
    places = [place_of(p, about, borders) for p, borders in zip(made, outsides)]
    to = arena.add(b"".join(longs((0, 0, 0, *(at or (0, 0)), borders, 5, 0) if is_known else [7] * 8)
                            for at, borders, is_known in zip(places, outsides, these.stamped)), name="points")
    rows = records([[row[9 + k], 1 << 31, *row[3 * k:3 * k + 3]] for k in range(3)], known.struct("near_row"))
    faces = table(arena, "scene_face", [[*(each[0] if each else [0] * 4), 0, len(each[1]) if each else 3]
                                        for each in these.faces])
    corners = table(arena, "scene_corner", [(point, 0, 0, 0) for each in these.faces if each for point in each[1]])
    slots, at = b"", corners
    for k, each in enumerate(these.faces):
        slots += longs((faces + face_size * k if each else 0, k, at, 0))
        at += corner_size * len(each[1]) if each else 0
    slots_at = arena.add(slots, name="slots")
    for k, each in enumerate(these.faces):
        arena.pointers += [slots_at + slot_size * k] * bool(each) + [slots_at + slot_size * k + 8]
    heads = gap_rows(arena, these.gaps)
    plan = arena.struct("near_face", {
        "slot": slots_at + slot_size * len(these.faces), "slots": slots_at, "points": to, "gaps": heads,
        "from": table(arena, "scene_point", these.points)},
        rows=list(rows), shifts=[16 + about.guard, 16 - about.guard], near_plane=about.near_plane,
        middle_x=about.width << 15, middle_y=about.height << 15, eye_x=row[12], eye_y=row[13], eye_z=row[14],
        right=about.width - 1, bottom=about.height - 1, before=0xFFFF - these.off, behind=these.off - 1, stamp=5, above=0, box=[0] * 4)
    result, end, used = known.constants["NEAR_NONE"], len(these.faces), set()
    above = box = None
    for k in reversed(range(len(these.faces))):
        if not these.faces[k] or not mesh.is_seen(these.faces[k][0], [*[0] * 12, *row[12:15]]):
            continue
        end, (plane, numbers) = k, these.faces[k]
        above = signed(signed(sum(n * e for n, e in zip(plane, row[12:15])) >> 30) - plane[3])
        used |= set(numbers)
        borders = [outsides[number] for number in numbers]
        some = int(np.bitwise_or.reduce(borders))
        if np.bitwise_and.reduce(borders):
            continue
        if not some & 1:
            box = box_of([places[number] for number in numbers], these.off, 2 * bool(some))
        if some & 1 or is_in_gap(box, these.gaps, about):
            result = some
            break
    shape = known.struct("near_face").fields
    writes = [Write(plan + shape["slot"]["offset"], longs((slots_at + slot_size * end,)), pointer=True),
              long_write(plan + shape["above"]["offset"], above)] if used else []
    writes += [Write(plan + shape["box"]["offset"], longs(box))] if box else []
    for number in sorted(number for number in used if not these.stamped[number]):
        p = made[number]
        writes += [Write(to + size * number, longs((p.x, p.y, p.w, *(places[number] or ())))),
                   long_write(to + size * number + 20, outsides[number]), long_write(to + size * number + 24, 5)]
    return Trial(Case("mesh_near_face", arena, pointers={"a0": plan}), title, {"d0": result}, writes=writes)


def gap_rows(arena: Arena, gaps: list[list[tuple[int, int]]]) -> int:
    """Appends the gaps of lines, and of each line the address of the first; returns the first of these."""
    heads, size = [], layout.load().struct("gap").size
    end = arena.add(bytes(size), name="gaps_end")
    fill(arena, end, END, END, end)
    for row in gaps:
        at = arena.add(bytes(size * len(row)), name="gaps") if row else end
        heads.append(at)
        for k, (first, last) in enumerate(row):
            fill(arena, at + k * size, first, last, at + (k + 1) * size if k + 1 < len(row) else end)
    rows = arena.add(b"".join(longs((head,)) for head in heads), name="gap_rows")
    arena.pointers += [rows + 4 * k for k in range(len(heads))]
    return rows


#: The middle of the frame is not drawn yet.
OPEN = [[(BIAS, BIAS + ABOUT.width - 1)]] * ABOUT.height


def seen_case():
    """COUNT faces from the back. One from the front cannot be called again: the plan's slot moves behind it."""
    row = view(9 << 16)
    row[12:15] = [3 << 16, 5 << 16, 4 << 16]
    return near_face_trial(Arena(), ABOUT, Faces([([-1 << 29, -1 << 28, -1 << 29, 0], [0, 1, 2])] * COUNT,
                                                 [[0, 0, 0]] * 3, [True] * 3, row, OPEN)).row(COUNT)


#: Names of rows and what makes each: units, case and check.
NEAR_CASES = {"mesh_near": near_case, "mesh_near_seen": seen_case}
