"""Pictures as textures in DRAM, in the N64's formats, and back.

A picture is uint8 [height, width, 4], R, G, B, A. A texture's rows are padded for every kind of
load: the last texel is repeated up to whole words of TMEM.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tmap.base.colours import OPAQUE, intensity, quantised, reduced
from tmap.base.errors import UserError
from tmap.images import images
from tmap.images.mipmap import halved, rounded
from tmap.n64.filters import convert
from tmap.n64.state import CI, FORMATS, I, IA, LEGAL, RGBA, YUV
from tmap.n64.texels import grey, ia16, rgba16

CONSTANTS = (175, -43, -89, 222, 114, 42)  # K0..K5 that convert video's YUV


@dataclass(frozen=True)
class Texture:
    """A texture in DRAM. ``form``, ``size``: as in set tile; ``width``, ``height``: texels;
    ``row_texels``: those of a row with its padding; ``data``: rows, big-endian; ``tlut``: 16-bit
    entries if ``form`` is CI; ``ia``: they are IA16, not RGBA16."""

    form: int
    size: int
    width: int
    height: int
    row_texels: int
    data: bytes
    tlut: bytes = b""
    ia: bool = False


def read(reference: str, folder: Path, where: str, width: int, height: int) -> np.ndarray:
    """Reads a picture of the given size from a PNG or JPEG, found and cut by tmap.images.images."""
    return images.load(reference, folder, where, width, height, "RGBA")


def to_rgba16(picture: np.ndarray) -> np.ndarray:
    """Converts to 16-bit texels 5, 5, 5, 1."""
    r, g, b = (quantised(picture[..., k], 5) for k in range(3))
    return r << 11 | g << 6 | b << 1 | (picture[..., 3] >= OPAQUE)


def to_ia16(picture: np.ndarray) -> np.ndarray:
    """Converts to 16-bit texels of intensity and alpha."""
    return intensity(picture) << 8 | picture[..., 3]


def nibbles(texels: np.ndarray) -> np.ndarray:
    """Packs 4-bit texels into bytes, even ones high."""
    return texels[:, ::2] << 4 | texels[:, 1::2]


def alignment(form: int, size: int) -> int:
    """Returns the texels in one 64-bit word of TMEM; for wide texels and YUV, in one of each
    half."""
    return 8 if form == YUV else 4 if size == 3 else 16 >> size


def padded(picture: np.ndarray, unit: int) -> np.ndarray:
    """Pads rows to a multiple of ``unit`` texels by repeating their last ones."""
    return np.pad(picture, ((0, 0), (0, -picture.shape[1] % unit), (0, 0)), "edge")


def palette_of(picture: np.ndarray, count: int, ia: bool) -> tuple[np.ndarray, np.ndarray]:
    """Returns (indices [height, width], entries [at most count]): exact if the picture has no more
    than ``count`` colours of 16 bits, else Pillow's choice; transparent texels share entry 0."""
    values = to_ia16(picture) if ia else to_rgba16(picture)
    entries, indices = np.unique(values, return_inverse=True)
    if entries.size <= count:
        return indices.reshape(values.shape), entries
    if ia:  # two channels as three, alpha twice
        pairs = np.stack([values >> 8, values & 255], -1).astype(np.uint8).reshape(-1, 2)
        indices, palette = reduced(pairs[:, [0, 1, 1]], count)
        entries = palette[:, 0].astype(np.int64) << 8 | palette[:, 1]
        return indices.reshape(values.shape), entries
    opaque = picture[..., 3] >= OPAQUE
    first = 0 if opaque.all() else 1
    indices = np.zeros(values.shape, np.int64)
    found, palette = reduced(picture[opaque][:, :3], count - first)
    indices[opaque] = found + first
    colours = np.pad(palette, ((0, 0), (0, 1)), constant_values=255)
    entries = np.concatenate([np.zeros(first, np.int64), to_rgba16(colours)])
    return indices, entries


def nearest(number: np.ndarray, parts: int) -> np.ndarray:
    """Divides integers by ``parts``, rounded to the nearest, halves up."""
    return (2 * number + parts) // (2 * parts)


def to_yuv(picture: np.ndarray) -> np.ndarray:
    """Returns bytes U0 Y0 V0 Y1 .. of a picture of even width, by the inverse of the conversion
    with CONSTANTS: K4 and K5 reduce the contrast of colours, and two texels share their chroma."""
    k0, k1, k2, k3 = (2 * k + 1 for k in CONSTANTS[:4])
    k4, k5 = CONSTANTS[4:]
    # R = Y + k0 V / 256, G = Y + (k1 U + k2 V) / 256, B = Y + k3 U / 256 solved for Y, U, V, all
    # times ``scale``
    scale = k0 * k3 - k0 * k1 - k2 * k3
    r, g, b = (256 * picture[..., c].astype(np.int64) + k4 * k5 for c in range(3))  # 256 + k5 times
    y = k0 * k3 * g - k0 * k1 * b - k2 * k3 * r
    u, v = ((scale * channel - y) * 256 for channel in (b, r))  # k3, k0 times
    u, v = (chroma[:, ::2] + chroma[:, 1::2] for chroma in (u, v))
    y, u, v = (nearest(number, parts) for number, parts in (
        (y, scale * (256 + k5)), (u, 2 * k3 * scale * (256 + k5)), (v, 2 * k0 * scale * (256 + k5))))
    made = np.stack([u + 128, y[:, ::2], v + 128, y[:, 1::2]], -1)
    return np.clip(made, 0, 255).astype(np.uint8)


def encode(picture: np.ndarray, form: int, size: int, ia: bool = False) -> Texture:
    """Converts a picture to a texture; ``ia``: a CI texture's palette contains IA16."""
    if (form, size) not in LEGAL:
        name = FORMATS[form] if form in range(len(FORMATS)) else f"format {form}"
        raise UserError(f"texture: there is no {name} of {4 << size} bits")
    height, width = picture.shape[:2]
    full = padded(picture, alignment(form, size))
    tlut = b""
    if form == RGBA:
        data = to_rgba16(full).astype(">u2") if size == 2 else full
    elif form == YUV:
        data = to_yuv(full)
    elif form == CI:
        indices, entries = palette_of(full, 16 if size == 0 else 256, ia)
        tlut = entries.astype(">u2").tobytes()
        data = (indices if size else nibbles(indices)).astype(np.uint8)
    elif form == IA:
        i, alpha = intensity(full), full[..., 3]
        if size == 2:
            data = to_ia16(full).astype(">u2")
        elif size == 1:
            data = (quantised(i, 4) << 4 | quantised(alpha, 4)).astype(np.uint8)
        else:
            data = nibbles(quantised(i, 3) << 1 | (alpha >= OPAQUE)).astype(np.uint8)
    else:
        i = intensity(full)
        data = (i if size else nibbles(quantised(i, 4))).astype(np.uint8)
    return Texture(form, size, width, height, full.shape[1], data.tobytes(), tlut, ia)


def decode(texture: Texture) -> np.ndarray:
    """Converts a texture to its picture, without the padding."""
    form, size = texture.form, texture.size
    data = np.frombuffer(texture.data, np.uint8)
    rows = data.reshape(texture.height, -1)
    if size == 0:
        value = np.stack([rows >> 4, rows & 15], -1).reshape(texture.height, -1).astype(np.int64)
    elif size == 1:
        value = rows.astype(np.int64)
    else:
        value = data.view(">u2").reshape(texture.height, -1).astype(np.int64)
    if form == YUV:
        picture = from_yuv(rows)
    elif form == RGBA:
        picture = rows.reshape(texture.height, -1, 4) if size == 3 else rgba16(value)
    elif form == CI:
        entries = np.frombuffer(texture.tlut, ">u2").astype(np.int64)
        picture = (ia16 if texture.ia else rgba16)(entries)[value]
    elif form == I:
        picture = grey(value, value) if size else grey(value * 17, value * 17)
    elif size == 2:
        picture = ia16(value)
    elif size == 1:
        picture = grey((value >> 4) * 17, (value & 15) * 17)
    else:
        i = value >> 1
        picture = grey(i << 5 | i << 2 | i >> 1, (value & 1) * 255)
    return np.ascontiguousarray(picture[:, :texture.width]).astype(np.uint8)


def from_yuv(rows: np.ndarray) -> np.ndarray:
    """Returns the picture of bytes U0 Y0 V0 Y1 .., opaque, converted by CONSTANTS."""
    u, y0, v, y1 = (rows[:, k::4].astype(np.int64) for k in range(4))
    texels = np.stack([np.stack([u - 128, v - 128, y, y], -1) for y in (y0, y1)], 2)
    colours = convert(list(CONSTANTS), texels.reshape(rows.shape[0], -1, 4))[..., :3]
    colours = np.where(colours >= 384, colours - 512, colours)
    bright = (colours - CONSTANTS[4]) * CONSTANTS[5] + (colours << 8) + 128 >> 8
    opaque = np.full((*bright.shape[:2], 1), 255)
    return np.concatenate([np.clip(bright, 0, 255), opaque], -1)


def chain(picture: np.ndarray, levels: int) -> list[np.ndarray]:
    """Returns a picture and its coarser levels: each texel is the mean of up to 2x2, rounded; sides
    halve down to 1."""
    pictures = [picture]
    for _ in range(levels - 1):
        height, width = pictures[-1].shape[:2]
        if any(side > 1 and side & 1 for side in (width, height)):
            raise UserError(f"mip map: a level of {width} x {height} texels has no half")
        pictures.append(rounded(halved(pictures[-1].astype(np.float64))))
    return pictures
