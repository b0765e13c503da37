"""Sums of a renderer's errors against the exact ideal."""

import math
from dataclasses import dataclass

import numpy as np

from tmap.ideal import ideal
from tmap.model import model
from tmap.model.model import Settings


@dataclass
class Errors:
    """Sums over the pixels of a set. A pixel's error is the larger of the errors of u and v."""

    coverage: int = 0  # pixels drawn outside the ideal or missing inside it
    ideal_pixels: int = 0
    pixels: int = 0  # drawn
    worst: float = 0.0  # texels, the largest of all pixels
    squares: float = 0.0  # of texels
    wrong: int = 0  # pixels that show another texel than the ideal

    def add(self, polygon: model.Polygon | None, exact: ideal.Picture, settings: Settings) -> None:
        """Adds a polygon after set-up, compared with the exact one."""
        lines = {polygon.top + k: line for k, line in enumerate(polygon.lines)} if polygon else {}
        self.ideal_pixels += exact.pixels
        for y in lines.keys() | exact.extents.keys():
            line = lines.get(y)
            left, right = (line.left, max(line.left, line.right)) if line else (0, 0)
            first, end = exact.extents.get(y, (0, 0))
            both = max(0, min(right, end) - max(left, first))
            self.coverage += right - left + end - first - 2 * both
            self.pixels += right - left
            if right > left and settings.mapper != "flat":
                self.texels(polygon.coordinates(y), line.left, y, exact)

    def texels(self, found, left: int, y: int, exact: ideal.Picture) -> None:
        """Adds u and v of a line's pixels from ``left`` on. Only pixels inside the polygon count,
        unless the ideal is endless."""
        columns = np.arange(left, left + len(found[0]))
        first, end = (left, columns[-1] + 1) if exact.endless else exact.extents.get(y, (0, 0))
        inside = (columns >= first) & (columns < end)
        if not inside.any():
            return
        found, columns = [c[inside] for c in found], columns[inside]
        worst, wrong = np.zeros(len(columns)), np.zeros(len(columns), bool)
        for values, plane in zip(found, exact.planes):
            error = plane.errors(values, columns, y)
            worst = np.maximum(worst, abs(error))
            fraction = (values & 0xFFFF) / 65536 - error  # of the exact value
            wrong |= (fraction < 0) | (fraction >= 1)
        self.worst = max(self.worst, float(worst.max()))
        self.squares += float((worst * worst).sum())
        self.wrong += int(wrong.sum())

    @property
    def rms(self) -> float:
        """Root mean square over all pixels of the larger of u's and v's errors, in texels."""
        return math.sqrt(self.squares / max(self.pixels, 1))

    def figures(self) -> dict:
        """Returns the error columns of a row."""
        pixels = max(self.pixels, 1)
        return {"coverage_errors_per_million": round(1e6 * self.coverage / self.ideal_pixels, 2),
                "texel_error_max": round(self.worst, 6),
                "texel_error_rms": round(self.rms, 6),
                "wrong_texels_percent": round(100 * self.wrong / pixels, 4)}
