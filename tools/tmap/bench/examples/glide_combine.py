"""Examples of the passes that mix texels: between levels, and the combine unit."""

from dataclasses import astuple, fields, replace

import numpy as np

from tmap.bench.examples.example import BENCH, Example, any_texels, pixels, some_step
from tmap.build import layout
from tmap.glide.combine import combined, detail_factor
from tmap.glide.functions import FACTORS, FUNCTIONS, combination
from tmap.glide.state import Combination, Modes


class Mix:
    """A random struct glide_mix for ``count`` texels."""

    def __init__(self, rng, count: int) -> None:
        n = np.arange(count)
        self.others = any_texels(rng, count)
        other_step = some_step(rng, count, 4, 0.2)
        self.other = self.others[n * other_step // 4]
        step = 2 if count == BENCH else int(rng.choice((0, 1, 2, 4)))
        factors = rng.integers(0, 256, 4 * count)
        factors = np.where(rng.random(4 * count) < 0.2, rng.choice((0, 255), 4 * count), factors)
        flip = 255 * int(rng.integers(2))
        one = int(rng.integers(2))
        #: Of 256, [count][1].
        self.factor = ((factors[n * step] ^ flip) + one)[:, None]
        self.flip = flip
        self.values = {"other_step": other_step, "factor_step": step, "flip": flip * 0x01010101,
                       "one": one}
        self.blocks = {"other": pixels(self.others), "factors": factors.astype(np.uint8).tobytes()}

    def example(self, kernel: str, texels: np.ndarray, mixed: np.ndarray) -> Example:
        """A call that makes ``mixed`` of texels, [count][4] both."""
        return Example(kernel, pixels(texels), pixels(mixed), len(texels), "glide_mix", self.values,
                       self.blocks)


def lerp(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("glide_lerp", texels, texels + ((mix.other - texels) * mix.factor >> 8))


def scale(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("glide_scale", texels, texels * mix.factor >> 8)


def modulate(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("glide_modulate", texels, texels * ((mix.other ^ mix.flip) + 1) >> 8)


def modulate_rgb(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    found = texels * ((mix.other ^ mix.flip) + 1) >> 8
    found[:, 3] = texels[:, 3]
    return mix.example("glide_modulate_rgb", texels, found)


def add(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("glide_add", texels, np.minimum(texels + mix.other, 255))


def alpha(rng, count: int) -> Example:
    texels, alphas = any_texels(rng, count), any_texels(rng, count)
    step = some_step(rng, count, 4)
    found = texels.copy()
    found[:, 3] = alphas[np.arange(count) * step // 4, 0]
    inverted = rng.choice((0, 255), 4)
    return Example("glide_alpha", pixels(texels), pixels(found ^ inverted), count, "glide_alphas",
                   {"step": step, "inverted": int.from_bytes(pixels(inverted), "big")},
                   {"alphas": pixels(alphas)})


def combine(rng, count: int) -> Example:
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
    return Example("glide_combiner", bytes(4), found.astype(np.uint8).tobytes(), count, "glide_inputs",
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


def modes_bytes(modes: Modes) -> list[int]:
    """struct glide_modes."""
    values = {field.name: getattr(modes, field.name) for field in fields(modes)}
    values |= {name: list(astuple(values[name])) for name in ("rgb", "alpha")} | {"spare": [0] * 2}
    return list(layout.load().struct("glide_modes").pack(**values))


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
    return Example("glide_combine_line", pixels(local), pixels(found), count, "glide_combine_call",
                   {"modes": modes_bytes(modes), "detail_step": step, "fraction_step": step,
                    "odd": level & 1, "has_other": has_other, "has_alpha": has_alpha, "spare": 0}
                   | dict(zip(("detail", "fraction", "flip"), known)), blocks)
