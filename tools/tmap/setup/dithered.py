"""The integer model's dithering: how far points are moved (src68k/span/dithered.s).

The points of 2x2 pixels are the corners of a square around their middle, turned so that along
either axis they are at -3, -1, 1 and 3 eighths of a texel. The bilinear filter's colour is the mean
over all points within half a texel of a place in both directions. The mean of the four points
approximates it. A pixel's point moves by 3/8 texel at most in u and in v, exactly: moves are whole
units.
"""

import numpy as np

#: 16.16 texels.
EIGHTH = 0x2000
#: Moves of u and v in eighths, [y & 1][x & 1].
MOVES = np.array([[(-1, -3), (3, -1)], [(-3, 1), (1, 3)]], np.int64)
#: The largest, in texels.
MOST = 3 / 8


def moves(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the moves of u and v for pixels, 16.16."""
    moved = MOVES[y & 1, x & 1] * EIGHTH
    return moved[:, 0], moved[:, 1]
