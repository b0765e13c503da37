"""Mip maps for the texture unit: all levels of a picture, and their place in a unit's memory."""

from dataclasses import replace

import numpy as np

from tmap.base.errors import UserError
from tmap.glide.images import Map
from tmap.glide.registers import BASE_UNIT
from tmap.glide.state import LAST_ASPECT, LAST_LEVEL, SIDE, Unit
from tmap.glide.texels import level_bases, level_size, owns, texel_bytes
from tmap.images.mipmap import from_light, halved, rounded, to_light

ALPHA = 3
SEEN = 1 / 512  # below this alpha a texel's colour is not visible in 8 bits


def shape_of(width: int, height: int) -> tuple[int, int, int]:
    """Returns (largest level, wide, aspect) of a map whose largest level has these sides."""
    for side, name in ((width, "wide"), (height, "high")):
        if side < 1 or side & side - 1 or side > SIDE:
            raise UserError(f"mip map: {side} texels {name}; a power of two up to {SIDE} expected")
    longer, shorter = max(width, height), min(width, height)
    aspect = (longer // shorter).bit_length() - 1
    if aspect > LAST_ASPECT:
        raise UserError(f"mip map: {width} x {height} texels; sides may differ up to "
                        f"{1 << LAST_ASPECT} times")
    return LAST_LEVEL - longer.bit_length() + 1, int(width >= height), aspect


def levels(picture: np.ndarray, how: str = "kaiser", wrap: tuple[bool, bool] = (True, True),
           gamma: bool = True, by_alpha: bool = False) -> list[np.ndarray]:
    """Returns all levels of a picture, the largest first, down to 1 x 1, uint8 [height, width, 4].

    ``picture``: R, G, B, A, uint8 or float 0..1, of a legal size; ``how``: one of
    tmap.images.mipmap.FILTERS; ``wrap``: for s and t, true if the map repeats, false if it is
    clamped; ``gamma``: colours are sRGB and averaged as linear light; ``by_alpha``: a texel's
    colour is weighted by its alpha. Each level is made from the last one unrounded.
    """
    shape_of(*picture.shape[1::-1])
    whole = picture / 255 if picture.dtype == np.uint8 else picture.astype(np.float64)
    colours, alpha = whole[..., :ALPHA], whole[..., ALPHA:]
    if gamma:
        colours = to_light(colours)
    state = np.concatenate([colours, alpha, colours * alpha], -1)
    found = []
    while True:
        colours, alpha, weighed = np.split(state, [ALPHA, ALPHA + 1], -1)
        if by_alpha:
            colours = np.where(alpha < SEEN, colours, weighed / np.maximum(alpha, SEEN))
        shown = from_light(colours) if gamma else rounded(colours * 255)
        found.append(np.concatenate([shown, rounded(alpha * 255)], -1))
        if state.shape[:2] == (1, 1):
            return found
        state = halved(state, how, wrap)


def store(unit: Unit, made: Map, base: int = 0, odd: int | None = None) -> None:
    """Puts a map with its tables into a unit's memory and sets the modes: level 0 would start at
    byte ``base``. ``odd``: only its odd (1) or even (0) levels, as a split map."""
    if base % BASE_UNIT:
        raise UserError(f"mip map: base {base}: not a multiple of {BASE_UNIT} bytes")
    height, width = made.levels[0].shape
    largest, wide, aspect = shape_of(width, height)
    smallest = largest + len(made.levels) - 1
    modes = replace(unit.modes, format=made.form, wide=wide, aspect=aspect, base=base,
                    lod_min=largest << 2, lod_max=smallest << 2, split=int(odd is not None),
                    odd=odd or 0)
    bases, kind = level_bases(modes), "<u2" if texel_bytes(made.form) == 2 else "u1"
    memory = unit.memory.copy()
    for level, texels in enumerate(made.levels, largest):
        if texels.shape != level_size(modes, level)[::-1]:
            raise UserError(f"mip map: level {level} has {texels.shape[1]} x {texels.shape[0]} "
                            "texels")
        if owns(modes, level):
            data = np.frombuffer(texels.astype(kind).tobytes(), np.uint8)
            memory[bases[level] + np.arange(data.size) & memory.size - 1] = data
    unit.memory, unit.modes = memory, modes
    if made.palette is not None:
        unit.palette = made.palette
    if made.ncc is not None:
        unit.ncc[modes.ncc_table] = made.ncc
