"""The state of a texture unit: modes, texture memory, palette, NCC tables.

Coordinates S, T are 14.18, W is 2.30, levels of detail 8.8, all signed. Colours are int64 arrays
[..., 4], R, G, B, A of 0..255. s and t run from 0 to 256 along a map's longer side.
"""

from dataclasses import dataclass, field

import numpy as np

from tmap.base.errors import UserError

(RGB332, YIQ422, A8, I8, AI44, P8, _, _, ARGB8332, AYIQ8422, RGB565, ARGB1555, ARGB4444, AI88,
 AP88) = range(15)
FORMATS = {RGB332: "RGB332", YIQ422: "YIQ422", A8: "A8", I8: "I8", AI44: "AI44", P8: "P8",
           ARGB8332: "ARGB8332", AYIQ8422: "AYIQ8422", RGB565: "RGB565", ARGB1555: "ARGB1555",
           ARGB4444: "ARGB4444", AI88: "AI88", AP88: "AP88"}
FIRST_WIDE = ARGB8332  # formats from this one on have 16 bits per texel

COORDINATE_BITS = 18  # fraction bits of S and T
ONE_W = 1 << 30
SIDE_BITS = 8  # a side of level 0 is at most 2^8 texels
SIDE = 1 << SIDE_BITS
LAST_LEVEL = SIDE_BITS
LEVELS = LAST_LEVEL + 1
LAST_ASPECT = 3  # 8:1
UNIT_MEMORY = 1 << 18
REACH = 8192  # |s| and |t| of vertices, and the differences between two, are below this
W_MAX = 16384  # the largest |w| of a vertex
VOODOO_BITS, VOODOO2_BITS = 4, 8  # fraction bits of filter weights
SUBDIVISIONS = (0, 8, 16)  # pixels; 0: every pixel is divided

ZERO, LOCAL, OTHER_ALPHA, LOCAL_ALPHA, DETAIL, LOD_FRACTION = range(6)  # mselect


@dataclass(frozen=True)
class Combination:
    """Half of the combine unit. ``mselect``: the factor, 0..5; the others are 0 or 1. In the colour
    half ``add_local`` adds the texel's own channel; in the alpha half both add its alpha."""

    zero_other: int = 0
    sub_local: int = 0
    mselect: int = ZERO
    reverse: int = 0
    add_local: int = 0
    add_alpha_local: int = 0
    invert: int = 0


@dataclass(frozen=True)
class Modes:
    """The registers' content. Fields are flags, 0 or 1, except: ``format``, a key of FORMATS;
    ``lod_min``, ``lod_max``: u4.2; ``lod_bias``: s4.2; ``aspect``: 0..3, the shorter side is the
    longer one >> aspect; ``detail_scale``: 0..7, ``detail_bias``: -32..31, ``detail_max``: 0..255;
    ``base``: the byte where level 0 would start; ``fraction_bits``: those of filter weights, 4 or
    8; ``subdivision``: pixels from one exact quotient to the next, 8 or 16; 0: every pixel has one.
    ``wide``: s is the longer side; ``odd``: the levels of a ``split`` map; ``table_quotients``: 1:
    s / w by the hardware's reciprocals, 0: exact; ``dithered``: 1: moved points may replace the
    bilinear filter."""

    perspective: int = 0
    minify: int = 0
    magnify: int = 0
    clamp_negative_w: int = 0
    dither: int = 0
    ncc_table: int = 0
    clamp_s: int = 0
    clamp_t: int = 0
    format: int = RGB565
    trilinear: int = 0
    rgb: Combination = Combination()
    alpha: Combination = Combination()
    lod_min: int = 0
    lod_max: int = LAST_LEVEL << 2
    lod_bias: int = 0
    odd: int = 0
    split: int = 0
    wide: int = 0
    aspect: int = 0
    detail_max: int = 0
    detail_scale: int = 0
    detail_bias: int = 0
    base: int = 0
    fraction_bits: int = VOODOO_BITS
    table_quotients: int = 0
    dithered: int = 0
    subdivision: int = 0

    def __post_init__(self):
        if self.format not in FORMATS:
            raise UserError(f"texture unit: format {self.format}: there is no such format")


@dataclass
class Ncc:
    """A table of narrow-channel compression. ``y``: [16], 0..255; ``i``, ``q``: [4, 3], R, G, B,
    -256..255."""

    y: np.ndarray = field(default_factory=lambda: np.zeros(16, np.int64))
    i: np.ndarray = field(default_factory=lambda: np.zeros((4, 3), np.int64))
    q: np.ndarray = field(default_factory=lambda: np.zeros((4, 3), np.int64))


@dataclass
class Unit:
    """A texture unit. ``memory``: uint8 [a power of two], 16-bit texels little-endian;
    ``palette``: int64 [256, 3]."""

    modes: Modes = field(default_factory=Modes)
    memory: np.ndarray = field(default_factory=lambda: np.zeros(UNIT_MEMORY, np.uint8))
    palette: np.ndarray = field(default_factory=lambda: np.zeros((256, 3), np.int64))
    ncc: list[Ncc] = field(default_factory=lambda: [Ncc(), Ncc()])


def unpacked(argb: np.ndarray | int) -> np.ndarray:
    """Converts longs A R G B to channels R, G, B, A, [..., 4]."""
    argb = np.asarray(argb, np.int64)
    return np.stack([argb >> shift & 255 for shift in (16, 8, 0, 24)], -1)


def packed(colour: np.ndarray) -> np.ndarray:
    """Converts channels [..., 4] to longs A R G B."""
    r, g, b, a = (colour[..., k] for k in range(4))
    return a << 24 | r << 16 | g << 8 | b
