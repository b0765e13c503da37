"""Convex polygons in space, split by planes.

A corner is a tuple of whole numbers, x, y and z first, then values that change evenly over the
polygon. Each is a number of the scene file with FINE more bits. A plane is (x, y, z, distance), its
normal 2.30, its distance 16.16, so that a corner's height over it is a whole number too. Heights
are exact; a new corner is rounded to its last bit, and once more, to the file's numbers, when the
tree is done.

A unit is 1/65536, the file's. How far from its plane a corner may be:
* A polygon's own corners are off its plane by ON at most, which whoever makes it sees to.
* A corner within ON of a plane counts as on it, so that part of a polygon that is that thin is
  not split off.
* Rounding a new corner to the file's numbers moves it by half a unit on each axis, so by
  sqrt(3) / 2 of a unit. FINE bits before that are nothing beside it: a thousand splits in a row
  move a corner by 2^-22 units.
So no corner is more than OFF = 4 units, 1/16384, on the wrong side of a plane that divides it from
others. Along a ray the height over a plane changes in one direction, so two faces that it divides
can only be drawn in the wrong order at pixels where one of them is within OFF of it.
"""

from dataclasses import dataclass
from math import isqrt

Corner = tuple[int, ...]
Plane = tuple[int, int, int, int]
Edge = tuple[Corner, Corner]

FINE = 32  # bits more than the scene file's
NORMAL = 30  # fraction bits of a normal
ON = 3  # units: a corner as near to a plane is on it
OFF = 4  # units: no corner is farther on the wrong side


@dataclass
class Polygon:
    """A face, or a part of one. ``edges``: for each corner the whole edge, from place to place, that it
    begins a part of; ``source``: the face's place in the order in which the faces came."""

    corners: list[Corner]
    edges: list[Edge]
    plane: Plane
    source: int
    two_sided: bool = False


def edge_of(a: Corner, b: Corner) -> Edge:
    """Returns an edge, the same in both directions."""
    return min(a[:3], b[:3]), max(a[:3], b[:3])


def polygon_of(corners: list[Corner], plane: Plane, source: int, two_sided: bool) -> Polygon:
    """Returns a whole face. ``corners``: the file's numbers."""
    fine = [tuple(n << FINE for n in corner) for corner in corners]
    edges = [edge_of(a, b) for a, b in zip(fine, fine[1:] + fine[:1])]
    return Polygon(fine, edges, plane, source, two_sided)


def plane_of(points: list[Corner]) -> Plane | None:
    """Returns the plane of a polygon: Newell's normal, the mean distance, both rounded to the nearest;
    None if it has no area. ``points``: the file's numbers."""
    sums = [0, 0, 0]
    for a, b in zip(points, points[1:] + points[:1]):
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            sums[axis] += (a[u] - b[u]) * (a[v] + b[v])
    square = sum(n * n for n in sums)
    if not square:
        return None
    size = isqrt(square << 64)  # 32 fraction bits
    normal = [((n << 33 + NORMAL) + size) // (2 * size) for n in sums]
    total = sum(n * p for point in points for n, p in zip(normal, point))
    below = len(points) << NORMAL
    return *normal, (2 * total + below) // (2 * below)


def height(plane: Plane, place: Corner) -> int:
    """Returns how far a corner is in front of a plane, in units of 2^-(FINE + NORMAL) of the file's."""
    x, y, z, distance = plane
    return x * place[0] + y * place[1] + z * place[2] - (distance << FINE + NORMAL)


def side(high: int) -> int:
    """Returns 1, 0 or -1: in front of a plane, on it or behind it, by the height over it."""
    return (high > ON << FINE + NORMAL) - (high < -ON << FINE + NORMAL)


def sides(plane: Plane, polygon: Polygon) -> list[int]:
    """Returns on which side of a plane each corner is."""
    return [side(height(plane, corner)) for corner in polygon.corners]


def between(a: Corner, b: Corner, plane: Plane) -> Corner:
    """Returns the corner where a plane cuts an edge, the same in both directions."""
    if a[:3] > b[:3]:
        a, b = b, a
    part, other = height(plane, a), height(plane, b)
    whole = part - other
    part, whole = (part, whole) if whole > 0 else (-part, -whole)
    return tuple(m + (2 * (n - m) * part + whole) // (2 * whole) for m, n in zip(a, b))


def split(polygon: Polygon, plane: Plane, cuts: dict[Edge, set[Corner]]) -> list[Polygon]:
    """Returns the parts of a polygon in front of a plane and behind it. ``cuts``: gets the places where
    edges are cut."""
    where, count = sides(plane, polygon), len(polygon.corners)
    parts: list[list[tuple[Corner, Edge | None]]] = [[], []]
    for k, corner in enumerate(polygon.corners):
        here, there, edge = where[k], where[(k + 1) % count], polygon.edges[k]
        for part, sign in zip(parts, (1, -1)):
            if here * sign >= 0:  # an edge that leaves the part here is a new one
                part.append((corner, edge if here * sign > 0 or there * sign >= 0 else None))
        if here * there < 0:
            new = between(corner, polygon.corners[(k + 1) % count], plane)
            cuts.setdefault(edge, set()).add(new[:3])
            for part, sign in zip(parts, (1, -1)):
                part.append((new, edge if there * sign > 0 else None))
    made = []
    for part in parts:
        corners = [corner for corner, _ in part]
        edges = [edge or edge_of(corner, corners[(k + 1) % len(part)]) for k, (corner, edge) in enumerate(part)]
        made.append(Polygon(corners, edges, polygon.plane, polygon.source, polygon.two_sided))
    return made


def with_cuts(polygon: Polygon, cuts: dict[Edge, set[Corner]]) -> list[Corner]:
    """Returns a polygon's corners, and those of its neighbours on its edges: where an edge has no corner
    that the neighbour's has, pixels between them stay free."""
    made = []
    for k, (a, edge) in enumerate(zip(polygon.corners, polygon.edges)):
        b = polygon.corners[(k + 1) % len(polygon.corners)]
        axis = max(range(3), key=lambda n: abs(edge[1][n] - edge[0][n]))
        whole = b[axis] - a[axis]
        made.append(a)
        found = {}
        for place in cuts.get(edge, ()):
            part = place[axis] - a[axis]
            if 0 < part * (whole > 0 or -1) < abs(whole):
                values = (m + (2 * (n - m) * part + whole) // (2 * whole) for m, n in zip(a[3:], b[3:]))
                found[abs(part), place] = (*place, *values)
        made += [found[key] for key in sorted(found)]
    return made


def in_file(corners: list[Corner]) -> list[Corner]:
    """Returns a polygon's corners in the file's numbers, without those at the place of their neighbour;
    none if no area is left."""
    half = 1 << FINE - 1
    rounded = [tuple((n + half) >> FINE for n in corner) for corner in corners]
    kept = [corner for k, corner in enumerate(rounded) if corner[:3] != rounded[k - 1][:3]]
    return kept if len(kept) >= 3 and plane_of([corner[:3] for corner in kept]) else []
