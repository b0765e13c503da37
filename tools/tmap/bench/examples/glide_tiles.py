"""Examples of the passes that read prefiltered tiles: any page, and pages of filters' results."""

from collections.abc import Callable

import numpy as np

from tmap.base.fixed import signed
from tmap.bench.examples.example import BENCH, Example, Map, any_texels, longs, pixels, walked, words
from tmap.bench.examples.glide_sample import filtered, packed

SIDE, ROWS = 256, 16  # of a page; rows of it that there are
SHIFT, SHIFTS = 14, 5  # from 14.18 to a page of level 0; and how many levels have one of their own


def line(rng, count: int, shift: int, first: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step: any s, and a t whose rows, signed bytes, are ROWS from ``first`` on."""
    one = 1 << shift
    t = rng.integers(first * one, (first + ROWS) * one, 2)
    tile = int(rng.integers(-1 << 31 - shift - 8, 1 << 31 - shift - 8)) << shift + 8
    ds = int(rng.integers(-1 << 31, 1 << 31) if rng.random() < 0.5 else rng.integers(-one, one))
    if count == BENCH:
        ds = one // 3
    start = [int(rng.integers(-1 << 31, 1 << 31)), int(t[0]) + tile]
    return signed(np.array(start)), np.array([ds, int(t[1] - t[0]) // count])


def example(start, step, count: int, shift: int, first: int, page: bytes,
            expected: bytes) -> Example:
    """A line over a page of which the rows from ``first`` on are there."""
    bits = len(page) // (SIDE * ROWS) * 8
    return Example(longs([*start, 0]), expected, count, "glide_paging",
                   {"s": step[0], "t": step[1], "left": 24 - shift, "spare": 0},
                   {"pixels": page}, within={"pixels": -first * SIDE * bits // 8})


def any_page(bits: int) -> Callable[..., Example]:
    """The maker of lines over noise, through rows on both sides of row 0."""
    def make(rng, count: int) -> Example:
        shift, first = SHIFT + int(rng.integers(SHIFTS)), -ROWS // 2
        page = rng.integers(0, 1 << bits, (ROWS, SIDE))
        start, step = line(rng, count, shift, first)
        column, row = (walked(start, step, count) >> shift).T & SIDE - 1
        found = page[signed(row, 8) - first, column]
        to = words if bits == 16 else longs
        return example(start, step, count, shift, first, to(page.ravel()), to(found))
    return make


def one_level(rng, side: int = 0) -> Callable[[np.ndarray], np.ndarray]:
    """The filter of a level that repeats within a page, at places [n][2] of the map that is 16
    times as fine: 16 columns or rows a texel."""
    side = side or 1 << int(rng.integers(5))
    level = Map(any_texels(rng, side * side).reshape(side, side, 4))
    return lambda at: filtered(at - 8, level, 4)


def two_levels(rng) -> Callable[[np.ndarray], np.ndarray]:
    """A level's filter, blended with the next smaller one's by a fraction of the LOD."""
    near, far, factor = one_level(rng, 16), one_level(rng, 8), int(rng.integers(1, 257))
    return lambda at: near(at) + ((far(at >> 1) - near(at)) * factor >> 8)


def prefiltered(bits: int, filter_of=one_level) -> Callable[..., Example]:
    """The maker of lines over a page of a filter's results; what they must show is worked out for
    each pixel, not read from the page."""
    def make(rng, count: int) -> Example:
        shift, first = SHIFT + int(rng.integers(SHIFTS)), -ROWS * int(rng.integers(2))
        found = filter_of(rng)
        start, step = line(rng, count, shift, first)
        rows, columns = np.divmod(np.arange(ROWS * SIDE), SIDE)
        page = pixels(found(np.stack([columns, rows + first], 1)))
        drawn = pixels(found(walked(start, step, count) >> shift))
        if bits == 16:
            page, drawn = packed(page), packed(drawn)
        return example(start, step, count, shift, first, page, drawn)
    return make


MAKERS: dict[str, Callable[..., Example]] = {
    "glide_tile_16": any_page(16), "glide_tile_32": any_page(32)} | {
    f"glide_{name}_prefiltered{end}": prefiltered(bits, filter_of)
    for name, filter_of in (("bilinear", one_level), ("trilinear", two_levels))
    for end, bits in (("", 32), ("_16", 16))}
#: Rows that are the two kernels on other pages.
FORMS = {name: "glide_tile_16" if name.endswith("16") else "glide_tile_32"
         for name in MAKERS if "prefiltered" in name}
