"""Polygons at a limit of the set-up, where one unit decides how they are drawn: the emulated
machine draws each as the model, and each is on the side of the limit that its name says."""

import random
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import pytest

from tmap.guest import guest_frames
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, ONE, Material, Object, Scene, Texture
from tmap.setup import perspective
from tmap.setup.edges import EDGE_ERROR, measure

#: Rounded edges drift: over 1,000 lines a slope of so many units of 1/65536 for the whole edge,
#: just below half a unit a line, is rounded to zero or to one unit a line.
TALL, DRIFT = 1000, 490
INSIDE = 600  # units of s inside the map: above the error of steps, below that of rounded edges
PAGE = np.random.default_rng(5).integers(0, 256, (256, 256), dtype=np.uint8)


@dataclass
class Border:
    """A polygon: vertices x, y, s, t and w in 16.16, a frame's size, the settings."""

    name: str
    vertices: list[tuple[int, ...]]
    settings: model.Settings
    size: tuple[int, int] = (128, 96)

    @property
    def adapted(self) -> list[tuple]:
        """The vertices in the form the model's set-up takes."""
        return model.adapt([(*v[:4], 0, v[4]) for v in self.vertices], self.settings, 256)

    @property
    def set_up(self):
        return model.set_up(self.adapted, *self.size, True, self.settings, (256, 256))


def affine(name: str, vertices, settings: model.Settings, size) -> Border:
    """A polygon of depth 1."""
    return Border(name, [(*v, ONE) for v in vertices], settings, size)


def all_in_a_line() -> list[Border]:
    """w from 16,384 to 1/256 over 1,018 pixels, with the deep end on the left, at a pixel's centre:
    its weight, q in 2^30 of the line's step, is less than one."""
    corners = [(3 * ONE, 0, 0, 0, 1 << 30), (1021 * ONE, 0, 256 * ONE, 0, 1 << 8),
               (3 * ONE, 5 * ONE, 0, 200 * ONE, 1 << 30)]
    return [Border(f"all depths in a line, {way}", corners, model.Settings("exact", perspective=way),
                   (1024, 6)) for way in ("every16", "every8", "pixel", "fine")]


def sureness(each: Border) -> int:
    """Returns how many times its error the least q of a polygon's planes is, rounded down; at most
    6."""
    corners, sides = each.adapted, measure(each.adapted, *each.size)
    with pytest.MonkeyPatch.context() as patch:
        for times in range(1, 7):
            patch.setattr(perspective, "Q_SURE", times)
            planes = perspective.perspective(corners, sides.corners, sides.box)
            if planes is None or not planes.is_sure:
                return times - 1
    return 6


def hardly_sure(count: int = 4) -> list[Border]:
    """Deep slivers whose q is 1, 2, ... 5 times its error: from four times on they are drawn with
    perspective. Two near corners are side by side, one is far away at the far end of the depth
    range."""
    rng, found = random.Random(4), {times: [] for times in range(1, 6)}
    while min(map(len, found.values())) < count:
        x, y = rng.randint(8, 40) * ONE, rng.randint(8, 80) * ONE
        near = rng.choice((256, 300))
        beside = x + rng.randint(1, 80) * ONE // 16, y + rng.randint(0, 32) * ONE // 16
        corners = [(x, y, 0, 0, near), (*beside, 256 * ONE, 0, near),
                   (rng.randint(90, 127) * ONE, rng.randint(0, 95) * ONE, 0, 256 * ONE,
                    rng.randint(1 << 29, 1 << 30))]
        each = Border("", corners, model.Settings("exact", perspective="fine"))
        made = each.set_up
        if made is None or made.pixels < 20:
            continue
        times = sureness(each)
        if times in found and len(found[times]) < count:
            each.name = f"{times} times as sure, {len(found[times])}"
            found[times].append(each)
    return sum(found.values(), [])


#: Triangles, far at the top and near at the bottom, whose lines change just too much in depth to be
#: level: if nothing were rounded up in that derivation, they would be level. Fields: which of
#: (texels, the change of q, their product) is rounded up; the setting; x, y, s, t and w.
ROUNDED_UP = [
    ((1, 0, 0), "pixel", [(0, 0, 8912896, 0, 671401053), (7602176, 0, 9364661, 524288, 669313789),
                          (2097152, 4980736, 8912896, 196608, 4926)]),
    ((1, 0, 0), "fine", [(0, 0, 8716288, 0, 665112704), (7012352, 0, 8873835, 262144, 664684082),
                         (1703936, 4325376, 8716288, 131072, 77714)]),
    ((0, 1, 0), "fine", [(0, 0, 7274496, 0, 394623581), (4915200, 0, 7375359, 458752, 394479816),
                         (4653056, 4194304, 7274496, 131072, 14440)]),
    ((0, 1, 0), "pixel", [(0, 0, 11927552, 0, 1026721088), (4325376, 0, 12030794, 0, 1021537203),
                          (3538944, 327680, 11927552, 196608, 8255)]),
    ((0, 0, 1), "fine", [(0, 0, 8716288, 0, 665112704), (7012352, 0, 8873835, 262144, 664684082),
                         (1703936, 4325376, 8716288, 131072, 77714)]),
    ((0, 0, 1), "fine", [(0, 0, 5570560, 0, 1013097277), (4128768, 0, 5832447, 458752, 1012715088),
                         (1769472, 5177344, 5570560, 393216, 71166)])]


def hardly_level() -> list[Border]:
    return [Border(f"not level by {part}, {way}, {k}", corners, model.Settings("exact", perspective=way))
            for k, (part, way, corners) in enumerate(ROUNDED_UP)]


def column(x: int, grows: int, wide: int) -> list[tuple[int, int]]:
    """x and y of a triangle along a column of pixels, TALL lines high: one edge starts at x at the
    top and is ``grows`` units further right at the bottom; the third corner is ``wide`` pixels
    beside it."""
    return [(x, 0), (x + grows, TALL * ONE), (x + wide * ONE, TALL * ONE // 2)]


def off_the_frame() -> list[Border]:
    """All corners are left of the frame by less than a pixel. With its slope rounded up to a unit a
    line the right edge crosses into column 0, which is lit from there on."""
    corners = column(-DRIFT - 40, TALL - DRIFT, 0)
    corners[2] = (-ONE * 3 // 4, TALL * ONE // 2)
    return [affine("off the frame, inside by rounding", [(*p, 0, 0) for p in corners],
                   model.Settings("subpixel"), (8, 1024))]


def on_the_maps_border() -> list[Border]:
    """A map that does not repeat, shown from its first to its last texel. An edge on which s is 0,
    or 256, is on the wrong side of pixels' centres by less than 1/128; there u is up to 1/32
    outside. Also right angles on whole pixels, whose steps are rounded."""
    # The exact edge is right of the pixels at 10, or left of those at 90; the drawn one is not.
    first = [(10 * ONE, 0), (10 * ONE + DRIFT, TALL * ONE), (80 * ONE, TALL * ONE // 2)]
    last = [(90 * ONE + 1, 0), (90 * ONE + 1 - DRIFT, TALL * ONE), (20 * ONE, TALL * ONE // 2)]
    made = []
    for noun, corners, edge, other in (("first", first, 0, 256 * ONE - 1), ("last", last, 256 * ONE - 1, 0)):
        st = ((edge, 0), (edge, 256 * ONE - 1), (other, 128 * ONE))
        for turned in (False, True):
            plane = [pair[::-1] if turned else pair for pair in st]
            made.append(affine(f"map's {noun} {'t' if turned else 's'} on a drifting edge",
                               [(*p, *q) for p, q in zip(corners, plane)],
                               model.Settings("subpixel", mapper="arbitrary"), (96, 1024)))
    # Four corners, just inside the map at the edge's ends: what counts is the plane as stepped.
    for sign, x in ((1, 10 * ONE), (-1, 90 * ONE + 1)):
        other = x + sign * 60 * ONE
        corners = [(x, 0), (x + sign * DRIFT, TALL * ONE), (other, TALL * ONE), (other, 0)]
        beside = [sign * (a - x) - Fraction(DRIFT * b, TALL * ONE) for a, b in corners]
        st = [(INSIDE + round(4 * c * Fraction(99, 100)), b // 4) for c, (_, b) in zip(beside, corners)]
        for turned in (False, True):
            plane = [((s, 256 * ONE - 1 - s)[sign < 0], t)[::-1 if turned else 1] for s, t in st]
            made.append(affine(f"{'t' if turned else 's'} of four corners on a drifting edge, {sign}",
                               [(*p, *q) for p, q in zip(corners, plane)],
                               model.Settings("subpixel", mapper="arbitrary"), (96, 1024)))
    for edges in ("integer", "subpixel", "exact"):
        for wide, high in ((96, 90), (97, 89), (67, 93)):
            a, b, c, d = (((x, y), (x * 256 // 96 * ONE, y * 256 // 96 * ONE)) for x, y in (
                (0, 0), (wide, 0), (wide, high), (0, high)))
            for k, three in enumerate(((a, b, d), (b, c, d), (c, d, a), (a, b, c), (a, b, c, d))):
                most = max(max(st) for _, st in three)
                whole = [(x * ONE, y * ONE, *(min(c * 256 * ONE // most, 256 * ONE - 1) for c in st))
                         for (x, y), st in three]
                made.append(affine(f"right angle of {wide} x {high}, {k}, {edges}", whole,
                                   model.Settings(edges, mapper="arbitrary"), (128, 96)))
    return made


def scene_of(some: list[Border]) -> Scene:
    """A scene of polygons with one frame size, one a frame."""
    textures = [Texture(PAGE), Texture(PAGE[::-1].copy(), "linear")]
    materials: dict[Material, int] = {}
    objects, vertices = [], []
    for number, each in enumerate(some):
        s = each.settings
        material = Material(s.mapper, s.edges, s.gradients, s.start, s.clip, s.perspective,
                            int(s.mapper == "arbitrary"))
        objects.append(Object(materials.setdefault(material, len(materials)), len(vertices),
                              len(each.vertices), 0, 1, number))
        vertices += [(*v[:4], 0, v[4]) for v in each.vertices]
    return Scene(*some[0].size, len(some), 7, np.zeros((256, 3), np.uint8), textures, list(materials),
                 objects, np.array(vertices), np.array([IDENTITY]))


@pytest.fixture(scope="module")
def families() -> dict[str, list[Border]]:
    makers = (all_in_a_line, hardly_sure, hardly_level, off_the_frame, on_the_maps_border)
    return {maker.__name__: maker() for maker in makers}


def test_each_is_drawn_as_the_model_has_it(families) -> None:
    """With all rules of lowering and with none."""
    sizes: dict[tuple[int, int], list[Border]] = {}
    for each in sum(families.values(), []):
        sizes.setdefault(each.size, []).append(each)
    scenes = [scene_of(some) for some in sizes.values()]
    found = guest_frames.draw([(this, form) for this in scenes for form in ("addx", "addx OFF all")],
                              "a1200-fast", timed=False)
    wrong = []
    for k, (some, this) in enumerate(zip(sizes.values(), scenes)):
        for number, each in enumerate(some):
            right = model.render(this, number)
            assert len(np.unique(right)) > 1, f"{each.name}: nothing is drawn"
            wrong += [f"{each.name}{off}: {each.vertices}" for off, digests in
                      zip(("", ", without rules"), found[2 * k:2 * k + 2])
                      if not guest_frames.is_models(right, digests[number])]
    assert not wrong, f"{len(wrong)} are not the model's:\n" + "\n".join(wrong)


def test_parts_of_a_line_keep_their_format(families) -> None:
    """The first end's weight would be 0 and is set to 1. No pixel's fraction of the line reaches
    half of the 32-bit range."""
    for each in families["all_in_a_line"]:
        polygon = each.set_up
        line = polygon.lines[0]
        q0, q1 = polygon.perspective.divided(np.array([line.left, line.right - 1]), polygon.top)[0].tolist()
        assert 0 < q0 < line.right - 1 - line.left and q1 > 1 << 29
        made = perspective.ends(polygon.perspective, line.left, line.right, polygon.top)
        assert max((k * (made.last >> 1) << 32) // made.weight(k) for k in range(1, made.n)) < 1 << 31


def test_planes_are_sure_from_four_times_on(families) -> None:
    """Those below four times are drawn affine."""
    for each in families["hardly_sure"]:
        assert (each.set_up.perspective is not None) == (int(each.name[0]) >= 4), each.name


def test_lines_are_not_level_by_what_is_rounded_up(families) -> None:
    """The error of treating the lines as level, in units of q times texels, is at most the
    setting's if one number less is rounded up, and more with all."""
    for each, (rounded, way, _) in zip(families["hardly_level"], ROUNDED_UP):
        polygon = each.set_up
        left, _, right, _ = measure(each.adapted, *each.size).box
        p = polygon.perspective
        assert not polygon.is_level, each.name
        most = p.least * perspective.way(way).off >> 16

        def off(texels: int, change: int, product: int) -> int:
            return ((p.farthest // ONE + texels) * (right - left) * (abs(p.q.dx) // ONE + change) // ONE
                    + product)

        assert off(1, 1, 1) > most >= off(*(1 - r for r in rounded)), each.name


def test_rounding_lights_a_column_that_no_corner_reaches(families) -> None:
    """The corners are less than an edge's error from the column."""
    each, = families["off_the_frame"]
    xs = [v[0] for v in each.vertices]
    assert -EDGE_ERROR < max(xs) < 0
    assert sum(line.right > line.left for line in each.set_up.lines) > TALL // 4


def test_no_texel_beyond_the_map_is_shown(families) -> None:
    """If u or v of the exact plane is at the map's border, or outside by less than the rounding of
    edges, the border's texel is right; every pixel's texel is on the map."""
    some = families["on_the_maps_border"]
    assert sum("drifting" in each.name for each in some) == 8
    for each in some:
        polygon = each.set_up
        for y, line in enumerate(polygon.lines, polygon.top):
            if line.right > line.left:
                for c in polygon.coordinates(y):
                    assert 0 <= c.min() and c.max() < 256 * ONE, f"{each.name}, line {y}"
