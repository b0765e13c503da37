"""Examples of the passes over YUV texels: chroma's coordinates, colour conversion."""

import numpy as np

from tmap.bench.examples.example import (Example, Map, any_map, any_texels, longs, pairs, pixels,
                                         words)
from tmap.bench.examples.n64_sample import DECODED, WIDEST, coordinates, quad_bytes
from tmap.n64 import filters
from tmap.n64.combiner import extended
from tmap.n64.filters import Quad, filtered
from tmap.n64.state import Modes, State

USUAL = 175, -43, -89, 222
NEUTRAL = 128  # the byte that stands for 0 of U and V


def halved(rng, count: int) -> Example:
    st = coordinates(rng, count)
    s, t = st.T
    column, fraction = s >> 5, s & 31
    shared = 32 * column + (fraction >> 1) + 16 * (column & 1)
    return Example(pairs(st), pairs(np.stack([shared, t], 1)), count)


def constants(rng) -> list[int]:
    """K0 to K3: the usual ones, any, extremes."""
    if rng.random() < 0.3:
        return list(USUAL)
    return [int(n) for n in np.where(rng.random(4) < 0.3, rng.choice((-256, 255), 4),
                                     rng.integers(-256, 256, 4))]


def matrix_bytes(k: list[int]) -> bytes:
    """struct n64_matrix of K0 to K3."""
    chroma = np.arange(256) - NEUTRAL
    k0, k1, k2, k3 = (2 * n + 1 for n in k)
    u = k1 * chroma + 128, k3 * chroma + 128 >> 8
    v = k2 * chroma, k0 * chroma + 128 >> 8
    return b"".join(longs((green & 0x1FFFF) << 15 | other & 511) for green, other in (u, v))


def matrix(rng, count: int) -> Example:
    k = constants(rng)
    return Example(words(k), matrix_bytes(k), count)


def conversion(rng, count: int) -> tuple[bytes, np.ndarray, dict[str, bytes]]:
    """Texels; what they are converted to, 9 bits, [n][4]; blocks of struct n64_yuv_conversion."""
    k, luma, chroma = constants(rng), any_texels(rng, count), any_texels(rng, count)
    found = filters.convert(k, np.stack([*(chroma.T[:2] - NEUTRAL), luma[:, 3]], 1))
    return pixels(luma), found, {"chroma": pixels(chroma), "matrix": matrix_bytes(k)}


def convert(rng, count: int) -> Example:
    texels, found, blocks = conversion(rng, count)
    colours = rng.integers(0, 256, (512, 4))
    return Example(texels, pixels(colours[found, np.arange(4)]), count,
                   "n64_yuv_conversion", {}, blocks | {"colours": pixels(colours)})


def threepoint(rng, count: int) -> Example:
    """Luma's map and chroma's are unlike each other."""
    k, st, ground = constants(rng), coordinates(rng, count), any_map(rng, WIDEST)
    shared = Map(any_texels(rng, ground.texels.size // 4).reshape(ground.texels.shape))
    _, values, blocks = ground.decoded(*DECODED, quad_bytes)
    *_, chroma = shared.decoded(*DECODED, quad_bytes)
    s, t = st.T
    fractions = (s & 31, t & 31), (s >> 1 & 31, t & 31)
    luma, found = (filtered(State(modes=Modes()), Quad(*of.corners(*(st >> 5).T).swapaxes(0, 1)), *at, None)
                   for of, at in zip((ground, shared), fractions))
    found = filters.convert(k, np.stack([found[:, 3] - NEUTRAL, found[:, 1] - NEUTRAL, luma[:, 3]], 1))
    colours = rng.integers(0, 256, (512, 4))
    values = {name: values[name] for name in ("mask_s", "mask_t", "columns_bits")}
    return Example(pairs(st), pixels(colours[found, np.arange(4)]), count, "n64_yuv_filter",
                   values | {"spare": 0}, {"luma": blocks["quads"], "chroma": chroma["quads"],
                                           "matrix": matrix_bytes(k), "colours": pixels(colours)})


def convert_wide(rng, count: int) -> Example:
    texels, found, blocks = conversion(rng, count)
    return Example(texels, words(extended(found)), count, "n64_yuv_conversion", {"colours": 0},
                   blocks)


def widen(rng, count: int) -> Example:
    texels, _, blocks = conversion(rng, count)
    luma, chroma = (np.frombuffer(made, np.uint8).reshape(count, 4).astype(int)
                    for made in (texels, blocks["chroma"]))
    return Example(texels, words(np.concatenate([chroma[:, :2] - NEUTRAL, luma[:, 2:]], 1)), count,
                   "n64_yuv_conversion", {"colours": 0}, blocks)
