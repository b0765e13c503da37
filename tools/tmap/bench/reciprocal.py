"""Calls of perspective by a table of reciprocals; rows have the lines of tmap.bench.perspective."""

from functools import partial

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.bench.perspective import (LINES, NEAR, RATIO, add_perspective_plan, polygon_lines,
                                    record_table, records_trial, row_of_records)
from tmap.bench.spans import BIAS, Ground
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import reciprocal as reciprocals

#: Row: pixels of a piece.
SPANS = {"persp_every16": 16, "persp_every8": 8}


def table(arena: Arena) -> int:
    """Adds the table of reciprocals; where its index 0 is."""
    return arena.add(np.array(reciprocals.TABLE, ">u2").tobytes()) + reciprocals.COUNT // 2 * 2


def line(k: int, length: int, m: int, rng) -> reciprocals.Reciprocal:
    """Line k of a row, as far as the table and C's 16 bits go."""
    piece, n = m.bit_length() - 1, length - 1
    q0, q1 = (NEAR, NEAR // RATIO)[::1 if k % 2 else -1]
    q0, q1 = 3 * q0, 3 * q1  # as normalised: 2^31 times 3/2
    r0, r1 = (reciprocals.TABLE[(q >> 16) - reciprocals.LOWEST] for q in (q0, q1))
    c = [int(d * length * (1 << 24 - piece) / (r1 - r0)) for d in (1, 0.7)]
    start = tuple(int(x) for x in rng.integers(0, 1 << 32, 2))
    dq = (q1 - q0 << piece) // max(n, 1)
    return reciprocals.Reciprocal(
        k % 4, n, start, reciprocals.swap(q0 - (reciprocals.ORIGIN << 16) & M32),
        reciprocals.swap(dq & M32), tuple(c), r0, r1, 128, piece)


def entry(each: reciprocals.Reciprocal) -> bytes:
    """The line as reciprocal_lines leaves it."""
    return layout.load().struct("reciprocal_line").pack(
        left=each.left + BIAS, n=each.n, u=each.start[0] & M32,
        v=each.start[1] & M32, q=each.q, dq=each.dq, cu=each.c[0], cv=each.c[1], first=each.first,
        last=each.last, carry=each.carry, scale=0)


def span_trial(piece: int, arena: Arena, ground: Ground, lines: list, pitch: int,
               title: str = "") -> Trial:
    """One table of lines in pieces of 2^``piece`` pixels."""
    near = dict(lines=record_table(arena, "reciprocal_line", lines, entry), table=table(arena))
    return records_trial(f"span_reciprocal_{1 << piece}", "reciprocal_span", arena, ground, lines,
                         pitch, reciprocals.coordinates, near, title)


def span_case(m: int, length: int):
    """A table of lines of one length, by reciprocals."""
    return row_of_records(length, lambda k, rng: line(k, length, m, rng),
                          partial(span_trial, m.bit_length() - 1))


def constants_fields(constants) -> dict:
    """What a reciprocal_plan has of its polygon's constants."""
    longs = zip(("cu", "cv", "dcu", "dcv"), constants.c + constants.dc)
    return {name: list((n % (1 << 64)).to_bytes(8, "big")) for name, n in longs} \
        | {"ku": signed(constants.k[0]), "kv": signed(constants.k[1]), "bits": reciprocals.BITS}


def constants_of(deep, piece: int | None, width: int, lines):
    """The constants of a polygon with lines (left, right, y), and the pixel they are found at."""
    x, y = next((left - deep.i, k) for k, (left, right, _) in enumerate(lines) if right > left)
    return reciprocals.find(deep, piece, width, x, y), x, y


def emptied_lines(arena: Arena, planes_at: int, lines, made: list) -> list[Write]:
    """What a plan's lines are to others: empty those that were ``made``, if others were not."""
    entry = layout.load().struct("scanline")
    table = int.from_bytes(arena.data[planes_at:planes_at + 4], "big")
    some_left = any(right > left and not line for (left, right, _), line in zip(lines, made))
    return [Write(table + k * entry.size + entry.fields["last"]["offset"],
                  ((left if line and some_left else right) - 1 + BIAS).to_bytes(2, "big"))
            for k, ((left, right, _), line) in enumerate(zip(lines, made))]


def made_trial(case: Case, struct: str, out: int, planes_at: int, lines, made: list, fields_of,
               title: str) -> Trial:
    """A call that makes a table of records at ``out``. ``made``: of each line, None where it is left to
    others or empty; ``fields_of``: the fields of a record that are written."""
    size = layout.load().struct(struct).size
    writes = [anything(out, size * len(lines)), *emptied_lines(case.arena, planes_at, lines, made)]
    for k, ((left, right, _), line) in enumerate(zip(lines, made)):
        wanted = fields_of(line) if line else {"n": -1 if right > left else right - left - 1}
        writes += fields(out + k * size, struct, wanted)
    others = sum(right > left and not line for (left, right, _), line in zip(lines, made))
    return Trial(case, f"{title}, {len(lines)} lines, {others} left", {"d0": others}, writes=writes)


def lines_trial(arena: Arena, deep, constants, lines, made: list, title: str = "") -> Trial:
    """reciprocal_lines on lines (left, right, y), of which those are ``made``."""
    shape, out = layout.load().struct("reciprocal_line"), arena.room("reciprocal_line", len(lines))
    planes_at = add_perspective_plan(arena, deep, lines, out)
    plan_at = arena.struct("reciprocal_plan", dict(planes=planes_at, table=table(arena), to=out),
                           **constants_fields(constants), limit=constants.limit,
                           piece=constants.piece)

    def fields_of(line: reciprocals.Reciprocal) -> dict[str, int]:
        unread = {"scale"} if line.n >> line.piece else {"scale", "dq"}  # it takes no step
        return {name: value for name, value in shape.unpack(entry(line)).items() if name not in unread}

    return made_trial(Case("reciprocal_lines", arena, pointers={"a0": plan_at}), "reciprocal_line", out,
                      planes_at, lines, made, fields_of, title)


def lines_case(m: int):
    """LINES lines of a turned triangle, all of which are taken."""
    deep, lines = polygon_lines()
    constants, *_ = constants_of(deep, m.bit_length() - 1, 200, lines)
    made = [reciprocals.line(deep, constants, *each) for each in lines]
    return lines_trial(Arena(), deep, constants, lines, made).row(LINES)
