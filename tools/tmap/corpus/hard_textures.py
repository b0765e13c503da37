"""Hard textures, shades and maps: one function per family, in texels of a 256x256 map."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from tmap.base.fixed import ONE, fix
from tmap.corpus.hard_case import LIMIT, HEIGHT, UNIT, WIDTH, Case, fitted, label, laid, make
from tmap.corpus.hard_outlines import box, leaning
from tmap.scene_file.textures import REPEATING

PAGE = 256  # texels
QUAD = [(16.25, 8.5), (112, 20.75), (100.5, 88), (8, 70.25)]
TRIANGLE = [(10.5, 6.25), (118.25, 30), (40.75, 90.5)]
#: Map sizes for mappers that take any size.
MAP_SIZES = ((1, 1), (2, 2), (1, 256), (256, 1), (1, 1024), (1024, 1), (3, 1), (100, 37), (8, 8),
             (8, 1024), (64, 512), (1024, 256))


def on_map(start, along_x, along_y=(0, 0)) -> dict:
    """Returns the arguments of ``make`` for a texture that leaves the map."""
    return {"texture": laid(start, along_x, along_y), "mappers": REPEATING}


def far_outside() -> Iterator[Case]:
    """Coordinates far from the map or negative: only their values modulo 256 may matter."""
    for way, (s, t) in {"s": (1, 0), "t": (0, 1), "both": (1, 1)}.items():
        for far in (-256, -16000, 16000):
            yield make(f"texture_{label(far)}_outside_{way}", f"The map is met {far} texels from "
                       "its origin.", QUAD, **on_map((20.5 + far * s, 30.25 + far * t),
                                                     (1, 0.25), (-0.25, 1)))
    yield make("texture_over_the_whole_range", "Both s and t run through all values they can have.",
               [(0, 0), (WIDTH, 0), (0, HEIGHT)],
               **on_map((-LIMIT, -LIMIT), (255.5, 0), (0, 340)))


def on_texel_borders() -> Iterator[Case]:
    """Pixel centres on borders of texels: a unit decides which texel is shown."""
    for step in (Fraction(1, 2), 1, 2):
        for move in (-UNIT, 0, UNIT):
            yield make(f"texel_borders_step_{label(step)}_{label(move)}_beside",
                       f"Every pixel centre is {label(move).replace('_', ' ')} beside a texel's "
                       "border or middle.", box(10, 10, 100, 80),
                       laid((4 + move, 6 + move), (step, 0), (0, step)))
    yield make("texel_borders_upright", "The map is turned by a quarter, on texel borders.",
               box(10, 10, 100, 80), laid((200, 10), (0, 2), (-2, 0)))


def gradients() -> Iterator[Case]:
    """From 0 to 256 texels per pixel, level and upright, in triangles that cross the screen."""
    for step in (0, UNIT, Fraction(1, 256), Fraction(1, 4), 1, 4, 16, 128, 255, 256):
        start = (-step * 50, -step * 40)
        mappers = {} if step > 1 else {"mappers": REPEATING + ("arbitrary",)}
        start = (3.5, 7.25) if mappers else start
        for way, along in (("level", ((step, Fraction(step, 2)), (0, 0))),
                           ("upright", ((0, 0), (Fraction(step, 2), step)))):
            yield make(f"gradient_{label(step)}_{way}", f"{float(step):.6g} texels a pixel, {way}.",
                       TRIANGLE, **{**on_map(start, *along), **mappers})
    for step in (64, 128, 255):
        yield make(f"gradient_{step}_inside_the_map", f"{step} texels a pixel, on so small a "
                   "triangle that it stays inside the map.",
                   [(50.25, 40), (50.25 + Fraction(250, step), 40), (50.25, 44)],
                   laid((3, 3), (step, 0), (0, 60)))
    yield make("gradient_on_a_sliver", "The plane of a triangle one unit high: steep upright, "
               "ordinary along the line.", [(9.25, 40), (118.5, 40), (60, 40 + UNIT)],
               **on_map((10.5, 20.5), (1, 0), (0, 4096)))
    yield make("gradient_across_a_narrow_sliver", "The plane of a triangle one unit wide: ends "
               "200 texels apart in one unit, far more than 16.16 can step.",
               [(60, 5.5), (60 + UNIT, 50), (60, 90)], laid((10, 20), (200 * ONE, 0), (0, 1)))


def mirrored() -> Iterator[Case]:
    """Gradients below 0: steps carry the other way."""
    for way, along in {"level": ((-1, 0), (0, 1)), "upright": ((1, 0), (0, -1)),
                       "both": ((-1, 0), (0, -1)), "diagonal": ((0, -1), (-1, 0)),
                       "by_a_unit": ((-UNIT, -UNIT), (-UNIT, -UNIT))}.items():
        yield make(f"mirrored_{way}", f"The map is mirrored, {way.replace('_', ' ')}.", QUAD,
                   laid((140.5, 130.25), *along))


def seams() -> Iterator[Case]:
    """From texel 255 to 0: u's and v's carries must not meet each other."""
    ways = {"s_up": ((200, 20), (1, 0)), "s_down": ((40, 20), (-1, 0)),
            "t_up": ((20, 220), (0, 1)), "t_down": ((20, 40), (0, -1)),
            "both_up": ((210, 210), (1, 1)), "both_down": ((40, 40), (-1, -1)),
            "against": ((210, 40), (1, -1)), "every_pixel": ((-15000, -15000), (255, 255)),
            "every_other_pixel": ((255.5, 255.5), (128, 128)),
            "slowly": ((PAGE - 40 * UNIT, PAGE - 40 * UNIT), (UNIT, UNIT))}
    for way, (start, along) in ways.items():
        yield make(f"seam_{way}", f"Lines cross the map's seam, {way.replace('_', ' ')}.",
                   box(3, 10, 120, 80), **on_map(start, along, (0, Fraction(1, 4))))
    for move in (-UNIT, 0, UNIT):
        yield make(f"seam_at_the_last_pixel_{label(move)}", "Each line reaches t = 256, or one "
                   "unit beside, at its last pixel.", box(0, 10, WIDTH, 80),
                   **on_map((10, PAGE - (WIDTH - 1) + move), (0, 1)))
    yield make("seam_upright", "Lines lie before the seam above and behind it below.",
               box(3, 10, 120, 80), **on_map((10.5, 220.5), (1, 0), (0, 1)))


def repeats() -> Iterator[Case]:
    """u crosses the map's seam in lines, once or often, or ends at it: v's row must not change."""
    for count in (1, 2, 8):
        step = Fraction(PAGE * count - 6, 128)
        for way, start, along in (("up", 3, step), ("down", PAGE * count - 3, -step),
                                  ("below_0", 3 - PAGE * count, step),
                                  ("down_below_0", -3, -step)):
            yield make(f"repeats_{count}_times_{way}", f"In each line u runs over {count} of the "
                       f"map's repetitions, {way.replace('_', ' ')}.", box(0, 8, WIDTH, 88),
                       **on_map((start, 20.25), (along, Fraction(1, 8)), (0, 1)))
    for way, start, along in (("up", PAGE - 127, 1), ("down", 126, -1)):
        for move in (-1, -UNIT, 0, UNIT, 1):
            yield make(f"row_{way}_left_by_{label(move)}", "The last pixel of each line shows the row's "
                       f"last texel, or is {label(move).replace('_', ' ')} on.", box(1, 10, WIDTH, 80),
                       **on_map((start + (move if way == "up" else -move), 20), (along, 0), (0, 1)))
    for part in (3, 7, 61):
        for way in (1, -1):
            step = Fraction(way, part)
            yield make(f"row_of_texels_{part}_pixels_long_{'up' if way > 0 else 'down'}", "Lines start on "
                       "a texel's border; their steps have no end in binary.", box(4, 10, 124, 80),
                       **on_map((100, 20), (step, 0), (0, Fraction(1, part))))
    yield make("rows_of_the_map_one_a_line", "Along lines u stays where it is; between them it crosses the "
               "seam.", box(3, 10, 120, 80), **on_map((200.5, 20), (0, 1), (4, 0)))


def up_to_the_last_texel() -> Iterator[Case]:
    """Coordinates that end exactly at the map's end: a pixel beyond would read outside it."""
    outlines = {"box": box(0, 0, WIDTH, HEIGHT), "small_box": box(20, 20, 52, 52),
                "one_pixel": box(50, 50, 51, 51), "offset_box": box(20.5, 20.5, 84.5, 84.5)}
    for shape, points in outlines.items():
        wide, high = points[2][0] - points[0][0], points[2][1] - points[0][1]
        for short in (0, UNIT):
            step = [Fraction(PAGE - short) / Fraction(side) for side in (wide, high)]
            yield make(f"last_texel_{shape}_{label(short)}_short", "Opposite corners have the "
                       "map's first and last coordinates.", points,
                       laid((0, 0), (step[0], 0), (0, step[1])))
            yield make(f"last_texel_{shape}_mirrored_{label(short)}_short", "The same, mirrored.",
                       points, laid((PAGE - short,) * 2, (-step[0], 0), (0, -step[1])))
    triangle = make("last_texel_triangle", "A triangle whose corners are corners of the map.",
                    TRIANGLE)
    texels = ((0, 0), (PAGE << 16, 0), (0, PAGE << 16))
    yield replace(triangle, vertices=tuple(
        (x, y, *texel, *rest) for (x, y, _, _, *rest), texel in zip(triangle.vertices, texels)))


def shades() -> Iterator[Case]:
    """Shades at both ends of the palette: a shade beyond one would wrap to the other."""
    last = PAGE - UNIT
    values = {"all_0": (0, 0, 0), "all_255": (255, 255, 255), "all_last": (last, last, last),
              "0_to_255": (0, 255, 0), "255_to_0": (255, 0, 255), "0_to_last": (0, last, last),
              "by_a_unit": (0, UNIT, 0), "last_by_a_unit": (last, last - UNIT, last)}
    for way, three in values.items():
        yield make(f"shades_{way}", f"Its shades are {way.replace('_', ' ')}.", TRIANGLE,
                   shades=three, mappers=("gouraud",))
    for size in (UNIT, 1, 2):
        yield make(f"shades_0_to_255_in_{label(size)}", "All shades there are in a few pixels or "
                   "less.", [(50, 10), (50 + size, 50), (50, 90)], shades=(0, last, 0),
                   mappers=("gouraud",))


def long_spans() -> Iterator[Case]:
    """Steps that are no multiple of 1/65536, over the longest way: their roundings add up."""
    for k, step in enumerate((Fraction(1, 3), Fraction(2, 131), 1 + Fraction(1, 131072),
                              -Fraction(100, 7))):
        yield make(f"long_span_{k}", f"Spans of the whole screen with steps of {float(step):.6g}.",
                   box(0, 0, WIDTH, HEIGHT), **on_map((0.5, 200.5), (step, -step), (step / 7, 1)))
        yield make(f"long_span_{k}_from_afar", "Spans that begin at the first column of all; the "
                   "screen shows their middle.", box(-LIMIT, 10, LIMIT - UNIT, 80),
                   **on_map((0.5 - LIMIT * step / 16, 200.5 + LIMIT * step / 16),
                               (step / 16, -step / 16), (step / 7, 1)))
    for where, step in (("first", Fraction(63, 16)), ("last", -Fraction(63, 16))):
        left = 43 + Fraction(1, 20)
        start = Fraction(1, 16) if where == "first" else PAGE - Fraction(1, 16) - UNIT
        away = step * (60 - left)
        case = make(f"long_edge_beside_the_{where}_texel", "A left side from the first line of "
                    "all, beside the end of map and palette: were it to drift, a pixel too far left "
                    "would be beyond it.",
                    [(left - leaning(Fraction(69, 20)), -LIMIT), (left, HEIGHT),
                     (60, HEIGHT)], shades=[start, start, start + away])
        yield replace(case, vertices=tuple(
            (x, y, fix(s), fix(t), *rest) for (x, y, _, _, *rest), s, t
            in zip(case.vertices, (start, start, start + away), (10, 100, 100))))


def map_sizes() -> Iterator[Case]:
    """Maps of one texel, one column, one row, and very different sides."""
    for size in MAP_SIZES:
        mappers = ("arbitrary", "columns")
        name = f"map_{size[0]}x{size[1]}"
        if min(size) <= 3:
            yield make(name, "A polygon somewhere on so narrow a map.", QUAD, mappers=mappers,
                       map_size=size)
        ends = [Fraction(PAGE * side, max(size)) for side in size]
        yield make(f"{name}_all_of_it", "The screen shows the map from its first to its last "
                   "texel.", box(0, 0, WIDTH, HEIGHT),
                   laid((0, 0), (ends[0] / WIDTH, 0), (0, ends[1] / HEIGHT)), mappers=mappers,
                   map_size=size)
    yield make("map_1x1_on_a_sliver", "One texel on a triangle one unit high.",
               [(9.25, 40), (118.5, 40), (60, 40 + UNIT)], fitted((1, 1)), mappers=("arbitrary",),
               map_size=(1, 1))


FAMILIES = (far_outside, on_texel_borders, gradients, mirrored, seams, repeats,
            up_to_the_last_texel, shades, long_spans, map_sizes)
