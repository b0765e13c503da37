"""How far affine pieces of a perspective span are from the exact curve, along the span."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from tmap.base.fixed import ONE
from tmap.ideal.perspective import Curve

#: Pixels of a piece, from far off to near.
PIECES = (32, 16, 8, 4)
SPAN, TEXELS, RATIO = 256, 256, 4  # pixels, texels along them, depth of the last to the first's
LEAST = 1e-3  # texels: what the logarithmic axis shows for less


def span(ratio: int = RATIO) -> Curve:
    """u from 0 to TEXELS over SPAN pixels of line 0, the depth growing from 1 to ``ratio``."""
    corners = [(0, 0), (SPAN << 16, 0), (0, ONE)]
    return Curve(corners, [0, TEXELS << 16, 0], [ONE, ratio * ONE, ONE])


def piece_errors(n: int, ratio: int = RATIO) -> np.ndarray:
    """Curve less chord at every pixel of the span and at its end, in texels, with pieces of n
    pixels that are exact at their ends."""
    curve = span(ratio)
    errors = [curve.chord_errors(first, n, 0)[:n] for first in range(0, SPAN, n)]
    return np.array([float(error) for piece in errors for error in piece] + [0.0])


def plot(path: Path, ratio: int = RATIO) -> None:
    """A curve for each length of piece, its largest error in the legend."""
    figure, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
    for n in PIECES:
        errors = abs(piece_errors(n, ratio))
        axes.plot(errors.clip(LEAST), lw=1, label=f"{n} pixels: {errors.max():.2f}")
    axes.set_yscale("log")
    axes.set_xlim(0, SPAN)
    axes.set_xlabel(f"pixel ({TEXELS} texels, depth 1 to {ratio})")
    axes.set_ylabel("distance from the exact u, texels")
    axes.grid(alpha=0.3)
    axes.legend(title="piece, largest error", fontsize=8)
    figure.savefig(path, dpi=110)
    plt.close(figure)
