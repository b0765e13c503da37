"""The integer model's planarity test of polygons with more than three vertices: c/drawing/fan.c,
which derives the limits. Polygons whose values are not planar are drawn as a fan of triangles from
their first vertex.

Vertices are (x, y, s, t, shade, w), 16.16, as a scene has them.
"""

from tmap.base.fixed import mul, mul_div, signed
from tmap.setup import snapped
from tmap.setup.edges import corners_of
from tmap.setup.texturing import Settings, plane

#: enum planar_values
TEXELS, DEPTHS, SHADES, COLOURS = 1, 2, 4, 8
ALL = 15
#: In what a polygon's caller vouches for: its shades may be SHADE off their plane.
ROUGH, SHADE = 16, 1 << 16
IN_SPACE = ALL - TEXELS  # what is planar on the screen if it is planar in space
FAR = 16384 << 16
ROUNDED = 16  # units
QUICK = (7, 7, 4, 4)
COLOUR_ROUNDED = 2 << 16
Q_ONE = 1 << 29
CORNERS = Settings(mapper="none")  # for a mapper whose u and v share no chain


def asked(material) -> int:
    """Returns the kinds of values that a material (or Settings) draws as planes; for texture units
    see tmap.model.units."""
    if material.mapper in ("flat", "n64", "glide") or material.gradients != "plane":
        return 0
    if material.mapper == "gouraud":
        return SHADES
    return (TEXELS if material.perspective == "none" else DEPTHS) \
        | SHADES * (material.mapper == "lit_gouraud")


def fan(vertices: list) -> list[list]:
    """Returns a polygon's triangles, from its first vertex."""
    return [[vertices[0], *pair] for pair in zip(vertices[1:], vertices[2:])]


def parts(vertices, material, frame: tuple[int, ...], longer: int, vouched: int = 0) -> list:
    """Returns the pieces in which a polygon is drawn: itself, or triangles. ``frame``: width and
    height, then bytes of a pixel unless one; ``longer``: the map's longer side; ``vouched``: kinds of values that are planar without a
    test."""
    if len(vertices) > 3 and snapped.may_draw(
            [(x, y, s * longer + 128 >> 8, t * longer + 128 >> 8) for x, y, s, t, *_ in vertices],
            material, *frame):
        return fan(vertices)
    wanted = asked(material) & ~vouched
    if vouched & ROUGH and max(v[4] for v in vertices) - min(v[4] for v in vertices) <= SHADE:
        wanted &= ~SHADES
    if len(vertices) > 3 and planar(vertices, wanted, SHADE if vouched & ROUGH else 0) != wanted:
        return fan(vertices)
    return [vertices]


def vouched(vertices, mapper: str, coloured: bool, halves: int) -> int:
    """Returns the kinds of values that a scene file marks as planar: those on planes, and those
    that no material of the mapper draws. ``coloured``: shades are colours; ``halves``: 2 if the
    second half of the vertices has s, t and w of a second unit."""
    possible = {"flat": 0, "gouraud": SHADES, "lit_gouraud": TEXELS | SHADES,
                "affine": TEXELS | DEPTHS, "glide": TEXELS | DEPTHS,
                "n64": TEXELS | DEPTHS | (COLOURS if coloured else SHADES)}.get(mapper, TEXELS)
    count, found = len(vertices) // halves, ALL
    for first in range(0, len(vertices), count) if count > 3 else ():
        values = [(*p[:2], *v[2:]) for p, v in zip(vertices, vertices[first:first + count])]
        found &= ALL & ~possible | planar(values, possible)
    return found


def is_parallelogram(vertices) -> bool:
    """Returns true if x, y, s and t of four vertices form a parallelogram up to rounding."""
    if len(vertices) != 4:
        return False
    return all(abs(signed(a - b + c - d)) <= most
               for a, b, c, d, most in zip(*(v[:4] for v in vertices), QUICK))


def moved(gradient: int) -> int:
    """Returns 10 times a gradient's magnitude, in units."""
    return (abs(gradient) >> 13) + (abs(gradient) >> 15)


def lie_on_plane(points, pair, corners, extra: tuple[int, int]) -> bool:
    """Returns true if pairs of values are on two planes, within the limits; ``extra``: the
    allowance of each value beyond that of 16.16."""
    xs, ys = zip(*points)
    box = min(xs) >> 16, min(ys) >> 16, max(xs) >> 16, max(ys) >> 16
    vertices = [(*point, *values) for point, values in zip(points, pair)]
    t, top = plane(vertices, corners, box, CORNERS), vertices[corners[0]]
    for k, ((x, y), values) in enumerate(zip(points, pair)):
        if k in corners:
            continue
        x, y = x - top[0], y - top[1]
        away = (abs(x) >> 16) + (abs(y) >> 16) >> 1
        for value, at, ddx, ddy, more in zip(values, top[2:], (t.dudx, t.dvdx), (t.dudy, t.dvdy), extra):
            ddx, ddy = signed(ddx), signed(ddy)
            most = ROUNDED + more + moved(ddx) + moved(ddy) + away
            if abs(signed(at + mul(ddx, x) + mul(ddy, y) - value)) > most:
                return False
    return True


def divided(vertices) -> tuple[list[tuple[int, int]], list[tuple[int, int]], tuple[int, int]]:
    """Returns pairs (q, s q) and (t q, 0) of vertices (x, y, s, t, shade, w), and the allowances of
    q and of the others beyond that of 16.16."""
    least = min(abs(v[5]) for v in vertices)
    qs = [mul_div(Q_ONE, least, abs(v[5])) * (1 if v[5] > 0 else -1) for v in vertices]
    spans = [[v[k] for v in vertices] for k in (2, 3)]
    bases = [min(span) + (max(span) - min(span) >> 1) for span in spans]
    farthest = max(max(abs(c - base) for c in span) for span, base in zip(spans, bases))
    scale = max(farthest.bit_length(), 16)
    parts = [[(c - base) * q >> scale for c, q in zip(span, qs)] for span, base in zip(spans, bases)]
    unsure = 4 * Q_ONE // least
    return list(zip(qs, parts[0])), [(part, 0) for part in parts[1]], \
        (unsure, unsure + (4 * Q_ONE >> scale) + 2)


def pairs_of(vertices, kind: int, rough: int = 0):
    """Returns the pairs of a kind of values, each with its allowances beyond that of 16.16; ``rough``: that of
    shades."""
    if kind == TEXELS:
        return [([v[2:4] for v in vertices], (0, 0))]
    if kind == DEPTHS:
        first, second, (q, s) = divided(vertices)
        return [(first, (q, s)), (second, (s, 0))]
    if kind == SHADES:
        return [([(v[4], 0) for v in vertices], (rough, 0))]
    return [([(c >> high << 8 & 0xFF0000, c >> high << 16 & 0xFF0000) for c in (v[4] for v in vertices)],
             (COLOUR_ROUNDED, COLOUR_ROUNDED)) for high in (16, 0)]


def planar(vertices, asked: int, rough: int = 0) -> int:
    """Returns those of the kinds ``asked`` whose values are on planes, shades but for ``rough``. Returns all of
    them if that cannot be tested: there is no area, or a coordinate is too far away."""
    quick = TEXELS | DEPTHS * (len({v[5] for v in vertices}) == 1)
    if not asked & ~quick and is_parallelogram(vertices):
        return asked
    corners, area = corners_of(vertices)
    if not area or any(not -FAR <= c < FAR for v in vertices for c in v[:4]):
        return asked
    points = [v[:2] for v in vertices]
    return sum(kind for kind in (TEXELS, DEPTHS, SHADES, COLOURS) if asked & kind
               and all(lie_on_plane(points, pair, corners, extra)
                       for pair, extra in pairs_of(vertices, kind, rough)))
