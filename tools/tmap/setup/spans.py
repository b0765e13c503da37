"""The integer model's spans: the texel that a mapper shows at each pixel of a line."""

import numpy as np

from tmap.base.fixed import M32, counted, signed
from tmap.setup.dithered import moves
from tmap.setup.shading import LIT, rows
from tmap.setup.texturing import CUT, Line

#: The start of u and v in generated code, units: steps rounded to the nearest never make them late.
BIAS = 520
#: The least step of u at which generated code draws no line: 8 such steps leave the map's row.
STEEP_32 = 32 << 16


def coordinates(line: Line, mapper: str = "affine", y: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Returns ``coordinates_of`` a line at y."""
    return coordinates_of([line], [y], mapper)


def coordinates_of(lines: list[Line], ys: list[int], mapper: str) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of the pixels of lines, one after the other, as the mapper steps them, int64, 16.16 modulo 2^32;
    ``ys``: the lines', used only by the mapper that moves points. All lines are chains or none."""
    counts = [max(line.right - line.left, 0) for line in lines]
    n = counted(counts)
    if lines[0].chain:
        made = np.array([(*line.chain, line.v, signed(line.dvdx)) for line in lines], np.int64)
        chain, step, v, dv = np.repeat(made, counts, axis=0).T
        return (chain + n * step >> 24) & M32, v + n * dv & M32
    made = np.array([(line.u, line.v, signed(line.dudx), signed(line.dvdx)) for line in lines], np.int64)
    if mapper == "generated":  # the start's fraction is dropped
        made[:, :2] = (made[:, :2] & ~0xFFFF) + BIAS
    uv, steps = np.repeat(made, counts, axis=0).T.reshape(2, 2, -1)
    u, v = (((c >> cut) + n * (step >> cut)) << cut & M32 for c, step, cut in zip(uv, steps, CUT.get(mapper, (0, 0))))
    if mapper == "dithered":
        moved = moves(n + np.repeat([line.left for line in lines], counts), np.repeat(ys, counts))
        u, v = (c + move & M32 for c, move in zip((u, v), moved))
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


def fetched_by(lines: list[Line], mapper: str, size: tuple[int, int],
               stepped: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Returns ``fetched`` of several lines, one after the other."""
    if mapper != "generated":  # a pixel's texel depends on its u and v alone
        return fetched(lines[0], mapper, size, stepped)
    return tuple(map(np.concatenate, zip(*(fetched(line, mapper, size, stepped) for line in lines))))


def pixels(lines: list[Line], mapper: str, texture: np.ndarray | None, light: np.ndarray | None,
           stepped: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
    """Returns the pixels of lines, one after the other. ``texture``: [v][u]; ``light``: [level][texel], or one level's
    row; ``stepped``: u and v."""
    size = (256, 1) if texture is None else texture.shape[::-1]
    columns, rows_ = fetched_by(lines, mapper, size, stepped)
    if mapper == "gouraud":
        return columns
    texels = texture[rows_, columns]
    return lit(lines, texels, light) if mapper in LIT else texels


def lit(lines: list[Line], texels: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Returns the pixels of lit lines from their texels; ``light``: as in ``pixels``."""
    return light[rows(lines), texels] if light.ndim == 2 else light[texels]
