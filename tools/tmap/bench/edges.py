"""Bench rows of the edge steppers: the lines between two edges, with u and v of their starts."""

import numpy as np

from tmap.base.fixed import M32, ONE
from tmap.bench.spans import DU, DV
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result
from tmap.model import model
from tmap.setup.scanline import MASKS, pack, rounded_edge

LINES = 64
SLOPES = (-45875, 85197)  # -0.7 and 1.3 pixels a line, 16.16: left, right


def edge_case(name: str):
    """One section of LINES lines between two edges."""
    form, exact = name.split("_")[1], name.endswith("_exact")
    form = "plain" if form == "swap" else form
    shapes = layout.load()
    bias, shape = shapes.constants["EDGE_BIAS"], shapes.struct("scanline")
    arena = Arena()
    table_at = arena.add(bytes(shape.size * LINES))
    height = LINES << 16  # x is in units of height pixels
    n = range(LINES)
    starts = (100 + bias) * ONE + 12345, (110 + bias) * ONE + 54321
    sides, columns = [], []
    for x, slope in zip(starts, SLOPES):
        edge = rounded_edge(LINES, x, slope)
        if exact:
            first, ratio = x * height >> 16, slope * height // ONE
            edge |= {"x": -(-first // height), "error": ~(-first % height) & M32,
                     "whole": ratio // height, "part": ratio % height, "height": height}
            columns.append([-(-(first + k * ratio) // height) for k in n])
        else:
            columns.append([(x + k * slope + 0xFFFF) >> 16 for k in n])
        sides.append(edge)
    whole = sides[0]["whole"]
    du, dv = -DV + whole * DU, DU + whole * DV  # a line and the whole pixels
    left_at, right_at = (arena.struct("edge", {}, **edge | {
        "u": 100 << 16, "v": 50 << 16, "du": du, "dv": dv}) for edge in sides)
    plan_at = arena.struct("edge_plan", dict(lines=table_at, left=left_at, right=right_at),
                           lefts=1, rights=1, dudx=DU, dvdx=DV)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, shape.dtype, LINES, table_at)
        for k, (left, right) in enumerate(zip(*columns)):
            moved = left - columns[0][0]
            wanted = {"left": left, "last": right - 1} | pack(
                form, (100 << 16) - k * DV + moved * DU, (50 << 16) + k * DU + moved * DV)
            for field, value in wanted.items():
                if (int(found[k][field]) ^ value) & MASKS[form].get(field, M32):
                    return f"line {k}: {field} is {found[k][field]}, expected {value}"
        return None

    return LINES, Case(name, arena, pointers={"a0": plan_at}), check


def ramp_case():
    """LINES lines of 10 pixels and more, sub-texel starts, packed."""
    shapes = layout.load()
    bias, shape = shapes.constants["EDGE_BIAS"], shapes.struct("scanline")
    arena, ramp = Arena(), shapes.struct("ramp")
    steps = {"dx": 0x4321, "du": 0x1234, "dv": -0x2345}
    starts = [dict(zip("xuv", (n << 16 for n in side))) for side in ((100, 20, 30), (110, 200, 90))]
    points = [[tuple(start[k] + n * steps["d" + k] for k in "xuv") for n in range(LINES)]
              for start in starts]
    table = np.zeros(LINES, shape.dtype)
    lines = []
    for entry, left, right in zip(table, *points):
        line = model.Line(model.ceil16(left[0]), model.ceil16(right[0]))
        entry["left"], entry["last"] = line.left + bias, line.right - 1 + bias
        model.scanline_line(line, left, right, truncated=False)
        lines.append(line)
    table_at = arena.add(table.tobytes())
    # A call uses the ramps up and the next one runs on from there: with the same steps
    # on both sides, at the same cost.
    ramps = [arena.add(ramp.pack(lines=LINES, **start, **steps)) for start in starts]
    steps_at = arena.add(bytes(8 * LINES))
    plan_at = arena.struct("ramp_plan", dict(lines=table_at, left=ramps[0], right=ramps[1],
                                             steps=steps_at),
                           count=LINES, truncated=0, packed=1)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, shape.dtype, LINES, table_at)
        made = np.frombuffer(result.memory, ">i4", 2 * LINES, steps_at).reshape(-1, 2)
        for k, line in enumerate(lines):
            for field, value in pack("addx", line.u, line.v).items():
                if (int(found[k][field]) ^ value) & MASKS["addx"][field]:
                    return f"line {k}: {field} is {found[k][field]}, expected {value}"
            if (made[k] != [model.signed(line.dudx), model.signed(line.dvdx)]).any():
                return f"line {k}: steps {made[k]}, expected {line.dudx}, {line.dvdx}"
        return None

    return LINES, Case("edge_ramp", arena, pointers={"a0": plan_at}), check
