"""Calls of whole effects: lit textures, light on drawn ones, and the rotator that fills a screen."""

import numpy as np

from tmap.base.fixed import M32, ONE, signed
from tmap.bench.edges import LINES
from tmap.bench.spans import (BIAS, DU, DV, GAP, Ground, Line, framed, line_count, span_trial,
                              table_of, table_trial, texels)
from tmap.bench.trial import Trial, fields, long_write
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


def lit_trial(kernel: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
              light: np.ndarray, light_at: int, title: str = "", *, level: int = 0,
              shades: list[int] | None = None, added: int = 0, dudx: int, dvdx: int, dcdx: int = 0,
              **more) -> Trial:
    """One table of lit spans. ``light``: [level][texel]; ``light_at``: where it is in the far
    arena. All is at one ``level``, or each line begins with one of ``shades``, 16.16; ``added``: to
    packed shades."""
    blocks = {} if shades is None else {
        "shades": b"".join(pack_shade(shade, added).to_bytes(4, "big") for shade in shades)}

    def drawn(k: int, _: int, __: int, count: int, u: int, v: int) -> np.ndarray:
        rows = shades[k] + np.arange(count, dtype=np.int64) * (dcdx & ~3) >> 16 if shades else level
        return light[rows, texels(ground.picture, u, v, dudx, dvdx, count)]

    return table_trial(kernel, "addx", lines, pitch, arena, ground, drawn, title, blocks=blocks,
                       far={"light": light_at + 256 * level}, dudx=dudx, dvdx=dvdx, dcdx=dcdx, **more)


def lit_case(kernel: str, length: int):
    """A table of lit spans of one length, as tmap.bench.spans.span_case."""
    rng, lines = np.random.default_rng(length), line_count(length)
    far, picture = Arena(), random_maps.page()
    light = rng.integers(0, 256, (LEVELS, 256), dtype=np.uint8)
    map_at, light_at = far.add(picture.tobytes(), ONE), far.add(light.tobytes(), ONE)
    starts, shades = [], []
    for k in range(lines):
        u, v = int(rng.integers(0, 1 << 24)) & ~1, int(rng.integers(0, 190 << 16))
        starts.append((k % 4, length, u, v))
        shades.append(int(rng.integers(0, 20 << 16)) & ~3)
    level = {"shades": shades} if kernel == "span_lit_gouraud" else {"level": 40}
    return lit_trial(kernel, starts, length + GAP, Arena(),
                     framed(far, map_at, picture, lines, length), light, light_at, dudx=DU, dvdx=DV,
                     dcdx=DC, **level).row(lines * length)


def light_trial(kernel: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
                light: np.ndarray, light_at: int, title: str = "", *, level: int = 0,
                shades: list[int] | None = None, dcdx: int = 0, **more) -> Trial:
    """One table of pixels that the ground's frame has. ``light``: [level][pixel]; ``light_at``: where it
    is in the far arena. All is at one ``level``, or each line begins with one of ``shades``, 16.16, and
    has the step ``dcdx``."""
    blocks, before = {}, bytes(ground.arena.data)
    if shades is not None:
        added = (light_at & 0xFFFF) + layout.load().constants["LEVEL_FALLS"] * (dcdx < 0)
        blocks["shades"] = b"".join(pack_shade(shade, added).to_bytes(4, "big") for shade in shades)

    def drawn(k: int, at: int, _: int, count: int, *__: int) -> np.ndarray:
        rows = shades[k] + np.arange(count, dtype=np.int64) * dcdx >> 16 if shades else level
        return light[rows, np.frombuffer(before, np.uint8, count, at)]

    return table_trial(kernel, "flat", lines, pitch, arena, ground, drawn, title, blocks=blocks,
                       far={"light": light_at + 256 * level}, dcdx=dcdx, **more)


def light_case(kernel: str, length: int):
    """A table of lines of one length, as tmap.bench.spans.span_case."""
    rng, lines, far = np.random.default_rng(length), line_count(length), Arena()
    light = rng.integers(0, 256, (LEVELS, 256), dtype=np.uint8)
    light_at = far.add(light.tobytes(), ONE)
    frame = far.add(rng.bytes(lines * (length + GAP)))
    places = [(k % 4, length, 0, 0) for k in range(lines)]
    shades = [int(rng.integers(0, 20 << 16)) & ~3 for _ in places]
    level = {"shades": shades, "dcdx": DC} if "gouraud" in kernel else {"level": 40}
    ground = Ground(far, frame, 0, np.zeros((256, 256), np.uint8))
    return light_trial(kernel, places, length + GAP, Arena(), ground, light, light_at,
                       **level).row(lines * length)


def held(start: int, step: int, pixels: int, low: int, high: int) -> int:
    """The start nearest to ``start`` with which no pixel leaves low..high."""
    travel = (pixels - 1) * step
    return min(max(start, low - min(travel, 0)), high - max(travel, 0))


def shade_trial(arena: Arena, lines: list[tuple[int, int]], title: str = "", **plan: int) -> Trial:
    """edge_shade on lines (first column with BIAS, pixels); ``plan``: fields of struct shade_plan.
    Shades are kept from low to high unless ``inside`` says that none leaves this range."""
    low, high, inside, dcdx = (plan[name] for name in ("low", "high", "inside", "dcdx"))
    table = table_of([{"left": left, "last": left + count - 1} for left, count in lines])
    at = arena.add(table, name="lines", shape=layout.load().struct("scanline"))
    shades_at = arena.blank(4 * len(lines), "shades")
    plan_at = arena.struct("shade_plan", {"lines": at, "shades": shades_at}, count=len(lines), **plan)
    longest, limited = max(*(count for _, count in lines), 1, 1) - 1, dcdx
    if longest and not inside:
        largest = (high - low) // longest & ~3
        limited = min(max(dcdx, -largest), largest)
    writes = fields(plan_at, "shade_plan", {"dcdx": limited})
    for k, (left, count) in enumerate(lines):
        start = signed(plan["shade"] + k * plan["dcdy"] + left * dcdx)
        if count > 0 or inside:
            kept = start if inside else held(start, limited, count, low, high)
            writes.append(long_write(shades_at + 4 * k, pack_shade(kept, plan["added"])))
    return Trial(Case("edge_shade", arena, pointers={"a0": plan_at}), title, writes=writes)


def shade_case(inside: int = 0):
    """Shades of LINES lines of 10 pixels and more; ``inside``: of struct shade_plan."""
    lines = [(BIAS + 40 + n // 2, 11 + n - n // 2) for n in range(LINES)]
    return shade_trial(Arena(), lines, added=0, shade=(20 << 16) - DC * BIAS & M32, dcdx=DC,
                       dcdy=-0x800, low=0, high=(LEVELS << 16) - 4, inside=inside).row(LINES)


def rotator_case(kernel: str, form: str, steps: tuple[int, int]):
    """A screen of turned texture in one call: 256 lines of 320 pixels, each a step further down."""
    (width, height), (du, dv), far, picture = SCREEN, steps, Arena(), random_maps.page()
    map_at = far.add(picture.tobytes(), ONE)
    ground = Ground(far, far.add(bytes(width * height)), map_at, picture)
    lines = [(0, width, (0x123456 & ~1) - y * dv & ~1, 0x456789 + y * du) for y in range(height)]
    return span_trial(kernel, form, lines, width, Arena(), ground, dudx=du, dvdx=dv).row(width * height)


#: Row to (kernel, its form, steps).
ROTATORS = {"rotator": ("span_affine_addx", "addx", TURNED),
            "rotator_wrap": ("span_affine_addx_wrap", "addx", FAR_OUT),
            "rotator_swap": ("span_affine_swap", "plain", TURNED)}
#: Rows to kernels.
LIGHT = {"light": "span_light", "light_gouraud": "span_light_gouraud"}
LIT = {"affine_lit": "span_lit", "affine_lit_wrap": "span_lit_wrap",
       "affine_gouraud": "span_lit_gouraud"}
