"""The integer model's edges: src68k/polygon's sides_find and edges_make
and the routines they call, c/polygon/edges.c."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tmap.base.fixed import ONE, Number, ceil16, mul_div

EDGE_ERROR = 1024  # how far an edge's x may be beyond its vertices, pixels, 16.16


@dataclass
class Edge:
    """A section of a side: from one vertex to a lower one, drawn on lines top to end - 1."""

    upper: tuple
    lower: tuple
    top: int
    end: int
    exact: bool
    upright: bool = False  # exact, and its lines are columns of the frame

    @property
    def extent(self) -> tuple[int, int]:
        """Width and height between the vertices, 16.16."""
        return self.lower[0] - self.upper[0], self.lower[1] - self.upper[1]

    @property
    def is_single(self) -> bool:
        """True if the edge has only one line: no slope is needed."""
        return self.end - self.top == 1

    @cached_property
    def slope(self) -> int:
        """Pixels per line, 16.16; 0 if the edge has only one line."""
        width, height = self.extent
        return 0 if self.is_single else mul_div(width, ONE, height)

    @cached_property
    def first(self) -> int:
        """x on the line ``top``, 16.16, rounded."""
        width, height = self.extent
        return self.upper[0] + mul_div(width, (self.top << 16) - self.upper[1], height)

    def at(self, line: Number) -> Number:
        """Returns x on a line, or on several, 16.16, rounded at the line ``top`` and in every step."""
        return self.first + (line - self.top) * self.slope

    @cached_property
    def columns(self) -> np.ndarray:
        """``column`` of all its lines."""
        return self.column(np.arange(self.top, self.end))

    def column(self, line: Number) -> Number:
        """Returns the first pixel at or right of the edge, on a line or on several. Products of coordinates within
        2^30 fit int64."""
        if not self.exact:
            return ceil16(self.at(line))
        (x, y, *_), (width, height) = self.upper, self.extent
        n = x * height + width * ((line << 16) - y)
        if self.upright and width > 0:
            return n // (height << 16) + 1
        return -(-n // (height << 16))

    @property
    def whole(self) -> int:
        """Whole pixels per line; 0 if the edge has only one line."""
        width, height = self.extent
        return self.slope >> 16 if self.is_single or not self.exact else width // height


@dataclass
class Sides:
    """Top, bottom and the vertex farthest from the line between them (indices), the direction in
    which the left side runs, and the box of pixels: left, top, right, bottom."""

    corners: tuple[int, int, int]
    direction: int
    box: tuple[int, int, int, int]


def corners_of(vertices) -> tuple[tuple[int, int, int], int]:
    """Returns top, bottom and middle of a polygon, as indices, and twice their area, above 0 if the
    middle is left of the line from top to bottom."""
    n = len(vertices)
    top = min(range(n), key=lambda k: (vertices[k][1], vertices[k][0]))
    bottom = min(range(n), key=lambda k: (-vertices[k][1], vertices[k][0]))
    ax, ay = vertices[top][:2]
    dx, dy = vertices[bottom][0] - ax, vertices[bottom][1] - ay
    turns = [dx * (v[1] - ay) - (v[0] - ax) * dy for v in vertices]
    middle = min(range(n), key=lambda k: (-abs(turns[k]), vertices[k][1], vertices[k][0]))
    return (top, bottom, middle), turns[middle]


def measure(vertices, width: int, height: int) -> Sides | None:
    """Returns the sides of a polygon; None if it covers no pixel."""
    n = len(vertices)
    if n < 3:
        return None
    corners, area = corners_of(vertices)
    top, bottom, middle = corners
    x_low, x_high = min(v[0] for v in vertices), max(v[0] for v in vertices)
    box = (max(ceil16(x_low - EDGE_ERROR), 0), max(ceil16(vertices[top][1]), 0),
           min(ceil16(x_high + EDGE_ERROR), width), min(ceil16(vertices[bottom][1]), height))
    if box[0] >= box[2] or box[1] >= box[3] or area == 0:
        return None
    forward = (middle - top) % n < (bottom - top) % n
    return Sides(corners, 1 if (area > 0) == forward else -1, box)


def side(vertices, start: int, direction: int, top: int, bottom: int, exact: bool,
         upright: bool = False) -> list[Edge]:
    """Returns the edges of one side from the top vertex on, between two lines."""
    edges, index, upper = [], start, vertices[start]
    while top < bottom:
        index = (index + direction) % len(vertices)
        lower = vertices[index]
        end = min(ceil16(lower[1]), bottom)
        if end > top and lower[1] > upper[1]:
            edges.append(Edge(upper, lower, top, end, exact, upright))
            top = end
        upper = lower
    return edges
