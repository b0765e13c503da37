"""Trials of the bench's kernels: whole pixels, single steps, memory alone."""

from functools import cache

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.span import MAP_ALIGN, STEPS, TURN, texture
from tmap.base.fixed import ONE
from tmap.bench import instruction_costs, steps
from tmap.bench.spans import Ground
from tmap.bench.trial import Trial, Write, both, values
from tmap.guest.kernels import M32, Case

FRAME = 512
ROW = 32768  # texels of a row that one interpolant walks over
ROUNDS = (1, 2, 3, 16)


@cache
def table_of_shades() -> np.ndarray:
    return np.random.default_rng(5).integers(0, 256, (256, 256), dtype=np.uint8)


@cache
def pixel_memory(*blocks: str) -> tuple[Memory, dict[str, int]]:
    """A far arena with a frame and what else is needed, and what lies where."""
    memory = Memory(4)
    places = {"frame": memory.add(memory.noise.randbytes(FRAME), name="frame")}
    for name in blocks:
        content = table_of_shades() if name == "shades" else texture()
        content, align = (content.reshape(-1)[:ROW], 4) if name == "row" else (content, MAP_ALIGN)
        places[name] = memory.add(content.tobytes(), align, name)
    return memory, places


def row_trial(form: str, u: int, du: int, count: int, at: int) -> Trial:
    """One interpolant over a row of texels, ``count`` pixels at ``at`` of the frame."""
    memory, places = pixel_memory("row")
    ground = Ground(memory, places["frame"] + 64 + at, places["row"], texture().reshape(-1)[:ROW])
    return steps.row_trial(form, u, du, count, ground,
                           f"{count} pixels at {at}, {values(u=u, dudx=du)}")


def map_trial(form: str, shaded: bool, start, step, count: int, at: int) -> Trial:
    """Two interpolants over the map, and a third one for its shade."""
    memory, places = pixel_memory("map", *(["shades"] if shaded else []))
    ground = Ground(memory, places["frame"] + 64 + at, places["map"], texture())
    (u, v, c), (du, dv, dc) = start, step
    title = f"{count} pixels at {at}, " + values(u=u, v=v, dudx=du, dvdx=dv)
    if not shaded:
        return steps.map_trial(form, start, step, count, ground, title)
    return steps.map_trial(form, start, step, count, ground, f"{title}; {values(c=c, dcdx=dc)}",
                           (table_of_shades(), places["shades"]))


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
    pairs = [(a, b) for a in STEPS for b in STEPS]
    pairs += [tuple(int(n) for n in rng.integers(-3 * ONE, 3 * ONE, 2)) for _ in range(20)]
    if shaded:  # their memory is large: some will do
        pairs = [pairs[k] for k in rng.choice(len(pairs), 40, replace=False)]
    trials = []
    for du, dv in pairs:
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


def step_trials(form: str, count: int, rng) -> list[Trial]:
    trials = []
    edges = (0, 1, 0xFFFF, ONE, ONE + 1, 0x18000)
    for k in range(30):
        rounds = ROUNDS[k % len(ROUNDS)]
        most = 32767 * ONE // (16 * rounds + 1)  # the integers stay below 32,768
        speeds = [int(rng.choice(edges)) if k < 15 else int(rng.integers(0, most)) for _ in range(count)]
        starts = [int(rng.integers(0, most)) if k % 3 else int(rng.choice(edges)) for _ in range(count)]
        if form == "swap" and k % 2:
            starts, speeds = ([int(n) for n in rng.integers(0, 1 << 32, count)] for _ in range(2))
        named = {f"{name}{k}": v for name, some in (("value", starts), ("step", speeds))
                 for k, v in enumerate(some)}
        title = f"{16 * rounds} steps, {values(**named)}"
        trials.append(steps.step_trial(form, starts, speeds, rounds, title,
                                       **({"d6": 0} if form == "addx" else {})))
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
            trials += [steps.floor_trial(name, memory, source, out, byte if name == "store" else fetched,
                                         rounds, title) for name in ("fetch", "store", "copy")]
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
    rng = np.random.default_rng(6)
    made = floor_trials(rng) + instruction_trials(np.random.default_rng(16))
    for form in ("swap", "addx", "chain"):
        made += [t for count in (1, 2, 3) for t in step_trials(form, count, rng)]
    for form in ("swap", "addx"):
        made += row_trials(form, rng) + map_trials(form, False, rng) + map_trials(form, True, rng)
    return made
