"""Examples of the passes that mix texels: between levels, and the combine unit."""

from collections.abc import Callable
from dataclasses import astuple, replace

import numpy as np

from tmap.bench.examples.example import BENCH, Example, any_texels, pairs, pixels, some_step
from tmap.bench.examples.glide_sample import DECODED, filter_pixels, filtered, packed, quad_bytes
from tmap.build import layout
from tmap.glide.combine import combined, detail_factor
from tmap.glide.functions import FACTORS, FUNCTIONS, combination
from tmap.glide.state import Combination, Modes


def mixed(by: Callable[..., np.ndarray]) -> Callable[..., Example]:
    """The maker of examples of a pass with a struct glide_mix. ``by``: what it makes of texels and
    others, [count][4], factors of 256, [count][1], and the flip of factors."""
    def make(rng, count: int) -> Example:
        texels, others, n = any_texels(rng, count), any_texels(rng, count), np.arange(count)
        other_step = some_step(rng, count, 4, 0.2)
        step = 2 if count == BENCH else int(rng.choice((0, 1, 2, 4)))
        factors = rng.integers(0, 256, 4 * count)
        factors = np.where(rng.random(4 * count) < 0.2, rng.choice((0, 255), 4 * count), factors)
        flip, one = 255 * int(rng.integers(2)), int(rng.integers(2))
        factor = ((factors[n * step] ^ flip) + one)[:, None]
        found = by(texels, others[n * other_step // 4], factor, flip)
        return Example(pixels(texels), pixels(found), count, "glide_mix",
                       {"other_step": other_step, "factor_step": step, "flip": flip * 0x01010101,
                        "one": one},
                       {"other": pixels(others), "factors": factors.astype(np.uint8).tobytes()})
    return make


MIXES = {name: mixed(by) for name, by in {
    "lerp": lambda texels, other, factor, _: texels + ((other - texels) * factor >> 8),
    "scale": lambda texels, _, factor, __: texels * factor >> 8,
    "modulate": lambda texels, other, _, flip: texels * ((other ^ flip) + 1) >> 8,
    "modulate_rgb": lambda texels, other, _, flip: np.concatenate(
        [texels[:, :3] * ((other[:, :3] ^ flip) + 1) >> 8, texels[:, 3:]], -1),
    "add": lambda texels, other, _, __: np.minimum(texels + other, 255)}.items()}


def product(m, x):
    """A channel x times another, m."""
    return x * (m + 1) >> 8


def products(_, __: int) -> Example:
    """The whole table, of each m and x: of int16 indices, m is the upper byte."""
    m, x = np.divmod(np.arange(1 << 16) ^ 0x8000, 256)
    return Example(b"", product(m, x).astype(np.uint8).tobytes(), 1)


def times(rng, count: int) -> Example:
    """Filtered texels are m, the others x."""
    st, ground = filter_pixels(rng, count)
    _, values, blocks = ground.decoded(*DECODED, quad_bytes)
    values = {name: values[name] for name in ("mask_s", "mask_t", "columns_bits")}
    others, table = any_texels(rng, count), products(rng, count)
    return Example(pairs(st), pixels(product(filtered(st, ground, 4), others)), count, "glide_times",
                   values | {"spare": 0}, {"quads": blocks["quads"], "other": pixels(others),
                                           "products": table.expected},
                   within={"products": len(table.expected) // 2})


def times_565(rng, count: int) -> Example:
    made = times(rng, count)
    made.expected = packed(made.expected)
    return made


def alpha(rng, count: int) -> Example:
    texels, alphas = any_texels(rng, count), any_texels(rng, count)
    step = some_step(rng, count, 4)
    found = texels.copy()
    found[:, 3] = alphas[np.arange(count) * step // 4, 0]
    inverted = rng.choice((0, 255), 4)
    return Example(pixels(texels), pixels(found ^ inverted), count, "glide_alphas",
                   {"step": step, "inverted": int.from_bytes(pixels(inverted), "big")},
                   {"alphas": pixels(alphas)})


def combiner(rng, count: int) -> Example:
    """One channel: its byte of each texel, or alpha, or a zero."""
    steps, blocks, used = {}, {}, []
    for name in ("other", "local", "factor", "added"):
        numbers = any_texels(rng, count)
        step = some_step(rng, count, 4)
        if rng.random() < 0.2 and count != BENCH:
            numbers = 0 * numbers
        steps[f"{name}_step"], blocks[name] = step, pixels(numbers)
        used.append(numbers[np.arange(count) * step // 4, 0])
    other, local, factor, added = used
    flip, invert = (255 * int(n) for n in rng.integers(0, 2, 2))
    found = ((other - local) * ((factor ^ flip) + 1) >> 8) + added
    found = np.clip(found, 0, 255) ^ invert
    return Example(bytes(4), found.astype(np.uint8).tobytes(), count, "glide_inputs",
                   steps | {"flip": flip, "invert": invert}, blocks, stride=4)


def any_half(rng) -> Combination:
    """Glide's functions and factors, and what registers can say besides."""
    if rng.random() < 0.8:
        return combination(str(rng.choice(list(FUNCTIONS))), str(rng.choice(list(FACTORS))),
                           int(rng.random() < 0.2))
    half = Combination(*(int(n) for n in rng.integers(0, 2, 7)))
    return replace(half, mselect=int(rng.integers(0, 8)),
                   add_alpha_local=half.add_alpha_local * (1 - half.add_local))


def any_modes(rng) -> Modes:
    """Of the combine unit: halves that agree, or an alpha that is left alone, or any."""
    rgb = any_half(rng)
    halves = (rgb, combination("local"), replace(rgb, invert=int(rng.integers(0, 2))),
              any_half(rng))
    return Modes(rgb=rgb, alpha=halves[rng.choice(4, p=(0.3, 0.2, 0.1, 0.4))],
                 trilinear=int(rng.integers(0, 2)), detail_bias=int(rng.integers(-1, 10)),
                 detail_scale=int(rng.integers(0, 8)),
                 detail_max=int(rng.choice((0, 255, rng.integers(0, 256)))))


def combine_line(rng, count: int) -> Example:
    """All pixels' levels are alike, their fractions may differ."""
    modes, local, other = any_modes(rng), any_texels(rng, count), any_texels(rng, count)
    has_other, has_alpha, is_one = rng.random(3) < (0.85, 0.6, 0.6)
    level = int(rng.integers(0, 9))
    fractions = np.full(count, rng.choice((0, 255, rng.integers(0, 256)))) if is_one \
        else rng.integers(0, 256, count)
    lod = level * 256 + fractions
    details = detail_factor(modes, lod)
    found = combined(modes, lod, local.astype(np.int64), other * int(has_other))
    found[:, 3] *= has_alpha
    blocks = {"other": pixels(other), "details": details.astype(np.uint8).tobytes(),
              "fractions": fractions.astype(np.uint8).tobytes()}
    step = int(not is_one)
    flip = 255 * (modes.trilinear & level)
    known = [int(n) if rng.random() < 0.7 and is_one else -1 for n in (details[0], fractions[0])]
    known.append(flip if rng.random() < 0.8 else -1)
    values = vars(modes) | {name: list(astuple(getattr(modes, name))) for name in ("rgb", "alpha")}
    stored = layout.load().struct("glide_modes").pack(**values, spare=[0] * 2)
    return Example(pixels(local), pixels(found), count, "glide_combine_call",
                   {"modes": list(stored), "detail_step": step, "fraction_step": step,
                    "odd": level & 1, "has_other": has_other, "has_alpha": has_alpha, "spare": 0}
                   | dict(zip(("detail", "fraction", "flip"), known)), blocks)
