"""Calls of edge_opaque, which leaves transparent ends of a map's rows out of lines, and of coverage_scan, which finds
the visible parts of a polygon's lines and covers them."""

import numpy as np

from tmap.base.fixed import ONE, signed
from tmap.bench.edges import LINES, table_writes
from tmap.bench.spans import BIAS, Line, table_of
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result
from tmap.setup.scanline import pack

PAGE = 256 << 16  # u is modulo this
END = 32767  # x of the gap behind all others
Gaps = list[tuple[int, int]]  # first and last x of each, from the left


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
    """LINES lines that are hidden between two gaps: calls that cover pixels would find them covered the next time."""
    gaps = [[(BIAS, BIAS + 9), (BIAS + 300, BIAS + 319)]] * LINES
    return scan_trial([(BIAS + 160, BIAS + 239)] * LINES, gaps, Arena()).row(LINES)
