"""The integer model's spans: which texel a mapper shows at each pixel of a line."""

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.setup.dithered import moves
from tmap.setup.shading import LIT, rows
from tmap.setup.texturing import CUT, Line

#: What u and v of generated code begin with, units: no step, rounded to the nearest, makes them late.
BIAS = 520
#: Steps of u from which on lines are not drawn by generated code: 8 of them leave the map's row.
STEEP = 32 << 16


def coordinates(line: Line, mapper: str = "affine", y: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """u and v of a line's pixels as the mapper steps them, int64, 16.16 modulo 2^32; ``y`` of the
    line counts where it moves points."""
    n = np.arange(line.right - line.left, dtype=np.int64)
    start, cuts = (line.u, line.v), CUT.get(mapper, (0, 0))
    if mapper == "generated":  # of the start only the texel counts
        start = [(c & ~0xFFFF) + BIAS for c in start]
    steps = (signed(line.dudx), signed(line.dvdx))
    u, v = (((c >> cut) + n * (step >> cut)) << cut & M32
            for c, step, cut in zip(start, steps, cuts))
    if mapper == "dithered":
        u, v = (c + move & M32 for c, move in zip((u, v), moves(line.left, line.right, y)))
    return u, v


def generated_offsets(dudx: int, dvdx: int, count: int) -> np.ndarray:
    """Bytes from a line's first texel to its others, as generated code has them."""
    n = np.arange(count, dtype=np.int64)
    far = 256 * (BIAS + n * signed(dvdx) >> 16) + (BIAS + n * signed(dudx) >> 16)
    return signed(far, 16)


def stays_in_row(line: Line) -> bool:
    """Whether generated code fetches all of a line's pixels in their own rows of the map: u's texels
    rise or fall along the line, so the last one decides."""
    steps, dudx = line.right - line.left - 1, signed(line.dudx)
    last = (line.u >> 16 & 255) + (BIAS + steps * dudx >> 16)
    return steps < 0 or (abs(dudx) < STEEP and 0 <= last <= 255)


def texel_generated(u: int, v: int, dudx: int, dvdx: int, count: int) -> np.ndarray:
    """Where generated code fetches a line's pixels: offsets from texel (0, 0), margins included."""
    return (v >> 8 & 0xFF00 | u >> 16 & 0xFF) + generated_offsets(dudx, dvdx, count)


def repeated(values: np.ndarray, side: int) -> np.ndarray:
    """The columns, or rows, in which u, or v, shows a map that repeats; ``side``: its texels."""
    return (values >> 16) % side


def fetched(line: Line, mapper: str, size: tuple[int, int],
            stepped: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Column and row of the map that each pixel of a line shows; Gouraud lines have the shade as
    column. ``size``: the map's width and height; ``stepped``: the line's ``coordinates``."""
    if mapper == "generated":
        at = texel_generated(line.u, line.v, line.dudx, line.dvdx, line.right - line.left)
        return at & 255, at >> 8 & 255  # the margins repeat the map
    u, v = stepped
    if mapper == "arbitrary":
        return u >> 16, v >> 16  # they are inside: an index beyond is an error
    return repeated(u, 256 if mapper == "gouraud" else size[0]), repeated(v, size[1])


def pixels(line: Line, mapper: str, texture: np.ndarray | None,
           light: np.ndarray | None = None, y: int = 0) -> np.ndarray:
    """A line's pixels. ``texture``: [v][u]; ``light``: [level][texel], or of one level; ``y`` as
    ``coordinates`` has it."""
    size = (256, 1) if texture is None else texture.shape[::-1]
    columns, rows_ = fetched(line, mapper, size, coordinates(line, mapper, y))
    if mapper == "gouraud":
        return columns
    texels = texture[rows_, columns]
    if mapper not in LIT:
        return texels
    return light[rows(line), texels] if light.ndim == 2 else light[texels]
