"""Plots the distance of affine pieces of a perspective span from the exact curve, along the
span."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from tmap.base.fixed import ONE
from tmap.ideal.perspective import Curve

#: Lengths of pieces in pixels, from the least to the most exact.
PIECES = (32, 16, 8, 4)
SPAN, TEXELS, RATIO = 256, 256, 4  # pixels, texels along them, the last depth over the first
LEAST = 1e-3  # texels: smaller errors are drawn as this on the logarithmic axis


def span(ratio: int = RATIO) -> Curve:
    """u from 0 to TEXELS over SPAN pixels of line 0; the depth grows from 1 to ``ratio``."""
    corners = [(0, 0), (SPAN << 16, 0), (0, ONE)]
    return Curve(corners, [0, TEXELS << 16, 0], [ONE, ratio * ONE, ONE])


def piece_errors(n: int, ratio: int = RATIO) -> np.ndarray:
    """Curve minus chord at every pixel of the span and its end, in texels; pieces of n pixels."""
    curve = span(ratio)
    errors = [curve.chord_errors(first, n, 0)[:n] for first in range(0, SPAN, n)]
    return np.array([float(error) for piece in errors for error in piece] + [0.0])


def plot(path: Path, ratio: int = RATIO) -> None:
    """Plots a curve for each length of piece, with its largest error in the legend."""
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
