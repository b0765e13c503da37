"""Random meshes of triangles that share edges, and parts of convex polygons.

Points are (x, y) in 16.16. Before a mesh's triangles are rotated and reversed at random, all have
the winding of its outline and none has zero area, so together they cover the outline, and no place
twice.
"""

import math
import random
from dataclasses import dataclass
from itertools import accumulate

from tmap.base.fixed import fix

#: Grids of points, in units: any unit, 1/256 pixel, half and whole pixels; and by how many units
#: the points are off them: just beside a pixel's centre, rounded edges cross each other.
GRIDS = ((1, 0), (1, 0), (1, 0), (0x100, 0), (0x8000, 0), (0x10000, 0), (0x10000, 2))


@dataclass
class Mesh:
    """Triangles, with either winding and any vertex first, and the outline around them."""

    kind: str
    outline: list[tuple[int, int]]
    triangles: list[list[tuple[int, int]]]


@dataclass
class Net:
    """A mesh before it is placed: points in any unit, the rest as indices."""

    points: list[tuple[float, float]]
    outline: list[int]
    faces: list[tuple[int, int, int]]


def twice_area(points) -> int:
    """Returns twice a polygon's area, its sign by the winding."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, [*points[1:], points[0]]))


def fan(rng: random.Random) -> Net:
    """Returns triangles around one point, which is inside or on the outline."""
    count = rng.randint(3, 12)
    closed = rng.random() < 0.5
    reach = math.tau if closed else rng.uniform(0.3, 6)
    angles = [reach * (k + rng.uniform(-0.4, 0.4)) / count for k in range(count)]
    lengths = [rng.uniform(0.3, 1) for _ in angles]
    points = [(0.0, 0.0), *((r * math.cos(a), r * math.sin(a)) for r, a in zip(lengths, angles))]
    ring = list(range(1, count + 1))
    faces = [(0, a, b) for a, b in zip(ring, ring[1:])]
    return Net(points, ring, [*faces, (0, count, 1)]) if closed else Net(points, [0, *ring], faces)


def net_of(rng: random.Random, rows: int, columns: int, points) -> Net:
    """Rows and columns of cells, each cut along either diagonal. ``points``: row by row."""
    def at(i: int, j: int) -> int:
        return j * (columns + 1) + i

    faces = []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            faces += rng.choice(([(a, b, c), (a, c, d)], [(a, b, d), (b, c, d)]))
    outline = [at(i, 0) for i in range(columns)] + [at(columns, j) for j in range(rows)]
    outline += [at(i, rows) for i in range(columns, 0, -1)] + [at(0, j) for j in range(rows, 0, -1)]
    return Net(points, outline, faces)


def grid(rng: random.Random, rows: int, columns: int) -> Net:
    """Returns a grid with randomly moved points."""
    side = max(rows, columns)
    points = [((2 * i - columns + rng.uniform(-0.6, 0.6)) / side,
               (2 * j - rows + rng.uniform(-0.6, 0.6)) / side)
              for j in range(rows + 1) for i in range(columns + 1)]
    return net_of(rng, rows, columns, points)


def split_edge(net: Net, rng: random.Random) -> None:
    """Adds a point on an edge and splits the triangles on both its sides."""
    face = rng.choice(net.faces)
    a, b = face[0], face[1]
    part, new = rng.uniform(0.1, 0.9), len(net.points)
    net.points.append(tuple(p + part * (q - p) for p, q in zip(net.points[a], net.points[b])))
    faces = []
    for f in net.faces:
        if {a, b} <= set(f):
            faces += [tuple(new if k == gone else k for k in f) for gone in (a, b)]
        else:
            faces.append(f)
    net.faces = faces
    for k, point in enumerate(net.outline):
        if {point, net.outline[k - 1]} == {a, b}:
            net.outline.insert(k, new)
            break


def split_face(net: Net, rng: random.Random) -> None:
    """Adds a point inside a triangle and splits it into three."""
    face = net.faces.pop(rng.randrange(len(net.faces)))
    weights = [rng.uniform(0.05, 1) for _ in face]
    net.points.append(tuple(sum(w * net.points[k][axis] for w, k in zip(weights, face))
                            / sum(weights) for axis in (0, 1)))
    net.faces += [(*pair, len(net.points) - 1) for pair in zip(face, face[1:] + face[:1])]


def subdivision(rng: random.Random) -> Net:
    """Returns a triangle whose edges and faces are split several times."""
    start = rng.uniform(0, math.tau)
    net = Net([(math.cos(start + math.tau * k / 3), math.sin(start + math.tau * k / 3))
               for k in range(3)], [0, 1, 2], [(0, 1, 2)])
    for _ in range(rng.randint(1, 8)):
        rng.choice((split_edge, split_face))(net, rng)
        net.faces = [rng.choice((f, f[1:] + f[:1], f[2:] + f[:2])) for f in net.faces]
    return net


def tiles(rng: random.Random) -> Net:
    """Rows of handwritten rectangles, on whole numbers, each cut along either diagonal."""
    columns, rows = rng.randint(1, 4), rng.randint(1, 4)
    ends = []
    for count in (columns, rows):
        step = rng.choice((1, 2, 8, 16, 16, None))
        ends.append([0, *accumulate(step or rng.randint(1, 20) for _ in range(count))])
    return net_of(rng, rows, columns, [(x, y) for y in ends[1] for x in ends[0]])


KINDS = {"fan": fan, "strip": lambda rng: grid(rng, 1, rng.randint(1, 8)),
         "grid": lambda rng: grid(rng, rng.randint(2, 4), rng.randint(2, 4)),
         "subdivision": subdivision, "tiles": tiles}


def place(rng: random.Random, net: Net, width: int, height: int) -> list[tuple[int, int]]:
    """Returns the points on the screen, with random size, thinness, rotation, place and grid."""
    size, (unit, beside) = rng.choice((3, 20, 60, 200)), rng.choice(GRIDS)
    squeeze = rng.choice((1, 1, 10 ** rng.uniform(-3, 0)))
    turn = rng.uniform(0, math.tau)
    c, s = size * math.cos(turn), size * math.sin(turn)
    at = rng.uniform(0, width), rng.uniform(0, height)
    return [tuple(round(fix(p) / unit) * unit + rng.randint(-beside, beside) for p in
                  (at[0] + c * x - s * squeeze * y, at[1] + s * x + c * squeeze * y))
            for x, y in net.points]


def laid(rng: random.Random, net: Net, width: int, height: int) -> list[tuple[int, int]]:
    """Returns the points on the screen, on whole or half pixels, upright."""
    x0, y0 = (rng.choice((0, 8, rng.randint(-8, side), rng.randint(0, 2 * side) / 2))
              for side in (width, height))
    return [(fix(x0 + x), fix(y0 + y)) for x, y in net.points]


def shuffled(rng: random.Random, polygon: list) -> list:
    """Puts a random vertex first, and reverses the winding every second time."""
    first = rng.randrange(len(polygon))
    turned = polygon[first:] + polygon[:first]
    return turned[::-1] if rng.random() < 0.5 else turned


def mesh(rng: random.Random, width: int, height: int, kind: str) -> Mesh:
    """Returns a mesh of a kind, usually at least partly in the frame."""
    while True:
        net = KINDS[kind](rng)
        points = laid(rng, net, width, height) if kind == "tiles" else place(rng, net, width, height)
        triangles = [[points[k] for k in face] for face in net.faces]
        if all(twice_area(t) > 0 for t in triangles):
            return Mesh(kind, [points[k] for k in net.outline],
                        [shuffled(rng, t) for t in triangles])


def halves(rng: random.Random, polygon: list) -> tuple[list, list]:
    """Cuts a polygon of more than three vertices along a diagonal."""
    count = len(polygon)
    a = rng.randrange(count)
    b = a + rng.randint(2, count - 2)
    ring = polygon + polygon
    return ring[a:b + 1], ring[b:a + count + 1]
