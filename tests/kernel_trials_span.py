"""Trials of the span routines: every pixel against the texel of its own u and v."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np

from kernel_checker import Memory, Trial, Write, values
from kernel_trials_edge import BIAS, ONE
from tools import layout
from tools.kernels import Case
from tools.scanline import add_span_plan, pack

MAP_ALIGN = 65536
FRAME = 65024
#: Pixels of the lines and bytes from line to line: room for a guard between lines.
SHORT = (0, -1, -2, -16, -BIAS, -2 * BIAS + 1, *range(1, 41)), 128
LONG = (0, 48, 49, 63, 64, 65, 80, 127, 128, 255, 256, 257, 320, 1024), 1152
STEPS = (0, 1, -1, ONE, -ONE, 0x18000, -0x18000, 128 * ONE - 1, -128 * ONE + 1)
#: Pairs (dudx, dvdx) that the grid of STEPS leaves out: negative dvdx with an integer
#: dudx and a low byte, or none; slopes that a byte can just hold, or not.
PAIRS = ((0, -0x80), (0, -0x100), (0, -0x180), (3 * ONE, -0x12345), (-2 * ONE, -0x100),
         (-ONE, -0x30000), (5 * ONE, -0x8001), (0x100, -0x100), (0xFFFF, -0xFFFF), (0x8000, -7 * ONE),
         (0xFF, 0xFF), (-0xFF, 0x1FF), (2, 0x40), (2, -0x40), (0, -128 * ONE), (-128 * ONE, ONE))
COLOURS = (0, 0xFF, 0x5C, 0x12345601, 0xFFFFFF00)
TURN = 1 << 24  # u and v repeat after 256 texels


@cache
def texture() -> np.ndarray:
    """A 256x256 map without equal neighbours in a row: a texel beside is another."""
    rows = np.tile(np.arange(256, dtype=np.uint8), (256, 1))
    return np.random.default_rng(256).permuted(rows, axis=1)


@cache
def picture_memory() -> tuple[Memory, int, int]:
    """The far arena of all spans and where its frame and its map begin."""
    memory = Memory(3)
    frame = memory.add(memory.noise.bytes(FRAME), name="frame")
    return memory, frame, memory.add(texture().tobytes(), MAP_ALIGN, "map")


@dataclass(frozen=True)
class Ground:
    """What spans are drawn on and from: a far arena, where its frame and map begin, bytes
    of a pixel; ``texels(u, v, dudx, dvdx, count)`` gives a span's pixels."""

    memory: Memory
    frame_at: int
    map_at: int
    texels: Callable[[int, int, int, int, int], np.ndarray]
    pixel_bytes: int = 1
    columns: dict[str, int] | None = None  # struct column_layout
    name: str = ""


def texels(u: int, v: int, dudx: int, dvdx: int, count: int) -> np.ndarray:
    """The pixels of a span."""
    n = np.arange(count, dtype=np.int64)
    return texture()[(v + n * dvdx) >> 16 & 255, (u + n * dudx) >> 16 & 255]


def once_wrapping(u: int, v: int, count: int, dudx: int, dvdx: int, rng) -> tuple[int, int, int]:
    """u, v and count changed to what span_affine_addx can draw: v wraps at most once in
    the line, and where it does, the lowest bit of u is free for it."""
    speed = (dvdx + TURN // 2) % TURN - TURN // 2
    if speed:
        count = min(count, (TURN - 1) // abs(speed) + 1)
    travel = abs(speed) * max(count - 1, 0)
    wraps = bool(travel) and dudx % 2 == 0 and bool(rng.integers(2))
    start = TURN - 1 - int(rng.integers(travel)) if wraps else int(rng.integers(TURN - travel))
    if speed < 0:
        start = TURN - 1 - start
    if wraps:
        u = u & ~1 | (speed < 0)
    return u, v // TURN * TURN + start, count


def span_trial(kernel: str, dudx: int, dvdx: int, colour: int, size, rng, upwards: bool,
               ground: Ground | None = None) -> Trial:
    """One table: every count at all four alignments, with a start of its own."""
    ground = ground or Ground(*picture_memory(), texels)
    far, frame_at, wide = ground.memory, ground.frame_at, ground.pixel_bytes
    counts, pitch = size
    shape = layout.load().struct("scanline")
    starts = [(count, k) for count in counts for k in range(4)]
    table = np.zeros(len(starts), shape.dtype)
    own_steps = []  # of each line, where the kernel reads them
    lines = []      # count, u, v, dudx, dvdx and where the first pixel is
    for index, (count, k) in enumerate(starts):
        u, v = (int(n) for n in rng.integers(0, 1 << 32, 2))
        if kernel == "span_affine_addx":
            u, v, count = once_wrapping(u, v, count, dudx, dvdx, rng)
        form = "addx" if "addx" in kernel or "scanline" in kernel else "plain"
        packed = pack(form, u, v)
        if form == "addx":  # room in v--U, used by the edges' additions
            packed["start2"] |= int(rng.integers(0, 0x8000)) << 8
        left = BIAS + k + 4 * int(rng.integers(4))
        for field, value in (packed | dict(left=left, count=count)).items():
            table[index][field] = value
        row = len(starts) - 1 - index if upwards else index
        own = (dudx, dvdx) if index % 3 else \
            tuple(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2))
        own_steps.append(own)
        steps = own if "scanline" in kernel else (dudx, dvdx)
        lines.append((count, u, v, *steps, frame_at + 64 + (row * pitch + left - BIAS) * wide))
    memory = Memory(int(rng.integers(1 << 30)))
    first_row = lines[0][-1] - int(table["left"][0]) * wide
    pointers = dict(lines=memory.add(table.tobytes(), name="lines", shape=shape))
    if "scanline" in kernel:
        step = layout.load().struct("scanline_step")
        pointers["steps"] = memory.add(
            b"".join(step.pack(dudx=du, dvdx=dv) for du, dv in own_steps), name="steps", shape=step)
    if ground.columns:
        pointers["columns"] = memory.struct("column_layout", {}, **ground.columns)
    pitch *= wide
    plan = add_span_plan(
        memory, pointers,
        dict(row=first_row, map=ground.map_at), count=len(lines),
        pitch=-pitch if upwards else pitch, dudx=dudx, dvdx=dvdx, colour=colour)

    def drawn(count: int, u: int, v: int, dudx: int, dvdx: int) -> bytes:
        return bytes([colour & 255]) * count if kernel == "span_fill" else \
            ground.texels(u, v, dudx, dvdx, count).tobytes()

    def where(offset: int, far: bool) -> str | None:
        if not far or not frame_at <= offset < frame_at + FRAME:
            return None
        index = min(range(len(lines)), key=lambda k: max(
            lines[k][-1] - offset, offset - lines[k][-1] - max(lines[k][0], 0) * wide + 1))
        count, u, v, du, dv, at = lines[index]
        line = (f"line {index} (left {table['left'][index]}, count {count}, "
                f"{values(u=u, v=v, dudx=du, dvdx=dv)})")
        if count <= 0:
            return f"{line}: byte {offset - at}"
        if offset < at:
            return f"{line}: {at - offset} byte(s) before its start"
        beyond = offset - at - count * wide + 1
        return f"{line}: {beyond} byte(s) past its end" if beyond > 0 else \
            f"{line}: pixel {(offset - at) // wide}"

    step = values(colour=colour) if kernel == "span_fill" else \
        values(dudx=dudx, dvdx=dvdx) + f" = {dudx / ONE:g}, {dvdx / ONE:g} texels a pixel"
    return Trial(
        Case(kernel, memory, pointers={"a0": plan}, far=far),
        f"{ground.name}{len(lines)} lines {'up' if upwards else 'down'}, {step}",
        writes=[Write(at, drawn(*line), far=True) for *line, at in lines if line[0] > 0],
        where=where)


def span_trials(kernel: str, rng) -> list[Trial]:
    """Steps of all kinds on short lines, some of them on long ones."""
    if kernel == "span_fill":
        return [span_trial(kernel, 0, 0, colour, size, rng, upwards)
                for colour in COLOURS for size in (SHORT, LONG) for upwards in (False, True)]
    steps = [(a, b) for a in STEPS for b in STEPS] + list(PAIRS)
    steps += [tuple(int(n) for n in rng.integers(-4 * ONE, 4 * ONE, 2)) for _ in range(12)]
    steps += [tuple(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)) for _ in range(8)]
    if kernel == "span_affine_c":  # any compiler's product: what matters is the routines
        steps = steps[::4]
    long_steps = [*PAIRS[:8], *(steps[k] for k in rng.choice(len(steps), 24, replace=False))]
    return [span_trial(kernel, *pair, 0, size, rng, upwards=k % 8 == 7)
            for size, chosen in ((SHORT, steps), (LONG, long_steps))
            for k, pair in enumerate(chosen)]


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    names = ("span_fill", "span_affine_addx", "span_affine_addx_wrap", "span_affine_swap",
             "span_affine_c", "span_affine_scanline")
    return [trial for seed, name in enumerate(names)
            for trial in span_trials(name, np.random.default_rng([3, seed]))]
