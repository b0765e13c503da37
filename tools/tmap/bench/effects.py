"""Bench rows of whole effects: lit textures, and the rotator that fills a screen."""

import numpy as np

from tmap.base.fixed import M32, ONE
from tmap.bench.edges import LINES
from tmap.bench.spans import DU, DV, GAP, line_count, scanlines, span_call
from tmap.build import layout
from tmap.corpus import random_maps
from tmap.guest.kernels import Arena, Case, Result
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


def shade_case(inside: int = 0):
    """Shades of LINES lines of 10 pixels and more, which move to the right; ``inside``: of struct
    shade_plan."""
    count, arena, bias = LINES, Arena(), layout.load().constants["EDGE_BIAS"]
    entries = np.zeros(count, layout.load().struct("scanline").dtype)
    n = np.arange(count)
    entries["left"], entries["last"] = bias + 40 + n // 2, bias + 50 + n
    lines_at, shades_at = arena.add(entries.tobytes()), arena.add(bytes(4 * count))
    first, down = 20 << 16, -0x800
    plan_at = arena.struct(
        "shade_plan", {"lines": lines_at, "shades": shades_at}, count=count, added=0,
        shade=first - DC * bias & M32, dcdx=DC, dcdy=down, low=0, high=(LEVELS << 16) - 4,
        inside=inside)
    wanted = [pack_shade(first + k * down + (40 + k // 2) * DC) for k in range(count)]

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, ">u4", count, shades_at).tolist()
        return None if found == wanted else f"shades {found}, expected {wanted}"

    return count, Case("edge_shade", arena, pointers={"a0": plan_at}), check


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
