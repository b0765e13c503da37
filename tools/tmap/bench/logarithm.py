"""Calls of perspective by logarithms; rows have the lines of tmap.bench.perspective."""

import numpy as np

from tmap.base.elementary import log2
from tmap.base.fixed import M32, ONE, swap
from tmap.bench.perspective import (LINES, RATIO, add_perspective_plan, polygon_lines, record_table,
                                    records_trial, row_of_records)
from tmap.bench.reciprocal import constants_fields, constants_of, made_trial
from tmap.bench.spans import BIAS, Ground
from tmap.bench.trial import Trial
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import logarithm as logarithms

NEAREST = 63000 << 16  # q of the nearer end as normalised


def log_table(arena: Arena) -> int:
    """Adds the table of logarithms; where its index 0 is."""
    return arena.add(logarithms.logs().astype(">i2").tobytes()) \
        + 2 * (logarithms.ORIGIN - logarithms.LOWEST)


def power_table(arena: Arena, lines) -> int:
    """Adds what lines read of the powers; where the whole table would begin."""
    ends = [each.power[axis] + int(log) for each in lines for axis in (0, 1)
            for log in logarithms.logs()[logarithms.indices(each)[[0, -1]]]]
    low, high = min(ends) - 8, max(ends) + 8  # the last step may be a unit off
    part = logarithms.powers()[max(low, 0):high] & 0xFFFF
    return arena.add(part.astype(">u2").tobytes()) - 2 * max(low, 0)


def line(k: int, length: int, rng) -> logarithms.Logarithmic:
    """Line k of a row."""
    n = length - 1
    q0, q1 = (NEAREST, NEAREST // RATIO)[::1 if k % 2 else -1]
    # u = K + C / q, from the first to the last pixel
    c = [max(way * length, 1) / abs(1 / q0 - 1 / q1) for way in (1, 0.7)]
    logs = np.rint(logarithms.OCTAVE * log2(256 * np.array(c) / ONE)).astype(int).tolist()
    power = tuple(log - logarithms.MIDDLE for log in logs)
    return logarithms.Logarithmic(
        k % 4, n, swap(q0 - (logarithms.ORIGIN << 16) & M32), swap(((q1 - q0) // max(n, 1)) & M32),
        tuple(int(x) for x in rng.integers(0, 1 << 16, 2)), power, 3 if q0 < q1 else 0)


def entry(each: logarithms.Logarithmic) -> bytes:
    """The line as logarithm_lines leaves it."""
    return layout.load().struct("logarithm_line").pack(
        left=each.left + BIAS, n=each.n, q=each.q, dq=each.dq,
        u=each.k[0] & 0xFFFF, v=each.k[1] & 0xFFFF, power_u=2 * each.power[0],
        power_v=2 * each.power[1], way=each.way, spare=0)


def span_trial(arena: Arena, ground: Ground, lines: list, pitch: int, title: str = "") -> Trial:
    """One table of lines, an empty one as its n alone."""
    near = dict(lines=record_table(arena, "logarithm_line", lines, entry), logs=log_table(arena),
                powers=power_table(arena, [each for each in lines if not isinstance(each, int)]))
    return records_trial("span_logarithm", "logarithm_span", arena, ground, lines, pitch,
                         logarithms.coordinates, near, title)


def span_case(length: int):
    """A table of lines of one length, by logarithms."""
    return row_of_records(length, lambda k, rng: line(k, length, rng), span_trial)


def lines_trial(arena: Arena, deep, constants, lines, made: list, title: str = "") -> Trial:
    """logarithm_lines on lines (left, right, y), of which those are ``made``."""
    shape, out = layout.load().struct("logarithm_line"), arena.room("logarithm_line", len(lines))
    planes_at = add_perspective_plan(arena, deep, lines, out)
    plan = arena.struct("reciprocal_plan", dict(planes=planes_at), **constants_fields(constants))
    tables = arena.struct("logarithm_tables", dict(logs=log_table(arena)), powers=0,
                          parts=logarithms.parts())

    def fields_of(line: logarithms.Logarithmic) -> dict[str, int]:
        return {name: value for name, value in shape.unpack(entry(line)).items() if name != "spare"}

    return made_trial(Case("logarithm_lines", arena, pointers={"a0": plan, "a1": tables, "d0": out}),
                      "logarithm_line", out, planes_at, lines, made, fields_of, title)


def lines_case():
    """LINES lines of a turned triangle, all of which are taken."""
    deep, lines = polygon_lines()
    constants, *_ = constants_of(deep, lines)
    made = [logarithms.line(deep, constants, *each) for each in lines]
    return lines_trial(Arena(), deep, constants, lines, made).row(LINES)
