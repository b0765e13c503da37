"""What a check finds: a polygon's errors, the largest of them beside its bound, and the first excess in words."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tmap.ideal.bounds_coverage import FLOAT, LARGEST


@dataclass
class Verdict:
    """The errors of one polygon. Texel errors in texels (shades)."""

    pixels: int = 0
    coverage_errors: int = 0  # pixels lit or left out against the exact polygon
    texel_error: float = 0.0  # the largest
    texel_bound: float = 0.0  # at the same pixel
    texel_ratio: float = 0.0  # the largest error / bound of a pixel
    unsure: int = 0  # polygons drawn affine though w differs
    complaint: str = ""  # the first excess found, in words

    def complain(self, text: str) -> None:
        """Notes an excess, if it is the first."""
        self.complaint = self.complaint or text

    def note(self, error: float, bound: float) -> None:
        """Notes a pixel's error, if it is the largest."""
        if error > self.texel_error or not self.texel_bound:
            self.texel_error, self.texel_bound = float(error), float(bound)

    def merge(self, other: "Verdict") -> None:
        """Takes the worse of both."""
        self.pixels += other.pixels
        self.coverage_errors += other.coverage_errors
        self.unsure += other.unsure
        self.note(other.texel_error, other.texel_bound)
        self.texel_ratio = max(self.texel_ratio, other.texel_ratio)
        self.complain(other.complaint)


def add_errors(errors: np.ndarray, below: np.ndarray, above: np.ndarray, at: Callable,
               out: Verdict) -> None:
    """Adds pixels' errors to a verdict; ``below``, ``above``: how far they may be; ``at``: returns the name of the
    value and the pixel of an index."""
    most, k = np.maximum(below, above), int(abs(errors).argmax())
    out.note(abs(errors[k]), most[k])
    bound = np.where(errors >= 0, above, below)
    judged = (most < LARGEST) & (errors != 0)
    ratio = np.where(judged, np.where(bound > 0, abs(errors) / np.where(bound > 0, bound, 1.0), 2.0), 0.0)
    out.texel_ratio = max(out.texel_ratio, float(ratio.max()))
    for k in np.flatnonzero(ratio > FLOAT)[:1].tolist():
        key, pixel = at(k)
        out.complain(f"{key} at pixel {pixel} is {errors[k]:.9f} off the exact value, "
                     f"{-below[k]:.9f} to {above[k]:.9f} are allowed")
