"""Calls of the edge steppers, which make the lines between two edges with u and v of their starts, of edge_opaque,
which leaves transparent ends of a map's rows out of them, and of coverage_cut, which cuts them to visible parts."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from tmap.base.fixed import M32, ONE, signed
from tmap.bench.spans import BIAS, DU, DV, Line, table_of
from tmap.bench.trial import Trial, Write, anything, fields, long_write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.model import model
from tmap.setup.scanline import MASKS, pack, rounded_edge

LINES = 64
PAGE = 256 << 16  # u is modulo this
SLOPES = (-45875, 85197)  # -0.7 and 1.3 pixels a line, 16.16: left, right
#: How each stepper packs u and v.
FORMS = {"addx": "addx", "plain": "plain", "swap": "plain", "flat": "flat", "right": "flat"}

Fields = dict[str, int]  # of a struct


def table_writes(at: int, lines: list[Fields], form: str = "flat") -> list[Write]:
    """The fields that lines of a table at ``at`` get."""
    shape, writes = layout.load().struct("scanline"), []
    for index, line in enumerate(lines):
        for name, value in line.items():
            size, offset = (shape.fields[name][key] for key in ("size", "offset"))
            bits = (1 << 8 * size) - 1
            writes.append(Write(at + index * shape.size + offset, (value & bits).to_bytes(size, "big"),
                                (MASKS[form].get(name, M32) & bits).to_bytes(size, "big")))
    return writes


def edge_columns(edge: Fields) -> list[int]:
    """The first pixel right of an edge on each line, biased."""
    if edge["height"]:  # how far x lies below its ceil, in 1/height
        below = (1 << 32) - 1 - edge["error"]
        moved = [-((below - n * edge["part"]) // edge["height"]) for n in range(edge["lines"])]
    else:
        moved = [edge["error"] + n * edge["part"] >> 32 for n in range(edge["lines"])]
    return [edge["x"] + n * edge["whole"] + more for n, more in enumerate(moved)]


def starts(edges: list[Fields], form: str, dudx: int, dvdx: int) -> list[Fields]:
    """The packed u and v of each line."""
    found = []
    for e in edges:
        for n, x in enumerate(edge_columns(e)):
            more = x - e["x"] - n * e["whole"]
            found.append(pack(form, e["u"] + n * e["du"] + more * dudx,
                              e["v"] + n * e["dv"] + more * dvdx))
    return found


def edge_trial(kernel: str, arena: Arena, lefts: list[Fields], rights: list[Fields], steps: Fields,
               title: str = "", spare: int = 0) -> Trial:
    """One call with the edges of both sides, struct edge each. ``steps``: dudx and dvdx; ``spare``:
    lines of the table behind those in use."""
    shape, form = layout.load().struct("edge"), FORMS[kernel.split("_")[1]]
    left, right = ([x for edge in edges for x in edge_columns(edge)] for edges in (lefts, rights))
    table = arena.room("scanline", len(left) + spare, "lines")
    sides = {name: arena.add(b"".join(shape.pack(**e) for e in edges), name=name, shape=shape)
             for name, edges in (("left", lefts), ("right", rights))}
    plan = arena.struct("edge_plan", dict(lines=table, **sides), lefts=len(lefts), rights=len(rights),
                        **steps)
    lines = [{"left": a, "last": b - 1} | start
             for a, b, start in zip(left, right, starts(lefts, form, **steps))]
    register = "a0"
    if kernel.startswith("edge_right"):
        lines, register = [{"last": line["last"]} for line in lines], "a6"
    return Trial(Case(kernel, arena, pointers={register: plan}), title,
                 writes=table_writes(table, lines, form))


def edge_sides(name: str) -> list[list[Fields]]:
    """The edges of both sides of a section of LINES lines."""
    height, sides = LINES << 16, []  # x is in units of height pixels
    for x, slope in zip(((100 + BIAS) * ONE + 12345, (110 + BIAS) * ONE + 54321), SLOPES):
        edge = rounded_edge(LINES, x, slope)
        if name.endswith("_exact"):
            first, ratio = x * height >> 16, slope * height // ONE
            edge |= {"x": -(-first // height), "error": ~(-first % height) & M32,
                     "whole": ratio // height, "part": ratio % height, "height": height}
        whole = (sides or [edge])[0]["whole"]
        sides.append(edge | {"u": 100 << 16, "v": 50 << 16,  # a line and the whole pixels:
                             "du": -DV + whole * DU, "dv": DU + whole * DV})
    return [[side] for side in sides]


def edge_case(name: str):
    """One section of LINES lines between two edges."""
    return edge_trial(name, Arena(), *edge_sides(name), dict(dudx=DU, dvdx=DV)).row(LINES)


def ramp_points(side: list[Fields]) -> Iterator[tuple[int, int, int]]:
    """x, u and v of each line of a side's ramps."""
    return (tuple(r[k] + n * r["d" + k] for k in "xuv") for r in side for n in range(r["lines"]))


def ramp_trial(arena: Arena, left: list[Fields], right: list[Fields], truncated: bool, packed: bool,
               title: str = "", count: int | None = None) -> Trial:
    """One call with the ramps of both sides, struct ramp each, in a frame of 320 columns. ``count``: of lines, if
    the ramps have more."""
    form, before, after, steps = "addx" if packed else "plain", [], [], []
    for a, b in islice(zip(ramp_points(left), ramp_points(right)), count):
        line = model.Line(max(model.ceil16(a[0]), 0), min(model.ceil16(b[0]), 320))
        before.append({"left": line.left + BIAS, "last": max(line.right, line.left - 5) + BIAS - 1})
        if line.right > line.left:
            model.scanline_line(line, a, b, truncated)
        is_drawn = line.right > line.left
        after.append(pack(form, line.u, line.v) if is_drawn else {})
        steps.append((line.dudx, line.dvdx) if is_drawn else ())
    ramp, scanline = (layout.load().struct(name) for name in ("ramp", "scanline"))
    lines_at = arena.add(table_of(before), name="lines", shape=scanline)
    sides = {name: arena.add(b"".join(ramp.pack(**r | {k: r[k] & M32 for k in "uv"}) for r in side),
                             name=name, shape=ramp)
             for name, side in (("left", left), ("right", right))}
    steps_at = arena.room("scanline_step", len(before), "steps")
    plan = arena.struct("ramp_plan", dict(lines=lines_at, **sides, steps=steps_at),
                        count=len(before), truncated=int(truncated), packed=int(packed))
    writes = table_writes(lines_at, after, form)
    writes += [long_write(steps_at + 8 * k + 4 * n, step)
               for k, pair in enumerate(steps) for n, step in enumerate(pair)]
    # The ramps are used up: what is left there does not count.
    writes += [anything(sides["left"], len(left) * ramp.size),
               anything(sides["right"], len(right) * ramp.size)]
    return Trial(Case("edge_ramp", arena, pointers={"a0": plan}), title, writes=writes)


def ramp_case():
    """LINES lines of 10 pixels and more, sub-texel starts, packed. The next call runs on from where one
    ends: with the same steps on both sides, at the same cost."""
    steps = {"dx": 0x4321, "du": 0x1234, "dv": -0x2345, "lines": 1 << 20}
    left, right = ([dict(zip("xuv", (n << 16 for n in side))) | steps]
                   for side in ((100, 20, 30), (110, 200, 90)))
    return ramp_trial(Arena(), left, right, False, True, count=LINES).row(LINES)


def row_of(texels: np.ndarray) -> dict[str, int]:
    """Returns the struct map_row of a row of texels."""
    opaque = np.flatnonzero(texels)
    if not len(opaque):
        return {"first": 1, "last": 0, "holes": 0, "unused": 0}
    first, last = int(opaque[0]), int(opaque[-1])
    return {"first": first, "last": last, "holes": int(len(opaque) <= last - first), "unused": 0}


def kept(u: int, dudx: int, count: int, row: dict[str, int], width: int) -> tuple[int, int, int]:
    """Returns the first pixel that a line keeps, how many it keeps, and its holes; u: 8.16."""
    x = u % (width << 16) + np.arange(count, dtype=np.int64) * dudx
    if not 0 <= x[-1] < width << 16:
        return 0, count, 1
    inside = (x >> 16 >= row["first"]) & (x >> 16 <= row["last"])
    if inside.any():
        return int(inside.argmax()), int(inside.sum()), row["holes"]
    before = (x >> 16 < row["first"]) if dudx > 0 else (x >> 16 > row["last"])
    passed = row["first"] <= row["last"] and 0 < before.sum() < count  # a step from one side to the other
    return (int(before.sum()) if passed else 0), 0, row["holes"] if passed else -1


def opaque_trial(lines: list[Line], dudx: int, picture: np.ndarray, arena: Arena, used: list[int],
                 title: str = "") -> Trial:
    """One table. ``picture``: the map, 0 is transparent; ``used``: as tmap.bench.spans.table_trial's."""
    shapes, (height, width) = layout.load(), picture.shape
    rows = [row_of(texels) for texels in picture]
    entries, after, step = [], [], signed(dudx << 8) >> 8
    for (column, count, u, v), spare in zip(lines, used):
        start = pack("addx", u, v)
        start["start2"] |= spare << 8
        entries.append(start | {"left": BIAS + column, "last": BIAS + column + count - 1})
        if count <= 0:
            after.append({})
            continue
        first, count, holes = kept(u % PAGE, step, count, rows[(v >> 16) % height], width)
        moved = pack("addx", u % PAGE + first * step, v)
        line = {"left": BIAS + column + first, "last": BIAS + column + first + count - 1,
                "start0": moved["start0"], "start2": start["start2"] & ~0xFF | moved["start2"] & 0xFF}
        if holes >= 0:
            line["start2"] = line["start2"] & ~0xFF00 | holes << 8
        after.append(line)
    table = arena.add(table_of(entries), name="lines", shape=shapes.struct("scanline"))
    shape = shapes.struct("map_row")
    at = arena.add(b"".join(shape.pack(**row) for row in rows), name="rows", shape=shape)
    plan = arena.struct("opaque_plan", {"lines": table, "rows": at}, count=len(lines), dudx=dudx, width=width,
                        height=height)
    return Trial(Case("edge_opaque", arena, pointers={"a0": plan}), title,
                 writes=table_writes(table, after, "plain"))


def opaque_case():
    """LINES lines of 56 pixels over a map of 64, the twelve texels at both ends of whose rows are transparent."""
    picture = np.full((64, 64), 7, np.uint8)
    picture[:, :12] = picture[:, 52:] = 0
    lines = [(k % 4, 56, 3 * ONE + 1000 * k, k << 16) for k in range(LINES)]
    return opaque_trial(lines, 0x10800, picture, Arena(), [0] * LINES).row(LINES)


Part = tuple[int, int]  # first pixel and last, biased


@dataclass
class Cut:
    """A line of the table: first pixel, last pixel, start0, start1 and start2, its steps, and its parts, of which the
    first is on the left; none: it is visible whole."""

    line: tuple[int, int, int, int, int]
    steps: tuple[int, int]
    parts: list[Part]


def moved(row: Cut, part: Part, form: str, steps: tuple[int, int], chained: bool) -> dict[str, int]:
    """A line that is cut to a part. u and v are whole numbers of 1/65536 texel, not modulo 256."""
    left, _, start0, start1, start2 = row.line
    made, pixels = {"left": part[0], "last": part[1]}, part[0] - left
    if pixels > 0 and part[1] >= part[0] and form == "addx":
        u, v = (start2 & 255) << 16 | start0, start1 << 8 | start2 >> 24
        step = (steps[1] + (1 << 23) & 0xffffff) - (1 << 23)
        after = v + pixels * step
        u += pixels * steps[0] + (after >> 24) * chained
        return made | {"start0": u & 0xffff, "start1": after >> 8 & 0xffff, "start2": (after & 255) << 24 | u >> 16 & 255}
    if pixels > 0 and part[1] >= part[0] and form == "plain":
        u = (start1 << 16 | start0) + pixels * steps[0] & M32
        start0, start1, start2 = u & 0xffff, u >> 16, start2 + pixels * steps[1] & M32
    return made | {"start0": start0, "start1": start1, "start2": start2}


def cut_trial(rows: list[Cut], form: str, chained: bool, own_steps: bool, arena: Arena, title: str = "",
              calls: int = 1) -> Trial:
    """One table. ``own_steps``: each line has its own; else all have those of the first. ``calls``: for which the lists
    have room."""
    known = layout.load()
    shapes = {name: known.struct(name) for name in ("scanline", "scanline_step", "visible_part", "cut_lines", "parts_plan")}
    names = ("left", "last", "start0", "start1", "start2")
    lines = arena.add(table_of([dict(zip(names, row.line)) for row in rows]), name="lines", shape=shapes["scanline"])
    steps = arena.add(b"".join((n & M32).to_bytes(4, "big") for row in rows for n in row.steps), name="steps")
    parts = [(number, *part) for number, row in enumerate(rows) for part in row.parts]
    at = arena.add(b"".join(n.to_bytes(2, "big") for part in parts for n in part) or bytes(2), name="parts")
    moves = {False: [], True: []}  # lines of the second list, and of the further one
    writes = []
    for number, row in enumerate(rows):
        pair = row.steps if own_steps else rows[0].steps
        for k, part in enumerate(row.parts):
            made = table_of([moved(row, part, form, pair, chained)])
            if k:
                moves[k > 1].append((number, made, pair))
            else:
                writes.append(Write(lines + shapes["scanline"].size * number, made))
    lists = {}
    for is_further, some in moves.items():
        before, size = int(is_further), {name: shapes[name].size for name in ("scanline", "scanline_step")}
        count = before + len(some)
        room = before + calls * len(some) + 1
        to = {name: arena.add(bytes(each * room), name=name) for name, each in
              (("lines", size["scanline"]), ("steps", size["scanline_step"]), ("rows", 2))}
        lists[is_further] = arena.struct("cut_lines", to, count=before)
        for k, (number, made, pair) in enumerate(some, before):
            writes += [Write(to["lines"] + k * size["scanline"], made), Write(to["rows"] + 2 * k, number.to_bytes(2, "big"))]
            if own_steps:
                writes.append(Write(to["steps"] + 8 * k, b"".join((n & M32).to_bytes(4, "big") for n in pair)))
        writes += fields(lists[is_further], "cut_lines", {"count": count}) if some else []
    first = rows[0].steps
    numbers = {"du": signed(first[0]), "dv": signed(first[1]), "chained": int(chained),
               "form": known.constants[f"LINES_{form.upper()}"]}
    pointers = {"parts": at, "end": at + shapes["visible_part"].size * len(parts), "lines": lines,
                "second": lists[False], "further": lists[True]}
    plan = arena.struct("parts_plan", pointers | ({"steps": steps} if own_steps else {}),
                        **numbers, **({} if own_steps else {"steps": 0}))
    if own_steps and parts:
        last = rows[parts[-1][0]].steps
        writes += fields(plan, "parts_plan", {"du": last[0], "dv": last[1]})
    return Trial(Case("coverage_cut", arena, pointers={"a0": plan}), title, writes=writes)


def random_cuts(rng, count: int) -> list[Cut]:
    """Lines of any starts and steps, with up to four parts; some are hidden whole."""
    rows = []
    for _ in range(count):
        ends = np.sort(rng.choice(1000, 2 * int(rng.integers(0, 5)), replace=False)) + BIAS
        parts = [(int(a), int(b)) for a, b in zip(ends[::2], ends[1::2])]
        left = int(parts[0][0] - rng.choice((0, 0, rng.integers(0, 500)))) if parts else BIAS
        last = max([left + int(rng.integers(0, 500))] + [b for _, b in parts])
        if rng.integers(5) == 0:
            parts = [(1, 0)]
        start = (int(rng.integers(1 << 16)), int(rng.integers(1 << 16)), int(rng.integers(1 << 32)) & 0xff0000ff)
        steps = tuple(int(n) for n in rng.integers(-1 << 24, 1 << 24, 2) >> int(rng.choice((0, 8, 16))))
        rows.append(Cut((left, last, *start), steps, parts))
    return rows


def cut_case():
    """LINES lines of two parts, of which the second begins 40 pixels after the line. Each call adds to the lists: rows
    of so many cycles a line are called four times to be timed."""
    rows = [Cut((BIAS, BIAS + 99, 5, 7, 9), (70000, 3000), [(BIAS, BIAS + 20), (BIAS + 40, BIAS + 99)])] * LINES
    return *cut_trial(rows, "addx", True, True, Arena(), calls=8).row(LINES), 700
