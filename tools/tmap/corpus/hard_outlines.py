"""Hard outlines: one function per family, in pixels of a frame of WIDTH x HEIGHT."""

import math
from collections.abc import Iterator
from fractions import Fraction

from tmap.base.elementary import cos, sin
from tmap.corpus.hard_case import LIMIT, HEIGHT, UNIT, WIDTH, Case, label, make

MIDDLE = (WIDTH // 2, HEIGHT // 2)
#: Lengths near the limits of the format: pixels.
SMALL = (UNIT, 2 * UNIT, 256 * UNIT, Fraction(1, 2), 1 - UNIT, 1, 1 + UNIT)
FARTHEST = LIMIT - UNIT
#: The eight directions on the screen, by name.
OCTANTS = {"right": (1, 0), "right_down": (1, 1), "down": (0, 1), "left_down": (-1, 1),
           "left": (-1, 0), "left_up": (-1, -1), "up": (0, -1), "right_up": (1, -1)}


def box(left, top, right, bottom) -> list[tuple]:
    """Returns a rectangle, clockwise on the screen."""
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


def ring(count: int, radius, centre=MIDDLE, turn: float = 0.3) -> list[tuple]:
    """Returns a regular polygon, clockwise on the screen."""
    angles = [turn + math.tau * k / count for k in range(count)]
    return [(centre[0] + float(radius) * cos(a), centre[1] + float(radius) * sin(a))
            for a in angles]


def leaning(units: Fraction) -> Fraction:
    """Returns the pixels by which an edge of ``units`` (1/65536 pixel per line) moves from the
    first line of the range to the screen's end."""
    return units * UNIT * (LIMIT + HEIGHT)


def slivers() -> Iterator[Case]:
    """Height or width from 1/65536 pixel up: huge slopes, tiny areas, a unit decides coverage."""
    for size in SMALL:
        yield make(f"sliver_{label(size)}_high", "Its flat top lies on a scanline and shows, "
                   "however low the triangle is.", [(9.25, 40), (118.5, 40), (60, 40 + size)])
        yield make(f"sliver_{label(size)}_wide", "Its upright side lies on a column of pixel "
                   "centres, and no other is near.", [(60, 5.5), (60 + size, 50), (60, 90)])
    for size in SMALL[::3]:
        yield make(f"sliver_{label(size)}_high_hanging", "Its flat bottom on a scanline is left "
                   "out: nothing or only what is above it shows.",
                   [(9.25, 40), (118.5, 40), (60, 40 - size)])
        yield make(f"sliver_{label(size)}_wide_leaning", "A quadrilateral so wide at every height "
                   "that leans: it shows where the lattice happens to meet it.",
                   [(20, 5), (20 + size, 5), (100 + size, 90), (100, 90)])


def needles() -> Iterator[Case]:
    """Long sharp points: both sides are nearly the same edge."""
    ends = {"level": ((2, 48), (125, 48)), "shallow": ((2, 40.3), (125, 50.1)),
            "diagonal": ((2.5, 2.25), (94.5, 94)), "back": ((125, 3), (3, 91)),
            "steep": ((60.3, 1), (66.9, 94)), "upright": ((64, 1), (64, 94)),
            "through": ((-900, -700), (1000, 790))}
    for way, ((x0, y0), (x1, y1)) in ends.items():
        for thick in (UNIT, Fraction(3, 2)):
            across = (0, thick) if abs(x1 - x0) > abs(y1 - y0) else (thick, 0)
            yield make(f"needle_{way}_{label(thick)}", f"A needle across the screen, {way}, "
                       f"{float(thick):.2g} pixels thick at its blunt end.",
                       [(x0, y0), (x1, y1), (x1 + across[0], y1 + across[1])])


def without_area() -> Iterator[Case]:
    """All vertices on one line: the plane's divisor is 0."""
    lines = {"level": [(10, 40), (100, 40), (50, 40)], "upright": [(50, 5), (50, 90), (50, 40)],
             "diagonal": [(10, 10), (40, 40), (90, 90)],
             "there_and_back": [(10, 10), (50, 30), (90, 50), (50, 30)],
             "far": [(-LIMIT, -LIMIT), (LIMIT - 1, LIMIT - 1), (0, 0)]}
    for way, points in lines.items():
        yield make(f"no_area_{way}", "Its vertices lie on one line: no area, no plane, no pixel.",
                   points)


def repeated_vertices() -> Iterator[Case]:
    """Edges of no length, where a divisor would be 0."""
    quad = [(20.5, 10.25), (100, 20), (90.75, 80), (30, 70.5)]
    for k, place in enumerate(("top", "right", "bottom", "left")):
        yield make(f"repeated_{place}_vertex", f"Its {place} vertex is there twice, one after the "
                   "other.", quad[:k + 1] + quad[k:])
    yield make("repeated_every_vertex", "Every vertex is there twice.",
               [vertex for vertex in quad for _ in range(2)])
    yield make("repeated_in_triangle", "A triangle with two equal vertices has no area.",
               [quad[0], quad[0], quad[1]])
    yield make("repeated_62_times", "64 vertices of which 62 are one.", [quad[0]] * 62 + quad[1:3])
    yield make("repeated_only", "All its vertices are one, on a pixel centre.", [(50, 50)] * 3)


def inside_one_pixel() -> Iterator[Case]:
    """Polygons between neighbouring pixel centres: one pixel or none."""
    places = {"between_centres": (50.5, 50.5, 0.25), "round_a_centre": (50, 50, 0.25),
              "round_a_centre_1_unit": (50, 50, UNIT),
              "round_a_centre_half": (50, 50, Fraction(1, 2))}
    for where, (x, y, size) in places.items():
        yield make(f"one_pixel_{where}", "All vertices are in one pixel: it is lit when its centre "
                   "is inside.", box(x - size, y - size, x + size, y + size))
    yield make("one_pixel_up_to_a_centre", "Its last corner is a pixel's centre: right and bottom "
               "do not count, nothing is lit.", box(49.5, 49.5, 50, 50))
    yield make("one_pixel_from_a_centre_on", "Its first corner is a pixel's centre: left and top "
               "count, the pixel is lit.", box(50, 50, 50.5, 50.5))
    yield make("one_pixel_ring_of_64", "64 vertices in one pixel.", ring(64, 0.4, (50, 50)))


def collinear_vertices() -> Iterator[Case]:
    """Vertices in the middle of an edge cut it into sections, which must continue the same edge."""
    corners = [(16, 8), (112, 24), (96, 88), (8, 72)]
    for k, place in enumerate(("top", "right", "bottom", "left")):
        (x0, y0), (x1, y1) = corners[k], corners[(k + 1) % 4]
        cuts = [(x0 + (x1 - x0) * Fraction(n, 8), y0 + (y1 - y0) * Fraction(n, 8))
                for n in range(1, 8)]
        yield make(f"collinear_{place}", f"Seven vertices lie on its {place} edge.",
                   corners[:k + 1] + cuts + corners[k + 1:])
    halves = [((a + c) / 2, (b + d) / 2)
              for (a, b), (c, d) in zip(corners, corners[1:] + corners[:1])]
    yield make("collinear_every_edge", "A vertex lies in the middle of every edge.",
               [p for pair in zip(corners, halves) for p in pair])
    yield make("collinear_triangle_of_64", "A triangle whose left side has 61 vertices more.",
               [(100, 2), *((36 - n, 2 + Fraction(3, 2) * n) for n in range(62)), (101, 95)])


def on_centres() -> Iterator[Case]:
    """Edges and vertices exactly on pixel centres, halfway between, or one unit beside them."""
    shapes = {"box": box(20, 20, 80, 60), "triangle": [(20, 10), (84, 42), (36, 74)],
              "diamond": [(64, 16), (96, 48), (64, 80), (32, 48)]}
    moves = {"on_centres": 0, "half_way": Fraction(1, 2), "1_unit_before_centres": -UNIT,
             "1_unit_behind_centres": UNIT}
    for shape, points in shapes.items():
        for where, move in moves.items():
            yield make(f"{shape}_{where}", f"Vertices lie {where.replace('_', ' ')}: the fill rule "
                       "alone decides about whole edges.",
                       [(x + move, y + move) for x, y in points])


def level_edges() -> Iterator[Case]:
    """Horizontal edges have no slope: they must be left out at top and bottom."""
    for where, move in (("on_a_line", 0), ("above_a_line", -UNIT), ("below_a_line", UNIT)):
        top, bottom = 20 + move, 70 + move
        for which, points in (
                ("top", [(10, top), (110, top), (50, bottom)]),
                ("bottom", [(50, top), (110, bottom), (10, bottom)]),
                ("top_and_bottom", [(30, top), (90, top), (110, bottom), (10, bottom)])):
            yield make(f"level_{which}_{where}", f"Its {which.replace('_', ' ')} is level and lies "
                       f"{where.replace('_', ' ')} or 1 unit from it.", points)
    yield make("level_in_many_parts", "Level top and bottom consist of many edges.",
               [*((20 + 8 * n, 20) for n in range(11)), *((100 - 8 * n, 70) for n in range(11))])


def between_lines() -> Iterator[Case]:
    """Edges that begin and end between the same two scanlines: sections without a line."""
    tip = [(60, 20.1), (62, 20.2), (66, 20.4), (80, 20.9)]
    yield make("between_lines_tip_right", "Three edges right of the tip meet no scanline.",
               [*tip, (100, 70), (30, 50)])
    yield make("between_lines_tip_left", "Three edges left of the tip meet no scanline.",
               [(128 - x, y) for x, y in reversed([*tip, (100, 70), (30, 50)])])
    yield make("between_lines_both_ends", "So do edges at the tip and at the bottom.",
               [*tip, (100, 50), *((128 - x, 100 - y) for x, y in tip), (28, 50)])
    yield make("between_lines_on_the_side", "In the middle of a side an edge meets no scanline.",
               [(40, 5), (90, 40.2), (91, 40.9), (80, 90), (30, 50)])
    yield make("between_lines_only", "The whole polygon lies between two scanlines.",
               [(10, 40.1), (100, 40.2), (110, 40.9), (30, 40.7)])


def slopes() -> Iterator[Case]:
    """An edge of each slope crosses the screen, as left and as right side."""
    for slope in (UNIT, Fraction(1, 4096), Fraction(1, 16), Fraction(1, 2), 1, 2, 16, 256, 4096,
                  LIMIT):
        height = min(Fraction(88), Fraction(2 * FARTHEST, slope), Fraction(100 * 96, slope))
        height = max(height, 1 + UNIT)
        half = height * slope / 2
        upper = (64 - half, 40 if height < 40 else 4)
        lower = (64 + half, upper[1] + height)
        yield make(f"slope_{label(slope)}_on_the_left", f"Its left side moves {float(slope):.6g} "
                   "pixels a line.", [upper, (min(lower[0] + 30, FARTHEST), upper[1]), lower])
        yield make(f"slope_{label(slope)}_on_the_right", f"Its right side moves {float(slope):.6g} "
                   "pixels a line.", [upper, lower, (max(upper[0] - 30, -LIMIT), lower[1])])
    yield make("slope_steepest", "The whole range in a line and a unit: the greatest slope of all.",
               [(-LIMIT, 40), (FARTHEST, 41 + UNIT), (-LIMIT, 44)])


def sizes() -> Iterator[Case]:
    """From one pixel to the whole range of coordinates."""
    for size in (1, 2, 4, 16, 64, 256, 1024, 4096, LIMIT):
        yield make(f"triangle_{size}_pixels", f"A triangle {size} pixels large round the middle.",
                   ring(3, Fraction(size, 2)))
    for size in (1, 128, LIMIT):
        yield make(f"hexagon_{size}_pixels", f"A hexagon {size} pixels large round the middle.",
                   ring(6, Fraction(size, 2)))
    yield make("box_of_the_whole_range", "All coordinates are the first or the last there is.",
               box(-LIMIT, -LIMIT, FARTHEST, FARTHEST))
    yield make("triangle_of_the_whole_range", "Half of the whole range of coordinates, cut "
               "along the diagonal.", [(-LIMIT, -LIMIT), (FARTHEST, FARTHEST), (-LIMIT, FARTHEST)])


def off_screen() -> Iterator[Case]:
    """Vertices off the screen in every octant, near and far, alone and together."""
    x, y = MIDDLE
    for name, (right, down) in OCTANTS.items():
        for far in (200, 16000):
            yield make(f"vertex_{far}_{name}", f"One vertex is {far} pixels off to the {name}.",
                       [(x + 30 * down - 5, y - 30 * right + 3), (x + far * right, y + far * down),
                        (x - 30 * down - 10 * right, y + 30 * right - 10 * down)])
        yield make(f"off_screen_{name}", f"It lies wholly to the {name} of the screen.",
                   ring(5, 40, (x + 180 * right, y + 180 * down)))
    yield make("vertices_in_every_octant", "A vertex in each octant off the screen, all at once.",
               [(x + a * 9000, y + b * 9000) if a and b else (x + a * 12000, y + b * 12000)
                for a, b in OCTANTS.values()])


def at_the_border() -> Iterator[Case]:
    """Polygons that touch the screen's border: no pixel, or only its first or last."""
    for over, what in ((0, "touches"), (UNIT, "crosses_1_unit"), (1, "crosses_1_pixel")):
        places = {"left": [(-40, 20), (over, 50), (-30, 80)],
                  "right": [(170, 20), (160, 80), (WIDTH - 1 + (1 - over), 50)],
                  "top": [(20, -40), (90, -30), (60, over)],
                  "bottom": [(20, 130), (60, HEIGHT - 1 + (1 - over)), (90, 140)]}
        for side, points in places.items():
            yield make(f"{what}_{side}_border", "The polygon lies outside but for a corner at the "
                       f"{side} border.", points)
    yield make("exactly_the_screen", "Its edges are the screen's borders.",
               box(0, 0, WIDTH, HEIGHT))
    yield make("one_unit_round_the_screen", "It is a unit larger than the screen on all sides.",
               box(-UNIT, -UNIT, WIDTH + UNIT, HEIGHT + UNIT))
    yield make("one_unit_inside_the_screen", "It is a unit smaller than the screen on all sides.",
               box(UNIT, UNIT, WIDTH - UNIT, HEIGHT - UNIT))


def vertex_counts() -> Iterator[Case]:
    """From 3 to 64 vertices, every other one anticlockwise."""
    for k, count in enumerate((3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 48, 63, 64)):
        yield make(f"{count}_vertices", f"A ring of {count} vertices.",
                   ring(count, 42.7)[::-1 if k % 2 else 1])
    yield make("64_vertices_off_screen", "64 vertices most of which are clipped away.",
               ring(64, 300, (260, 180)))


def windings() -> Iterator[Case]:
    """The same polygon from every vertex on, in both directions."""
    shapes = {"triangle": [(20.3, 10.7), (110.1, 40.2), (40.9, 85.5)], "pentagon": ring(5, 44.1)}
    for shape, points in shapes.items():
        for first in range(0, len(points), 2):
            turned = points[first:] + points[:first]
            yield make(f"{shape}_clockwise_from_{first}", f"Clockwise, vertex {first} first.",
                       turned)
            yield make(f"{shape}_anticlockwise_from_{first}",
                       f"Anticlockwise, vertex {first} last.", turned[::-1])


def nearly_concave() -> Iterator[Case]:
    """A vertex slightly off the straight line between its neighbours, to either side."""
    for bulge in (UNIT, 16 * UNIT, -UNIT):
        what = "dented" if bulge < 0 else "bulging"
        size = label(abs(bulge))
        by = f"{what} by {size.replace('_', ' ')}"
        yield make(f"{what}_{size}_right", f"A right side {by}.",
                   [(30, 5), (90, 5), (90 + bulge, 50), (90, 90), (30, 90)])
        yield make(f"{what}_{size}_left", f"A leaning left side {by}.",
                   [(100, 4), (110, 90), (20, 84), (60 - bulge, 44)])
    yield make("bulging_1_unit_top", "A level top with a vertex 1 unit above it.",
               [(20, 20), (64, 20 - UNIT), (110, 20), (64, 80)])


def long_edges() -> Iterator[Case]:
    """Edges that begin 16,384 lines above the screen: the lines' roundings add up."""
    for k, (x0, x1) in enumerate(((20, 100), (-5000, 5100), (100.3, 20.7))):
        yield make(f"long_edge_{k}", "An edge through all lines there are; the screen shows "
                   f"those in the middle, where its slope of {(x1 - x0) / 32767:.4f} has drifted.",
                   [(x0, -LIMIT), (x1 + 20, FARTHEST), (x1, FARTHEST)])
        yield make(f"long_edge_{k}_ends_on_screen", "An edge from the first line of all, at its "
                   "end on the screen, where it has drifted most.",
                   [(x0, -LIMIT), (x1 / 50 + 100, 90.5), (x1 / 50, 91.25)])
    for way, units in (("down", Fraction(69, 20)), ("up", Fraction(71, 20))):
        lean = leaning(units)
        yield make(f"long_edge_ends_at_right_border_rounded_{way}", "A right side from the first "
                   "line of all ends a unit from the screen's right border: it must not drift "
                   "across.", [(1, -LIMIT), (WIDTH - UNIT - lean, -LIMIT), (WIDTH - UNIT, HEIGHT),
                               (1, HEIGHT)])
        yield make(f"long_edge_at_the_last_column_rounded_{way}", "A right side from the first "
                   "line of all ends at the last x there is: it must not drift across.",
                   [(0, -LIMIT), (FARTHEST - lean, -LIMIT), (FARTHEST, HEIGHT), (0, HEIGHT)])
    lean = 53 * UNIT  # in 97 lines: less than a unit a line, rounded to one
    yield make("sides_drift_apart_at_the_whole_range", "Its sides step a little too far out and "
               "leave the range of coordinates, each at one end.",
               [(lean - LIMIT, 0), (FARTHEST - lean, 0), (FARTHEST, HEIGHT + 1), (-LIMIT,
                                                                                  HEIGHT + 1)])


FAMILIES = (slivers, needles, without_area, repeated_vertices, inside_one_pixel,
            collinear_vertices, on_centres, level_edges, between_lines, slopes, sizes, off_screen,
            at_the_border, vertex_counts, windings, nearly_concave, long_edges)
