"""Bench rows of perspective by logarithms: the lines of tools.bench_perspective."""

import math

import numpy as np

from . import layout
from . import model_logarithm as logarithms
from .bench_mappers import first_difference
from .bench_perspective import NEAR, RATIO
from .kernels import M32, Arena, Case, Result
from .model_reciprocal import swap

NEAREST = 63000 << 16  # q of the nearer end as normalised


def log_table(arena: Arena) -> int:
    """Adds the table of logarithms; where its index 0 is."""
    return arena.add(logarithms.logs().astype(">i2").tobytes()) + logarithms.COUNT


def power_table(arena: Arena, lines) -> int:
    """Adds what lines read of the powers; where the whole table would begin."""
    ends = [each.power[axis] + int(log) for each in lines for axis in (0, 1)
            for log in logarithms.logs()[logarithms.indices(each)[[0, -1]]]]
    low, high = min(ends) - 8, max(ends) + 8  # the last step may be a unit off
    part = logarithms.powers()[max(low, 0):high] & 0xFFFF
    return arena.add(part.astype(">u2").tobytes()) - 2 * max(low, 0)


def line(k: int, length: int, ratio: int, rng) -> logarithms.Logarithmic:
    """Line k of a row."""
    n = length - 1
    q0, q1 = (NEAREST, NEAREST // ratio)[::1 if k % 2 else -1]
    # u = K + C / q, from the first to the last pixel
    c = [max(way * length, 1) / abs(1 / q0 - 1 / q1) for way in (1, 0.7)]
    power = tuple(round(logarithms.OCTAVE * math.log2(256 * d / 65536)) - logarithms.MIDDLE for d in c)
    return logarithms.Logarithmic(
        k % 4, n, swap(q0 - (logarithms.ORIGIN << 16) & M32), swap(((q1 - q0) // max(n, 1)) & M32),
        tuple(int(x) for x in rng.integers(0, 1 << 16, 2)), power, 3 if q0 < q1 else 0)


def entry(each: logarithms.Logarithmic) -> bytes:
    """The line as logarithm_lines leaves it."""
    shapes = layout.load()
    return shapes.struct("logarithm_line").pack(
        left=each.left + shapes.constants["EDGE_BIAS"], n=each.n, q=each.q, dq=each.dq,
        u=each.k[0] & 0xFFFF, v=each.k[1] & 0xFFFF, power_u=2 * each.power[0],
        power_v=2 * each.power[1], way=each.way, spare=0)


def span_case(length: int):
    """A table of lines of one length, by logarithms."""
    rng = np.random.default_rng(length)
    count = min(128, max(16, 2048 // length))
    pitch = length + 4
    bias = layout.load().constants["EDGE_BIAS"]
    arena, far = Arena(), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = far.add(picture.tobytes(), layout.load().constants["ARENA_ALIGN"])
    lines = [line(k, length, RATIO, rng) for k in range(count)]
    expected = np.zeros((count, pitch), np.uint8)
    for k, each in enumerate(lines):
        u, v = logarithms.coordinates(each)
        expected[k, each.left:each.left + length] = picture[v >> 16 & 255, u >> 16 & 255]
    frame_at = far.add(bytes(pitch * count))
    plan_at = arena.struct(
        "logarithm_span",
        dict(lines=arena.add(b"".join(map(entry, lines))), logs=log_table(arena),
             powers=power_table(arena, lines)),
        dict(row=frame_at - bias, map=map_at), count=count, pitch=pitch)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, np.uint8, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return count * length, Case("span_logarithm", arena, pointers={"a0": plan_at}, far=far), check
