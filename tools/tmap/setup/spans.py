"""The integer model's spans: the texel that a mapper shows at each pixel of a line."""

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.setup.dithered import moves
from tmap.setup.shading import LIT, rows
from tmap.setup.texturing import CUT, Line

#: The start of u and v in generated code, units: steps rounded to the nearest never make them late.
BIAS = 520
#: The least step of u at which generated code draws no line: 8 such steps leave the map's row.
STEEP_32 = 32 << 16


def coordinates(line: Line, mapper: str = "affine", y: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of a line's pixels as the mapper steps them, int64, 16.16 modulo 2^32; ``y``:
    the line's, used only by the mapper that moves points."""
    n = np.arange(line.right - line.left, dtype=np.int64)
    if line.chain:
        return (line.chain[0] + n * line.chain[1] >> 24) & M32, \
            line.v + n * signed(line.dvdx) & M32
    start, cuts = (line.u, line.v), CUT.get(mapper, (0, 0))
    if mapper == "generated":  # the start's fraction is dropped
        start = [(c & ~0xFFFF) + BIAS for c in start]
    steps = (signed(line.dudx), signed(line.dvdx))
    u, v = (((c >> cut) + n * (step >> cut)) << cut & M32
            for c, step, cut in zip(start, steps, cuts))
    if mapper == "dithered":
        u, v = (c + move & M32 for c, move in zip((u, v), moves(line.left, line.right, y)))
    return u, v


def generated_offsets(dudx: int, dvdx: int, count: int) -> np.ndarray:
    """Returns the bytes from a line's first texel to the others, as in generated code."""
    n = np.arange(count, dtype=np.int64)
    far = 256 * (BIAS + n * signed(dvdx) >> 16) + (BIAS + n * signed(dudx) >> 16)
    return signed(far, 16)


def stays_in_row(line: Line) -> bool:
    """Returns true if generated code fetches all of a line's pixels in the correct rows of the map.
    u is monotonic along the line, so the last texel decides."""
    steps, dudx = line.right - line.left - 1, signed(line.dudx)
    last = (line.u >> 16 & 255) + (BIAS + steps * dudx >> 16)
    return steps < 0 or (abs(dudx) < STEEP_32 and 0 <= last <= 255)


def texel_generated(u: int, v: int, dudx: int, dvdx: int, count: int) -> np.ndarray:
    """Returns the offsets from texel (0, 0) at which generated code fetches a line's pixels,
    margins included."""
    return (v >> 8 & 0xFF00 | u >> 16 & 0xFF) + generated_offsets(dudx, dvdx, count)


def repeated(values: np.ndarray, side: int) -> np.ndarray:
    """Returns the columns of u, or the rows of v, in a map that repeats; ``side``: its texels."""
    return (values >> 16) % side


def fetched(line: Line, mapper: str, size: tuple[int, int],
            stepped: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Returns the column and row of the map that each pixel of a line shows; the column of Gouraud
    lines is the shade. ``size``: the map's width and height; ``stepped``: the line's
    ``coordinates``."""
    if mapper == "generated":
        at = texel_generated(line.u, line.v, line.dudx, line.dvdx, line.right - line.left)
        return at & 255, at >> 8 & 255  # the margins repeat the map
    u, v = stepped
    if mapper == "arbitrary":
        return u >> 16, v >> 16  # must be inside the map: an index beyond it is an error
    return repeated(u, 256 if mapper == "gouraud" else size[0]), repeated(v, size[1])


def pixels(line: Line, mapper: str, texture: np.ndarray | None,
           light: np.ndarray | None = None, y: int = 0) -> np.ndarray:
    """Returns a line's pixels. ``texture``: [v][u]; ``light``: [level][texel], or one level's row;
    ``y``: as in ``coordinates``."""
    size = (256, 1) if texture is None else texture.shape[::-1]
    columns, rows_ = fetched(line, mapper, size, coordinates(line, mapper, y))
    if mapper == "gouraud":
        return columns
    texels = texture[rows_, columns]
    return lit(line, texels, light) if mapper in LIT else texels


def lit(line: Line, texels: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Returns a lit line's pixels from its texels; ``light``: as in ``pixels``."""
    return light[rows(line), texels] if light.ndim == 2 else light[texels]
