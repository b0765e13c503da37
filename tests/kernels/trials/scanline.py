"""Trials of edge_ramp and edge_clamp: u and v of each line against their definition."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base.fixed import ONE
from tmap.bench import edges
from tmap.bench.edges import table_writes
from tmap.bench.effects import held
from tmap.bench.spans import BIAS, table_of
from tmap.bench.trial import Trial, long_write, values
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup.scanline import pack

FAR = 16383 * ONE


def ramps(rng, total: int, low: int, high: int) -> list[dict[str, int]]:
    """A side: x stays between two columns (16.16), u and v within the vertices' range."""
    made = []
    while total:
        lines = min(total, int(rng.integers(1, 12)))
        total -= lines
        ends = [[int(rng.integers(a, b)) for _ in range(2)]
                for a, b in ((low, high), (-FAR, FAR), (-FAR, FAR))]
        steps = [(b - a) // lines for a, b in ends]
        made.append(dict(zip(("x", "u", "v", "dx", "du", "dv"), [e[0] for e in ends] + steps),
                         lines=lines))
    return made


def ramp_trial(rng, truncated: bool, packed: bool, gap: tuple[int, int],
               x: tuple[int, int] = (-100 * ONE, 300 * ONE)) -> Trial:
    """One table; ``gap``: least and most pixels between the sides, ``x``: where the left one
    is, 16.16."""
    total = int(rng.integers(1, 40))
    left = ramps(rng, total, *x)
    right = [r | {"x": r["x"] + int(rng.integers(gap[0], gap[1] + 1)), "u": int(rng.integers(-FAR, FAR)),
                  "v": int(rng.integers(-FAR, FAR))} for r in left]
    return edges.ramp_trial(
        Memory(int(rng.integers(1 << 30))), left, right, truncated, packed,
        f"{total} lines, truncated {truncated}, packed {packed}, gap {gap[1] / ONE:g}")


def clamp_trial(rng, most: int) -> Trial:
    """A table with lines of up to ``most`` pixels."""
    counts = [int(rng.integers(-3, most + 1)) for _ in range(int(rng.integers(1, 30)))]
    longest = max(max(counts), 1) - 1
    plan = {"count": len(counts)}
    for name, step in (("u", "dudx"), ("v", "dvdx")):
        low = int(rng.choice((0, rng.integers(0, 255 * ONE))))
        high = low + int(rng.choice((0, 1, ONE - 1, rng.integers(0, 1024 * ONE - 1))))
        plan |= {f"{name}_low": low, f"{name}_high": high,
                 step: int(rng.integers(-20 * ONE, 20 * ONE)) >> int(rng.integers(0, 20))}
    limited = dict(plan)
    for name, step in (("u", "dudx"), ("v", "dvdx")):
        if longest:
            most_step = (plan[f"{name}_high"] - plan[f"{name}_low"]) // longest
            limited[step] = min(max(plan[step], -most_step), most_step)
    before, after = [], []
    for count in counts:
        start = {name: int(rng.integers(plan[f"{name}_low"] - 5 * ONE, plan[f"{name}_high"] + 5 * ONE))
                 for name in "uv"}
        if rng.integers(10) == 0:
            start = {name: int(rng.integers(-1 << 30, 1 << 30)) for name in "uv"}
        before.append(pack("plain", start["u"], start["v"]) | {"left": BIAS, "last": BIAS + count - 1})
        kept = [held(start[n], limited[s], count, plan[f"{n}_low"], plan[f"{n}_high"])
                for n, s in (("u", "dudx"), ("v", "dvdx"))]
        after.append(pack("plain", *kept) if count > 0 else {})
    memory = Memory(int(rng.integers(1 << 30)))
    at = memory.add(table_of(before), name="lines", shape=layout.load().struct("scanline"))
    plan_at = memory.struct("clamp_plan", dict(lines=at), **plan)
    fields = layout.load().struct("clamp_plan").fields
    writes = table_writes(at, after, "plain")
    writes += [long_write(plan_at + fields[s]["offset"], limited[s]) for s in ("dudx", "dvdx")]
    return Trial(Case("edge_clamp", memory, pointers={"a0": plan_at}), values(**plan),
                 writes=writes)


def trials() -> list[Trial]:
    rng = np.random.default_rng(5)
    ways = [(truncated, packed) for truncated in (False, True) for packed in (False, True)]
    made = [ramp_trial(rng, *way, (0, gap)) for way in ways
            for gap in (0, 3, ONE // 2, ONE, 2 * ONE, 320 * ONE) for _ in range(6)]
    # The border between narrow and wide: a pixel exactly, and a unit less or more, whatever the steps.
    made += [ramp_trial(rng, *way, (gap, gap), (10 * ONE, 12 * ONE)) for way in ways
             for gap in (ONE - 1, ONE, ONE + 1) for _ in range(4)]
    first = -16384 * ONE  # sides as far apart as they can be, and drifted a little further
    made += [ramp_trial(rng, *way, (gap, gap + 80), (first - 40, first + 40)) for way in ways
             for gap in (32767 * ONE, 32768 * ONE - 40) for _ in range(3)]
    return made + [clamp_trial(rng, most) for most in (1, 2, 3, 40, 320) for _ in range(20)]
