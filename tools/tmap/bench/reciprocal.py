"""Bench rows of perspective by a table of reciprocals: the lines of tmap.bench.perspective."""

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.bench.perspective import (LINES, NEAR, RATIO, add_perspective_plan, case_of_lines,
                                    first_wrong_line, polygon_lines)
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result
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
    shapes = layout.load()
    return shapes.struct("reciprocal_line").pack(
        left=each.left + shapes.constants["EDGE_BIAS"], n=each.n, u=each.start[0] & M32,
        v=each.start[1] & M32, q=each.q, dq=each.dq, cu=each.c[0], cv=each.c[1], first=each.first,
        last=each.last, carry=each.carry, scale=0)


def span_case(m: int, length: int):
    """A table of lines of one length, by reciprocals."""
    return case_of_lines(
        f"span_reciprocal_{m}", "reciprocal_span", length, lambda k, rng: line(k, length, m, rng),
        reciprocals.coordinates,
        lambda arena, lines: dict(lines=arena.add(b"".join(map(entry, lines))), table=table(arena)))


def constants_fields(constants) -> dict:
    """What a reciprocal_plan has of its polygon's constants."""
    longs = zip(("cu", "cv", "dcu", "dcv"), constants.c + constants.dc)
    return {name: list((n % (1 << 64)).to_bytes(8, "big")) for name, n in longs} \
        | {"ku": signed(constants.k[0]), "kv": signed(constants.k[1])}


def add_reciprocal_plan(arena: Arena, planes_at: int, constants, table_at: int, to_at: int) -> int:
    """Adds a reciprocal_plan with its constants."""
    return arena.struct("reciprocal_plan", dict(planes=planes_at, table=table_at, to=to_at),
                        **constants_fields(constants), limit=constants.limit, piece=constants.piece)


def lines_left(result: Result) -> str | None:
    """What is wrong where no line is to be left to others."""
    left = result.registers["d0"]
    return f"{left} lines are left to others" if left else None


def lines_case(m: int):
    """LINES lines of a turned triangle, all of which are taken."""
    arena, shape = Arena(), layout.load().struct("reciprocal_line")
    deep, lines = polygon_lines()
    constants = reciprocals.find(deep, m.bit_length() - 1, 200, lines[0][0] - deep.i, 0)
    expected = [reciprocals.line(deep, constants, *each) for each in lines]
    to_at = arena.add(bytes(shape.size * LINES))
    planes_at = add_perspective_plan(arena, deep, lines, to_at)
    plan_at = add_reciprocal_plan(arena, planes_at, constants, table(arena), to_at)

    def check(result: Result) -> str | None:
        return lines_left(result) or first_wrong_line(
            shape, result.memory[to_at:], [entry(each) for each in expected], ("scale",))

    return LINES, Case("reciprocal_lines", arena, pointers={"a0": plan_at}), check
