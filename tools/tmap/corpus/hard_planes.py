"""Hard planarity: polygons of more than three vertices whose values are not, or hardly, planar."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from tmap.base.fixed import ONE
from tmap.corpus.hard_case import HEIGHT, MAPPERS, WIDTH, Case, make

QUAD = [(20, 10), (104, 22), (96, 80), (12, 70)]
HEXAGON = [(40, 8), (88, 10), (116, 46), (84, 88), (36, 84), (8, 44)]
TEXTURED = tuple(mapper for mapper in MAPPERS if mapper not in ("flat", "gouraud"))


def moved(case: Case, number: int, field: int, by: int) -> Case:
    """Returns the case with one number of a vertex changed by some units."""
    vertex = list(case.vertices[number])
    vertex[field] += by
    return replace(case, vertices=(*case.vertices[:number], tuple(vertex), *case.vertices[number + 1:]))


def uneven() -> Iterator[Case]:
    """Polygons drawn as triangles, so that every vertex has its own values."""
    for number in range(4):
        case = make(f"uneven_quad_vertex_{number}", f"Vertex {number} is 40 texels off the plane of the "
                    "others.", QUAD, mappers=TEXTURED)
        yield moved(case, number, 3, 40 * ONE)
    yield moved(make("uneven_quad_by_1_texel", "A vertex is one texel off the plane of the others.", QUAD,
                     mappers=TEXTURED), 3, 2, ONE)
    yield moved(make("uneven_hexagon", "One of six vertices is 30 texels off the others' plane.", HEXAGON,
                     mappers=TEXTURED), 4, 2, 30 * ONE)
    yield moved(make("uneven_shades", "A shade is 50 off the plane of the others.", QUAD,
                     mappers=("gouraud", "lit_gouraud")), 2, 4, -50 * ONE)
    case = make("uneven_zigzag", "Six vertices say the map's ends by turns.", HEXAGON, mappers=TEXTURED)
    yield replace(case, vertices=tuple((x, y, (20 + 200 * (k & 1)) * ONE, 50 * ONE, *rest)
                                       for k, (x, y, _, _, *rest) in enumerate(case.vertices)))
    yield moved(make("uneven_collinear", "The vertex that is off lies on a side: a triangle of the fan has "
                     "no area.", [QUAD[0], (62, 16), *QUAD[1:]], mappers=TEXTURED), 1, 2, 25 * ONE)
    yield moved(make("uneven_repeated", "Two vertices in one place say another s each.",
                     [*QUAD, QUAD[3]], mappers=TEXTURED), 4, 2, 30 * ONE)
    yield moved(make("uneven_beyond_the_frame", "The vertex that is off lies outside; the edge between the "
                     "triangles crosses a border.", [(20, 10), (300, 22), (290, 180), (12, 70)],
                     mappers=TEXTURED), 2, 2, -20 * ONE)
    sliver = [(10, 20), (70, 20 + Fraction(1, 4)), (WIDTH - 4, 21), (60, 20 + Fraction(5, 8))]
    yield moved(make("uneven_sliver", "A quad less than a pixel high, one vertex 9 texels off.", sliver,
                     mappers=TEXTURED), 2, 3, 9 * ONE)
    case = moved(make("uneven_depth", "The depth of one vertex is not on the plane of the others.", QUAD,
                      mappers=("affine",)), 2, 5, ONE)
    yield replace(case, depth=True)


def hardly_even() -> Iterator[Case]:
    """Polygons as near to the limit as 16.16 allows: fan.c accepts errors by rounding."""
    for units in (4, 16, 31, 32, 33, 64, 4096):
        yield moved(make(f"hardly_even_{units}_units", f"A vertex is {units} units off the plane of the "
                         "others, whose gradients are at most 1.", QUAD, mappers=TEXTURED), 3, 2, units)
    turned = [(64 + Fraction(round(ONE * (x * 0.8 - y * 0.6)), ONE),
               HEIGHT // 2 + Fraction(round(ONE * (x * 0.6 + y * 0.8)), ONE))
              for x, y in ((-40, -20), (40, -20), (40, 20), (-40, 20))]
    case = make("even_turned", "A rectangle that was turned and rounded, its map's corners at its own.",
                turned, mappers=TEXTURED)
    ends = ((1, 1), (255, 1), (255, 255), (1, 255))
    yield replace(case, vertices=tuple((*v[:2], s * ONE, t * ONE, *v[4:])
                                       for v, (s, t) in zip(case.vertices, ends)))


FAMILIES = (uneven, hardly_even)
