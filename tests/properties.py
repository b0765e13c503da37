"""What must hold for every polygon: each function returns complaints, none where it holds.

They call the integer model through its modules, so that tests can put a wrong renderer in
its place. Coordinates are 16.16; a vertex is (x, y, s, t, shade). What the renderer may be
off from the ideal stands in tools/ideal.py.

``check`` draws a random case of a property by seed and number.
"""

import random
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from tools import ideal, meshes, model, random_polygons
from tools.ideal import UNIT

SIDE = 256 << 16  # of a map that repeats: 256 texels


@dataclass(frozen=True)
class Case:
    """A polygon in a frame, and where it comes from."""

    origin: str
    vertices: tuple
    width: int
    height: int
    settings: model.Settings = model.Settings()
    size: tuple[int, int] = (256, 256)  # of the map, in texels

    def adapted(self) -> list[tuple]:
        """The vertices as the set-up takes them: (x, y, u, v)."""
        return model.adapt(self.vertices, self.settings, max(self.size))

    def drawn(self) -> model.Polygon | None:
        """The model's polygon."""
        return model.set_up(self.adapted(), self.width, self.height,
                            self.settings.mapper != "flat", self.settings, self.size)

    def keeps_shape(self) -> bool:
        """Whether the polygon is still convex, no two vertices in one place, when its
        vertices are cut to whole pixels. Otherwise its parts may lie over each other, and
        of two vertices in one place the list's order chooses whose texture counts."""
        points = [v[:2] for v in self.adapted()]
        return len(set(points)) == len(points) and random_polygons.is_convex(points)

    def complaint(self, what: str, pixel: tuple, expected, found) -> str:
        """All a person needs to look into it."""
        return "\n".join([
            f"{self.origin}: {what} at (x {pixel[0]}, y {pixel[1]}): expected {expected}, "
            f"found {found}", f"  {self.width}x{self.height}, map {self.size}, {self.settings}",
            *listed(self.vertices)])


def listed(vertices) -> list[str]:
    """Vertices in decimal and hex."""
    return [f"  vertex {k}: " + ", ".join(f"{n} {c / 65536:.6f} ({c & model.M32:#010x})"
                                          for n, c in zip(("x", "y", "s", "t", "shade"), vertex))
            for k, vertex in enumerate(vertices)]


def rows(polygon: model.Polygon | None) -> dict[int, model.Line]:
    """The lines with pixels, by number."""
    lines = enumerate(polygon.lines, polygon.top) if polygon else ()
    return {y: line for y, line in lines if line.right > line.left}


def lit(rows_: dict[int, model.Line]) -> set[tuple[int, int]]:
    """The pixels of lines."""
    return {(i, y) for y, line in rows_.items() for i in range(line.left, line.right)}


def moved(rows_: dict[int, model.Line], columns: int = 0, down: int = 0, u: int = 0,
          v: int = 0) -> dict[int, model.Line]:
    """Lines elsewhere, with other u and v."""
    return {y + down: replace(line, left=line.left + columns, right=line.right + columns,
                              u=line.u + u & model.M32, v=line.v + v & model.M32)
            for y, line in rows_.items()}


def same(case: Case, what: str, wanted: dict[int, model.Line],
         found: dict[int, model.Line]) -> list[str]:
    """Complains of the first line that differs in anything."""
    for y in sorted(wanted.keys() | found.keys()):
        a, b = wanted.get(y), found.get(y)
        if a != b:
            return [case.complaint(what, ((a or b).left, y), a, b)]
    return []


# 1. Watertight

def counted(case: Case, pieces) -> np.ndarray:
    """How many of some polygons cover each pixel: int, [y][x]."""
    counts = np.zeros((case.height, case.width), int)
    for piece in pieces:
        part = replace(case, vertices=tuple((*p[:2], 0, 0, 0) for p in piece))
        for y, line in rows(part.drawn()).items():
            counts[y, line.left:line.right] += 1
    return counts


def possible(case: Case, pieces, column: int, line: int) -> tuple[int, int]:
    """How often a pixel at an edge may be covered, beyond what it should be: least, most.

    Polygons that share an edge have it from the same upper vertex, so it is the same
    numbers to both: what one leaves the other covers, wherever the edge is. Only two
    things can differ. An edge of the outline may be on the pixel's other side. And a
    piece may be inside out there, its left edge right of its right one: it draws nothing
    where it would have to take one away. For that both its edges must be near the pixel.
    """
    def near(vertices) -> int:
        return sum(c.near(column, case.settings, case.width, case.height)
                   for c in ideal.crossings(vertices, line))

    at_border = near(case.vertices)
    return -at_border, at_border + sum(near(piece) > 1 for piece in pieces)


def covers_once(case: Case, pieces) -> list[str]:
    """The pieces of a polygon (the case's, convex or not) cover its pixels exactly once.

    Vertices cut to whole pixels can turn a piece over or make a line of it, which is not
    drawn: then nothing is promised.
    """
    if case.settings.edges == "integer":
        pieces = [[tuple(c & ~0xFFFF for c in p[:2]) for p in piece] for piece in pieces]
        case = replace(case, vertices=tuple(tuple(c & ~0xFFFF for c in p[:2])
                                            for p in case.vertices))
        areas = [abs(meshes.twice_area(p)) for p in pieces]
        if not all(areas) or sum(areas) != abs(meshes.twice_area(case.vertices)):
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


# 2. Exact coverage

def coverage(case: Case) -> list[str]:
    """The ideal's pixels; where edges are rounded or cut, others only as near to an edge as
    that may move it (ideal.Crossing.slack)."""
    if not case.keeps_shape():
        return []
    vertices = case.adapted()
    wanted, found = ideal.coverage(vertices, case.width, case.height), counted(case, [case.vertices])
    for y, x in np.argwhere(wanted != found).tolist():
        if not any(c.near(x, case.settings, case.width, case.height)
                   for c in ideal.crossings(vertices, y)):
            return [case.complaint("covered", (x, y), wanted[y, x], found[y, x])]
    return []


# 3. No drift

def drift(case: Case) -> list[str]:
    """Edges, and u and v on the texture plane, are within their bounds everywhere."""
    polygon, vertices, found = case.drawn(), case.adapted(), []
    if polygon is None:
        return []
    if case.settings.edges != "exact":
        found += [("edge", *error) for error in ideal.edge_errors(vertices, polygon)]
    if polygon.texturing:
        found += ideal.texel_errors(vertices, polygon)
    return [case.complaint(f"error of {what}", (i, y), f"{bound} at most", error)
            for what, i, y, error, bound in found if error > bound][:1]


# 4. Inside

def within(case: Case) -> list[str]:
    """u and v of every pixel are in the range that their plane has on the polygon.

    A pixel lies inside the polygon, or outside by its edge's slack along the line: the
    range grows by so many times the gradient, and by the bound of u or v.
    """
    polygon, vertices = case.drawn(), case.adapted()
    if polygon is None:
        return []
    plane, three = polygon.texturing, [vertices[k] for k in ideal.corners(vertices)]
    coordinates = [ideal.Plane([v[:2] for v in three], [v[k] for v in three]) for k in (2, 3)]
    ranges = [[exact.at(v[0], v[1]) for v in vertices] for exact in coordinates]
    for y, line in rows(polygon).items():
        slack = max((c.slack(case.settings, case.width, case.height)
                     for c in ideal.crossings(vertices, y)), default=0)
        stepped = model.coordinates(line, case.settings.mapper)
        for exact, values, ends, spare in zip(coordinates, stepped, ranges, (plane.spare, 0)):
            low, high = min(ends), max(ends)
            for k, i in ((0, line.left), (-1, line.right - 1)):
                room = exact.bound(i, y, plane.i, plane.j, spare) / UNIT
                room += float(slack) * abs(exact.nx / exact.d)
                value = float(low) + model.signed(int(values[k]) - int(low))
                if not low - room <= value <= high + room:
                    return [case.complaint("u or v", (i, y), f"{float(low)} to {float(high)}, "
                                           f"{room} more on either side", value)]
    return []


def held(case: Case) -> list[str]:
    """Every shade is one of the vertices' range, every texel one of the map, exactly."""
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


# 5. Invariance

def rotation(case: Case) -> list[str]:
    """Whichever vertex comes first: the same lines, u, v and steps in every setting."""
    if not case.keeps_shape():
        return []
    wanted, v = rows(case.drawn()), case.vertices
    return [c for k in range(1, len(v)) for c in same(
        case, f"vertex {k} first: line", wanted, rows(replace(case, vertices=v[k:] + v[:k]).drawn()))]


def reversal(case: Case) -> list[str]:
    """Either winding: the same lines, u, v and steps in every setting."""
    if not case.keeps_shape():
        return []
    other = replace(case, vertices=case.vertices[::-1])
    return same(case, "the other way round: line", rows(case.drawn()), rows(other.drawn()))


def translation(case: Case, columns: int, down: int) -> list[str]:
    """Moved by whole pixels and in the frame before and after, so that no border of it
    cuts the polygon or the box that u and v are seen from: the same lines, moved."""
    there = replace(case, vertices=tuple((x + (columns << 16), y + (down << 16), *rest)
                                         for x, y, *rest in case.vertices))
    return same(case, f"moved by {columns}, {down}: line", moved(rows(case.drawn()), columns, down),
                rows(there.drawn()))


def wrapping(case: Case, s: int, t: int) -> list[str]:
    """s and t further by whole maps that repeat: u and v further by as much, the same steps."""
    other = replace(case, vertices=tuple((x, y, u + s * SIDE, v + t * SIDE, shade)
                                         for x, y, u, v, shade in case.vertices))
    return same(case, f"{s} and {t} maps further: line",
                moved(rows(case.drawn()), u=s * SIDE, v=t * SIDE), rows(other.drawn()))


def two_planes(case: Case, what: str, first: Case, second: Case) -> list[str]:
    """u and v of two polygons with one texture plane, at pixels of both: where both are
    seen from the same pixel the same, elsewhere off by both bounds together at most.

    Along a line the difference is linear, so the ends of the common part show the worst.
    """
    drawn = [c.drawn() for c in (first, second)]
    both, planes = [rows(p) for p in drawn], [p and p.texturing for p in drawn]
    three = [case.vertices[k] for k in ideal.corners(case.vertices)]
    exact = [ideal.Plane([v[:2] for v in three], [v[k] for v in three]) for k in (2, 3)]
    for y in both[0].keys() & both[1].keys():
        a, b = both[0][y], both[1][y]
        left, right = max(a.left, b.left), min(a.right, b.right)
        for i in (left, right - 1) if left < right else ():
            for k, plane in enumerate(exact):
                found = [int(model.coordinates(line)[k][i - line.left]) for line in (a, b)]
                away = abs(model.signed(found[1] - found[0]))
                room = 0.0
                if planes[0] != planes[1]:
                    room = sum(plane.bound(i, y, p.i, p.j, 0 if k else p.spare)
                               for p in planes) / UNIT
                if away > room:
                    return [case.complaint(f"{what}: {'uv'[k]}", (i, y),
                                           f"{found[0]}, {room} at most away", found[1])]
    return []


def splitting(case: Case, parts) -> list[str]:
    """Cut along a diagonal: the same pixels, each once, u and v within the bounds of both.
    The polygon's texture must lie on one plane exactly."""
    complaints = covers_once(case, parts)
    for k, part in enumerate(parts):
        complaints += two_planes(case, f"part {k}", case, replace(case, vertices=tuple(part)))
    return complaints


# 6. Monotone

def monotone(case: Case, part) -> list[str]:
    """A polygon of some of a convex one's vertices lights none but its pixels.

    With rounded edges it may only where it has an edge of its own, with another upper
    vertex, as near to the pixel as both edges' slacks allow: edges from one vertex have
    the order of their exact slopes in their first x and in their slopes, for rounding to
    the nearest never reverses two numbers, so they never cross.
    """
    inner = replace(case, vertices=tuple(part))
    for i, y in sorted(lit(rows(inner.drawn())) - lit(rows(case.drawn()))):
        pairs = [(a, b) for a in ideal.crossings(inner.vertices, y)
                 for b in ideal.crossings(case.vertices, y) if a.upper != b.upper]
        for a, b in pairs:
            slack = max(c.slack(case.settings, case.width, case.height) for c in (a, b))
            if slack and max(c.distance(i) for c in (a, b)) <= slack:
                break
        else:
            return [inner.complaint("lit outside the larger polygon", (i, y), "not lit", "lit")
                    + "\n the larger polygon:\n" + "\n".join(listed(case.vertices))]
    return []


# 8. Clipping

def clipping(case: Case) -> list[str]:
    """Cut vertices and cut lines light the same pixels, but where an edge is as near to
    one as the new vertices may move it; u and v on the plane are within their bounds."""
    cut = replace(case, settings=replace(case.settings, clip="vertices"))
    scissor = replace(case, settings=replace(case.settings, clip="scissor"))
    vertices = case.adapted()
    for i, y in sorted(lit(rows(cut.drawn())) ^ lit(rows(scissor.drawn()))):
        if not any(c.near(i, cut.settings, case.width, case.height)
                   for c in ideal.crossings(vertices, y)):
            return [case.complaint("lit by cut vertices or by cut lines", (i, y), "both", "one")]
    return two_planes(case, "vertices cut", scissor, cut)


# Random cases

WIDTH, HEIGHT = 96, 72
LATTICE = 243  # units; odd, so that gradients have no end in binary
REPEATING = ("affine", "tiled", "columns", "generated")  # mappers of maps that repeat


def planar(rng: random.Random, points) -> tuple:
    """Vertices whose s and t lie on one plane exactly: points on multiples of LATTICE,
    gradients of 1 / LATTICE texel a pixel."""
    steps = [(rng.randint(-g, g), rng.randint(-g, g))
             for g in (LATTICE * rng.choice((0, 1, 1, 4)) for _ in range(2))]
    start = [rng.randint(-300 << 16, 300 << 16) for _ in range(2)]
    return tuple((x, y, *(a + gx * (x // LATTICE) + gy * (y // LATTICE)
                          for a, (gx, gy) in zip(start, steps)), 0) for x, y in points)


def convex(rng: random.Random, least: int = 3, unit: int = 1) -> list[tuple[int, int]]:
    """A convex polygon of some vertices at least, on multiples of a unit."""
    while True:
        points = [(x // unit * unit, y // unit * unit)
                  for x, y in random_polygons.convex_polygon(rng, WIDTH, HEIGHT)]
        if len(points) >= least and random_polygons.is_convex(points) and meshes.twice_area(points):
            return points


def textured(rng: random.Random, points, shades=(0, 255)) -> tuple:
    """Vertices with s, t, 8,192 texels from the map's corner at most, and shade."""
    st = [(model.FAR, 0)]
    while max(abs(c) for pair in st for c in pair) > model.FAR // 2:
        st = random_polygons.texture_plane(rng, points)
    return tuple((*p, *c, rng.randint(shades[0] << 16, (shades[1] << 16) + 0xFFFF))
                 for p, c in zip(points, st))


def any_settings(rng: random.Random, count: int, **fixed) -> model.Settings:
    """Settings that a polygon of so many vertices can have."""
    kinds = {"edges": ("integer", "subpixel", "exact"), "start": ("truncated", "subtexel"),
             "gradients": ("scanline", "plane") + (("polygon",) if count == 3 else ()),
             "clip": ("scissor", "vertices"), "mapper": REPEATING}
    return model.Settings(**{k: rng.choice(v) for k, v in kinds.items()} | fixed)


def any_case(rng: random.Random, origin: str, **fixed) -> Case:
    """A random polygon with any settings but those given."""
    points = long_triangle(rng, HEIGHT) if rng.random() < 0.1 else convex(rng)
    vertices = textured(rng, points)
    return Case(origin, vertices, WIDTH, HEIGHT, any_settings(rng, len(vertices), **fixed))


def long_triangle(rng: random.Random, side: int) -> list[tuple[int, int]]:
    """In, across or far beyond a frame so wide and high; some are needles."""
    while True:
        reach = [rng.choice((0, 0, side, 16000 - side)) for _ in range(2)]
        points = [tuple(round(rng.uniform(-r, side + r) * 65536) for r in reach)
                  for _ in range(3)]
        if rng.random() < 0.3:
            axis = rng.randrange(2)
            points[1] = tuple(c + rng.randint(-65536, 65536) if k == axis else points[2][k]
                              for k, c in enumerate(points[0]))
        if meshes.twice_area(points):
            return points


def held_case(rng: random.Random, origin: str) -> Case:
    """A polygon whose texels or shades reach the end of what they may be; with more than
    three vertices they are on no plane."""
    points = long_triangle(rng, HEIGHT) if rng.random() < 0.3 else convex(rng)
    size = tuple(rng.choice((1, 2, 8, 100, 256, 1000)) for _ in range(2))
    low, high = sorted(rng.choice((0, 0, 255, rng.randrange(256))) for _ in range(2))
    room = [256 * 65536 * side // max(size) for side in size]
    inset = min(model.INSET * 256 // max(size) + 1, *room)  # lines just need not be held
    vertices = tuple(
        (*p[:2], *(rng.choice((0, end, inset, end - inset, rng.randint(0, end))) for end in room),
         p[4]) for p in textured(rng, points, (low, high)))
    settings = any_settings(rng, len(points), mapper=rng.choice(("gouraud", "arbitrary")))
    return Case(origin, vertices, WIDTH, HEIGHT, settings, size)


def check_watertight(rng: random.Random, origin: str) -> list[str]:
    kind = rng.choice(list(meshes.KINDS))
    mesh = meshes.mesh(rng, WIDTH, HEIGHT, kind)
    settings = model.Settings(rng.choice(("integer", "subpixel", "exact")),
                              clip=rng.choice(("scissor", "scissor", "vertices")), mapper="flat")
    return covers_once(Case(f"{origin} ({kind})", tuple(mesh.outline), WIDTH, HEIGHT, settings),
                       mesh.triangles)


def check_coverage(rng: random.Random, origin: str) -> list[str]:
    return coverage(any_case(rng, origin, mapper="flat", gradients="plane"))


def check_drift(rng: random.Random, origin: str) -> list[str]:
    side = rng.choice((72, 72, 1024))
    points = long_triangle(rng, side) if rng.random() < 0.5 else convex(rng)
    settings = model.Settings(rng.choice(("subpixel", "exact")))
    return drift(Case(origin, textured(rng, points), side, side, settings))


def check_within(rng: random.Random, origin: str) -> list[str]:
    return within(any_case(rng, origin, gradients="plane", start="subtexel", mapper="affine"))


def check_held(rng: random.Random, origin: str) -> list[str]:
    return held(held_case(rng, origin))


def check_rotation(rng: random.Random, origin: str) -> list[str]:
    return rotation(any_case(rng, origin))


def check_reversal(rng: random.Random, origin: str) -> list[str]:
    return reversal(any_case(rng, origin))


def check_translation(rng: random.Random, origin: str) -> list[str]:
    while True:
        case = any_case(rng, origin)
        ways = []
        for axis, side in ((0, WIDTH), (1, HEIGHT)):
            values = [v[axis] for v in case.vertices]
            base = min(values) >> 16
            ways.append((-base, side - 2 - (max(values) >> 16)))
        if all(low <= high for low, high in ways):
            break
    first, second = ([rng.randint(*way) for way in ways] for _ in range(2))
    placed = tuple((x + (first[0] << 16), y + (first[1] << 16), *rest)
                   for x, y, *rest in case.vertices)
    return translation(replace(case, vertices=placed), *(b - a for a, b in zip(first, second)))


def check_wrapping(rng: random.Random, origin: str) -> list[str]:
    return wrapping(any_case(rng, origin), rng.randint(-20, 20), rng.randint(-20, 20))


def check_splitting(rng: random.Random, origin: str) -> list[str]:
    vertices = planar(rng, convex(rng, 4, LATTICE))
    settings = any_settings(rng, 4, gradients="plane", start="subtexel", mapper="affine",
                            edges=rng.choice(("subpixel", "exact")))
    return splitting(Case(origin, vertices, WIDTH, HEIGHT, settings),
                     meshes.halves(rng, list(vertices)))


def check_monotone(rng: random.Random, origin: str) -> list[str]:
    vertices = textured(rng, convex(rng, 4))
    settings = any_settings(rng, 4, edges=rng.choice(("subpixel", "exact")), mapper="flat")
    return monotone(Case(origin, vertices, WIDTH, HEIGHT, settings),
                    meshes.subset(rng, list(vertices)))


def check_clipping(rng: random.Random, origin: str) -> list[str]:
    vertices = planar(rng, convex(rng, 3, LATTICE))
    return clipping(Case(origin, vertices, WIDTH, HEIGHT, model.Settings("exact")))


#: name: what draws a case by chance and returns its complaints
CHECKS = {name.removeprefix("check_"): function for name, function in list(globals().items())
          if name.startswith("check_")}


def check(name: str, seed: int, number: int) -> list[str]:
    """The complaints of one random case, which depends on nothing but these three."""
    rng = random.Random(f"{name} {seed} {number}")
    return CHECKS[name](rng, f"{name}, seed {seed}, number {number}")


def complaints(name: str, seed: int, count: int) -> Iterator[str]:
    """Those of so many cases."""
    for number in range(count):
        yield from check(name, seed, number)
