"""Pictures as texels of the unit's formats, and back.

A picture is uint8 [height, width, 4], R, G, B, A. The levels of a map share its palette or NCC
table. Formats of intensity use the brightness of colours; A8 uses only the alpha.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tmap.base.colours import OPAQUE, intensity, quantised, reduced
from tmap.base.errors import UserError
from tmap.glide import ncc
from tmap.glide.state import (A8, AI44, AI88, AP88, ARGB1555, ARGB4444, ARGB8332, AYIQ8422,
                              FORMATS, I8, P8, RGB332, RGB565, YIQ422, Ncc)
from tmap.glide.texels import decoded
from tmap.images.palette import nearest

COLOURS = 256  # of a palette
BITS = {RGB332: (3, 3, 2), ARGB8332: (3, 3, 2), RGB565: (5, 6, 5), ARGB1555: (5, 5, 5),
        ARGB4444: (4, 4, 4)}


@dataclass(frozen=True)
class Map:
    """Levels of a format, the largest first: int64 [height, width], 8 or 16 bits per texel.
    ``palette``: int64 [256, 3]."""

    form: int
    levels: list[np.ndarray]
    palette: np.ndarray | None = None
    ncc: Ncc | None = None


def palette_of(pictures: Sequence[np.ndarray]) -> np.ndarray:
    """Returns a palette, uint8 [256, 3], for the colours of pictures: exact if they have at most
    256; unused entries are black."""
    pixels = np.concatenate([picture[..., :3].reshape(-1, 3) for picture in pictures])
    colours = np.unique(pixels, axis=0)
    if len(colours) > COLOURS:
        _, colours = reduced(pixels, COLOURS)
    palette = np.zeros((COLOURS, 3), np.uint8)
    palette[:len(colours)] = colours
    return palette


def alpha_bits(form: int, alpha: np.ndarray) -> np.ndarray | int:
    """Returns the alpha bits of texels, in their place."""
    alpha = alpha.astype(np.int64)
    if form in (ARGB8332, AYIQ8422, AI88, AP88):
        return alpha << 8
    if form == ARGB1555:
        return (alpha >= OPAQUE).astype(np.int64) << 15
    if form == ARGB4444:
        return quantised(alpha, 4) << 12
    if form == AI44:
        return quantised(alpha, 4) << 4
    return alpha if form == A8 else 0


def colour_bits(form: int, picture: np.ndarray, palette: np.ndarray | None,
                table: Ncc | None) -> np.ndarray | int:
    """Returns the colour bits of texels, int64 [height, width]."""
    if form in BITS:
        value = 0
        for channel, bits in enumerate(BITS[form]):
            value = value << bits | quantised(picture[..., channel], bits)
        return value
    if form in (P8, AP88):
        return nearest(picture[..., :3], palette).astype(np.int64)
    if form in (YIQ422, AYIQ8422):
        return ncc.indices(table, picture[..., :3])
    if form == AI44:
        return quantised(intensity(picture), 4)
    return intensity(picture) if form in (I8, AI88) else 0


def encode(pictures: Sequence[np.ndarray], form: int) -> Map:
    """Converts pictures, the levels of a map, to the nearest texels."""
    if form not in FORMATS:
        raise UserError(f"texture: there is no format {form}")
    palette = palette_of(pictures) if form in (P8, AP88) else None
    table = ncc.fit(pictures) if form in (YIQ422, AYIQ8422) else None
    made = [alpha_bits(form, picture[..., 3]) | colour_bits(form, picture, palette, table)
            for picture in pictures]
    return Map(form, made, None if palette is None else palette.astype(np.int64), table)


def decode(made: Map) -> list[np.ndarray]:
    """Returns the pictures of a map."""
    return [decoded(made.form, level, made.palette, made.ncc).astype(np.uint8)
            for level in made.levels]
