"""How far wrong pixels, drawn or left out, may be from a polygon's exact edges.

1 unit = U = 1/2^16 of a pixel. Vertices are those that ``model.adapt`` returns.

`exact` edges have no error. For rounded ones on line j, f being the edge's first line in the frame,
x starts at the nearest unit and steps by a slope to the nearest unit: E(j) = (j - f + 1) U/2
pixels, without the roundings that are exact. A pixel may be lit or left out wrongly only if the
exact edge passes within E(j) of its centre, and no pixel if E is 0. Polygons cut to the window have
new vertices (not with `exact` edges). Each cut rounds one coordinate (U/2), and an edge is cut four
times at most, so it moves across its direction by another 2U at most.
"""

from math import sqrt

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


def crossing(edge: Edge, line: int) -> float:
    """Returns x where the exact edge crosses a line, pixels."""
    (x0, y0, *_), (x1, y1, *_) = edge.upper, edge.lower
    return (x0 + (x1 - x0) * ((line << 16) - y0) / (y1 - y0)) * UNIT


def across(vertices, i: int, j: int) -> float:
    """The distance of pixel (i, j) from the nearest straight line through an edge, pixels."""
    best = LARGEST
    for (x0, y0, *_), (x1, y1, *_) in zip(vertices, [*vertices[1:], vertices[0]]):
        dx, dy = x1 - x0, y1 - y0
        length = sqrt(dx * dx + dy * dy)
        if length:
            best = min(best, abs(dx * ((j << 16) - y0) - ((i << 16) - x0) * dy) / length * UNIT)
    return best


def edges_by_line(edges: list[Edge]) -> dict[int, Edge]:
    """Returns the edge of each line."""
    return {line: edge for edge in edges for line in range(edge.top, edge.end)}


def exact_extents(vertices, width: int, height: int) -> dict[int, list[tuple[int, int, int]]]:
    """Returns, for each line of a frame that an exact polygon crosses, its left and right x as
    numerator and denominator, each with the first pixel from there on, inside the frame."""
    ys, extent = [v[1] for v in vertices], ideal.extents(vertices)
    return {y: [(n, d, min(max(-(-n // (d << 16)), 0), width)) for n, d in extent(y)]
            for y in range(max(ceil16(min(ys)), 0), min(ceil16(max(ys)), height))}


def check_coverage(vertices, polygon: model.Polygon | None, settings: Settings, width: int,
                   height: int) -> tuple[int, str]:
    """The count of a convex polygon's wrong pixels; a text on the first too far from its edge."""
    exact = exact_extents(vertices, width, height)
    lines = {polygon.top + k: line for k, line in enumerate(polygon.lines)} if polygon else {}
    sides = [edges_by_line(e) for e in (polygon.left_edges, polygon.right_edges)] if polygon else []
    wrong, complaint = 0, ""
    clipped = 2 * UNIT if settings.clip == "vertices" and not settings.has_exact_edges else 0.0
    for y in exact.keys() | lines.keys():
        found = [lines[y].left, lines[y].right] if y in lines else [0, 0]
        ends = [end for _, _, end in exact[y]] if y in exact else [0, 0]
        found, ends = ([a, max(a, b)] for a, b in (found, ends))
        pixels = set(range(*found)) ^ set(range(*ends))
        wrong += len(pixels)
        allowed = 0.0 if settings.has_exact_edges else max(
            (edge_bound(side[y], y) for side in sides if y in side), default=0.0)
        for i in sorted(pixels):
            off = min((abs(i - n / d * UNIT) for n, d, _ in exact.get(y, ())), default=LARGEST)
            if allowed and off <= allowed * FLOAT:
                continue
            if clipped and across(vertices, i, y) <= (allowed + clipped) * FLOAT:
                continue
            complaint = complaint or (
                f"pixel ({i}, {y}) is {'lit' if i in range(*found) else 'left out'}: its centre is "
                f"{off:.9f} pixels from the exact edge, {allowed + clipped:.9f} are allowed")
    return wrong, complaint
