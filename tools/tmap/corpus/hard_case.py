"""A hard polygon and the code that its makers share: outlines in pixels, planar textures, shades.

Makers give numbers in pixels and texels: integers, fractions or floats that are multiples of
1/65536. ``make`` rounds them to 16.16 once. Textures are affine functions of the rounded x and y,
in exact fractions, so they are planar to 1/65536 texel however thin or large the polygon is.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from tmap.base.fixed import ONE, fix
from tmap.scene_file import textures
from tmap.setup.texturing import Settings

WIDTH, HEIGHT = 128, 96  # pixels of every case's frame
UNIT = Fraction(1, 65536)
LIMIT = 16384  # pixels and texels: coordinates reach from -LIMIT to LIMIT - UNIT
MAPPERS = textures.MAPPERS[1]  # those that draw one-byte pixels
SPREAD = Fraction(15, 16)  # the part of a map that a fitted texture uses

Points = list[tuple[Fraction, Fraction]]
Texture = Callable[[Points], list[tuple[Fraction, Fraction]]]


@dataclass(frozen=True)
class Case:
    """A named polygon. ``vertices``: (x, y, s, t, shade, w), 16.16, as struct vertex."""

    name: str
    sentence: str  # why it is hard
    vertices: tuple[tuple[int, int, int, int, int, int], ...]
    mappers: tuple[str, ...] = MAPPERS  # the mappers that draw it
    map_size: tuple[int, int] = (256, 256)  # width, height, if the mapper takes any size
    depth: bool = False  # drawn with every perspective


def laid(start: tuple, along_x: tuple, along_y: tuple = (0, 0)) -> Texture:
    """A texture from (s, t) at the first vertex and their growth per pixel right and down."""
    def texture(points: Points) -> list[tuple[Fraction, Fraction]]:
        x0, y0 = points[0]
        return [tuple(Fraction(a) + Fraction(b) * (x - x0) + Fraction(c) * (y - y0)
                      for a, b, c in zip(start, along_x, along_y)) for x, y in points]
    return texture


def spread(values: list[Fraction], low: Fraction, high: Fraction, steepest: int) -> list[Fraction]:
    """Scales values by at most ``steepest``; moves them so that they are in a range's middle."""
    least, extent = min(values), max(values) - min(values)
    scale = min(Fraction(steepest), (high - low) / extent) if extent else 0
    first = (low + high - scale * extent) / 2
    return [first + scale * (value - least) for value in values]


def fitted(size: tuple[int, int] = (256, 256)) -> Texture:
    """A rotated texture of at most one texel per pixel that stays inside a map of this size."""
    def texture(points: Points) -> list[tuple[Fraction, Fraction]]:
        turned = ([Fraction(4 * x + 3 * y, 5) for x, y in points],
                  [Fraction(4 * y - 3 * x, 5) for x, y in points])
        margin = (1 - SPREAD) / 2
        ends = [Fraction(256 * side, max(size)) for side in size]
        return list(zip(*(spread(values, margin * end, (1 - margin) * end, 1)
                          for values, end in zip(turned, ends))))
    return texture


def make(name: str, sentence: str, points, texture: Texture | None = None, shades=None,
         mappers: tuple[str, ...] = MAPPERS, map_size: tuple[int, int] = (256, 256)) -> Case:
    """Returns a case from points in pixels; its texture and shades are fitted unless given."""
    corners = [(fix(x), fix(y)) for x, y in points]
    exact = [(x * UNIT, y * UNIT) for x, y in corners]
    plane = (texture or fitted(map_size))(exact)
    if shades is None:
        shades = spread([2 * x + y for x, y in exact], Fraction(0), Fraction(255), LIMIT)
    return Case(name, sentence,
                tuple((*corner, fix(s), fix(t), fix(shade), ONE)
                      for corner, (s, t), shade in zip(corners, plane, shades)), mappers, map_size)


def label(value) -> str:
    """Returns a number for a name: "3", or "32768_units" of 1/65536 if it has a fraction."""
    whole = Fraction(value).denominator == 1
    count = abs(value) if whole else abs(value) / UNIT
    return ("minus_" if value < 0 else "") + str(count) + (
        "" if whole else "_unit" if count == 1 else "_units")


def called(case, settings: Settings) -> str:
    """Returns the name in messages of a drawing of a Case or a MeshCase."""
    ways = ", ".join(str(value) for value in vars(settings).values() if value)
    return f"{case.name}: {case.sentence} {ways}"
