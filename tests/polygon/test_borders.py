"""A texel border exactly on a pixel centre shows the texel that begins there.

A pixel's centre and a texel's border are both at whole numbers, so an enlarged picture, a sprite or
a panel has such pixels in every column. The expected texels are computed in fractions from the
figure's own numbers.
"""

import itertools
import random
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import pytest

from tmap.accuracy import glide_errors
from tmap.base.fixed import ONE, fix, signed
from tmap.corpus import written
from tmap.glide import polygon
from tmap.glide.coordinates import quotient
from tmap.glide.state import ONE_W
from tmap.model import model
from tmap.model.model import Settings
from tmap.setup import texturing, unit_planes
from tmap.setup.dithered import MOVES
from tmap.setup.perspective import CURVES

WIDTH, HEIGHT = 320, 256
#: Texels a pixel: whole enlargements, reductions, and simple fractions between them.
SCALES = [Fraction(1, n) for n in (1, 2, 3, 4, 5, 6, 7, 9, 10, 11, 13)] + [
    Fraction(n) for n in (2, 3)] + [Fraction(*n) for n in ((2, 3), (3, 2), (3, 4), (4, 3), (5, 3), (3, 7), (8, 5))]
#: The corner of the figure at which s and t begin, and whether s runs down instead of across.
TURNS = list(itertools.product((False, True), (False, True), (False, True)))
LIT = ("lit", "lit_gouraud")
OTHERS = ["affine", "arbitrary", "tiled", "columns", "lit"]  # their gradients are not a plane's
MAPPERS = ["affine", "arbitrary", "tiled", "columns", "generated", "lit", "lit_gouraud", "dithered", "keyed"]
SIDE = {"arbitrary": (96, 80), "columns": (128, 64)}  # the other maps are 256x256


@dataclass(frozen=True)
class Figure:
    """A rectangle of whole pixels that shows texels from ``first`` on, ``scale`` texels a pixel."""

    left: int
    top: int
    width: int
    height: int
    first: tuple[int, int]
    scale: Fraction
    turn: tuple[bool, bool, bool]

    def ways(self, i, j):
        """Pixels from the corner where s and t begin, in the directions of s and t."""
        from_right, from_below, turned = self.turn
        across = self.left + self.width - i if from_right else i - self.left
        down = self.top + self.height - j if from_below else j - self.top
        return (down, across) if turned else (across, down)

    def vertices(self, longer: int) -> list[tuple]:
        """Corners (x, y, s, t, shade, w), 16.16, clockwise from the upper left one."""
        corners = ((0, 0), (self.width, 0), (self.width, self.height), (0, self.height))
        found = []
        for x, y in corners:
            ways = self.ways(self.left + x, self.top + y)
            s, t = (fix((at + way * self.scale) * 256 / longer) for at, way in zip(self.first, ways))
            found.append((self.left + x << 16, self.top + y << 16, s, t, 9 << 16, ONE))
        return found


def figures(mapper: str) -> list[Figure]:
    """Figures of all scales and turns, with random sizes, places and texels. They stay inside maps
    that do not repeat, and inside the map for generated code, which does not draw u that wraps."""
    rng = np.random.default_rng(len(mapper))
    sides, repeats = SIDE.get(mapper, (256, 256)), mapper not in ("arbitrary", "generated")
    found = []
    for scale, turn in itertools.product(SCALES, TURNS):
        size, texels = [], []  # across and down
        for most, side in zip((WIDTH, HEIGHT), sides[::-1] if turn[2] else sides):
            pieces = int(rng.integers(1, min(most // scale.denominator, side // scale.numerator) + 1))
            size.append(pieces * scale.denominator)
            texels.append(pieces * scale.numerator)
        first = [int(rng.choice((0, 1, 64, 255, -3) if repeats else (0, side - used)))
                 for side, used in zip(sides, texels[::-1] if turn[2] else texels)]
        place = [int(rng.integers(0, most - used + 1)) for most, used in zip((WIDTH, HEIGHT), size)]
        found.append(Figure(*place, *size, tuple(first), scale, turn))
    return found


def shown(mapper: str, parts: list[list[tuple]], settings: Settings) -> np.ndarray:
    """The texel (u, v) that each pixel of a frame shows, [2][y][x]; -1 if not drawn."""
    width, height = SIDE.get(mapper, (256, 256))
    texture = np.arange(1, width * height + 1).reshape(height, width)  # none is 0, which may be transparent
    light = np.tile(np.arange(width * height + 1), (64, 1)) if mapper in LIT else None
    frame = np.full((HEIGHT, WIDTH), -1)
    for part in parts:
        polygon = model.set_up(model.adapt(part, settings, max(width, height)), WIDTH, HEIGHT, True,
                               settings, (width, height))
        model.draw(frame, polygon, texture, 0, light)
    return np.where(frame < 0, -1, np.stack([(frame - 1) % width, (frame - 1) // width]))


def wanted(mapper: str, figure: Figure) -> np.ndarray:
    """The expected texels of the figure's pixels, exactly. A map of any size does not repeat:
    beyond its far border is its last texel."""
    j, i = np.mgrid[figure.top:figure.top + figure.height, figure.left:figure.left + figure.width]
    n, d = figure.scale.numerator, figure.scale.denominator
    exact = np.stack(figure.ways(i, j)) * n + np.reshape(figure.first, (2, 1, 1)) * d
    if mapper == "dithered":
        eighths = MOVES[j & 1, i & 1].transpose(2, 0, 1)
        exact, d = exact * 8 + eighths * d, d * 8
    sides = np.reshape(SIDE.get(mapper, (256, 256)), (2, 1, 1))
    return np.minimum(exact // d, sides - 1) if mapper == "arbitrary" else exact // d % sides


def check(mapper: str, figure: Figure, parts: list[list[tuple]], settings: Settings) -> None:
    """Every pixel of the figure shows the exact texel."""
    place = np.s_[:, figure.top:figure.top + figure.height, figure.left:figure.left + figure.width]
    found, exact = shown(mapper, parts, settings)[place], wanted(mapper, figure)
    wrong = np.argwhere((found != exact).any(axis=0))
    if len(wrong):
        y, x = wrong[0]
        pytest.fail(f"{settings}: {figure}: pixel ({x + figure.left}, {y + figure.top}): expected texel "
                    f"{exact[:, y, x]}, found {found[:, y, x]}; {len(wrong)} of {found[0].size} differ")


def cut(vertices: list[tuple]) -> list[list[tuple]]:
    a, b, c, d = vertices
    return [[a, b, c], [a, c, d]]


@pytest.mark.parametrize("mapper", MAPPERS)
def test_planes_show_the_texel_that_begins_on_a_border(mapper: str) -> None:
    """Scales, offsets, flips and quarter turns; whole, and cut along a diagonal, which generated
    code would get wrong by dropping the fractions of lines' starts."""
    for k, figure in enumerate(figures(mapper)):
        settings = Settings(edges=("integer", "subpixel", "exact")[k % 3], mapper=mapper)
        vertices = figure.vertices(max(SIDE.get(mapper, (256, 256))))
        check(mapper, figure, cut(vertices) if k & 8 and mapper != "generated" else [vertices],
              settings)


@pytest.mark.parametrize("mapper", OTHERS)
def test_other_gradients_do_too(mapper: str) -> None:
    """Two divides a polygon, of two triangles, and two divides a scanline."""
    for k, figure in enumerate(figures(mapper)):
        vertices = figure.vertices(max(SIDE.get(mapper, (256, 256))))
        edges = ("integer", "subpixel", "exact")[k % 3]
        check(mapper, figure, cut(vertices), Settings(edges, "polygon", "subtexel", mapper=mapper))
        start = ("truncated", "subtexel")[k & 1]
        check(mapper, figure, [vertices], Settings(edges, "scanline", start, mapper=mapper))


PERSPECTIVES = ("every16", "every8", "pixel", "fine")


def deep_shown(vertices: list[tuple], setting: str) -> np.ndarray:
    return shown("affine", [vertices], Settings("exact", perspective=setting))


@pytest.mark.parametrize("setting", PERSPECTIVES)
def test_floors_show_the_texel_that_begins_on_a_border(setting: str) -> None:
    """Depth is constant along lines: w of line j is 128 / (128 - j), u is w (i - 160) / n and v is
    w j / 2 texels at every pixel, exactly."""
    j, i = np.mgrid[:64, 64:256]
    for n in (1, 2, 3, 4, 6, 8, 12, 16):
        corners = []
        for x, y in ((64, 0), (256, 0), (256, 64), (64, 64)):
            w = Fraction(128, 128 - y)
            corners.append((x << 16, y << 16, fix(w * (x - 160) / n), fix(w * y / 2), 0, fix(w)))
        found = deep_shown(corners, setting)[:, :64, 64:256]
        u = (i - 160) * 128 // (n * (128 - j)) % 256
        v = 64 * j // (128 - j) % 256
        wrong = (found != np.stack([u, v])).any(axis=0)
        assert not wrong.any(), f"{setting}: 1/{n} texel a pixel: {wrong.sum()} pixels, first {np.argwhere(wrong)[0]}"


@pytest.mark.parametrize("setting", PERSPECTIVES)
def test_walls_show_it_where_lines_begin_and_where_they_are_straight(setting: str) -> None:
    """Depth changes along lines: w of column i, from 64 on, is 128 / (128 - near (i - 64)); u is
    half a texel a pixel there, v is w (j - 60) / n texels. The texels are exact all along line 60, and in the
    first column where lines begin there: at the deep end, which is on the left if turned round, or at both."""
    j = np.arange(20, 100)
    for n, near, turned in itertools.product((1, 2, 3, 4, 8), (Fraction(1, 4), Fraction(1, 2), Fraction(15, 16)),
                                             (False, True)):
        corners = []
        for x, y in ((64, 20), (192, 20), (192, 100), (64, 100)):
            way = 192 - x if turned else x - 64
            w = 128 / (128 - near * way)
            corners.append((x << 16, y << 16, fix(w * way / 2), fix(w * (y - 60) / n), 0, fix(w)))
        found = deep_shown(corners, setting)
        assert (found[1, 60, 64:192] == 0).all(), (setting, n, near, turned)
        if turned or setting in CURVES:
            way, w = (128, 1 / (1 - near)) if turned else (0, 1)
            assert (found[0, 20:100, 64] == w * way / 2 // 1 % 256).all(), (setting, n, near)
            exact = [int(w * (k - 60) / n // 1) % 256 for k in j.tolist()]
            assert np.array_equal(found[1, 20:100, 64], exact), (setting, n, near)


def deep_polygon(rng: random.Random) -> tuple[list, list]:
    """x and y of a polygon's corners, and their s, t and w, all 16.16: triangles, and rectangles
    that show one place of the map, so that s, t and w are on planes."""
    points = written.outline(rng, WIDTH, HEIGHT)
    texels = written.texels(rng, points, (256, 256))
    depths = [max(round(w * ONE), 1) for w in written.depths(rng, points)]
    if rng.random() < 0.3:
        texels = [texels[0]] * len(points)
    else:
        del points[3:]
    return points, [(s, t, w) for (s, t), w in zip(texels, depths)][:len(points)]


def test_quotients_of_glides_unit_are_never_below_the_exact_ones() -> None:
    """In perspective too, s and t of every pixel are at least the exact ones of the corners' s, t
    and w, and above by no more than the raised S and W, the format and the rounding explain."""
    rng, seen = random.Random(21), 0
    frame = np.zeros((HEIGHT, WIDTH), np.uint16)
    for number in range(80):
        points, corners = deep_polygon(rng)
        found = unit_planes.set_up_coordinates(points, corners, True, frame,
                                               Settings("exact", mapper="none"), polygon.SCALE)
        if found is None:
            continue
        at, st, w = found
        exact = glide_errors.surface([(*p, *c[:2], 0, c[2]) for p, c in zip(points, corners)], True)
        *overs, inverse = exact.terms(at.x, at.y)
        depth = signed(w.values[0])
        for key, (value, over) in enumerate(zip(st.values, overs)):
            meant = (over << 18) // inverse
            off = quotient(signed(value), depth) - meant
            more = st.above + 2 * unit_planes.divided_more(corners, key, w, polygon.SCALE)
            most = more * ONE_W / np.maximum(depth, 1) + 1
            fits = np.abs(meant) + most < 1 << 31  # 14.18
            k = int(np.argmax(fits & ((off < 0) | (off > most))))
            assert not fits[k] or 0 <= off[k] <= most[k], (
                f"polygon {number}, pixel ({at.x[k]}, {at.y[k]}): {'st'[key]} is {off[k]} / 2^18 above the "
                f"exact {meant[k] / 2**18}, {most[k]:.1f} at most: {points} {corners}")
        seen += len(at.x)
    assert seen > 10**5


def test_a_plane_that_is_not_raised_is_caught(monkeypatch) -> None:
    """With steps to the nearest unit alone the texels fall short: a figure three times enlarged
    shows it."""
    figure = Figure(16, 16, 192, 192, (0, 0), Fraction(1, 3), (False, False, False))
    check("affine", figure, [figure.vertices(256)], Settings())
    for name in ("shortfall", "gentle_shortfall"):
        monkeypatch.setattr(texturing, name, lambda *_: 0)
    with pytest.raises(pytest.fail.Exception, match="expected texel"):
        check("affine", figure, [figure.vertices(256)], Settings())
