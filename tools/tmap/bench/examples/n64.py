"""Random input of the texture engine's passes, and what must come out of each.

The expected output is worked out from the rules (the coordinate steps, filter, divide, combiner),
pixel by pixel or by the engine's model: neither the C nor the assembly is asked. The bench
measures one example of each pass, the tests call many.
"""

from collections.abc import Callable
from functools import partial

import numpy as np

from tmap.base.fixed import signed
from tmap.bench.examples import n64_divide as depth, n64_sample as sample, n64_yuv as yuv
from tmap.bench.examples.example import (BENCH, Example, any_texels, longs, pixels, some_step,
                                         walked, words)
from tmap.n64.combiner import clamp, extended


def copy_row(rng, count: int) -> Example:
    count = -(-count // 32) * 32
    row = rng.bytes(4 * count)
    return Example(row, row, count)


def shade(rng, count: int) -> Example:
    start = rng.integers(-4 << 16, 260 << 16, 4)
    step = rng.integers(-3 << 16, 3 << 16, 4)
    if rng.random() < 0.2:
        start, step = rng.integers(-1 << 31, 1 << 31, (2, 4))
    found = np.clip(walked(start, step, count) >> 16, 0, 255)
    return Example(longs(start), pixels(found), count, "n64_shades", dict(zip("rgba", step)))


def lerp(rng, count: int) -> Example:
    first, second = any_texels(rng, count), any_texels(rng, count)
    near = np.clip(second + rng.integers(-9, 10, first.shape), 0, 255)
    first = np.where(rng.random(count)[:, None] < 0.5, near, first) if count != BENCH else first
    fractions = rng.integers(-256 if rng.random() < 0.7 and count != BENCH else 0, 256, count)
    step = some_step(rng, count, 2)
    fractions = np.where(rng.random(count) < 0.2, 0, fractions)
    used = fractions[np.arange(count) * step // 2][:, None]
    found = clamp((second - first) * used + 256 * first + 128 >> 8)
    return Example(pixels(first), pixels(found), count, "n64_blend", {"fraction_step": step},
                   {"other": pixels(second), "fractions": words(fractions)})


def modulate(rng, count: int) -> Example:
    first, other = any_texels(rng, count), any_texels(rng, count)
    step = some_step(rng, count, 4)
    found = first * other[np.arange(count) * step // 4] + 128 >> 8
    return Example(pixels(first), pixels(found), count, "n64_modulation", {"step": step},
                   {"other": pixels(other)})


def mapped(rng, count: int) -> Example:
    texels, tables = any_texels(rng, count), rng.integers(0, 256, (256, 4))
    found = tables[texels, np.arange(4)]
    return Example(pixels(texels), pixels(found), count, table=pixels(tables))


def mapped_intensity(rng, count: int) -> Example:
    texels, tables = any_texels(rng, count), rng.integers(0, 256, (256, 4))
    return Example(pixels(texels), pixels(tables[texels[:, 3]]), count, table=pixels(tables))


def modulate_intensity(rng, count: int) -> Example:
    first, other, tables = any_texels(rng, count), any_texels(rng, count), rng.integers(0, 256, (256, 4))
    found = tables[first[:, 3] * other[:, 3] + 128 >> 8]
    return Example(pixels(first), pixels(found), count, "n64_intensities", {},
                   {"other": pixels(other), "colours": pixels(tables)})


def widen(rng, count: int) -> Example:
    texels = any_texels(rng, count)
    return Example(pixels(texels), words(texels), count)


def narrow(rng, count: int) -> Example:
    numbers = rng.integers(-128, 384, (count, 4))
    return Example(words(numbers), pixels(np.clip(numbers, 0, 255)), count)


def combine(rng, count: int) -> Example:
    inputs, steps, used = {}, {}, []
    for name in "abcd":
        numbers = rng.integers(-128, 384, (count, 4))
        if rng.random() < 0.3:
            numbers = rng.integers(-256, 256, (count, 4))
        step = some_step(rng, count, 8)
        inputs[name], steps[f"{name}_step"] = words(numbers), step
        used.append(numbers[np.arange(count) * step // 8, 0])
    a, b, c, d = used
    found = extended((a - b) * signed(c, 9) + 256 * d + 128 >> 8)
    return Example(bytes(4), words(found), count, "n64_combination", steps, inputs, stride=8)


#: Pass to the maker of its examples.
MAKERS: dict[str, Callable[..., Example]] = {f"n64_{name}": make for name, make in {
    "walk": sample.walk, "threepoint": sample.threepoint, "threepoint_16": sample.threepoint_16,
    "threepoint_intensity": sample.threepoint_intensity, "map_intensity": mapped_intensity,
    "modulate_intensity": modulate_intensity,
    "average": partial(sample.threepoint, averages=True), "point": sample.point,
    "store_16": sample.store_16, "divide": depth.divide, "tile": sample.tiled,
    "tile_plain": partial(sample.tiled, kind="plain"),
    "tile_clamp": partial(sample.tiled, kind="clamp"),
    "tile_walked": partial(sample.tiled, kind="line"),
    "lerp": lerp, "modulate": modulate, "map": mapped, "widen": widen, "combiner": combine,
    "narrow": narrow, "shade": shade, "copy_row": copy_row, "chroma": yuv.halved,
    "threepoint_yuv": yuv.threepoint, "convert": yuv.convert, "convert_wide": yuv.convert_wide,
    "threepoint_levels": sample.threepoint_levels, "widen_yuv": yuv.widen, "matrix": yuv.matrix,
    "lod": depth.lod, "lod_apart": partial(depth.lod, apart=1), "quads": sample.quads,
    "reciprocals": depth.reciprocal_table, "levels": depth.levels}.items()}
#: Tables, made by C alone.
IN_C_ALONE = ("n64_reciprocals", "n64_levels", "n64_matrix")
#: Another form, or other input, of a pass, and the pass.
FORMS = {"n64_tile_plain": "n64_tile", "n64_tile_clamp": "n64_tile", "n64_lod_apart": "n64_lod"}
