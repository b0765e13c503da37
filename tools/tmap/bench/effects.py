"""Bench rows of whole effects: lit textures, and the rotator that fills a screen."""

import numpy as np

from tmap.base.fixed import M32, ONE, signed
from tmap.bench.edges import LINES, long_write
from tmap.bench.spans import BIAS, DU, DV, GAP, line_count, scanlines, span_call, table_of
from tmap.bench.trial import Trial
from tmap.build import layout
from tmap.corpus import random_maps
from tmap.guest.kernels import Arena, Case
from tmap.setup.scanline import pack_shade

DC = 0x2800  # levels a pixel, 16.16
LEVELS = 64
SCREEN = 320, 256  # pixels, the rotator's
#: The rotator's step (dudx, dvdx): turned by 35.5 degrees, 0.86 texels a pixel: v wraps once
#: a line at most; and by 39.8 degrees, 1.95 texels: it wraps more often.
TURNED, FAR_OUT = (0xB334, 0x8000), (DU, DV)


def lit_case(kernel: str, length: int):
    """A table of lit spans of one length, as tmap.bench.spans.span_case."""
    rng, lines = np.random.default_rng(length), line_count(length)
    arena, far, texels = Arena(), Arena(), random_maps.page()
    light = rng.integers(0, 256, (LEVELS, 256), dtype=np.uint8)
    map_at, light_at = far.add(texels.tobytes(), ONE), far.add(light.tobytes(), ONE)
    n, expected = np.arange(length), np.zeros((lines, length + GAP), np.uint8)
    starts, shades, level = [], b"", 40
    for k in range(lines):
        u, v = int(rng.integers(0, 1 << 24)) & ~1, int(rng.integers(0, 190 << 16))
        shade = int(rng.integers(0, 20 << 16)) & ~3
        starts.append((k % 4, u, v))
        shades += pack_shade(shade).to_bytes(4, "big")
        rows = shade + n * DC >> 16 if kernel == "span_lit_gouraud" else level
        expected[k, k % 4:k % 4 + length] = light[
            rows, texels[v + n * DV >> 16 & 255, u + n * DU >> 16 & 255]]
    pointers = {"lines": arena.add(scanlines(starts, length, "addx"))}
    if kernel == "span_lit_gouraud":
        pointers["shades"], level = arena.add(shades), 0
    return lines * length, *span_call(
        kernel, arena, far, pointers, {"map": map_at, "light": light_at + 256 * level}, expected,
        dudx=DU, dvdx=DV, dcdx=DC)


def held(start: int, step: int, pixels: int, low: int, high: int) -> int:
    """The start nearest to ``start`` with which no pixel leaves low..high."""
    travel = (pixels - 1) * step
    return min(max(start, low - min(travel, 0)), high - max(travel, 0))


def shade_trial(arena: Arena, lines: list[tuple[int, int]], title: str = "", **plan: int) -> Trial:
    """edge_shade on lines (first column with BIAS, pixels); ``plan``: fields of struct shade_plan. Shades
    are kept from low to high unless ``inside`` says that none leaves it."""
    low, high, inside, dcdx = (plan[name] for name in ("low", "high", "inside", "dcdx"))
    table = table_of([{"left": left, "last": left + count - 1} for left, count in lines])
    at = arena.add(table, name="lines", shape=layout.load().struct("scanline"))
    shades_at = arena.blank(4 * len(lines), "shades")
    plan_at = arena.struct("shade_plan", {"lines": at, "shades": shades_at}, count=len(lines), **plan)
    longest, limited = max(*(count for _, count in lines), 1, 1) - 1, dcdx
    if longest and not inside:
        largest = (high - low) // longest & ~3
        limited = min(max(dcdx, -largest), largest)
    writes = [long_write(plan_at + layout.load().struct("shade_plan").fields["dcdx"]["offset"], limited)]
    for k, (left, count) in enumerate(lines):
        start = signed(plan["shade"] + k * plan["dcdy"] + left * dcdx)
        if count > 0 or inside:
            kept = start if inside else held(start, limited, count, low, high)
            writes.append(long_write(shades_at + 4 * k, pack_shade(kept, plan["added"])))
    return Trial(Case("edge_shade", arena, pointers={"a0": plan_at}), title, writes=writes)


def shade_case(inside: int = 0):
    """Shades of LINES lines of 10 pixels and more, which move to the right; ``inside``: of struct
    shade_plan."""
    lines = [(BIAS + 40 + n // 2, 11 + n - n // 2) for n in range(LINES)]
    return shade_trial(Arena(), lines, added=0, shade=(20 << 16) - DC * BIAS & M32, dcdx=DC, dcdy=-0x800,
                       low=0, high=(LEVELS << 16) - 4, inside=inside).row(LINES)


def screen(steps: tuple[int, int]) -> np.ndarray:
    """Where each pixel of the rotator's screen is fetched in the map, int64 [y][x]."""
    (width, _), (du, dv) = SCREEN, steps
    u, v = screen_starts(steps)
    n = np.arange(width)
    return (v[:, None] + n * dv >> 8 & 0xFF00) | (u[:, None] + n * du >> 16 & 0xFF)


def screen_starts(steps: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """u and v at the left border, each line a step of the turned texture further down."""
    line, (du, dv) = np.arange(SCREEN[1]), steps
    return (0x123456 & ~1) - line * dv & ~1, 0x456789 + line * du


def rotator_case(kernel: str, form: str, steps: tuple[int, int]):
    """A screen of turned texture in one call: 256 lines of 320 pixels."""
    (width, height), texels = SCREEN, random_maps.page()
    arena, far = Arena(), Arena()
    map_at = far.add(texels.tobytes(), ONE)
    u, v = (c.tolist() for c in screen_starts(steps))
    pointers = {"lines": arena.add(scanlines([(0, *start) for start in zip(u, v)], width, form))}
    expected = texels.reshape(-1)[screen(steps)]
    return width * height, *span_call(kernel, arena, far, pointers, {"map": map_at}, expected,
                                      dudx=steps[0], dvdx=steps[1])


#: Row to (kernel, its form, steps).
ROTATORS = {"rotator": ("span_affine_addx", "addx", TURNED),
            "rotator_wrap": ("span_affine_addx_wrap", "addx", FAR_OUT),
            "rotator_swap": ("span_affine_swap", "plain", TURNED)}
LIT = {"affine_lit": "span_lit", "affine_lit_wrap": "span_lit_wrap",
       "affine_gouraud": "span_lit_gouraud"}
