"""Random input of the texture engine's passes, and what must come out of each.

The expected output is worked out pixel by pixel from the rules (the coordinate steps,
filter, divide, combiner), in whatever way is plainest: neither the C nor the assembly is
asked. The bench measures one example of each pass, the tests call many.
"""

from collections.abc import Callable

import numpy as np

from tmap.base.fixed import signed
from tmap.bench.examples import n64_divide as depth, n64_sample as sample, n64_yuv as yuv
from tmap.bench.examples.example import (BENCH, Example, any_texels, longs, pixels, some_step,
                                         walked, words)


def combined(a, b, c, d) -> np.ndarray:
    """The combiner's clamped result, of plain numbers."""
    value = (a - b) * c + 256 * d + 128 >> 8 & 0x1FF
    return np.where(value < 256, value, np.where(value < 384, 255, 0))


def copy_row(rng, count: int) -> Example:
    count = -(-count // 32) * 32
    row = rng.bytes(4 * count)
    return Example("n64_copy_row", row, row, count)


def shade(rng, count: int) -> Example:
    start = rng.integers(-4 << 16, 260 << 16, 4)
    step = rng.integers(-3 << 16, 3 << 16, 4)
    if rng.random() < 0.2:
        start, step = rng.integers(-1 << 31, 1 << 31, (2, 4))
    found = np.clip(walked(start, step, count) >> 16, 0, 255)
    return Example("n64_shade", longs(start), pixels(found), count, "n64_shades",
                   dict(zip("rgba", step)))


def lerp(rng, count: int) -> Example:
    first, second = any_texels(rng, count), any_texels(rng, count)
    fractions = rng.integers(-256 if rng.random() < 0.7 and count != BENCH else 0, 256, count)
    step = some_step(rng, count, 2)
    fractions = np.where(rng.random(count) < 0.2, 0, fractions)
    used = fractions[np.arange(count) * step // 2][:, None]
    return Example("n64_lerp", pixels(first), pixels(combined(second, first, used, first)), count,
                   "n64_blend", {"fraction_step": step},
                   {"other": pixels(second), "fractions": words(fractions)})


def modulate(rng, count: int) -> Example:
    first, other = any_texels(rng, count), any_texels(rng, count)
    step = some_step(rng, count, 4)
    found = first * other[np.arange(count) * step // 4] + 128 >> 8
    return Example("n64_modulate", pixels(first), pixels(found), count, "n64_modulation",
                   {"step": step}, {"other": pixels(other)})


def mapped(rng, count: int) -> Example:
    texels, tables = any_texels(rng, count), rng.integers(0, 256, (4, 256))
    return Example("n64_map", pixels(texels), pixels(tables[np.arange(4), texels]), count,
                   table=pixels(tables))


def widen(rng, count: int) -> Example:
    texels = any_texels(rng, count)
    return Example("n64_widen", pixels(texels), words(texels), count)


def narrow(rng, count: int) -> Example:
    numbers = rng.integers(-128, 384, (count, 4))
    clamped = np.where(numbers < 0, 0, np.where(numbers > 255, 255, numbers))
    return Example("n64_narrow", words(numbers), pixels(clamped), count)


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
    value = (a - b) * signed(c, 9) + 256 * d + 128 >> 8 & 0x1FF
    found = np.where(value >> 7 == 3, value - 512, value)
    return Example("n64_combiner", bytes(4), words(found), count, "n64_combination", steps, inputs,
                   stride=8)


#: Pass to the maker of its examples.
MAKERS: dict[str, Callable[..., Example]] = {
    "n64_walk": sample.walk, "n64_threepoint": sample.threepoint,
    "n64_threepoint_16": sample.threepoint_16, "n64_average": sample.average,
    "n64_point": sample.point, "n64_store_16": sample.store_16, "n64_divide": depth.divide,
    "n64_tile": sample.tiled, "n64_tile_plain": sample.tiled_plain, "n64_lerp": lerp,
    "n64_modulate": modulate, "n64_map": mapped, "n64_widen": widen, "n64_combiner": combine,
    "n64_narrow": narrow, "n64_shade": shade, "n64_copy_row": copy_row,
    "n64_chroma": yuv.halved, "n64_convert": yuv.convert,
    "n64_convert_wide": yuv.convert_wide, "n64_matrix": yuv.matrix,
    "n64_lod": depth.lod, "n64_lod_apart": depth.lod_apart, "n64_quads": sample.quads,
    "n64_reciprocals": depth.reciprocal_table, "n64_levels": depth.levels,
}
#: Tables, made by C alone.
IN_C_ALONE = ("n64_reciprocals", "n64_levels", "n64_matrix")
#: Another form, or other input, of a pass, and the pass.
FORMS = {"n64_tile_plain": "n64_tile", "n64_lod_apart": "n64_lod", "n64_copy_row": "n64_copy_row"}
