"""Examples of the passes that mix texels: between levels, and the combine unit."""

import numpy as np

from .tx_example import Example, any_texels, pixels

BENCH = 256  # pixels of what is measured


class Mix:
    """A random struct tmu_mix for ``count`` texels."""

    def __init__(self, rng, count: int) -> None:
        is_plain = count == BENCH
        n = np.arange(count)
        self.others = any_texels(rng, count)
        other_step = 0 if rng.random() < 0.2 and not is_plain else 4
        self.other = self.others[n * other_step // 4]
        step = 2 if is_plain else int(rng.choice((0, 1, 2, 4)))
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
        return Example(kernel, pixels(texels), pixels(mixed), len(texels), "tmu_mix", self.values,
                       self.blocks)


def lerp(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("tmu_lerp", texels, texels + ((mix.other - texels) * mix.factor >> 8))


def scale(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("tmu_scale", texels, texels * mix.factor >> 8)


def modulate(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("tmu_modulate", texels, texels * ((mix.other ^ mix.flip) + 1) >> 8)


def add(rng, count: int) -> Example:
    texels, mix = any_texels(rng, count), Mix(rng, count)
    return mix.example("tmu_add", texels, np.minimum(texels + mix.other, 255))


def combine(rng, count: int) -> Example:
    """One channel: its byte of each texel, or alpha, or a zero."""
    steps, blocks, used = {}, {}, []
    for name in ("other", "local", "factor", "added"):
        numbers = any_texels(rng, count)
        step = 0 if rng.random() < 0.3 and count != BENCH else 4
        if rng.random() < 0.2 and count != BENCH:
            numbers = 0 * numbers
        steps[f"{name}_step"], blocks[name] = step, pixels(numbers)
        used.append(numbers[np.arange(count) * step // 4, 0])
    other, local, factor, added = used
    flip, invert = (255 * int(n) for n in rng.integers(0, 2, 2))
    found = ((other - local) * ((factor ^ flip) + 1) >> 8) + added
    found = np.clip(found, 0, 255) ^ invert
    return Example("tmu_combiner", bytes(4), found.astype(np.uint8).tobytes(), count, "tmu_inputs",
                   steps | {"flip": flip, "invert": invert}, blocks, stride=4)
