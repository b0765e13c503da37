"""What a renderer's pixels are off the exact ideal, summed up."""

import math
from dataclasses import dataclass

import numpy as np

from tmap.ideal import ideal
from tmap.model import model
from tmap.model.model import Settings


@dataclass
class Errors:
    """Sums over the pixels of a set. Where u and v are both off, the larger of the two counts."""

    coverage: int = 0  # pixels lit or left out against the ideal
    ideal_pixels: int = 0
    pixels: int = 0  # drawn
    worst: float = 0.0  # texels, of any pixel
    squares: float = 0.0  # of texels
    wrong: int = 0  # pixels that show another texel than the ideal

    def add(self, polygon: model.Polygon | None, exact: ideal.Picture, settings: Settings) -> None:
        """Adds a polygon as it was set up, compared with the exact one."""
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
                self.texels(polygon.coordinates(line, y), line.left, y, exact)

    def texels(self, found, left: int, y: int, exact: ideal.Picture) -> None:
        """Adds u and v of a line's pixels from ``left`` on; where the ideal ends with the polygon,
        of those in it."""
        columns = np.arange(left, left + len(found[0]))
        first, end = (left, columns[-1] + 1) if exact.endless else exact.extents.get(y, (0, 0))
        inside = (columns >= first) & (columns < end)
        if inside.any():
            self.compare([c[inside] for c in found], columns[inside], y, exact)

    def compare(self, found, columns: np.ndarray, y: int, exact: ideal.Picture) -> None:
        """Adds u and v that were found at pixels of a line, next to each other."""
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
        """Root of the mean square over all pixels, of the larger of u's and v's errors, texels."""
        return math.sqrt(self.squares / max(self.pixels, 1))

    def figures(self) -> dict:
        """The error columns of a row."""
        pixels = max(self.pixels, 1)
        return {"coverage_errors_per_million": round(1e6 * self.coverage / self.ideal_pixels, 2),
                "texel_error_max": round(self.worst, 6),
                "texel_error_rms": round(self.rms, 6),
                "wrong_texels_percent": round(100 * self.wrong / pixels, 4)}
