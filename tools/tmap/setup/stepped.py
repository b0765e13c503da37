"""u and v of all pixels of a polygon, one line after the other."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import counted
from tmap.setup import afar, perspective
from tmap.setup.level import level
from tmap.setup.spans import coordinates_of


@dataclass
class Stepped:
    """u and v, int64, 16.16 modulo 2^32. The pixels of line k begin at ``starts`` [k] and end at ``starts`` [k + 1]."""

    starts: np.ndarray
    u: np.ndarray
    v: np.ndarray

    def line(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns u and v of a line's pixels."""
        part = slice(self.starts[k], self.starts[k + 1])
        return self.u[part], self.v[part]


def stepped_of(polygon) -> Stepped:
    """Returns u and v of a tmap.setup.polygon.Polygon as its mapper steps them."""
    ends = np.array([(line.left, line.right) for line in polygon.lines], np.int64).reshape(-1, 2)
    starts = np.concatenate([[0], np.cumsum(np.maximum(ends[:, 1] - ends[:, 0], 0))])
    drawn = [k for k, line in enumerate(polygon.lines) if line.right > line.left]
    uv = values_of(polygon, drawn) if drawn else np.zeros((2, 0), np.int64)
    return Stepped(starts, *uv)


def values_of(polygon, drawn: list[int]):
    """Returns u and v of the lines ``drawn``, indices of lines that have pixels."""
    lines, ys = [polygon.lines[k] for k in drawn], [polygon.top + k for k in drawn]
    deep = polygon.perspective
    if not deep:
        return coordinates_of(lines, ys, polygon.mapper)
    if polygon.columns:
        return crossed(polygon.columns, lines, ys)
    if polygon.is_level:
        return level(deep, lines, ys)
    if polygon.constants:
        return afar.model_of(polygon.constants).coordinates([polygon.records[k] for k in drawn])
    across = np.array([(line.left, line.right) for line in lines]).T
    made = perspective.all_ends(deep, *across, np.array(ys), perspective.raise_of(polygon.exact))
    return [np.concatenate(each) for each in zip(*(perspective.coordinates(ends, polygon.exact) for ends in made))]


def crossed(columns, lines, ys: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of lines of a polygon that is drawn by columns, a polygon whose lines they are."""
    across = np.array([(each.left, each.right) for each in columns.lines]).T
    counts = [line.right - line.left for line in lines]
    y, x = np.repeat(ys, counts), np.repeat([line.left for line in lines], counts) + counted(counts)
    left, right = (each[x - columns.top] for each in across)
    if not ((left <= y) & (y < right)).all():
        raise ValueError("a column has no pixel on a line that is drawn")
    at = columns.stepped.starts[x - columns.top] + y - left
    return columns.stepped.u[at], columns.stepped.v[at]
