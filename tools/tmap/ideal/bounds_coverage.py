"""How far wrong pixels, drawn or left out, may be from a polygon's exact edges.

1 unit = U = 1/2^16 of a pixel. Vertices are those that ``model.adapt`` returns.

`exact` edges have no error. For rounded ones on line j, f being the edge's first line in the frame,
x starts at the nearest unit and steps by a slope to the nearest unit: E(j) = (j - f + 1) U/2
pixels, without the roundings that are exact. A pixel may be lit or left out wrongly only if the
exact edge passes within E(j) of its centre, and no pixel if E is 0. Polygons cut to the window have
new vertices (not with `exact` edges). Each cut rounds one coordinate (U/2), and an edge is cut four
times at most, so it moves across its direction by another 2U at most.
"""

from collections.abc import Callable
from functools import cached_property
from math import sqrt

import numpy as np

from tmap.base.fixed import ceil16
from tmap.ideal import ideal
from tmap.ideal.ideal import UNIT
from tmap.model import model
from tmap.setup.edges import Edge
from tmap.setup.texturing import Settings

LARGEST = 32768.0  # pixels and texels: values are modulo twice that
#: The rounding of double precision when a bound is evaluated and compared.
FLOAT = 1 + 1e-9


def edge_bound(edge: Edge, line: int) -> float:
    """Returns E(j) of a rounded edge, pixels; an exact quotient adds nothing."""
    (x0, y0, *_), (x1, y1, *_) = edge.upper, edge.lower
    width, height = x1 - x0, y1 - y0
    start, step = width * ((edge.top << 16) - y0) % height, (width << 16) % height
    return ((start != 0) + (line - edge.top) * (step != 0)) * UNIT / 2


class Side:
    """The edges of one side of a polygon on some of its lines, ``ys``, ascending: arrays over these."""

    def __init__(self, edges: list[Edge], ys: np.ndarray) -> None:
        self.edges, self.ys = edges, ys
        self.which = np.minimum(np.searchsorted([edge.end for edge in edges], ys, "right"), len(edges) - 1)
        self.below = ys - self.each(lambda edge: edge.top)  # lines below the edge's first

    def each(self, function: Callable[[Edge], float]) -> np.ndarray:
        """Returns a function of each line's edge."""
        return np.array([function(edge) for edge in self.edges])[self.which]

    def by_line(self, function: Callable[[Edge, np.ndarray], np.ndarray]) -> np.ndarray:
        """Returns a function of each line's edge and of the line."""
        parts = np.split(self.ys, np.searchsorted(self.which, np.arange(1, len(self.edges))))
        return np.concatenate([function(edge, ys) for edge, ys in zip(self.edges, parts)])

    @cached_property
    def bounds(self) -> np.ndarray:
        """E(j), pixels."""
        start = self.each(lambda edge: edge_bound(edge, edge.top))
        return start + self.below * self.each(lambda edge: edge_bound(edge, edge.top + 1) - edge_bound(edge, edge.top))

    @cached_property
    def columns(self) -> np.ndarray:
        """The first pixels at or right of the edges that are drawn."""
        return self.by_line(Edge.column)

    @cached_property
    def at(self) -> np.ndarray:
        """x of the edges that are drawn, 16.16."""
        return self.by_line(Edge.at)

    @cached_property
    def crossings(self) -> np.ndarray:
        """x where the exact edges cross the lines, pixels."""
        return self.values(0) * UNIT

    def values(self, key: int) -> np.ndarray:
        """Returns where the exact edges cross the lines: one of the vertices' numbers, units."""
        def value(edge: Edge, lines: np.ndarray) -> np.ndarray:
            (_, y0, *_), (_, y1, *_), a, b = edge.upper, edge.lower, edge.upper[key], edge.lower[key]
            return a + (b - a) * ((lines << 16) - y0) / (y1 - y0)  # the product is exact: below 2^62
        return self.by_line(value)


def across(vertices, i: int, j: int) -> float:
    """The distance of pixel (i, j) from the nearest straight line through an edge, pixels."""
    best = LARGEST
    for (x0, y0, *_), (x1, y1, *_) in zip(vertices, [*vertices[1:], vertices[0]]):
        dx, dy = x1 - x0, y1 - y0
        length = sqrt(dx * dx + dy * dy)
        if length:
            best = min(best, abs(dx * ((j << 16) - y0) - ((i << 16) - x0) * dy) / length * UNIT)
    return best


def pixels_of(vertices, polygon: model.Polygon | None, lines: range, width: int,
              height: int) -> tuple[np.ndarray, ...]:
    """Returns the first pixel and the end of what is drawn on some lines, and of a convex polygon's exact pixels."""
    drawn, exact = np.zeros((2, 2, len(lines)), np.int64)
    if polygon:
        part = slice(polygon.top - lines.start, polygon.top - lines.start + len(polygon.lines))
        drawn[:, part] = np.array([(line.left, line.right) for line in polygon.lines]).reshape(-1, 2).T
    top, end = exact_lines(vertices, height)
    if top < end:
        exact[:, top - lines.start:end - lines.start] = ideal.first_pixels(vertices, top, end).clip(0, width)
    return tuple((left, np.maximum(left, right)) for left, right in (drawn, exact))


def exact_lines(vertices, height: int) -> tuple[int, int]:
    """Returns the first line of a frame that a polygon crosses and the one behind the last."""
    ys = [v[1] for v in vertices]
    return max(ceil16(min(ys)), 0), min(ceil16(max(ys)), height)


def check_coverage(vertices, polygon: model.Polygon | None, settings: Settings, width: int,
                   height: int) -> tuple[int, str]:
    """The count of a convex polygon's wrong pixels; a text on the first too far from its edge."""
    spans = [exact_lines(vertices, height), *([(polygon.top, polygon.top + len(polygon.lines))] if polygon else [])]
    spans = [span for span in spans if span[0] < span[1]]
    if not spans:
        return 0, ""
    lines = range(min(top for top, _ in spans), max(end for _, end in spans))
    found, ends = pixels_of(vertices, polygon, lines, width, height)
    both = np.maximum(np.minimum(found[1], ends[1]) - np.maximum(found[0], ends[0]), 0)
    wrong = found[1] - found[0] + ends[1] - ends[0] - 2 * both
    for k in np.flatnonzero(wrong).tolist():
        complaint = wrong_line(vertices, polygon, settings, lines[k], height,
                               [range(*(int(end[k]) for end in each)) for each in (found, ends)])
        if complaint:
            return int(wrong.sum()), complaint
    return int(wrong.sum()), ""


def wrong_line(vertices, polygon: model.Polygon | None, settings: Settings, y: int, height: int,
               pixels: list[range]) -> str:
    """A text on the first pixel of a line that is too far from its edge, or "". ``pixels``: drawn ones, exact ones."""
    clipped = 2 * UNIT if settings.clip == "vertices" and not settings.has_exact_edges else 0.0
    every = (*polygon.left_edges, *polygon.right_edges) if polygon else ()
    edges = [edge for edge in every if edge.top <= y < edge.end]
    allowed = 0.0 if settings.has_exact_edges else max((edge_bound(edge, y) for edge in edges), default=0.0)
    exact = ideal.extents(vertices)(y) if y in range(*exact_lines(vertices, height)) else ()
    for i in sorted(set(pixels[0]) ^ set(pixels[1])):
        off = min((abs(i - n / d * UNIT) for n, d in exact), default=LARGEST)
        if allowed and off <= allowed * FLOAT:
            continue
        if clipped and across(vertices, i, y) <= (allowed + clipped) * FLOAT:
            continue
        return (f"pixel ({i}, {y}) is {'lit' if i in pixels[0] else 'left out'}: its centre is "
                f"{off:.9f} pixels from the exact edge, {allowed + clipped:.9f} are allowed")
    return ""
