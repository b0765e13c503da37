"""Whole polygons and rectangles of the texture unit's model, and their error against the ideal."""

import numpy as np
import pytest

from tests.helpers.arrays import check_equal, check_within
from tests.n64.scene import N, TEXEL0, TEXEL0_SHADE, floor, noise, smooth, square, unit
from tmap.base.errors import UserError
from tmap.ideal import n64
from tmap.ideal.texels import Coordinate, error
from tmap.n64 import images
from tmap.n64.filters import sample
from tmap.n64.misuse import Misuse
from tmap.n64.pixels import picture
from tmap.n64.polygon import Vertex, draw, prepare, rectangle
from tmap.n64.state import CI, COPY, RGBA, State
from tmap.n64.texels import fetch
from tmap.n64.words import Wrap

WIDTH, HEIGHT = 96, 64


def frame(kind=np.uint32) -> np.ndarray:
    """An empty frame."""
    return np.zeros((HEIGHT, WIDTH), kind)


def texture(size: int = 2, width: int = 16, height: int = 16) -> images.Texture:
    """A texture of random RGBA texels."""
    return images.encode(noise(width, height), RGBA, size)


@pytest.mark.parametrize("kind", [np.uint16, np.uint32])
@pytest.mark.parametrize("perspective", [0, 1])
def test_a_magnified_square_is_point_sampled(kind, perspective):
    """Texels of 4 x 4 pixels. With perspective W = 0x7fff is just below 1, and coordinates may be a
    unit too low or high: so s and t start 2 units, a quarter pixel, in."""
    shown = texture()
    state, found = unit(shown, perspective=perspective), frame(kind)
    corners = square(8, 0, 64, 16, 16)
    corners = [v._replace(s=v.s + N // 16, t=v.t + N // 16) for v in corners]
    assert draw(state, found, corners) == 64 * 64 and state.pending
    want = np.kron(images.decode(shown), np.ones((4, 4, 1), np.uint8))
    check_equal(picture(found)[:, 8:72], want, "row, column - 8, channel")
    assert not found[:, :8].any() and not found[:, 72:].any()


def test_values_far_from_zero_wrap():
    """Iterators count modulo 2^32: they wrap after 2048 texels."""
    state, one, other = unit(texture()), frame(), frame()
    corners = square(0, 0, 64, 16, 16)
    draw(state, one, corners)
    draw(state, other, [v._replace(s=v.s + 2048 * N, t=v.t - 2048 * N) for v in corners])
    check_equal(other, one, "row, column")


def test_shade_is_interpolated_and_cut():
    """Shade is interpolated for each pixel and multiplied with the texel; it is not computed if the
    combiner does not read it."""
    state, found = unit(texture(), cycle=TEXEL0_SHADE), frame()
    corners = square(0, 0, 64, 16, 16)
    colours = [(0, 255, 10, 255), (255, 255, 10, 255), (255, 0, 10, 255), (0, 0, 10, 255)]
    corners = [v._replace(colour=c) for v, c in zip(corners, colours)]
    shade = prepare(state, found, corners).shade.reshape(64, 64, 4)
    step = np.arange(64)
    # a gradient rounded to 1/65536 may make a whole number one lower
    check_within(shade[..., 0], 255 * step // 64, 1, "red: row, column")
    check_within(shade[..., 1], 255 - 255 * step[:, None] / 64, 1, "green: row, column")
    assert set(np.unique(shade[..., 2])) <= {9, 10}
    draw(state, found, corners)
    texel = np.kron(images.decode(texture()), np.ones((4, 4, 1), np.uint8)).astype(int)
    check_equal(picture(found)[:, :64], texel * shade + 128 >> 8, "row, column, channel")
    assert prepare(unit(texture()), found, corners).shade is None


def test_polygons_that_draw_nothing():
    """Too few corners, no area, beyond the frame, too large a range of s; a w of 0 is refused."""
    state, found = unit(texture()), frame()
    corners = square(0, 0, 64, 16, 16)
    assert draw(state, found, corners[:2]) == 0
    assert draw(state, found, [v._replace(x=0) for v in corners]) == 0
    assert draw(state, found, square(WIDTH, 0, 8, 1, 1)) == 0
    assert draw(state, found, square(0, 0, 64, 1025, 1)) == 0  # s has too large a range
    assert not found.any() and not state.pending
    state.modes.perspective = 1
    with pytest.raises(UserError, match="a vertex's w is 0"):
        draw(state, found, [v._replace(w=0) for v in corners])


def test_modes_that_draw_no_polygons():
    """Copy and fill mode; indexed texels without a palette."""
    for cycle in (2, 3):
        state = unit(texture(), "point", cycle=TEXEL0)
        state.modes.cycle = cycle
        with pytest.raises(Misuse, match="one-cycle and two-cycle"):
            draw(state, frame(), square(0, 0, 8, 8, 8))
    state = unit(images.encode(smooth(16), CI, 1))
    state.modes.tlut = 0
    with pytest.raises(Misuse, match="without a TLUT"):
        draw(state, frame(), square(0, 0, 8, 8, 8))


def test_rectangles_that_cannot_be():
    """Copies into 32-bit frames or of wide texels, perspective, shade."""
    state = unit(texture(3))
    state.modes.cycle = COPY
    with pytest.raises(Misuse, match="frames of 16 bits"):
        rectangle(state, frame(), (0, 0, 8, 8), 0, 0, 0, 0x1000, 0x400)
    with pytest.raises(Misuse, match="YUV or of RGBA of 32 bits"):
        rectangle(state, frame(np.uint16), (0, 0, 8, 8), 0, 0, 0, 0x1000, 0x400)
    state = unit(texture(), perspective=1)
    with pytest.raises(Misuse, match="perspective must be off"):
        rectangle(state, frame(), (0, 0, 8, 8), 0, 0, 0, 0x400, 0x400)
    with pytest.raises(Misuse, match="shade"):
        rectangle(unit(texture(), cycle=TEXEL0_SHADE), frame(), (0, 0, 8, 8), 0, 0, 0, 1024, 1024)


def drawn(state: State, corners: list[Vertex]):
    """A polygon's pixels: columns, lines, colours."""
    found = frame()
    assert draw(state, found, corners)
    at = prepare(state, found, corners).at
    return at.x, at.y, picture(found)[at.y, at.x]


#: The largest relative error of the divide's reciprocal.
TABLE = 1 / 6430


def units(corners: list[Vertex], perspective: bool) -> float:
    """The largest error of a coordinate, in 1/32 texel: 1 for its own rounding down, plus the
    errors of S and W, which are cut to 16 bits before, S by 1, W by 1 of 32767 where it is nearest
    (weighted by the ratio of depths), plus the reciprocal's error."""
    if not perspective:
        return 1
    ratio = max(v.w for v in corners) / min(v.w for v in corners)
    most = max(max(v.s, v.t) for v in corners) / N * 32
    return 1 + ratio + most * ratio / 32767 + most * TABLE


def steepest(state: State) -> float:
    """The largest difference between neighbouring texels of tile 0 in a channel, along one axis."""
    tile = state.tiles[0]
    t, s = np.mgrid[:1 << tile.t.mask, :1 << tile.s.mask]
    texels = fetch(state, tile, s, t)[..., :3]
    return max(np.abs(np.roll(texels, 1, axis) - texels).max() for axis in (0, 1))


@pytest.mark.parametrize("perspective", [0, 1])
def test_three_point_filter_is_as_near_as_coordinates_are(perspective):
    """The filtered surface is continuous: along each axis a coordinate's error changes the colour
    by that fraction of the steepest step between two texels; rounding the result adds 1/2."""
    state = unit(images.encode(smooth(32), RGBA, 3), "bilerp", perspective=perspective)
    corners = floor(WIDTH, HEIGHT, 2, 6, 60) if perspective else square(0, 0, 64, 30, 30)
    x, y, colours = drawn(state, corners)
    s, t = n64.Surface(corners, bool(perspective)).at(x, y)
    off = error(colours, n64.sample(state, 0, s, t, "three-point"))
    bound = 2 * units(corners, bool(perspective)) / 32 * steepest(state) + 0.5
    assert 0 < off.rms <= off.most <= bound, f"at most {bound} expected, {off} found"


def test_point_sampling_shows_the_exact_texel():
    """Only where the exact coordinate is far enough from a texel's edge."""
    state = unit(images.encode(noise(32, 32), RGBA, 3), perspective=1)
    corners = floor(WIDTH, HEIGHT, 2, 6, 60)
    x, y, colours = drawn(state, corners)
    s, t = n64.Surface(corners, True).at(x, y)
    margin = units(corners, True) / 32
    inside = np.ones(x.size, bool)
    for c in (s, t):
        inside &= (c.fraction > margin) & (c.fraction < 1 - margin)
    assert inside.sum() > 1000
    wanted = n64.sample(state, 0, s, t, "point")
    check_equal(colours[inside], wanted[inside], "pixel among those, channel")


def test_ideal_coordinates():
    """The exact coordinates of a square are known."""
    corners = square(0, 0, 64, 48, 16)
    x, y = np.array([0, 1, 63, 10]), np.array([0, 5, 63, 7])
    s, t = n64.Surface(corners, False).at(x, y)
    assert (s.value == x * 0.75).all() and (t.value == y * 0.25).all()
    s, t = n64.Surface([v._replace(w=7 * N) for v in corners], True).at(x, y)
    assert (s.value == x * 0.75).all() and (t.value == y * 0.25).all()
    assert (n64.Surface(corners, False).distance(x, y) == 0.75).all()


@pytest.mark.parametrize("how", n64.FILTERS)
@pytest.mark.parametrize("wrap", [Wrap(mask=4), Wrap(mask=4, mirror=1), Wrap(clamp=1),
                                  Wrap(mask=4, shift=2), Wrap(mask=4, shift=14)])
def test_ideal_samples_are_the_hardwares_at_whole_coordinates(how, wrap):
    """Every fourth texel, also far beyond the tile; at whole coordinates the filters do not
    blend."""
    state = unit(texture(3), "point" if how == "point" else "bilerp", s=wrap, t=wrap)
    s, t = np.mgrid[-40:41, -40:41].reshape(2, -1)
    found = sample(state, 0, s * 128, t * 128)
    at = [Coordinate(c * 4, np.zeros(c.size)) for c in (s, t)]
    check_equal(found, n64.sample(state, 0, *at, how), "place, channel")


def test_ideal_refuses():
    """Unknown filters, and points behind the viewer."""
    with pytest.raises(UserError, match="filter 'cubic'"):
        n64.sample(unit(texture()), 0, *[Coordinate(np.zeros(1, int), np.zeros(1))] * 2,
                   "cubic")
    corners = [Vertex(0, 0, 0, 0, N), Vertex(64 * N, 0, N, 0, 9 * N), Vertex(0, 64 * N, 0, N, N)]
    with pytest.raises(UserError, match="behind the viewer"):
        n64.Surface(corners, True).at(np.array([200]), np.array([0]))
