"""Properties that must hold for every polygon: each function returns complaints, none if the
property holds.

They call the integer model through its modules, so that tests can put a wrong renderer in its
place. Coordinates are 16.16; a vertex is (x, y, s, t, shade, w). tools/tmap/ideal/ideal.py derives
how far the renderer may be off the ideal. tests/helpers/property_cases.py has random cases.
"""

from dataclasses import dataclass, replace

import numpy as np

from tmap.corpus import random_meshes, random_polygons
from tmap.ideal import bounds, ideal
from tmap.ideal.ideal import UNIT
from tmap.model import model
from tmap.scene_file.scene_file import ONE
from tmap.setup import spans

SIDE = 256 << 16  # width of a map that repeats: 256 texels


@dataclass(frozen=True)
class Case:
    """A polygon in a frame; ``origin`` says how it was generated."""

    origin: str
    vertices: tuple
    width: int
    height: int
    settings: model.Settings = model.Settings()
    size: tuple[int, int] = (256, 256)  # of the map, in texels

    def adapted(self) -> list[tuple]:
        """The vertices in the form the set-up takes: (x, y, u, v)."""
        return model.adapt(self.vertices, self.settings, max(self.size))

    def drawn(self) -> model.Polygon | None:
        return model.set_up(self.adapted(), self.width, self.height,
                            self.settings.mapper != "flat", self.settings, self.size)

    def keeps_shape(self) -> bool:
        """Returns whether the polygon is still convex, with no two vertices in the same place, when
        its vertices are cut to whole pixels. Otherwise its parts may overlap, and of two vertices
        in one place the order of the list decides whose texture counts."""
        points = [v[:2] for v in self.adapted()]
        return len(set(points)) == len(points) and random_polygons.is_convex(points)

    def complaint(self, what: str, pixel: tuple, expected, found) -> str:
        """Describes a failure completely: the case, the pixel, the expected and the found value."""
        return "\n".join([
            f"{self.origin}: {what} at (x {pixel[0]}, y {pixel[1]}): expected {expected}, "
            f"found {found}", f"  {self.width}x{self.height}, map {self.size}, {self.settings}",
            *listed(self.vertices)])


def listed(vertices) -> list[str]:
    """Formats vertices in decimal and hex."""
    return [f"  vertex {k}: " + ", ".join(f"{n} {c / 65536:.6f} ({c & model.M32:#010x})"
                                          for n, c in zip(("x", "y", "s", "t", "shade", "w"), vertex))
            for k, vertex in enumerate(vertices)]


def rows(polygon: model.Polygon | None) -> dict[int, model.Line]:
    lines = enumerate(polygon.lines, polygon.top) if polygon else ()
    return {y: line for y, line in lines if line.right > line.left}


def lit(rows_: dict[int, model.Line]) -> set[tuple[int, int]]:
    return {(i, y) for y, line in rows_.items() for i in range(line.left, line.right)}


def moved(rows_: dict[int, model.Line], columns: int = 0, down: int = 0, u: int = 0,
          v: int = 0) -> dict[int, model.Line]:
    """Returns the lines moved, with u and v shifted."""
    return {y + down: replace(line, left=line.left + columns, right=line.right + columns,
                              u=line.u + u & model.M32, v=line.v + v & model.M32)
            for y, line in rows_.items()}


def same(case: Case, what: str, wanted: dict[int, model.Line],
         found: dict[int, model.Line]) -> list[str]:
    """Complains about the first line that differs in any field."""
    for y in sorted(wanted.keys() | found.keys()):
        a, b = wanted.get(y), found.get(y)
        if a != b:
            return [case.complaint(what, ((a or b).left, y), a, b)]
    return []


# Watertight

def counted(case: Case, pieces) -> np.ndarray:
    """Counts how many of the pieces, lists of (x, y, ...), cover each pixel of the case's frame,
    drawn with the case's settings: int, [y][x]."""
    counts = np.zeros((case.height, case.width), int)
    for piece in pieces:
        part = replace(case, vertices=tuple((*p[:2], 0, 0, 0, ONE) for p in piece))
        for y, line in rows(part.drawn()).items():
            counts[y, line.left:line.right] += 1
    return counts


def possible(case: Case, pieces, column: int, line: int) -> tuple[int, int]:
    """Returns by how much the coverage of a pixel at an edge may differ from the expected: least,
    most.

    Polygons that share an edge start it at the same upper vertex and so compute the same numbers:
    wherever the edge is, each pixel belongs to exactly one of them. Only two things can differ. An
    edge of the outline may be on the pixel's other side. And a piece may be inside out at this
    line, its left edge right of its right one: it then draws nothing where the exact count would
    need -1. That needs both its edges near the pixel.
    """
    def near(vertices) -> int:
        return sum(c.near(column, case.settings, case.width, case.height)
                   for c in ideal.crossings(vertices, line))

    at_border = near(case.vertices)
    return -at_border, at_border + sum(near(piece) > 1 for piece in pieces)


def covers_once(case: Case, pieces) -> list[str]:
    """The pieces of a polygon (the case's, convex or not) cover its pixels exactly once.

    Vertices cut to whole pixels can turn a piece over, or reduce it to a line, which is not drawn:
    then nothing is promised.
    """
    if case.settings.edges == "integer":
        pieces = [[tuple(c & ~0xFFFF for c in p[:2]) for p in piece] for piece in pieces]
        case = replace(case, vertices=tuple(tuple(c & ~0xFFFF for c in p[:2])
                                            for p in case.vertices))
        areas = [abs(random_meshes.twice_area(p)) for p in pieces]
        if not all(areas) or sum(areas) != abs(random_meshes.twice_area(case.vertices)):
            return []
    wanted = ideal.coverage(case.vertices, case.width, case.height)
    counts = counted(case, pieces)
    for y, x in np.argwhere(counts != wanted).tolist():
        low, high = possible(case, pieces, x, y)
        if not low <= counts[y, x] - wanted[y, x] <= high:
            complaint = case.complaint("covered", (x, y), wanted[y, x], counts[y, x])
            return ["\n".join([complaint, *(f"  piece {k}:\n" + "\n".join(listed(piece))
                                            for k, piece in enumerate(pieces))])]
    return []


# Inside

def held(case: Case) -> list[str]:
    """Every shade is in the vertices' range, every texel on the map, with no tolerance."""
    if case.settings.mapper == "gouraud":
        shades = [v[4] >> 16 for v in case.vertices]
        limits = [(min(shades), max(shades))]
    else:
        limits = [(0, side - 1) for side in case.size]
    for y, line in rows(case.drawn()).items():
        for (low, high), values in zip(limits, model.coordinates(line, case.settings.mapper)):
            whole = values >> 16
            wrong = np.flatnonzero((whole < low) | (whole > high))
            if len(wrong):
                return [case.complaint("texel or shade", (line.left + int(wrong[0]), y),
                                       f"{low} to {high}", int(whole[wrong[0]]))]
    return []


def rows_kept(case: Case) -> list[str]:
    """Every pixel shows the column of its own u and the row of its own v: neither carries into the
    other, however often the map repeats along a line."""
    polygon = case.drawn()
    for y, line in rows(polygon).items():
        stepped = polygon.coordinates(y)
        found = spans.fetched(line, polygon.mapper, case.size, stepped)
        for name, values, texels, side in zip(("column", "row"), stepped, found, case.size):
            wrong = np.flatnonzero((values >> 16) % side != texels)
            if len(wrong):
                k = int(wrong[0])
                return [case.complaint(name, (line.left + k, y), int(values[k] >> 16) % side,
                                       int(texels[k]))]
    return []


# Invariance

def rotation(case: Case) -> list[str]:
    """Any vertex may come first: the lines, u, v and steps are the same in every setting."""
    if not case.keeps_shape():
        return []
    wanted, v = rows(case.drawn()), case.vertices
    turned = [replace(case, vertices=v[k:] + v[:k]) for k in range(1, len(v))]
    return [c for k, other in enumerate(turned, 1)
            for c in same(case, f"vertex {k} first: line", wanted, rows(other.drawn()))]


def reversal(case: Case) -> list[str]:
    """Either winding gives the same lines, u, v and steps in every setting."""
    if not case.keeps_shape():
        return []
    other = replace(case, vertices=case.vertices[::-1])
    return same(case, "the other way round: line", rows(case.drawn()), rows(other.drawn()))


def translation(case: Case, columns: int, down: int) -> list[str]:
    """A polygon moved by whole pixels has the same lines, moved. It must be inside the frame before
    and after, so that no border cuts it or the box in which u and v are seen."""
    there = replace(case, vertices=tuple((x + (columns << 16), y + (down << 16), *rest)
                                         for x, y, *rest in case.vertices))
    return same(case, f"moved by {columns}, {down}: line", moved(rows(case.drawn()), columns, down),
                rows(there.drawn()))


def wrapping(case: Case, s: int, t: int) -> list[str]:
    """Adding whole repeating maps to s and t adds as much to u and v; the steps stay the same."""
    other = replace(case, vertices=tuple((x, y, u + s * SIDE, v + t * SIDE, *rest)
                                         for x, y, u, v, *rest in case.vertices))
    return same(case, f"{s} and {t} maps further: line",
                moved(rows(case.drawn()), u=s * SIDE, v=t * SIDE), rows(other.drawn()))


def two_planes(case: Case, what: str, first: Case, second: Case) -> list[str]:
    """Compares u and v of two polygons with one texture plane, at pixels of both: they are equal if
    both planes are seen from the same pixel, otherwise apart by the larger bound at most.

    Along a line the difference is linear, so it is largest at an end of the common part.
    """
    drawn = [c.drawn() for c in (first, second)]
    both, planes = [rows(p) for p in drawn], [p and p.texturing for p in drawn]
    three = [case.vertices[k] for k in ideal.corners(case.vertices)]
    exact = [ideal.Plane([v[:2] for v in three], [v[k] for v in three]) for k in (2, 3)]
    for y in both[0].keys() & both[1].keys():
        a, b = both[0][y], both[1][y]
        left, right = max(a.left, b.left), min(a.right, b.right)
        stepped = [(line.left, model.coordinates(line)) for line in (a, b)] if left < right else []
        for i in (left, right - 1) if left < right else ():
            for k, plane in enumerate(exact):
                found = [int(values[k][i - start]) for start, values in stepped]
                away = abs(model.signed(found[1] - found[0]))
                room = 0.0
                if planes[0] != planes[1]:
                    room = max(plane.bound(i, y, p, p.cuts[k]) for p in planes) / UNIT
                if away > room:
                    return [case.complaint(f"{what}: {'uv'[k]}", (i, y),
                                           f"{found[0]}, {room} at most away", found[1])]
    return []


def splitting(case: Case, parts) -> list[str]:
    """A polygon cut along a diagonal has the same pixels, each once, with u and v within the bounds
    of both. The polygon's texture must be one plane exactly."""
    complaints = covers_once(case, parts)
    for k, part in enumerate(parts):
        complaints += two_planes(case, f"part {k}", case, replace(case, vertices=tuple(part)))
    return complaints


# Pieces

def pieces(case: Case) -> list[str]:
    """A polygon is drawn in one piece if its values are on planes, otherwise as triangles that
    cover it once; each piece is within its bounds, and every vertex belongs to one."""
    parts = model.parts(case.vertices, case.settings, (case.width, case.height), max(case.size))
    if {v for part in parts for v in part} != set(case.vertices):
        return [case.complaint("vertices drawn", ("any", "any"), case.vertices, parts)]
    if not case.keeps_shape():
        return []
    found = bounds.judge(case.vertices, case.settings, case.width, case.height, case.size).complaint
    if found:
        return [case.complaint(found, ("see there", "see there"), "within its bounds", parts)]
    return covers_once(case, parts)
