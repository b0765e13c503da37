"""Trials of the span routines: every pixel against the texel of its own u and v."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base import c_lists
from tmap.base.fixed import ONE
from tmap.bench import spans
from tmap.bench.spans import BIAS, Ground
from tmap.bench.trial import Trial, values
from tmap.build import layout

MAP_ALIGN = 65536
FRAME = 65024
MARGIN = 64  # bytes of the frame before the first line
#: Pixels of the lines and bytes from line to line: room for a guard between lines.
SHORT = (0, -1, -2, -16, -BIAS, -2 * BIAS + 1, *range(1, 41)), 128
LONG = (0, 48, 49, 63, 64, 65, 80, 127, 128, 255, 256, 257, 320, 1024), 1152
#: As LONG, for two bytes a pixel in the same frame.
LONG_WIDE = (0, 48, 63, 64, 65, 257, 1024), LONG[1]
STEPS = (0, 1, -1, ONE, -ONE, 0x18000, -0x18000, 128 * ONE - 1, -128 * ONE + 1)
#: Pairs (dudx, dvdx) that the grid of STEPS leaves out: negative dvdx with an integer
#: dudx and a low byte, or none; slopes that a byte can just hold, or not.
PAIRS = ((0, -0x80), (0, -0x100), (0, -0x180), (3 * ONE, -0x12345), (-2 * ONE, -0x100),
         (-ONE, -0x30000), (5 * ONE, -0x8001), (0x100, -0x100), (0xFFFF, -0xFFFF), (0x8000, -7 * ONE),
         (0xFF, 0xFF), (-0xFF, 0x1FF), (2, 0x40), (2, -0x40), (0, -128 * ONE), (-128 * ONE, ONE))
#: The most pixels of a line, and as SHORT and LONG, of the spans for short lines.
MOST = {f"span_{name}": layout.load().constants[f"SHORT_{constant}"] for name, constant in (
    ("affine_short", "AFFINE"), ("affine_short_wrap", "AFFINE_WRAP"),
    ("affine_row_short", "AFFINE_ROW"), ("gouraud_short", "GOURAUD"), ("lit_short", "LIT"),
    ("lit_short_wrap", "LIT_WRAP"))}
#: The chain of two registers: v wraps at most once in a line.
ONCE_WRAPPING = ("span_affine_addx", "span_affine_short", "span_affine_16", "span_affine_32", "span_keyed")
OWN_STEPS = ("_scanline", "_level")  # endings of kernels' names whose lines have steps of their own
COLOURS = (0, 0xFF, 0x5C, 0x12345601, 0xFFFFFF00)
TURN = 1 << 24  # u and v repeat after 256 texels


@cache
def texture() -> np.ndarray:
    """A 256x256 map without equal neighbours in a row: a texel beside is another."""
    rows = np.tile(np.arange(256, dtype=np.uint8), (256, 1))
    return np.random.default_rng(256).permuted(rows, axis=1)


def ground_of(seed: int, stored: bytes, picture: np.ndarray, at: int = 0,
              align: int = MAP_ALIGN) -> Ground:
    """A far arena with a frame and the map ``stored``, to which spans point ``at`` bytes behind
    its beginning."""
    memory = Memory(seed)
    frame = memory.add(memory.noise.randbytes(FRAME), name="frame")
    return Ground(memory, frame + MARGIN, memory.add(stored, align, "map") + at, picture)


@cache
def picture_ground() -> Ground:
    """What most spans are drawn on and from: the page ``texture``."""
    return ground_of(3, texture().tobytes(), texture())


@cache
def holed_ground() -> Ground:
    """A page for spans with transparent texels: half of them are 0, in runs of all lengths."""
    rng = np.random.default_rng(257)
    holes = np.repeat(rng.integers(0, 2, 1 << 16), rng.integers(1, 24, 1 << 16))[:1 << 16].reshape(256, 256)
    picture = np.where(holes, 0, texture()).astype(np.uint8)
    return ground_of(4, picture.tobytes(), picture)


def sizes(kernel: str) -> tuple:
    """The lines of its tables: SHORT and LONG, or all that a span for short lines can draw."""
    if kernel not in MOST:
        return SHORT, LONG
    return ((0, -1, -2, -16, -BIAS, -2 * BIAS + 1, *range(1, MOST[kernel] + 1)), 128),


def random_starts(counts, rng) -> list[tuple[int, int, int]]:
    """Lines (count, u, v), each count at all four alignments of the pixels, with any u and v."""
    counts = [count for count in counts for _ in range(4)]
    return [(count, *start) for count, start in zip(
        counts, rng.integers(0, 1 << 32, (len(counts), 2)).tolist())]


def once_wrapping(count: int, u: int, v: int, dudx: int, dvdx: int, rng) -> tuple[int, int, int]:
    """count, u and v changed to what the addx chain can draw: v wraps at most once in
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
    return count, u, v // TURN * TURN + start


def table_trial(trial_of: Callable[..., Trial], starts: list[tuple[int, int, int]], pitch: int, rng,
                upwards: bool, title: str, **more) -> Trial:
    """``trial_of`` a table of lines (count, u, v), at all four alignments by turns."""
    used, right = (rng.integers(0, most, len(starts)).tolist() for most in (0x8000, 4))
    lines = [(k % 4 + 4 * right[k], *start) for k, start in enumerate(starts)]
    return trial_of(lines=lines, pitch=pitch, arena=Memory(int(rng.integers(1 << 30))), upwards=upwards,
                    used=used, title=f"{len(lines)} lines {'up' if upwards else 'down'}, {title}", **more)


def form_of(kernel: str) -> str:
    """How the lines of a span routine are packed."""
    packed = {f"span_{name}" for _, name, lines in c_lists.rows("polygon/span_list.h", "SPAN")
              if lines == "ADDX"}
    return "addx" if kernel in packed or kernel.endswith(OWN_STEPS) else "plain"


def span_trial(kernel: str, dudx: int, dvdx: int, colour: int, size, rng, upwards: bool,
               ground: Ground | None = None, name: str = "") -> Trial:
    """One table: every count at all four alignments, with a start of its own. ``name``: of the
    ground."""
    counts, pitch = size
    starts = random_starts(counts, rng)
    if kernel in ONCE_WRAPPING:
        starts = [once_wrapping(*start, dudx, dvdx, rng) for start in starts]
    own_steps = None
    if kernel.endswith(OWN_STEPS):
        own_steps = [(dudx, dvdx) if k % 3 else tuple(map(int, rng.integers(-1 << 31, 1 << 31, 2)))
                     for k in range(len(starts))]
    title = values(colour=colour) if kernel.startswith("span_fill") else steps_text(dudx, dvdx)
    return table_trial(partial(spans.span_trial, kernel, form_of(kernel)), starts, pitch, rng, upwards,
                       name + title, ground=ground or picture_ground(), dudx=dudx, dvdx=dvdx,
                       colour=colour, own_steps=own_steps)


ALONE_MOST = 64000  # texels that u or v alone may travel in a line


def alone_trials(kernel: str, rng, ground: Ground | None = None, tables=None) -> list[Trial]:
    """Steps of all kinds with the other one 0, or whole maps; ``tables`` instead of the kernel's
    sizes."""
    moving = [*STEPS, *(a for pair in PAIRS for a in pair),
              *(int(n) for n in rng.integers(-ONE, ONE, 8)),
              *(int(n) for n in rng.integers(-1 << 31, 1 << 31, 12))]
    trials = []
    for counts, pitch in tables or sizes(kernel):
        for k, step in enumerate(moving):
            still = (0, TURN, -3 * TURN)[k % 3]
            reduced = abs((step + TURN // 2) % TURN - TURN // 2) / ONE
            longest = int(ALONE_MOST / reduced) if reduced else ALONE_MOST
            size = [min(count, longest) for count in counts], pitch
            pair = (step, still) if "_row" in kernel else (still, step)
            trials.append(span_trial(kernel, *pair, 0, size, rng, k % 8 == 7, ground))
    return trials


def copy_trial(counts: list[int], pitch: int, source: int, near: bool, rng, upwards: bool,
               kernel: str = "span_affine_copy", ground: Ground | None = None) -> Trial:
    """One table of copied texels: every count at all four alignments of the pixels, from
    texels at ``source`` modulo 4. ``near``: some of each line lies behind its row's end."""
    steps = ONE + TURN * int(rng.integers(-3, 4)), TURN * int(rng.integers(-3, 4))
    starts = []
    for count, u, v in random_starts(counts, rng):
        first = 256 - int(rng.integers(1, min(max(count, 4), 256) + 1)) if near else u >> 16
        starts.append((count, (first & -4 | source) << 16 | u & 0xFFFF, v))

    return table_trial(partial(spans.span_trial, kernel, "addx"), starts, pitch, rng, upwards,
                       steps_text(*steps), ground=ground or picture_ground(), dudx=steps[0],
                       dvdx=steps[1])


def copy_trials(rng) -> list[Trial]:
    """Lines of all lengths up to 72 pixels, and longer ones, at all alignments."""
    tables = ((*SHORT[0], *range(41, 73)), SHORT[1]), LONG, \
        ((253, 254, 255, 256, 257, 258, 511, 512, 513, 768, 1000, 1021, 1022, 1023), LONG[1])
    return [copy_trial(counts, pitch, source, near, rng, upwards=source == 3)
            for counts, pitch in tables for near in (False, True) for source in range(4)]


def upright_trial(kernel: str, counts, pitch: int, rng) -> Trial:
    """One table of columns side by side, each with steps of its own."""
    starts = [(int(rng.integers(0, 4)), count, *start) for count, start in zip(
        counts, rng.integers(0, 1 << 32, (len(counts), 2)).tolist())]
    steps = [tuple(map(int, rng.integers(-1 << 31, 1 << 31, 2) >> int(rng.integers(0, 16)))) for _ in starts]
    return spans.upright_trial(kernel, starts, pitch, Memory(int(rng.integers(1 << 30))), picture_ground(), steps,
                               f"{len(starts)} columns, {pitch} bytes from pixel to pixel")


def upright_trials(rng) -> list[Trial]:
    """Columns of all lengths, whole frames of them, in frames of different pitches."""
    few = (0, -1, -2, -16, -BIAS, -2 * BIAS + 1, *range(1, 41))
    return [upright_trial(kernel, rng.permutation(counts).tolist(), pitch, rng)
            for kernel in ("span_affine_upright", "span_affine_level_upright") for counts, pitch in ((few, 64), (few, 96), ((0, 48, 63, 64, 65, 127, 128, 255, 256, 257), 200),
                                  ((1000, 1, 1019), 61), ((7,) * 60, 64)) for _ in range(6)]


def steps_text(dudx: int, dvdx: int) -> str:
    return values(dudx=dudx, dvdx=dvdx) + f" = {dudx / ONE:g}, {dvdx / ONE:g} texels a pixel"


def fill_trials(kernel: str, ground: Ground, long, rng) -> list[Trial]:
    return [span_trial(kernel, 0, 0, colour, size, rng, upwards, ground) for colour in COLOURS
            for size in (SHORT, long) for upwards in (False, True)]


def steps_of(rng) -> list[tuple[int, int]]:
    """Pairs of all kinds: each of STEPS with three others, PAIRS, and random ones."""
    steps = [(a, b) for k, a in enumerate(STEPS) for b in STEPS[k % 3::3]] + list(PAIRS)
    steps += [tuple(int(n) for n in rng.integers(-4 * ONE, 4 * ONE, 2)) for _ in range(8)]
    return steps + [tuple(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)) for _ in range(6)]


def span_trials(kernel: str, rng) -> list[Trial]:
    if kernel.startswith("span_fill"):
        if kernel == "span_fill":
            return fill_trials(kernel, picture_ground(), LONG, rng)
        wide = replace(picture_ground(), picture=texture().astype(">u2"))
        return fill_trials(kernel, wide, LONG_WIDE, rng)
    steps = steps_of(rng)
    if kernel == "span_affine_c":  # any compiler's product: what matters is the routines
        steps = steps[::2]
    long_steps = [*PAIRS[:8], *(steps[k] for k in rng.choice(len(steps), 24, replace=False))]
    ground = holed_ground() if "keyed" in kernel else None
    return [span_trial(kernel, *pair, 0, size, rng, k % 8 == 7, ground)
            for size, chosen in zip(sizes(kernel), (steps, long_steps))
            for k, pair in enumerate(chosen)]


def trials() -> list[Trial]:
    names = ("span_fill", "span_affine_addx", "span_affine_addx_wrap", "span_affine_swap",
             "span_affine_c", "span_affine_scanline", "span_affine_level", "span_fill_16", "span_affine_short",
             "span_affine_short_wrap", "span_keyed", "span_keyed_wrap")
    made = [trial for seed, name in enumerate(names)
            for trial in span_trials(name, np.random.default_rng([3, seed]))]
    alone = "span_affine_row", "span_affine_column", "span_affine_row_short"
    made += [trial for seed, name in enumerate(alone)
             for trial in alone_trials(name, np.random.default_rng([4, seed]))]
    made += [trial for seed, name in enumerate(("span_keyed_row", "span_keyed_rows"))
             for trial in alone_trials(name, np.random.default_rng([4, 102 + seed]), holed_ground())]
    return made + copy_trials(np.random.default_rng([4, 100])) + upright_trials(np.random.default_rng([4, 101]))
