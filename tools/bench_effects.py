"""Bench rows of whole effects: lit textures, and the rotator that fills a screen."""

import numpy as np

from . import layout
from .bench_mappers import first_difference
from .kernels import Arena, Case, Result
from .model_spans import texel_generated
from .scanline import add_span_plan, pack, pack_shade

DU, DV, DC = 0x18000, 0x14000, 0x2800  # texels, levels a pixel, 16.16
LEVELS = 64
SCREEN = 320, 256  # pixels, the rotator's
#: The rotator's step (dudx, dvdx): turned by 35.5 degrees, 0.86 texels a pixel: v wraps once
#: a line at most; and by 39.8 degrees, 1.95 texels: it wraps more often.
TURNED, FAR_OUT = (0xB334, 0x8000), (DU, DV)


def picture() -> np.ndarray:
    """A 256x256 map of noise."""
    return np.random.default_rng(256).integers(0, 256, (256, 256), dtype=np.uint8)


def table(lines: list[tuple[int, int, int]], count: int, form: str) -> bytes:
    """Scanline entries of ``count`` pixels each, from (first column, u, v)."""
    bias = layout.load().constants["EDGE_BIAS"]
    entries = np.zeros(len(lines), layout.load().struct("scanline").dtype)
    for entry, (first, u, v) in zip(entries, lines):
        for field, value in pack(form, u, v).items():
            entry[field] = value
        entry["left"], entry["last"] = bias + first, bias + first + count - 1
    return entries.tobytes()


def made(kernel: str, arena: Arena, far: Arena, pointers: dict[str, int], frame_at: int,
         far_pointers: dict[str, int], expected: np.ndarray, **values: int):
    """The call that must leave ``expected`` at ``frame_at``, and its check."""
    bias = layout.load().constants["EDGE_BIAS"]
    plan_at = add_span_plan(arena, pointers, far_pointers | {"row": frame_at - bias},
                            count=len(expected), pitch=expected.shape[1], **values)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, np.uint8, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return Case(kernel, arena, pointers={"a0": plan_at}, far=far), check


def lit_case(kernel: str, length: int):
    """A table of lit spans of one length, as tools.bench_cases.span_case."""
    rng = np.random.default_rng(length)
    lines = min(128, max(16, 2048 // length))
    arena, far, texels = Arena(), Arena(), picture()
    light = rng.integers(0, 256, (LEVELS, 256), dtype=np.uint8)
    map_at, light_at = far.add(texels.tobytes(), 65536), far.add(light.tobytes(), 65536)
    n, expected = np.arange(length), np.zeros((lines, length + 4), np.uint8)
    starts, shades, level = [], b"", 40
    for k in range(lines):
        u, v = int(rng.integers(0, 1 << 24)) & ~1, int(rng.integers(0, 190 << 16))
        shade = int(rng.integers(0, 20 << 16)) & ~3
        starts.append((k % 4, u, v))
        shades += pack_shade(shade).to_bytes(4, "big")
        rows = shade + n * DC >> 16 if kernel == "span_lit_gouraud" else level
        expected[k, k % 4:k % 4 + length] = light[
            rows, texels[v + n * DV >> 16 & 255, u + n * DU >> 16 & 255]]
    pointers = {"lines": arena.add(table(starts, length, "addx"))}
    if kernel == "span_lit_gouraud":
        pointers["shades"], level = arena.add(shades), 0
    return lines * length, *made(
        kernel, arena, far, pointers, far.add(bytes(expected.size)),
        {"map": map_at, "light": light_at + 256 * level}, expected, dudx=DU, dvdx=DV, dcdx=DC)


def shade_case(count: int, inside: int = 0):
    """Shades of so many lines of 10 pixels and more, which move to the right."""
    arena, bias = Arena(), layout.load().constants["EDGE_BIAS"]
    entries = np.zeros(count, layout.load().struct("scanline").dtype)
    n = np.arange(count)
    entries["left"], entries["last"] = bias + 40 + n // 2, bias + 50 + n
    lines_at, shades_at = arena.add(entries.tobytes()), arena.add(bytes(4 * count))
    first, down = 20 << 16, -0x800
    plan_at = arena.struct(
        "shade_plan", {"lines": lines_at, "shades": shades_at}, count=count, added=0,
        shade=first - DC * bias & 0xFFFFFFFF, dcdx=DC, dcdy=down, low=0, high=(LEVELS << 16) - 4,
        inside=inside)
    wanted = [pack_shade(first + k * down + (40 + k // 2) * DC) for k in range(count)]

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, ">u4", count, shades_at).tolist()
        return None if found == wanted else f"shades {found}, expected {wanted}"

    return count, Case("edge_shade", arena, pointers={"a0": plan_at}), check


def screen(kernel: str, steps: tuple[int, int]) -> np.ndarray:
    """Where each pixel of the rotator's screen is fetched in the map, int64 [y][x]."""
    (width, height), (du, dv) = SCREEN, steps
    u, v = screen_starts(steps)
    if kernel == "span_generated":
        return np.stack([texel_generated(int(a), int(b), du, dv, width) & 0xFFFF
                         for a, b in zip(u, v)])
    n = np.arange(width)
    return (v[:, None] + n * dv >> 8 & 0xFF00) | (u[:, None] + n * du >> 16 & 0xFF)


def screen_starts(steps: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """u and v at the left border, each line a step of the turned texture further down."""
    line, (du, dv) = np.arange(SCREEN[1]), steps
    return (0x123456 & ~1) - line * dv & ~1, 0x456789 + line * du


def wrong_texels(kernel: str, steps: tuple[int, int] = TURNED) -> float:
    """The part of the rotator's screen that shows another texel than the exact one."""
    return float((screen(kernel, steps) != screen("exact", steps)).mean())


def rotator_case(kernel: str, form: str, steps: tuple[int, int]):
    """A screen of turned texture in one call: 256 lines of 320 pixels."""
    (width, height), texels = SCREEN, picture()
    arena, far = Arena(), Arena()
    lying = texels.tobytes()
    if kernel == "span_generated":
        half = 32768
        map_at = far.add(bytes(half) + lying[half:] + lying + lying[:half], 65536) + 65536
    else:
        map_at = far.add(lying, 65536)
    u, v = (np.array(c).tolist() for c in screen_starts(steps))
    pointers = {"lines": arena.add(table([(0, *start) for start in zip(u, v)], width, form)),
                "code": arena.add(bytes(layout.load().constants["CODE_BYTES"]))}
    expected = texels.reshape(-1)[screen(kernel, steps)]
    return width * height, *made(
        kernel, arena, far, pointers, far.add(bytes(expected.size)), {"map": map_at}, expected,
        dudx=steps[0], dvdx=steps[1])


#: Row to (kernel, its form, steps).
ROTATORS = {"rotator": ("span_affine_addx", "addx", TURNED),
            "rotator_wrap": ("span_affine_addx_wrap", "addx", FAR_OUT),
            "rotator_swap": ("span_affine_swap", "plain", TURNED),
            "rotator_generated": ("span_generated", "plain", TURNED)}
LIT = {"affine_lit": "span_lit", "affine_lit_wrap": "span_lit_wrap",
       "affine_gouraud": "span_lit_gouraud"}
