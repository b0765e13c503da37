"""Calls of edge_opaque, which leaves transparent ends of a map's rows out of lines."""

import numpy as np

from tmap.base.fixed import ONE, signed
from tmap.bench.edges import LINES, table_writes
from tmap.bench.spans import BIAS, Line, table_of
from tmap.bench.trial import Trial
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup.scanline import pack

PAGE = 256 << 16  # u is modulo this


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
