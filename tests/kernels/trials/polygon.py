"""Trials of src68k/polygon: sides and edges of polygons against exact integers, and against the
model where numbers are rounded."""

from functools import partial

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.math import any_size
from tmap.base.fixed import M32, ONE
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial, Write, anything, fields, values
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.model import model
from tmap.setup import edges as model_edges

FAR = BIAS << 16
WIDTH, HEIGHT = 320, 256


def vertex_block(memory: Memory, vertices) -> int:
    """The vertices, (x, y, s, t) each, as a C array."""
    shape = layout.load().struct("vertex")
    content = b"".join(shape.pack(**dict(zip("xyst", v)), shade=0, w=65536) for v in vertices)
    return memory.add(content, name="vertices", shape=shape)


def box_block(memory: Memory, box: tuple[int, int, int, int]) -> int:
    return memory.struct("rectangle", {}, **dict(zip(("left", "top", "right", "bottom"), box)))


def vertex_at(base: int, index: int) -> int:
    return base + index * layout.load().struct("vertex").size


def described(vertices) -> str:
    return "; ".join(values(**dict(zip("xyst", v))) for v in vertices)


def polygons(rng: np.random.Generator) -> list[list[tuple]]:
    """Convex polygons and others, small and large, some without area."""
    made = [[(0, 0, 0, 0), (ONE, 0, 0, 0), (0, ONE, 0, 0)],
            [(0, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0)],
            [(0, 0, 1, 2), (ONE, ONE, 3, 4), (2 * ONE, 2 * ONE, 5, 6)],
            [(5, 0, 0, 0), (0, 0, 0, 0), (9, 0, 0, 0)],
            [(-FAR, -FAR, -FAR, -FAR), (FAR - 1, -FAR, FAR - 1, 0), (0, FAR - 1, 7, FAR - 1)],
            [(-FAR, -FAR, 0, 0), (FAR - 1, -FAR, 0, 0), (FAR - 1, FAR - 1, 0, 0), (-FAR, FAR - 1, 0, 0)],
            [(0, 0, 0, 0), (4 * ONE, 0, 0, 0), (4 * ONE, 4 * ONE, 0, 0), (0, 4 * ONE, 0, 0)],
            [(0, 0, 0, 0), (0, 1, 0, 0), (1, 1, 0, 0), (1, 0, 0, 0)]]
    for count in (3, 3, 3, 4, 5, 7, 12, 64):
        for _ in range(12):
            size = 1 << int(rng.integers(1, 31))
            angles = np.sort(rng.uniform(0, 2 * np.pi, count))
            centre = rng.integers(-FAR // 2, FAR // 2, 2)
            points = centre[:, None] + min(size, FAR // 2) * np.array([np.cos(angles), np.sin(angles)])
            way = 1 if rng.integers(2) else -1
            made.append([(int(x), int(y), any_size(rng, 30), any_size(rng, 30))
                         for x, y in points.T[::way]])
    for _ in range(60):
        made.append([tuple(any_size(rng, 30) for _ in range(4)) for _ in range(3)])
    for _ in range(40):
        e = [any_size(rng, 20) for _ in range(2)]  # slivers
        a = [any_size(rng, 24) for _ in range(4)]
        made.append([tuple(a), (a[0] + e[0], a[1] + e[1], 5, 7),
                     (a[0] + 3 * e[0] + int(rng.integers(-1, 2)), a[1] + 3 * e[1], 9, 100 * ONE)])
    return made


def wanted_sides(vertices):
    """top, bottom, middle, left direction, area and whether the middle is right; or None."""
    n = len(vertices)
    top = min(range(n), key=lambda k: (vertices[k][1], vertices[k][0]))
    bottom = min(range(n), key=lambda k: (-vertices[k][1], vertices[k][0]))
    (ax, ay, *_), (bx, by, *_) = vertices[top], vertices[bottom]
    turns = [(bx - ax) * (v[1] - ay) - (v[0] - ax) * (by - ay) for v in vertices]
    middle = min(range(n), key=lambda k: (-abs(turns[k]), vertices[k][1], vertices[k][0]))
    if turns[middle] == 0:
        return None
    forward = (middle - top) % n < (bottom - top) % n
    direction = 1 if (turns[middle] > 0) == forward else -1
    return top, bottom, middle, direction, abs(turns[middle]), turns[middle] < 0


def sides_numbers(vertices, wanted) -> dict[str, int]:
    """The fields of struct sides that are numbers."""
    *_, direction, area, right = wanted
    return {"middle_right": 255 * right,
            "left_step": direction * layout.load().struct("vertex").size,
            "x_low": min(v[0] for v in vertices), "x_high": max(v[0] for v in vertices)}


def sides_pointers(at: int, vertices, wanted) -> dict[str, int]:
    """The fields that point to vertices, as offsets."""
    top, bottom, middle, *_ = wanted
    return {name: vertex_at(at, k) for name, k in
            dict(first=0, last=len(vertices) - 1, top=top, bottom=bottom, middle=middle).items()}


def sides_find_trials(rng) -> list[Trial]:
    trials = []
    constants = layout.load().constants
    for vertices in polygons(rng):
        memory = Memory()
        at, out = vertex_block(memory, vertices), memory.room("sides")
        case = Case("sides_find", memory, {"d0": len(vertices)}, {"a0": out, "a1": at})
        wanted = wanted_sides(vertices)
        trial = Trial(case, described(vertices))
        trials.append(trial)
        trial.outputs["d0"] = constants["POLYGON_DRAWN" if wanted else "POLYGON_EMPTY"]
        if not wanted:
            trial.writes.append(anything(out, layout.load().struct("sides").size))
            continue
        trial.writes = fields(out, "sides", sides_numbers(vertices, wanted),
                              sides_pointers(at, vertices, wanted))
        area = out + layout.load().struct("sides").fields["area"]["offset"]
        trial.writes.append(Write(area, wanted[4].to_bytes(8, "big")))
    for field in range(4):  # one coordinate outside the range
        for value in (FAR, -FAR - 1, 0x7FFFFFFF, -0x80000000):
            for index in range(3):
                vertices = [[0, 0, 0, 0], [ONE, 0, 0, 0], [0, ONE, 0, 0]]
                vertices[index][field] = value
                memory = Memory()
                at, out = vertex_block(memory, vertices), memory.room("sides")
                trials.append(Trial(
                    Case("sides_find", memory, {"d0": 3}, {"a0": out, "a1": at}), described(vertices),
                    {"d0": constants["POLYGON_OUTSIDE_RANGE"]},
                    writes=[anything(out, layout.load().struct("sides").size)]))
    return trials


def exact_fields(edge: model.Edge) -> dict[str, int]:
    (x0, y0, *_), (x1, y1, *_) = edge.upper, edge.lower
    width, height = x1 - x0, y1 - y0
    numerator = x0 * height + width * ((edge.top << 16) - y0)  # of x in 16.16
    if edge.upright and width > 0:  # the first pixel behind the edge, not the first on it
        numerator += 1
    pixels = -(-numerator // (height << 16))
    below = (pixels * height << 16) - numerator >> 16
    return {"x": pixels + BIAS, "whole": edge.whole, "error": ~below,
            "part": 0 if edge.is_single else width % height, "height": height}


def rounded_fields(edge: model.Edge) -> dict[str, int]:
    x = edge.at(edge.top) + (BIAS << 16) + 0xFFFF
    return {"x": x >> 16 & 0xFFFF, "whole": edge.slope >> 16, "error": x << 16,
            "part": edge.slope << 16, "height": 0}


def edge_trials(exact: bool, rng) -> list[Trial]:
    """Single edges from a line on, with one line and with more; by vertices and by extents."""
    far = FAR - 1
    ends = [((0, 0), (0, 1), 0), ((-FAR, -FAR), (far, far), 0), ((5, -FAR), (-far, far), 95),
            ((-far, -far), (far, far), 0), ((far, -far), (-far, far), 16383),
            ((-far, -far), (far, far), -16383), ((far, -1), (-far, 0), 0), ((5, -1), (7, 1), 0),
            ((-far, 0), (far, 1), 0), ((1 << 16, 3 << 16), (-1 << 16, 5 << 16), 4),
            ((0x8000, -0x8000), (0x18000, 0x18000), 1), ((7, 0), (7, 9 << 16), 9)]
    for _ in range(300):
        x0, x1, y0 = (any_size(rng, 30) for _ in range(3))
        y1 = y0 + int(rng.integers(1, 1 << int(rng.integers(1, 31))))
        first, last = y0 + 0xFFFF >> 16, y1 >> 16
        if y1 > far or last < first:
            continue
        for line in {first, last, int(rng.integers(first, last + 1))}:
            ends.append(((x0, y0), (x1, y1), line))
    trials = []
    kernel = "edge_exact" if exact else "edge_rounded"
    for k, (upper, lower, line) in enumerate(ends):
        most = max(-(-lower[1] // ONE) - line, 1)
        for lines in {1, most, 1 + k % most}:
            edge = model.Edge(upper, lower, line, line + lines, exact)
            found = (exact_fields if exact else rounded_fields)(edge)
            title = values(x0=upper[0], y0=upper[1], x1=lower[0], y1=lower[1], line=line, lines=lines)
            memory = Memory()
            at = vertex_block(memory, [(*upper, 0, 0), (*lower, 0, 0)])
            out = edge_block(memory, lines)
            trials.append(Trial(
                Case(kernel, memory, {"d1": line}, {"a0": out, "a1": at, "a2": vertex_at(at, 1)}), title,
                writes=fields(out, "edge", found)))
            memory = Memory()
            out = edge_block(memory, lines)
            width, height = edge.extent
            registers = {"d1": (line << 16) - upper[1], "d4": width, "d5": height, "d6": lines,
                         "d7": upper[0]}
            trials.append(Trial(
                Case(f"{kernel}_across", memory, {name: n & M32 for name, n in registers.items()},
                     {"a0": out}), title, writes=fields(out, "edge", found)))
    return trials


def upright_trials(rng) -> list[Trial]:
    """Edges whose lines are columns, many of them through pixels."""
    trials, grid = [], ONE // 4
    for k in range(300):
        step = grid if k % 3 else 1
        x0, x1, y0 = (int(rng.integers(-99 * ONE, 99 * ONE)) // step * step for _ in range(3))
        y1 = y0 + int(rng.integers(1, 60 * ONE // step)) * step
        if k % 5 == 0:
            x0, y0, x1, y1 = (c // ONE * ONE for c in (x0, y0, x1, y1 + ONE))
        first, end = y0 + 0xFFFF >> 16, y1 + 0xFFFF >> 16
        if end <= first:
            continue
        for line in {first, end - 1, int(rng.integers(first, end))}:
            edge = model.Edge((x0, y0), (x1, y1), line, end, True, True)
            memory = Memory()
            at = vertex_block(memory, [(x0, y0, 0, 0), (x1, y1, 0, 0)])
            out = edge_block(memory, end - line)
            trials.append(Trial(
                Case("edge_exact_upright", memory, {"d1": line}, {"a0": out, "a1": at, "a2": vertex_at(at, 1)}),
                values(x0=x0, y0=y0, x1=x1, y1=y1, line=line, lines=end - line),
                writes=fields(out, "edge", exact_fields(edge))))
    return trials


def edge_block(memory: Memory, lines: int) -> int:
    """struct edge before its numbers are found."""
    return memory.struct("edge", {}, **dict.fromkeys(layout.load().struct("edge").fields, 0) | {
        "lines": lines})


def sides_block(memory: Memory, at: int, vertices, wanted) -> int:
    """struct sides as sides_find leaves it."""
    numbers, pointers = sides_numbers(vertices, wanted), sides_pointers(at, vertices, wanted)
    return memory.struct("sides", pointers, **numbers, spare=[0] * 3,
                         area=list(wanted[4].to_bytes(8, "big")))


def edges_make_trial(vertices, exact: bool, upright: bool = False) -> Trial | None:
    """Both sides of a polygon; None where it covers no line of the frame. ``upright``: lines are columns."""
    wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
    if sides is None:
        return None
    memory = Memory()
    at = vertex_block(memory, vertices)
    sides_at = sides_block(memory, at, vertices, wanted)
    box = box_block(memory, sides.box)
    room = {side: memory.room("edge", len(vertices), f"{side} edges") for side in ("left", "right")}
    plan = memory.struct("edge_plan", room, lines=0, lefts=0, rights=0, dudx=0, dvdx=0)
    writes = []
    for side, way in (("left", 1), ("right", -1)):
        edges = model_edges.side(vertices, wanted[0], way * sides.direction, sides.box[1],
                                 sides.box[3], exact, upright)
        writes += fields(plan, "edge_plan", {f"{side}s": len(edges)})
        for k, edge in enumerate(edges):
            numbers = (exact_fields if exact else rounded_fields)(edge)
            numbers |= {"lines": edge.end - edge.top, "top": edge.top}
            pointers = {"upper": vertex_at(at, vertices.index(edge.upper)),
                        "lower": vertex_at(at, vertices.index(edge.lower))}
            place = room[side] + k * layout.load().struct("edge").size
            writes += fields(place, "edge", numbers, pointers)
    return Trial(Case("edges_make_upright" if upright else "edges_make", memory,
                      {} if upright else {"d1": int(exact)}, {"a0": plan, "a1": sides_at, "d0": box}),
                 f"box {sides.box}, exact {exact}: {described(vertices)}", writes=writes)


def seen_polygons(rng) -> list[list[tuple]]:
    """Convex polygons of different vertices, most of them in the frame or around it."""
    made = []
    for count in (3, 3, 3, 4, 5, 9, 30):
        for size in (1, 20, 200, 5000):
            for _ in range(5):
                angles = np.sort(rng.uniform(0, 2 * np.pi, count))
                centre = rng.uniform(0, 256 * ONE, 2)
                points = centre[:, None] + size * ONE * np.array([np.cos(angles), np.sin(angles)])
                way = 1 if rng.integers(2) else -1
                made.append([(int(x), int(y), any_size(rng, 28), any_size(rng, 28))
                             for x, y in points.T[::way]])
    whole = [(0, 0), (0, 100), (50, 100), (50, 0)]
    made += [[(x * ONE, y * ONE, 0, y) for x, y in corners] for corners in (whole, whole[::-1])]
    return [p for p in made if len(set(p)) == len(p)]


def edges_make_trials(rng) -> list[Trial]:
    trials = [edges_make_trial(p, exact, upright) for p in seen_polygons(rng)
              for exact, upright in ((False, False), (True, False), (True, True))]
    return [trial for trial in trials if trial]


def trials() -> list[Trial]:
    makers = (sides_find_trials, partial(edge_trials, True), partial(edge_trials, False),
              edges_make_trials, upright_trials)
    return [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng([4, seed]))]
