"""Trials of the bench's kernels: whole pixels, single steps, memory alone."""

from functools import cache

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.span import MAP_ALIGN, STEPS, TURN, texels, texture
from tmap.base.fixed import ONE
from tmap.bench import instruction_costs
from tmap.bench.trial import Trial, Write, both, values
from tmap.guest.kernels import M32, Case

FRAME = 512
ROW = 32768  # texels of a row that one interpolant walks over
ROUNDS = (1, 2, 3, 16)


@cache
def table_of_shades() -> np.ndarray:
    """256 shades by 256 texels."""
    return np.random.default_rng(5).integers(0, 256, (256, 256), dtype=np.uint8)


@cache
def pixel_memory(*blocks: str) -> tuple[Memory, dict[str, int]]:
    """A far arena with a frame and what else is needed, and what lies where."""
    memory = Memory(4)
    places = {"frame": memory.add(memory.noise.bytes(FRAME), name="frame")}
    for name in blocks:
        content = table_of_shades() if name == "shades" else texture()
        content, align = (content.reshape(-1)[:ROW], 4) if name == "row" else (content, MAP_ALIGN)
        places[name] = memory.add(content.tobytes(), align, name)
    return memory, places


def swapped(value: int, high: int | None = None) -> int:
    """ff:ii of a 16.16 value; another one's fraction, where it is given."""
    return (value if high is None else high) << 16 & 0xFFFF0000 | value >> 16 & 0xFFFF


def pixel_trial(kernel: str, count: int, at: int, expected: np.ndarray, registers, pointers,
                title: str) -> Trial:
    """A call that draws ``count`` pixels at ``at`` of the frame."""
    memory, places = pixel_memory(*(block for block, _ in pointers.values()))
    first = places["frame"] + 64 + at

    def where(offset: int, far: bool) -> str | None:
        n = offset - first
        if not far or not places["frame"] <= offset < places["frame"] + FRAME:
            return None
        return f"pixel {n}" if 0 <= n < count else \
            f"{-n} byte(s) before the first pixel" if n < 0 else \
            f"{n - count + 1} byte(s) past the last pixel"

    pointers = {name: places[block] + more for name, (block, more) in pointers.items()}
    case = Case(kernel, registers=registers, far=memory,
                far_pointers=pointers | {"a1": first, "a6": first + count})
    return Trial(case, f"{count} pixels at {at}, {title}", ends={"a1": first + count},
                 writes=[Write(first, expected.tobytes(), far=True)], where=where)


def row_trial(form: str, u: int, du: int, count: int, at: int) -> Trial:
    """One interpolant over a row of texels."""
    row = texture().reshape(-1)[:ROW]
    column = u + np.arange(count, dtype=np.int64) * du
    if form == "addx":  # the fraction one step ahead; a carry of that step is in U already
        early = (u & 0xFFFF) + (du & 0xFFFF) >> 16
        column[0] += early * ONE
        registers = {"d0": swapped(u + early * ONE, u + du), "d2": swapped(du)}
    else:
        registers = {"d0": u, "d2": du & M32}
    return pixel_trial(f"pixel_{form}_1", count, at, row[column >> 16], registers,
                       {"a0": ("row", 0)}, values(u=u, dudx=du))


def step_down(high: int, dv: int) -> tuple[int, int]:
    """uuVv of the steps (u's 16 bits of fraction in ``high``) and what U loses for it: a
    negative Vv always carries, which is taken from uu, or from U where uu is 0."""
    word = dv >> 8 & 0xFFFF
    if word < 0x8000:
        return high << 16 | word, 0
    return (high - 1 & 0xFFFF) << 16 | word, int(high == 0)


def map_trial(form: str, shaded: bool, start, step, count: int, at: int) -> Trial:
    """Two interpolants over the map, and a third one for its shade."""
    (u, v, c), (du, dv, dc) = start, step
    expected = texels(u, v, du, dv, count)
    carried = v
    if form == "addx":  # v's lower byte one step ahead; a carry of that step is in Vv already
        carried = v + ((v & 0xFF) + (dv & 0xFF) & 0x100)
        expected = np.concatenate([texels(u, carried, du, dv, 1), expected[1:]])
    if shaded:
        expected = table_of_shades()[(c + np.arange(count) * dc) >> 16 & 255, expected]
    if form == "swap":
        registers = {"d0": u, "d1": v << 8 & M32 ^ 1 << 31, "d2": du & M32, "d3": dv << 8 & M32,
                     "d7": 0xFFFFFF}
        pointers = {"a0": ("map", 32768)}
        if shaded:
            registers |= {"d5": c << 8 & M32 ^ 1 << 31, "a4": dc << 8 & M32}
            pointers |= {"a3": ("shades", 32768)}
    else:
        down, borrowed = step_down(du & 0xFFFF, dv)
        b, b_step = (u & 0xFFFF) << 16 | carried >> 8 & 0xFFFF, down
        whole, whole_step = u >> 16 & 0xFF, (du >> 16) - borrowed & 0xFF
        ahead, low_step = (v + dv & 0xFF) << 24, (dv & 0xFF) << 24
        if shaded:
            registers = {
                "d0": b, "d1": (c & 0xFF) << 24 | whole, "d2": ahead | c >> 8 & 0xFFFF,
                "d3": b_step, "d4": (dc & 0xFF) << 24 | whole_step, "d5": low_step | dc >> 8 & 0xFFFF}
            pointers = {"d6": ("map", 0), "d7": ("shades", 0)}
        else:
            registers = {"d0": b, "d1": ahead | whole, "d2": b_step, "d3": low_step | whole_step}
            pointers = {"d4": ("map", 0)}
    shade = "; " + values(c=c, dcdx=dc) if shaded else ""
    return pixel_trial(f"pixel_{form}_{2 + shaded}", count, at, expected, registers, pointers,
                       values(u=u, v=v, dudx=du, dvdx=dv) + shade)


def row_trials(form: str, rng) -> list[Trial]:
    trials = []
    for du in (0, 1, 0xFFFF, ONE, 0x18000, 7 * ONE + 1, *(int(n) for n in rng.integers(0, 40 * ONE, 12)),
               *((-1, -ONE, -0x18000) if form == "swap" else ())):
        for rounds in ROUNDS:
            count = 16 * rounds
            travel = du * count
            u = int(rng.integers(max(-travel, 0), ROW * ONE - max(travel, 0)))
            trials.append(row_trial(form, u, du, count, len(trials) % 4))
    return trials


def map_trials(form: str, shaded: bool, rng) -> list[Trial]:
    steps = [(a, b) for a in STEPS for b in STEPS]
    steps += [tuple(int(n) for n in rng.integers(-3 * ONE, 3 * ONE, 2)) for _ in range(20)]
    if shaded:  # their memory is large: some will do
        steps = [steps[k] for k in rng.choice(len(steps), 40, replace=False)]
    trials = []
    for du, dv in steps:
        count = 16 * int(rng.choice(ROUNDS[:3])) + 8 * (shaded or form == "swap")
        u, v, c = (int(n) for n in rng.integers(0, TURN, 3))
        dc = int(rng.integers(-2 * ONE, 2 * ONE))
        if form == "addx":  # v wraps once at most, and u has its lowest bit free for it
            if abs(dv) * count >= TURN:
                dv //= 128
            du &= ~1
            u = u & ~1 | (dv < 0)
        trials.append(map_trial(form, shaded, (u, v, c), (du, dv, dc), count, len(trials) % 4))
    return trials


def step_registers(form: str, pairs: list[int]) -> list[int]:
    """Registers of 16.16 numbers: plain, swapped, or each fraction before the integer of
    the next one of the circle: d0's belongs to d1's."""
    if form == "swap":
        return [n & M32 for n in pairs]
    if form == "addx":
        return [swapped(n) for n in pairs]
    return [swapped(pairs[k - 1], pairs[k]) for k in range(len(pairs))]


def step_trial(form: str, starts: list[int], steps: list[int], rounds: int) -> Trial:
    """16 steps a round of one to three interpolants."""
    n, count = 16 * rounds, len(starts)
    ends = [a + n * b for a, b in zip(starts, steps)]
    final = step_registers(form, ends)
    if form == "chain":  # the last fraction's last carry is still in X
        late = ((starts[-1] & 0xFFFF) + (n - 1) * (steps[-1] & 0xFFFF)) >> 16
        whole = (starts[-1] >> 16) + n * (steps[-1] >> 16) + late
        final[0] = final[0] & 0xFFFF0000 | whole & 0xFFFF
    registers = {f"d{k}": v for k, v in enumerate(step_registers(form, starts))}
    registers |= {f"d{k + 3}": v for k, v in enumerate(step_registers(form, steps))}
    registers |= {"d7": rounds - 1} | ({"d6": 0} if form == "addx" else {})
    named = {f"value{k}": v for k, v in enumerate(starts)} | {f"step{k}": v for k, v in enumerate(steps)}
    return Trial(Case(f"step_{form}_{count}", registers=registers), f"{n} steps, {values(**named)}",
                 {f"d{k}": v for k, v in enumerate(final)})


def step_trials(form: str, count: int, rng) -> list[Trial]:
    trials = []
    edges = (0, 1, 0xFFFF, ONE, ONE + 1, 0x18000)
    for k in range(30):
        rounds = ROUNDS[k % len(ROUNDS)]
        most = 32767 * ONE // (16 * rounds + 1)  # the integers stay below 32,768
        steps = [int(rng.choice(edges)) if k < 15 else int(rng.integers(0, most)) for _ in range(count)]
        starts = [int(rng.integers(0, most)) if k % 3 else int(rng.choice(edges)) for _ in range(count)]
        if form == "swap" and k % 2:
            starts, steps = ([int(n) for n in rng.integers(0, 1 << 32, count)] for _ in range(2))
        trials.append(step_trial(form, starts, steps, rounds))
    return trials


def floor_trials(rng) -> list[Trial]:
    memory, places = pixel_memory("row")
    trials = []
    for rounds in ROUNDS:
        for k in range(4):
            count, byte = 16 * rounds, int(rng.integers(256))
            source, out = places["row"] + int(rng.integers(ROW)), places["frame"] + 64 + k
            fetched = memory.data[source]
            title = f"{count} bytes at {k}, the byte is {both(byte, 1)}, in memory {both(fetched, 1)}"

            def trial(kernel: str, content: int | None, registers, pointers) -> Trial:
                case = Case(kernel, registers=registers | {"d7": rounds - 1}, far=memory,
                            far_pointers=pointers)
                writes = [] if content is None else [Write(out, bytes([content]) * count, far=True)]
                return Trial(case, title, writes=writes,
                             ends={} if content is None else {"a1": out + count})

            trials += [trial("floor_fetch", None, {}, {"a0": source}),
                       trial("floor_store", byte, {"d0": byte}, {"a1": out}),
                       trial("floor_copy", fetched, {}, {"a0": source, "a1": out})]
            trials[-3].outputs = {"d0": fetched}
    return trials


def instruction_trials(rng) -> list[Trial]:
    """Code that adds and one that stores, a round's bytes lying behind one another."""
    made = []
    for rounds in ROUNDS:
        start, step = (int(n) for n in rng.integers(0, 1 << 32, 2))
        count = 16 * rounds
        memory, far = Memory(rounds), Memory(rounds + 1)
        out = far.add(bytes(count), name="bytes")
        for words, end, writes in (
                ("d081", start + count * step, []),  # add.l d1,d0
                ("12c0", start, [Write(out, bytes([start & 255]) * count, far=True)])):  # move.b d0,(a1)+
            at = memory.add(instruction_costs.code(words), name="code")
            case = Case("instructions", memory, {"d0": start, "d1": step, "d7": rounds - 1},
                        {"a4": at}, far, {"a1": out})
            made.append(Trial(case, f"{count} times ${words}, {values(d0=start, d1=step)}",
                              outputs={"d0": end & M32}, writes=writes))
    return made


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    rng = np.random.default_rng(6)
    made = floor_trials(rng) + instruction_trials(np.random.default_rng(16))
    for form in ("swap", "addx", "chain"):
        made += [t for count in (1, 2, 3) for t in step_trials(form, count, rng)]
    for form in ("swap", "addx"):
        made += row_trials(form, rng) + map_trials(form, False, rng) + map_trials(form, True, rng)
    return made
