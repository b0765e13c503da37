"""Calls of addx against swap: steps of interpolants alone, pixels of a line, and the floor under them,
memory alone.
"""

import numpy as np

from tmap.base.fixed import M32, ONE
from tmap.bench.spans import COLOUR, DU, DV, Ground, texels
from tmap.bench.trial import Trial, Write
from tmap.corpus import random_maps
from tmap.guest.kernels import Arena, Case

DC = 0x00A00  # shade a pixel, 16.16
STEPS = 1024
PIXELS = 256
IN_LOOP = 16  # steps or pixels each time round a kernel's loop


def swapped(value: int, high: int | None = None) -> int:
    """ff:ii of a 16.16 value; another one's fraction, where it is given."""
    return (value if high is None else high) << 16 & 0xFFFF0000 | value >> 16 & 0xFFFF


def step_registers(form: str, values: list[int]) -> list[int]:
    """Registers of 16.16 numbers: plain, swapped, or each fraction before the integer of
    the next one of the circle: d0's belongs to d1's."""
    if form == "swap":
        return [n & M32 for n in values]
    if form == "addx":
        return [swapped(n) for n in values]
    return [swapped(values[k - 1], values[k]) for k in range(len(values))]


def step_trial(form: str, starts: list[int], steps: list[int], rounds: int, title: str = "",
               **more: int) -> Trial:
    """IN_LOOP steps a round of one to three interpolants; ``more``: registers."""
    n, count = IN_LOOP * rounds, len(starts)
    final = step_registers(form, [a + n * b for a, b in zip(starts, steps)])
    if form == "chain":  # the last fraction's last carry is still in X
        late = ((starts[-1] & 0xFFFF) + (n - 1) * (steps[-1] & 0xFFFF)) >> 16
        whole = (starts[-1] >> 16) + n * (steps[-1] >> 16) + late
        final[0] = final[0] & 0xFFFF0000 | whole & 0xFFFF
    registers = {f"d{k}": v for k, v in enumerate(step_registers(form, starts))}
    registers |= {f"d{k + 3}": v for k, v in enumerate(step_registers(form, steps))}
    return Trial(Case(f"step_{form}_{count}", registers=registers | {"d7": rounds - 1} | more), title,
                 {f"d{k}": v for k, v in enumerate(final)})


def step_case(form: str, count: int):
    """STEPS steps of ``count`` interpolants."""
    starts = [(3 + k) * ONE + 0x1234 * (k + 1) for k in range(count)]
    speeds = [ONE * k + 0x9876 + 0x321 * k for k in range(count)]
    return step_trial(form, starts, speeds, STEPS // IN_LOOP, d6=0).row(STEPS)


def pixel_trial(kernel: str, expected: np.ndarray, registers: dict[str, int], pointers: dict[str, int],
                ground: Ground, title: str) -> Trial:
    """A call that draws a line of pixels at the frame's beginning."""
    first, count = ground.frame_at, len(expected)

    def where(offset: int, far: bool) -> str | None:
        n = offset - first
        if not far or abs(n) > 2 * count + 64:
            return None
        return f"pixel {n}" if 0 <= n < count else \
            f"{-n} byte(s) before the first pixel" if n < 0 else \
            f"{n - count + 1} byte(s) past the last pixel"

    case = Case(kernel, registers=registers, far=ground.arena,
                far_pointers=pointers | {"a1": first, "a6": first + count})
    return Trial(case, title, ends={"a1": first + count}, where=where,
                 writes=[Write(first, expected.tobytes(), far=True)])


def row_trial(form: str, u: int, du: int, count: int, ground: Ground, title: str = "") -> Trial:
    """One interpolant over a row of texels, as many as the ground's picture has."""
    column = u + np.arange(count, dtype=np.int64) * du
    if form == "addx":  # the fraction one step ahead; a carry of that step is in U already
        early = (u & 0xFFFF) + (du & 0xFFFF) >> 16
        column[0] += early * ONE
        registers = {"d0": swapped(u + early * ONE, u + du), "d2": swapped(du)}
    else:
        registers = {"d0": u, "d2": du & M32}
    return pixel_trial(f"pixel_{form}_1", ground.picture.reshape(-1)[column >> 16], registers,
                       {"a0": ground.map_at}, ground, title)


def step_down(high: int, dv: int) -> tuple[int, int]:
    """uuVv of the steps (u's 16 bits of fraction in ``high``) and what U loses for it: a
    negative Vv always carries, which is taken from uu, or from U where uu is 0."""
    word = dv >> 8 & 0xFFFF
    if word < 0x8000:
        return high << 16 | word, 0
    return (high - 1 & 0xFFFF) << 16 | word, int(high == 0)


def map_trial(form: str, start, step, count: int, ground: Ground, title: str = "",
              shades: tuple[np.ndarray, int] | None = None) -> Trial:
    """Two interpolants over the map, and a third one for its shade. ``start``, ``step``: of u, v and
    the shade; ``shades``: the table, [shade][texel], and where it is."""
    (u, v, c), (du, dv, dc) = start, step
    expected = texels(ground.picture, u, v, du, dv, count)
    carried, map_at = v, ground.map_at
    if form == "addx":  # v's lower byte one step ahead; a carry of that step is in Vv already
        carried = v + ((v & 0xFF) + (dv & 0xFF) & 0x100)
        expected = np.concatenate([texels(ground.picture, u, carried, du, dv, 1), expected[1:]])
    if shades:
        table, table_at = shades
        expected = table[(c + np.arange(count) * dc) >> 16 & 255, expected]
    if form == "swap":
        registers = {"d0": u, "d1": v << 8 & M32 ^ 1 << 31, "d2": du & M32, "d3": dv << 8 & M32,
                     "d7": 0xFFFFFF}
        pointers = {"a0": map_at + 32768}
        if shades:
            registers |= {"d5": c << 8 & M32 ^ 1 << 31, "a4": dc << 8 & M32}
            pointers |= {"a3": table_at + 32768}
    else:
        down, borrowed = step_down(du & 0xFFFF, dv)
        b, b_step = (u & 0xFFFF) << 16 | carried >> 8 & 0xFFFF, down
        whole, whole_step = u >> 16 & 0xFF, (du >> 16) - borrowed & 0xFF
        ahead, low_step = (v + dv & 0xFF) << 24, (dv & 0xFF) << 24
        if shades:
            registers = {
                "d0": b, "d1": (c & 0xFF) << 24 | whole, "d2": ahead | c >> 8 & 0xFFFF,
                "d3": b_step, "d4": (dc & 0xFF) << 24 | whole_step, "d5": low_step | dc >> 8 & 0xFFFF}
            pointers = {"d6": map_at, "d7": table_at}
        else:
            registers = {"d0": b, "d1": ahead | whole, "d2": b_step, "d3": low_step | whole_step}
            pointers = {"d4": map_at}
    return pixel_trial(f"pixel_{form}_{3 if shades else 2}", expected, registers, pointers, ground, title)


def pixel_case(form: str, count: int):
    """One line of whole pixels: row, map, or map and table of shades."""
    table = np.random.default_rng(count).integers(0, 256, (256, 256), dtype=np.uint8)
    far, picture = Arena(), random_maps.page()
    map_at, table_at = (far.add(each.tobytes(), ONE) for each in (picture, table))
    ground = Ground(far, far.add(bytes(PIXELS)), map_at, picture)
    u, v, c, du = 0x123456, 0x456788, 0x105678, 0xF800
    if count == 1:
        return row_trial(form, u if form == "swap" else u - du, du, PIXELS, ground).row(PIXELS)
    return map_trial(form, (u, v, c), (DU, DV, DC), PIXELS, ground,
                     shades=(table, table_at) if count == 3 else None).row(PIXELS)


def floor_trial(name: str, far: Arena, source: int, out: int, byte: int, rounds: int,
                title: str = "") -> Trial:
    """Memory alone: a ``byte`` is fetched from ``source``, stored to ``out`` on, or both."""
    pointers = {"fetch": {"a0": source}, "store": {"a1": out}, "copy": {"a0": source, "a1": out}}[name]
    registers = {"d7": rounds - 1} | ({"d0": byte} if name == "store" else {})
    trial = Trial(Case(f"floor_{name}", registers=registers, far=far, far_pointers=pointers), title)
    if name == "fetch":
        trial.outputs = {"d0": byte}
    else:
        trial.ends = {"a1": out + IN_LOOP * rounds}
        trial.writes = [Write(out, bytes([byte]) * IN_LOOP * rounds, far=True)]
    return trial


def floor_case(name: str):
    """STEPS times one byte; registers that a kernel does not read are set, too."""
    far = Arena()
    source, out = far.add(bytes([COLOUR]) * 4), far.add(bytes(STEPS))
    trial = floor_trial(name, far, source, out, COLOUR, STEPS // IN_LOOP)
    trial.case.registers["d0"] = COLOUR
    trial.case.far_pointers |= {"a0": source, "a1": out}
    return trial.row(STEPS)
