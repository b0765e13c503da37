"""Calls of what finds visible pixels: depth_fill and depth_copy, z of lines and pixels by it; coverage_scan, which
finds the visible parts of a polygon's lines and covers them."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.bench import edges
from tmap.bench.spans import BIAS, table_of
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result

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
