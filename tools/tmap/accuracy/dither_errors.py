"""Errors of dithered points against the bilinear filter that they replace.

The model draws a turned, enlarged map, point by point and dithered. Both are compared with the
exact bilinear filter of the same map at the same places: pixel by pixel, and as means over 2x2
pixels, because the eye blends them. The same means are taken of the filter's colours.
"""

import math

import numpy as np

from tmap.base import markdown
from tmap.base.elementary import cos, each, sin
from tmap.base.fixed import ONE
from tmap.model import model
from tmap.setup.spans import coordinates, coordinates_of, pixels

SIDE = 256  # pixels of the frame
MAP = 64  # texels
TURN = 0.3  # radians
SCALES = (2, 4, 8)  # pixels a texel
MAPPERS = {"points": "affine", "dithered": "dithered"}


def maps() -> dict[str, np.ndarray]:
    """Returns greys from 0 to 255: waves of 32 texels and less, and noise."""
    (y, x), turn = np.indices((MAP, MAP)), 2 * math.pi / MAP
    waves = each(cos, 2 * x * turn + 1) + each(cos, 3 * y * turn) + each(cos, (4 * x + 5 * y) * turn)
    return {"smooth": np.rint(127.5 + 42.5 * waves).astype(np.uint8),
            "noise": np.random.default_rng(5).integers(0, 256, (MAP, MAP), dtype=np.uint8)}


def square(scale: int) -> model.Polygon:
    """Returns the frame as a polygon filled with the map; a texel is ``scale`` pixels long."""
    def texel(x: int, y: int) -> list[int]:
        c, s, x, y = cos(TURN), sin(TURN), x - 91, y - 77
        return [round((x * c - y * s) / scale * ONE), round((x * s + y * c) / scale * ONE)]

    corners = [(x << 16, y << 16, *texel(x, y)) for x, y in
               ((0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE))]
    return model.set_up(corners, SIDE, SIDE, True)


def bilinear(picture: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The exact bilinear filter of a repeated map at u, v in texels. Texel centres are at 0.5."""
    i, j = (np.floor(c - 0.5).astype(int) for c in (u, v))
    fu, fv = u - 0.5 - i, v - 0.5 - j
    return sum(picture[(j + down) % MAP, (i + across) % MAP] * part * share
               for down, part in ((0, 1 - fv), (1, fv)) for across, share in ((0, 1 - fu), (1, fu)))


def errors(picture: np.ndarray, scale: int) -> dict[str, tuple[float, float]]:
    """Returns the mean errors of points and of dithered points: pixel by pixel, and blended."""
    def blended(frame: np.ndarray) -> np.ndarray:
        return (frame[1:, 1:] + frame[1:, :-1] + frame[:-1, 1:] + frame[:-1, :-1]) / 4

    polygon, found = square(scale), {}
    lines = list(enumerate(polygon.lines))
    exact = np.array([bilinear(picture, *(c / ONE for c in coordinates(line)))
                      for _, line in lines])
    for name, mapper in MAPPERS.items():
        stepped = coordinates_of(polygon.lines, range(len(lines)), mapper)
        drawn = pixels(polygon.lines, mapper, picture, None, stepped).reshape(len(lines), -1).astype(float)
        found[name] = tuple(float(abs(of(drawn) - of(exact)).mean()) for of in (np.array, blended))
    return found


def table() -> str:
    """Returns all errors as a Markdown table."""
    names = list(MAPPERS)
    rows = []
    for kind, picture in maps().items():
        for scale in SCALES:
            found = errors(picture, scale)
            rows.append([f"{kind}, a texel {scale} pixels long",
                         *(f"{found[name][k]:.2f}" for k in (0, 1) for name in names)])
    return markdown.table(["mean error in 1/255",
                           *(f"{name}{of}" for of in ("", ", means of 2x2") for name in names)], rows)
