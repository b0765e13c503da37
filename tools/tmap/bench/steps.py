"""Bench rows of addx against swap: steps of interpolants alone, pixels of a line, and the floor under
them, memory alone.
"""

import numpy as np

from tmap.base.fixed import M32, ONE
from tmap.bench.spans import COLOUR, DU, DV, first_difference
from tmap.corpus import random_maps
from tmap.guest.kernels import Arena, Case, Result

DC = 0x00A00  # shade a pixel, 16.16
STEPS = 1024
PIXELS = 256
IN_LOOP = 16  # steps or pixels each time round a kernel's loop


def step_case(form: str, count: int):
    """STEPS steps of ``count`` interpolants; the registers tell whether they were right."""
    values = [(3 + k) * ONE + 0x1234 * (k + 1) for k in range(count)]
    speeds = [ONE * k + 0x9876 + 0x321 * k for k in range(count)]

    def swapped(x: int) -> int:
        return (x << 16 | x >> 16) & M32

    if form == "chain":  # each fraction above the integer of the one before it
        fractions = lambda xs: [(xs[k] & 0xFFFF) << 16 | xs[k - 1] >> 16 for k in range(count)]
        start, step = fractions(values), fractions(speeds)
        ends = [x + STEPS * s for x, s in zip(values, speeds)]
        late = values[-1] + (STEPS - 1) * (speeds[-1] & 0xFFFF) >> 16
        end = fractions(ends)
        end[0] = (ends[0] & 0xFFFF) << 16 | late + STEPS * (speeds[-1] >> 16)
    else:
        turn = swapped if form == "addx" else (lambda x: x)
        start, step = map(turn, values), map(turn, speeds)
        end = [turn(x + STEPS * s & M32) for x, s in zip(values, speeds)]
    registers = {f"d{k}": v for k, v in enumerate(start)}
    registers |= {f"d{k + 3}": v for k, v in enumerate(step)}
    registers |= {"d6": 0, "d7": STEPS // IN_LOOP - 1}

    def check(result: Result) -> str | None:
        found = [result.registers[f"d{k}"] for k in range(count)]
        return None if found == end else f"expected {end}, found {found}"

    return STEPS, Case(f"step_{form}_{count}", registers=registers), check


def pixel_case(form: str, count: int):
    """One line of whole pixels: row, map, or map and table of shades."""
    rng = np.random.default_rng(count)
    length, picture, shades = PIXELS, random_maps.page(), rng.integers(0, 256, (256, 256), dtype=np.uint8)
    far = Arena()
    map_at = far.add(picture.tobytes(), 65536)
    table_at = far.add(shades.tobytes(), 65536)
    out_at = far.add(bytes(length))
    u, v, c = 0x123456, 0x456788, 0x105678
    n = np.arange(length)
    du = DU if count > 1 else 0xF800
    registers, pointers = {}, {"a1": out_at, "a6": out_at + length}
    if count == 1:
        expected = picture.reshape(-1)[(u + n * du) >> 16]
        if form == "swap":
            registers = {"d0": u, "d2": du}
        else:
            registers = {"d0": u << 16 & M32 | u >> 16, "d2": du << 16 & M32 | du >> 16}
            expected = picture.reshape(-1)[late_carry(u, du, length)]
        pointers["a0"] = map_at
    else:
        texels = picture[(v + n * DV) >> 16 & 255, (u + n * DU) >> 16 & 255]
        expected = texels if count == 2 else shades[(c + n * DC) >> 16 & 255, texels]
        registers, more = pixel_registers(form, count, u, v, c, map_at, table_at)
        pointers |= more

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, np.uint8, length, out_at)
        return first_difference(expected[None], found[None])

    return length, Case(f"pixel_{form}_{count}", registers=registers, far=far,
                        far_pointers=pointers), check


def late_carry(u: int, du: int, length: int) -> list[int]:
    """Integers of a self-chained register: its carry counts one step later."""
    whole, fraction, carry, out = u >> 16, u & 0xFFFF, 0, []
    for _ in range(length):
        out.append(whole)
        total = fraction + (du & 0xFFFF)
        whole, fraction, carry = whole + (du >> 16) + carry, total & 0xFFFF, total >> 16
    return out


def pixel_registers(form: str, count: int, u: int, v: int, c: int, map_at: int, table_at: int):
    """Registers and pointers of the pixels with two and three interpolants."""
    if form == "swap":
        registers = {"d0": u, "d1": (v << 8) ^ 1 << 31, "d2": DU, "d3": DV << 8, "d7": 0xFFFFFF}
        pointers = {"a0": map_at + 32768}
        if count == 3:
            registers |= {"d5": (c << 8) ^ 1 << 31, "a4": DC << 8}
            pointers |= {"a3": table_at + 32768}
        return registers, pointers
    first = [u << 16 & M32 | v >> 8 & 0xFFFF, u >> 16 & 255]
    step = [DU << 16 & M32 | DV >> 8 & 0xFFFF, DU >> 16 & 255]
    if count == 2:  # A's v one step ahead; these numbers make no carry of it at the start
        first[1] |= (v + DV & 0xFF) << 24
        step[1] |= (DV & 0xFF) << 24
        return dict(zip(("d0", "d1", "d2", "d3"), first + step)), {"d4": map_at}
    first += [(v + DV & 0xFF) << 24 | c >> 8 & 0xFFFF]
    step += [(DV & 0xFF) << 24 | DC >> 8 & 0xFFFF]
    first[1] |= (c & 0xFF) << 24
    step[1] |= (DC & 0xFF) << 24
    return dict(zip(("d0", "d1", "d2", "d3", "d4", "d5"), first + step)), \
        {"d6": map_at, "d7": table_at}


def floor_case(name: str):
    """Memory alone: one byte fetched, stored, or both, for each pixel."""
    far, length = Arena(), STEPS
    source_at = far.add(bytes([COLOUR]) * 4)
    out_at = far.add(bytes(length))

    def check(result: Result) -> str | None:
        found = result.far_memory[out_at:out_at + length]
        return None if name == "fetch" or found == bytes([COLOUR]) * length else "bytes were not stored"

    return length, Case(f"floor_{name}", registers={"d0": COLOUR, "d7": length // IN_LOOP - 1},
                        far=far, far_pointers={"a0": source_at, "a1": out_at}), check
