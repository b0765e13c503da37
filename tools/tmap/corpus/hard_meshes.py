"""Hard meshes: one function per family. Cases that need a camera: faces through the near plane,
edge-on, out of the guard band, up to the horizon, past the eye, tiny and huge in one mesh; normals
at the limits of an environment and a light.

In the mesh x is right, y down, z away from the viewer, and the eye is at its origin unless a case
gives another place. Points are exact in 16.16 and every face is exactly on a plane, so only the
camera's numbers are rounded: turns are by Pythagorean triples, exact as fractions.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from tmap.base.elementary import cos, sin
from tmap.base.fixed import ONE
from tmap.corpus.hard_case import UNIT, label

REACH, NEAREST = 2048, Fraction(1, 256)
FOCAL = 64  # pixels from the eye to the screen

Vector = tuple[Fraction, Fraction, Fraction]
Turn = tuple[Vector, Vector, Vector]


@dataclass(frozen=True)
class MeshCase:
    """A named mesh before a camera. Points and texels are in units (pixels are 64 from the eye)."""

    name: str
    sentence: str  # why it is hard
    points: tuple[Vector, ...]
    faces: tuple[tuple[int, ...], ...]
    texels: tuple[tuple[tuple[Fraction, Fraction], ...], ...]  # s, t of each face's corners
    turn: Turn  # the camera's right, down and forward
    eye: Vector = (0, 0, 0)
    near: Fraction = Fraction(1, 8)
    focal: int = FOCAL
    two_sided: bool = False
    look: str = "uv"  # or "environment", "shade"
    around: bool = False  # the mesh fills the whole screen: no pixel may be left out


# Turns

def about(axis: int, c, s) -> Turn:
    """Returns the rotation about x, y or z by an angle with the given cosine and sine."""
    rows = [[Fraction(int(k == n)) for n in range(3)] for k in range(3)]
    a, b = (axis + 1) % 3, (axis + 2) % 3
    rows[a][a] = rows[b][b] = Fraction(c)
    rows[a][b], rows[b][a] = -Fraction(s), Fraction(s)
    return tuple(map(tuple, rows))


def then(first: Turn, second: Turn) -> Turn:
    """Returns one rotation after another."""
    return tuple(tuple(sum(a * first[k][n] for k, a in enumerate(row)) for n in range(3))
                 for row in second)


STRAIGHT = about(0, 1, 0)
ASKEW = then(then(about(0, Fraction(12, 13), Fraction(5, 13)), about(1, Fraction(24, 25), Fraction(7, 25))),
             about(2, Fraction(40, 41), Fraction(9, 41)))
ROLLED = about(2, Fraction(3, 5), Fraction(4, 5))


# Shapes

def made(name: str, sentence: str, faces, turn: Turn = STRAIGHT, **more) -> MeshCase:
    """Returns a case from faces: lists of (x, y, z, s, t); its name begins with mesh_."""
    numbers, rows, texels = {}, [], []
    for face in faces:
        row = [tuple(Fraction(c) for c in corner) for corner in face]
        rows.append(tuple(numbers.setdefault(corner[:3], len(numbers)) for corner in row))
        texels.append(tuple(corner[3:] for corner in row))
    return MeshCase(f"mesh_{name}", sentence, tuple(numbers), tuple(rows), tuple(texels), turn, **more)


def sheet(origin, along, down, size=(1, 1), texels=(256, 256), start=(0, 0)) -> list[tuple]:
    """Returns a parallelogram from a corner, its sides times ``size``, with s along and t down:
    seen from the side from which it reads like a page."""
    o, a, b = ([Fraction(c) for c in vector] for vector in (origin, along, down))
    corners = ((0, 0), (0, 1), (1, 1), (1, 0))
    return [(*(p + k * size[0] * c + n * size[1] * d for p, c, d in zip(o, a, b)),
             start[0] + k * Fraction(texels[0]), start[1] + n * Fraction(texels[1])) for k, n in corners]


def floor(height, x, z, texels=(256, 256)) -> list[tuple]:
    """Returns ground from z[0] to z[1] ahead and x[0] to x[1] sideways, ``height`` below the eye:
    seen from above; t runs towards the viewer."""
    return sheet((x[0], height, z[1]), (x[1] - x[0], 0, 0), (0, 0, z[0] - z[1]), texels=texels)


def box(low, high, inward: bool = False) -> list[list[tuple]]:
    """Returns six faces with the whole map each, seen from outside or from inside."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    w, h, d = x1 - x0, y1 - y0, z1 - z0
    faces = [sheet((x0, y0, z0), (w, 0, 0), (0, h, 0)), sheet((x1, y0, z1), (-w, 0, 0), (0, h, 0)),
             sheet((x0, y0, z1), (0, 0, -d), (0, h, 0)), sheet((x1, y0, z0), (0, 0, d), (0, h, 0)),
             sheet((x0, y0, z1), (w, 0, 0), (0, 0, -d)), sheet((x0, y1, z0), (w, 0, 0), (0, 0, d))]
    return [face[::-1] for face in faces] if inward else faces


def ring(count: int, radius, height, middle=(0, 0)) -> list[tuple]:
    """Ground of ``count`` corners around a place, s and t flat on it; radius a multiple of 1/16."""
    angles = [math.tau * k / count for k in range(count)]
    corners = [(round(float(radius) * 4096 * cos(a)), round(float(radius) * 4096 * sin(a)))
               for a in angles]
    return [(middle[0] + Fraction(x, 4096), Fraction(height), middle[1] + Fraction(z, 4096),
             Fraction(x, 64), Fraction(z, 64)) for x, z in corners]


def ball(radius, middle, around: int, inward: bool = False) -> list[list[tuple]]:
    """The triangles of a globe, ``around`` of them round it; s and t are longitude and latitude."""
    down = 8

    def place(k: int, n: int) -> tuple:
        a, b = math.tau * (k % around) / around, math.pi * n / down
        way = cos(a) * sin(b), -cos(b), sin(a) * sin(b)
        return (*(m + Fraction(round(float(radius) * ONE * c), ONE) for m, c in zip(middle, way)),
                Fraction(256 * k, around), Fraction(256 * n, down))

    faces = []
    for k in range(around):
        for n in range(down):
            a, b, c, d = place(k, n), place(k + 1, n), place(k + 1, n + 1), place(k, n + 1)
            faces += [[c, b, a]] * (n > 0) + [[d, c, a]] * (n < down - 1)
    return [face[::-1] for face in faces] if inward else faces


# Families

def near_planes() -> Iterator[MeshCase]:
    """Faces that cross the near plane, or reach behind the eye."""
    ground = floor(1, (-4, 4), (-8, 9), (512, 1088))
    yield made("floor_behind_the_eye", "Ground from behind the eye on.", [ground])
    yield made("floor_behind_the_eye_askew", "The same, seen turned, tilted and rolled.", [ground], ASKEW)
    for count, corners in ((1, [(0, -2), (5, 4), (0, 9), (-5, 4)]),
                           (2, [(3, -2), (5, 9), (-5, 9), (-3, -2)]),
                           (3, [(4, -3), (0, 9), (-4, -3), (0, -8)])):
        yield made(f"{count}_corners_behind_the_eye", f"{count} of four corners lie behind the eye.",
                   [[(x, 1, z, 32 * x, 32 * z) for x, z in corners]])
    for name, near in (("nearest", NEAREST), ("1", 1), ("1000", 1000)):
        yield made(f"near_plane_{name}", f"A near plane {float(near):.4g} before the eye, ground through it.",
                   [floor(Fraction(near) / 2, (-2000, 2000), (-2000, 2000), (16000, 16000))],
                   near=Fraction(near))
    near = Fraction(1, 2)
    for off, where in ((-UNIT, "1_unit_behind"), (0, "on"), (UNIT, "1_unit_before")):
        z = near + off
        yield made(f"corner_{where}_the_near_plane", "A triangle's nearest corner is "
                   f"{where.replace('_', ' ')} the near plane, the others are before it.",
                   [[(0, Fraction(1, 4), z, 128, 0), (2, 1, 4, 256, 256), (-2, 1, 4, 0, 256)]], near=near)
        yield made(f"edge_{where}_the_near_plane", "A whole edge is.",
                   [floor(Fraction(1, 4), (-Fraction(1, 4), Fraction(1, 4)), (z, 3))], near=near)
        yield made(f"face_{where}_the_near_plane", "All corners are: it lies along that plane.",
                   [sheet((-Fraction(1, 4), -Fraction(1, 4), z), (1, 0, 0), (0, 1, 0),
                          (Fraction(1, 2), Fraction(1, 2)))], near=near)
    yield made("far_behind_the_eye", "One corner 2,000 before the eye, two 2,000 behind it.",
               [[(0, 3, 2000, 8000, 0), (-2000, 3, -2000, 0, 16000), (2000, 3, -2000, 16000, 16000)]])
    yield made("ring_around_the_eye", "32 corners around the eye: the near plane cuts off half.",
               [ring(32, 6, Fraction(1, 2))], ASKEW)
    yield made("box_around_the_eye", "The inside of a box: each face passes the eye.",
               box((-1, -1, -1), (2, 1, 3), inward=True), ASKEW, around=True)


def edge_on() -> Iterator[MeshCase]:
    """Faces whose plane passes through the eye, or some units beside it. Rounding decides if they
    are seen from the front; a line of pixels depends on it."""
    for off, where in ((-UNIT, "1_unit_above"), (0, "through"), (UNIT, "1_unit_below"),
                       (64 * UNIT, "64_units_below")):
        said = where.replace("_", " ")
        yield made(f"plane_{where}_the_eye", f"Ground whose plane is {said} the eye.",
                   [floor(off, (-1, 1), (2, 4))])
        yield made(f"box_its_top_{where}_the_eye", f"A box; the plane of its top is {said} the eye.",
                   box((-1, off, 3), (1, off + 1, 5)), ROLLED)
        yield made(f"side_{where}_the_eye_far_away", "A box of 2,000 some 4,000 away, a side's plane "
                   f"{said} the eye.",
                   box((-1000, 0, -1000), (1000, 2000, 1000)), ASKEW, eye=(0, -off, -5000))
    for lean in (1, 64):
        for both in (False, True):
            for side, where in ((1, "below"), (-1, "above")):
                edges = [[(-1, side * lean * UNIT, 2, 0, 256), (-1, -side * lean * UNIT, 4, 0, 0),
                          (1, -side * lean * UNIT, 4, 256, 0), (1, side * lean * UNIT, 2, 256, 256)][::-1]]
                yield made(f"leaning_{lean}_units_{where}{'_two_sided' * both}", "Ground that leans by "
                           f"{2 * lean} units over its length: its plane is {3 * lean} units {where} the "
                           "eye, and a line of pixels lies on it.", edges, two_sided=both)
    yield made("box_from_its_corner", "Three sides' planes run almost through the eye.",
               box((-UNIT, -UNIT, 2), (1, 1, 3)), ROLLED)


def guard_bands() -> Iterator[MeshCase]:
    """Faces that leave the range that may be projected: 128 pixels from the screen's middle."""
    for name, (x, y) in {"left": (-1, 0), "right": (1, 0), "above": (0, -1), "below": (0, 1),
                         "corner": (1, 1)}.items():
        face = sheet((-1 + 7 * min(x, 0), -1 + 7 * min(y, 0), 2), (2 + 7 * abs(x), 0, 0),
                     (0, 2 + 7 * abs(y), 0), texels=(512, 512))
        yield made(f"out_of_the_guard_band_{name}", f"A wall that goes on out of it, {name}.", [face],
                   ROLLED if name == "corner" else STRAIGHT)
    yield made("out_of_the_guard_band_everywhere", "A wall that leaves it on all sides.",
               [sheet((-50, -60, 2), (100, 0, 0), (0, 120, 0), texels=(6400, 7680))], ROLLED)
    for off, where in ((-UNIT, "inside"), (0, "on"), (UNIT, "outside")):
        yield made(f"edge_{where}_the_guard_band", "An edge of it is at the border, or a unit beside.",
                   [sheet((0, -1, 2), (4 + off, 0, 0), (0, 2, 0))])
    yield made("all_corners_beyond_other_borders", "Every corner is outside another border; the middle "
               "is seen.",
               [[(-9, -9, 3, 0, 0), (-9, 9, 3, 0, 512), (9, 9, 3, 512, 512), (9, -9, 3, 512, 0)]], ROLLED)
    yield made("beside_the_view", "Its corners are outside different borders, and nothing of it is seen.",
               [[(9, 0, 1, 0, 0), (0, 12, 1, 0, 256), (12, 12, 1, 256, 256)]])
    yield made("spike", "A spike 2,000 long aside, a thirtieth high.",
               [[(0, -Fraction(1, 64), 2, 0, 0), (0, Fraction(1, 64), 2, 0, 64), (2000, 0, 2, 16000, 32)]])
    for count in (8, 32):
        yield made(f"ring_of_{count}_through_the_borders", f"{count} corners, some outside each border.",
                   [ring(count, 12, Fraction(5, 4), (0, 8))], ASKEW)
    yield made("longer_lens", "A lens twice as long: the borders are nearer.",
               [sheet((-7, -1, 4), (14, 0, 0), (0, 2, 0), texels=(1024, 256))], ROLLED, focal=2 * FOCAL)


def horizons() -> Iterator[MeshCase]:
    """Ground up to the horizon, 2,000 and 10,000 away, from eyes high and low."""
    for height in (Fraction(1, 64), 1, 100):
        for name, turn in (("", STRAIGHT), ("_rolled", ROLLED), ("_askew", ASKEW)):
            yield made(f"floor_{label(height)}_below_the_eye{name}", f"Ground {float(height):.4g} below "
                       "the eye, from behind it to 2,000 ahead.",
                       [floor(height, (-2000, 2000), (-48, 2000), (16000, 16000))], turn)
    yield made("floor_to_10000", "Ground from 6,000 to 10,000 away, its mesh's origin 8,000 from the eye.",
               [floor(0, (-2000, 2000), (-2000, 2000), (16000, 16000))], eye=(0, -3000, -8000))
    yield made("ceiling", "A ceiling to 2,000.",
               [floor(-1, (-2000, 2000), (-9, 2000), (16000, 16000))[::-1]])
    ground = floor(1, (-900, 900), (-9, 900), (9000, 9000))
    yield made("floor_in_triangles", "Ground of two triangles, cut by different borders.",
               [[ground[k] for k in part] for part in ((0, 1, 2), (0, 2, 3))], ASKEW)


def grazing() -> Iterator[MeshCase]:
    """Walls that pass the eye closely."""
    for aside in (UNIT * 4, UNIT * 8, Fraction(1, 256), Fraction(1, 16), Fraction(1, 2)):
        for name, turn in (("", STRAIGHT), ("_askew", ASKEW)):
            yield made(f"wall_{label(aside)}_aside{name}", f"A wall {float(aside):.4g} beside the eye, "
                       "from behind it to 100 ahead.",
                       [sheet((aside, -1, 100), (0, 0, -108), (0, 2, 0), texels=(6912, 128))], turn,
                       near=NEAREST)
    for name, eye in {"middle": (0, 0, 0), "1_64_from_a_wall": (Fraction(127, 64), 0, -8),
                      "in_a_corner": (-Fraction(255, 128), Fraction(191, 128), -20)}.items():
        walls = box((-2, -Fraction(3, 2), -30), (2, Fraction(3, 2), 30), inward=True)
        for way, turn in (("", STRAIGHT), ("_askew", ASKEW)):
            yield made(f"corridor_{name}{way}", f"A corridor 60 long, the eye {name.replace('_', ' ')}: "
                       "every wall passes it.", walls, turn, eye=eye, near=NEAREST, around=True)


def tiny_and_huge() -> Iterator[MeshCase]:
    """Faces of some units and of thousands in one mesh."""
    lengths = [4 * UNIT * 2 ** k for k in range(24)]
    edges = [sum(lengths[:k], Fraction(0)) for k in range(25)]
    strip = [floor(Fraction(1, 4), (-1, 1), (Fraction(1, 4) + a, Fraction(1, 4) + b))
             for a, b in zip(edges, edges[1:])]
    for name, turn in (("", STRAIGHT), ("_askew", ASKEW)):
        yield made(f"strip_of_doubling_faces{name}", "24 faces in a row, from 4 units long to 512, each as "
                   "long as all before it.", strip, turn)
    side = 8 * UNIT
    tiny = box((-side, -side, 0), (side, side, 2 * side))
    yield made("tiny_box", "A box of 16 units near the eye, on ground of 4,000.",
               [floor(1, (-2000, 2000), (-2000, 2000), (16000, 16000)), *tiny], ROLLED,
               eye=(0, 0, -Fraction(1, 128)), near=NEAREST)
    yield made("box_in_one_pixel", "A box that covers one pixel.",
               box((-Fraction(1, 2), -Fraction(1, 2), 60), (Fraction(1, 2), Fraction(1, 2), 61)), ASKEW)
    yield made("ball_within_a_pixel", "A ball of 112 faces far away, all of it smaller than a pixel.",
               ball(4, (0, 0, 0), 8), ASKEW, eye=(3, 5, -9000))
    yield made("ball_of_small_faces", "A ball of 224 faces, most of them smaller than a pixel.",
               ball(300, (0, 0, 0), 16), ASKEW, eye=(0, 0, -3000))
    yield made("ball_around_the_eye", "The same from inside, the eye near its wall: huge and small at once.",
               ball(300, (0, 0, 0), 16, inward=True), ASKEW, eye=(0, 0, -270), around=True)
    yield made("largest", "A box of the largest size from close by.",
               box((-REACH, -REACH, -REACH), (REACH, REACH, REACH)), ASKEW, eye=(-2100, 2500, -5000))


def orders() -> Iterator[MeshCase]:
    """Faces that hide one another."""
    walls = [sheet((-2 - z, -2 - z, 3 + z), (4, 0, 0), (0, 4, 0), start=(32 * z, 0)) for z in (0, 1, 2)]
    yield made("walls_far_ones_first", "Three walls one behind the other, the farthest first.", walls[::-1])
    yield made("walls_near_ones_first", "The same, the nearest first.", walls)
    yield made("box_before_a_wall", "A box that hides part of a wall.",
               [sheet((-9, -9, 12), (18, 0, 0), (0, 18, 0)), *box((-1, -1, 3), (1, 1, 5))], ROLLED)
    yield made("sides_meet", "A box and ground it stands on: their edges meet.",
               [floor(1, (-9, 9), (2, 20)), *box((-1, -1, 4), (1, 1, 6))])


def normals() -> Iterator[MeshCase]:
    """Normals at the limits of an environment's s and t, and of a light's shades."""
    for look in ("environment", "shade"):
        for name, turn in (("", STRAIGHT), ("_askew", ASKEW)):
            yield made(f"{look}_of_a_ball{name}", "Normals of all directions.",
                       ball(1, (0, 0, 3), 12), turn, look=look)
        corners = [[(x, 0, 4, 0, 0), (0, y, 4, 0, 0), (0, 0, 4 + z, 0, 0)][::x * y * z]
                   for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        yield made(f"{look}_of_an_octahedron", "Normals along the axes, where it begins and ends.",
                   corners, look=look)
        yield made(f"{look}_out_of_the_guard_band", "Cut where its corners are far off the screen.",
                   ball(40, (0, 0, 41), 12, inward=True), ASKEW, eye=(0, 0, 3), look=look)


FAMILIES = (near_planes, edge_on, guard_bands, horizons, grazing, tiny_and_huge, orders, normals)


def cases() -> list[MeshCase]:
    """Returns all cases."""
    return [case for family in FAMILIES for case in family()]
