"""Trials of src68k/edge: scanline tables against the closed forms of their lines."""

from dataclasses import replace

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base.fixed import ONE, signed
from tmap.bench import edges
from tmap.bench.edges import table_writes
from tmap.bench.spans import BIAS, table_of
from tmap.bench.trial import Trial, values
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup.scanline import pack, rounded_edge

SLOPES = (0, 1, -1, ONE, -ONE, 3 * ONE, -5 * ONE, ONE + 1, -ONE - 1, ONE - 1, 1 - ONE, 0x8000,
          -0x8000, 0x18000, -0x18000, 1000 * ONE, -1000 * ONE, 1000 * ONE + 1, -1000 * ONE - 1)
#: Lines of each edge, left and right.
SPLITS = (((1,), (1,)), ((9,), (9,)), ((3, 1, 5), (9,)), ((9,), (4, 5)), ((1, 1, 1, 1), (2, 2)),
          ((2, 7), (7, 2)), ((40,), (13, 27)), ((5, 6, 7, 8, 9, 10), (45,)), ((1, 63), (64,)))
STEPS = (0, 1, -1, 256, ONE, -ONE, 0x18000, -0x18000, 0x7FFFFFFF, -0x80000000)
#: Lines of a table behind the last one in use: nobody may touch them.
SPARE = 2


def side(rng, split: tuple[int, ...], slope: int | None, exact: bool) -> list[dict[str, int]]:
    """Edges whose x stays within the frame's range; the slope, or any."""
    made = []
    for lines in split:
        k = slope if slope is not None else \
            int(rng.choice(SLOPES)) if rng.integers(2) else int(rng.integers(-300 * ONE, 300 * ONE))
        travel = [(lines - 1) * slope for slope in
                  ([k // ONE * ONE, k // ONE * ONE + ONE] if exact else [k])]
        low = 1 + max(-travel[0], 0) + ONE
        high = 2 * BIAS * ONE - 1 - max(travel[-1], 0) - ONE
        if high < low:  # too steep for so many lines
            return side(rng, split, k // 2, exact)
        x = int(rng.choice([low, high])) if rng.integers(5) == 0 else int(rng.integers(low, high + 1))
        if rng.integers(4) == 0 and low <= x // ONE * ONE <= high:
            x = x // ONE * ONE  # on a pixel's centre
        texels = {name: int(rng.integers(0, 1 << 32)) for name in ("u", "v")}
        texels |= {name: int(rng.integers(-1 << 31, 1 << 31)) for name in ("du", "dv")}
        edge = rounded_edge(lines, x, k, **texels)
        if exact:
            height = int(rng.choice((1, 2, 3, ONE, (1 << 31) - 1, rng.integers(1, 1 << 31))))
            part = int(rng.choice((0, height - 1, rng.integers(0, height))))
            error = (1 << 32) - int(rng.choice((1, height, rng.integers(1, height + 1))))
            edge |= dict(height=height, part=part, error=error)
        made.append(edge)
    return made


def edge_trial(kernel: str, lefts, rights, steps: dict[str, int], rng) -> Trial:
    sides = "; ".join(
        f"{name} " + ", ".join(f"{e['lines']} lines: " + values(
            **{k: e[k] for k in ("x", "whole", "error", "part", "height", "u", "v", "du", "dv")
               [:9 if name == "left" else 5]}) for e in some)
        for name, some in (("left", lefts), ("right", rights)))
    return edges.edge_trial(kernel, Memory(int(rng.integers(1 << 30))), lefts, rights, steps,
                            f"{sides}; {values(**steps)}", SPARE)


def edge_trials(kernel: str, rng) -> list[Trial]:
    def steps(choice) -> dict[str, int]:
        return {name: choice() for name in ("dudx", "dvdx")}

    def fixed() -> int:
        return int(rng.choice(STEPS))

    def any_step() -> int:
        return int(rng.integers(-1 << 31, 1 << 31))

    exact = kernel.endswith("_exact")
    made = [edge_trial(kernel, side(rng, (12,), k, exact), side(rng, (5, 7), -k, exact),
                       steps(fixed), rng) for k in SLOPES]
    made += [edge_trial(kernel, side(rng, a, None, exact), side(rng, b, None, exact),
                        steps(choice), rng)
             for a, b in SPLITS for choice in (fixed, any_step) for _ in range(3)]
    return made


def scissor_trial(kernel: str, width: int, dudx: int, dvdx: int, rng) -> Trial:
    """One call of a scissor routine on a table with lines on all sides of the borders."""
    form = kernel.split("_")[1]
    near = [0, 1, 2, 100, BIAS - 1]
    ends = {BIAS - k for k in near} | {BIAS + k for k in near} \
        | {BIAS + width + k for k in (-1, 0, 1)} | {0, 1, 2 * BIAS, 2 * BIAS + 1}
    pairs = [(left, right) for left in ends for right in ends]
    pairs += [tuple(int(x) for x in rng.integers(1, 2 * BIAS, 2)) for _ in range(20)]
    pairs = sorted(pairs)
    memory = Memory(int(rng.integers(1 << 30)))
    shape = layout.load().struct("scanline")
    table, lines, before = [], [], []
    for left, right in pairs:
        u, v = (int(n) for n in rng.integers(0, 1 << 32, 2))
        packed = pack(form, u, v)
        if form == "addx":  # room in v--U, used by additions before
            packed["start2"] |= int(rng.integers(0, 0x8000)) << 8
        table.append(packed | {"left": left, "last": signed(right - 1, 16)})
        before.append(f"(from column {left - BIAS} to {right - BIAS}, {values(u=u, v=v)})")
        first, end = max(left, BIAS), min(right, BIAS + width)
        lines.append({"left": first, "last": end - 1} | pack(
            form, u + (first - left) * dudx, v + (first - left) * dvdx))
    at = memory.add(table_of(table), name="lines", shape=shape)
    plan = memory.struct("scissor_plan", dict(lines=at), count=len(lines), width=width,
                         dudx=dudx, dvdx=dvdx)
    # A line with nothing left may hold anything that is empty to a span routine.
    writes = []
    for write, line in zip(table_writes(at, lines, form),
                           (line for line in lines for _ in line)):
        is_empty = line["last"] < line["left"]
        writes.append(write._replace(mask=bytes(len(write.mask))) if is_empty else write)

    def emptied(result) -> str | None:
        found = np.frombuffer(result.memory, shape.dtype, len(lines), at)
        for index, line in enumerate(lines):
            is_drawn = (int(found["last"][index]) - int(found["left"][index])) & 0xFFFF < 0x8000
            if line["last"] < line["left"] and is_drawn:
                return (f"lines[{index}] {before[index]} lies outside: "
                        f"left {found['left'][index]}, last {found['last'][index]}")
        return None

    def where(offset: int, far: bool) -> str | None:
        index = (offset - at) // shape.size
        return None if far or not 0 <= index < len(lines) else \
            f"{memory.place(offset).name} {before[index]}"

    return Trial(Case(kernel, memory, pointers={"a0": plan}),
                 f"{len(lines)} lines, {values(width=width, dudx=dudx, dvdx=dvdx)}",
                 writes=writes, where=where, also=emptied)


def scissor_trials(kernel: str, rng) -> list[Trial]:
    steps = [(a, b) for a in STEPS for b in STEPS]
    picked = [steps[k] for k in rng.choice(len(steps), 20, replace=False)]
    picked += [tuple(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)) for _ in range(10)]
    widths = (1, 2, 16, 320, 640, 1024, BIAS)
    return [scissor_trial(kernel, widths[k % len(widths)], *pair, rng)
            for k, pair in enumerate(picked)]


def called_as(kernel: str, found: list[Trial]) -> list[Trial]:
    """Returns the same trials of another routine that takes and does the same."""
    return [replace(trial, case=replace(trial.case, kernel=kernel)) for trial in found]


def trials() -> list[Trial]:
    made = []
    for seed, form in enumerate(("addx", "plain", "swap", "flat", "right")):
        for exact in ("", "_exact") if form != "swap" else ("",):
            found = edge_trials(f"edge_{form}{exact}", np.random.default_rng([1, seed, len(exact)]))
            made += found
            if form in ("addx", "plain", "flat"):  # the same for assembly
                made += called_as(f"lines_{form}{exact}", found[::4])
    for seed, form in enumerate(("addx", "plain", "flat")):
        made += scissor_trials(f"scissor_{form}", np.random.default_rng([2, seed]))
    return made
