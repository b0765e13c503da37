"""Tables of narrow-channel compression fitted to pictures.

A colour is Y[y] + I[i] + Q[q], clamped to 0..255: 256 colours from 40 numbers. A fit iterates two
steps, like k-means: each colour takes the nearest of the 256; then least squares give the best
numbers for that choice, which are rounded. The fit ends when the error no longer falls, and is
never worse than any of the tables that it starts from. In 256 x 256 photographs the channels are
off by 3 to 5 in the root mean square, a third of RGB332's error; for fully saturated colours of all
hues RGB332 is better.

Choices and errors are integers; the numbers between them are added and multiplied in a stated
order, so that every processor finds the same table.
"""

import math
from collections.abc import Sequence

import numpy as np

from tmap.base import linear
from tmap.base.linear import length, product
from tmap.glide.state import YIQ422, Ncc
from tmap.glide.texels import decoded
from tmap.images.palette import nearest

MOST_COLOURS = 1 << 13  # in a fit
PATIENCE = 4  # a fit ends after this many rounds without a smaller error
STILL = 2.0 ** -10  # weight of keeping an entry unchanged, relative to one colour
FINE = (np.arange(4) - 1.5) / 4  # quarters of a step
Y, I, Q = slice(0, 16), slice(16, 20), slice(20, 24)


def colours_of(table: Ncc) -> np.ndarray:
    """Returns the colours of a table's bytes, uint8 [256, 3]."""
    return decoded(YIQ422, np.arange(256), ncc=table)[:, :3].astype(np.uint8)


def indices(table: Ncc, colours: np.ndarray) -> np.ndarray:
    """Returns the byte nearest to each colour, uint8 [..., 3]; int64 [...]."""
    return nearest(colours, colours_of(table)).astype(np.int64)


def quantiles(values: np.ndarray, counts: np.ndarray, number: int) -> np.ndarray:
    """Returns the medians of ``number`` parts with equally many values each."""
    order = np.argsort(values, kind="stable")
    below = np.cumsum(counts[order]) * 2 * number
    at = np.searchsorted(below, (2 * np.arange(number) + 1) * counts.sum())
    return values[order][at]


def fine_greys() -> Ncc:
    """Returns a table that has all greys exactly: Y in steps of 16, I of 4, Q of 1."""
    step = np.arange(4)[:, None] * np.ones(3, np.int64)
    return Ncc(np.arange(16) * 16, 4 * step, step)


def axes(rest: np.ndarray, counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the unit vectors along which colours minus their greys, int64 [n, 3], differ most and
    least: the eigenvectors of a 2 x 2 matrix, in the plane orthogonal to grey."""
    r, g, b = rest.T
    x, y = r - g, r + g - 2 * b  # times sqrt 2, sqrt 6
    xx, xy, yy = (float((counts * p).sum()) for p in (x * x, x * y, y * y))
    half, across = (xx - yy / 3) / 2, xy / math.sqrt(3)
    far = math.sqrt(half * half + across * across)
    u, v = (half + far, across) if half > 0 else (across, far - half)
    u, v = (u / length((u, v)), v / length((u, v))) if far else (1.0, 0.0)
    return tuple(a / math.sqrt(2) * np.array([1, -1, 0]) + b / math.sqrt(6) * np.array([1, 1, -2])
                 for a, b in ((u, v), (-v, u)))


def starts(colours: np.ndarray, counts: np.ndarray) -> list[Ncc]:
    """Returns tables to start from: all greys; and tables with Y from the colours' means, I along
    the axis on which they differ most from grey, and Q along the other one, or in finer steps along
    the first or of grey."""
    thrice = colours.sum(1, dtype=np.int64)  # three times grey and rest: integers
    rest = 3 * colours.astype(np.int64) - thrice[:, None]
    y = np.rint(quantiles(thrice, counts, 16) / 3).astype(np.int64)
    most, least = axes(rest, counts)
    first, second = (quantiles(product(rest, axis), counts, 4)[:, None] / 3 * axis
                     for axis in (most, least))
    fine_y = np.ptp(y) / 15 * FINE[:, None] * np.ones(3)
    fine = np.ptp(first, 0) / 3 * FINE[:, None] * np.sign(most)
    return [fine_greys(), *(Ncc(y, np.rint(first).astype(np.int64), np.rint(q).astype(np.int64))
                            for q in (second, fine, fine_y))]


def solved(table: Ncc, chosen: np.ndarray, off: np.ndarray, counts: np.ndarray) -> Ncc:
    """Returns the table that fits the bytes chosen for colours best, up to rounding; numbers that
    do not matter for them change least. ``off`` [n, 3]: the colours minus those of ``table``; if a
    sum is clamped to 0..255, the wanted change is relative to the clamped value."""
    entries = [Y.start + (chosen >> 4), I.start + (chosen >> 2 & 3), Q.start + (chosen & 3)]
    pairs = sum(np.bincount(24 * a + b, counts, 24 * 24) for a in entries for b in entries)
    pairs = pairs.reshape(24, 24)  # floats with integer values, like sums
    sums = np.stack([sum(np.bincount(a, counts * channel, 24) for a in entries)
                     for channel in off.T], -1)
    left, right = STILL * np.eye(40), np.zeros(40)
    left[Y, Y] += 3 * pairs[Y, Y]
    right[Y] = sums[Y].sum(1)
    chroma = slice(16, 24)
    for channel in range(3):  # channels share Y; each has its own I and Q
        own = slice(16 + 8 * channel, 24 + 8 * channel)
        left[own, own] += pairs[chroma, chroma]
        right[own] = sums[chroma, channel]
        left[Y, own], left[own, Y] = pairs[Y, chroma], pairs[chroma, Y]
    change = linear.solved(left, right)
    y, colours = np.rint(table.y + change[Y]), change[16:].reshape(3, 8).T
    i, q = (np.clip(np.rint(old + new), -256, 255).astype(np.int64)
            for old, new in ((table.i, colours[:4]), (table.q, colours[4:])))
    return Ncc(np.clip(y, 0, 255).astype(np.int64), i, q)


def refined(table: Ncc, colours: np.ndarray, counts: np.ndarray) -> tuple[int, Ncc]:
    """Returns (sum of squared errors, table), the best found when starting from a table."""
    best, since = (None, table), 0
    while since < PATIENCE:
        chosen = indices(table, colours)
        off = colours - colours_of(table)[chosen].astype(np.int64)
        found = int((counts[:, None] * off * off).sum())
        since += 1
        if best[0] is None or found < best[0]:
            best, since = (found, table), 0
        table = solved(table, chosen, off, counts)
    return best


def grouped(pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns (colours [m, 3], counts [m]) of pixels [n, 3], uint8: all colours, or, if there are
    more than MOST_COLOURS, the means of those with equal upper bits."""
    for bits in range(8):
        cells, where = np.unique(pixels >> bits, axis=0, return_inverse=True)
        if len(cells) <= MOST_COLOURS:
            break
    counts = np.bincount(where)
    sums = np.stack([np.bincount(where, pixels[:, channel]) for channel in range(3)], -1)
    return np.rint(sums / counts[:, None]).astype(np.uint8), counts


def fit(pictures: Sequence[np.ndarray]) -> Ncc:
    """Returns a table fitted to pictures, uint8 [height, width, 3 or more]."""
    colours, counts = grouped(np.concatenate([p[..., :3].reshape(-1, 3) for p in pictures]))
    return min((refined(table, colours, counts) for table in starts(colours, counts)),
               key=lambda found: found[0])[1]
