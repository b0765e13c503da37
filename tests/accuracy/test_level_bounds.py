"""Level lines whose first pixel is held in the range of the vertices' u and v: polygons that the fuzzer has found,
also mirrored in u and v, so that the other end of the range holds them."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from tmap.fuzz import fuzz, polygons
from tmap.fuzz.families import PERSPECTIVE
from tmap.fuzz.polygons import BLOCK, Fuzzed, frame_size, scene, textures
from tmap.guest import guest_frames
from tmap.ideal import bounds, bounds_perspective
from tmap.model import model
from tmap.setup import level, level_reciprocal
from tmap.setup.texturing import Settings


@dataclass(frozen=True)
class Found:
    """A polygon that the fuzzer has found, with its seed's frame and maps."""

    seed: int
    number: int
    each: Fuzzed
    line: int  # that is held

    @property
    def block(self) -> int:
        return self.number // BLOCK


def tilted(seed: int, number: int, line: int, texture: int, settings: dict, *vertices) -> Found:
    """A polygon of whole pixels, far off the planes of three of its vertices."""
    return Found(seed, number, Fuzzed(vertices, Settings("integer", **settings), texture), line)


#: Before the first pixel's error was stretched in the bound, and what the range takes from it was added to the steps.
TILTED = {
    "seven_corners_6_texels_off": tilted(
        2040, 14347, 27, 0, dict(clip="vertices", perspective="every8"),
        (3735552, 1867776, -11103840, 6329321, 3958029, 1187), (3735552, 2424832, -7346945, 3033287, 11434307, 816),
        (3604480, 2818048, 46784, 1665675, 16711680, 669), (3375104, 2785280, 10513970, 1656006, 16271898, 679),
        (3244032, 2326528, 20738437, 3184856, 10114964, 864), (3309568, 1769472, 24819570, 6896673, 2638686, 1290),
        (3538944, 1572864, 5750799, 9471477, 0, 1562)),
    "five_corners_8_texels_off": tilted(
        2040, 34932, 3, 1, dict(clip="vertices", perspective="every16", tolerance=65536),
        (3826456, 53595, 7287845, -15442246, 0, 3157634), (2893924, 54776, 32990496, -16393366, 43660, 3069684),
        (2802057, 199774, 37639654, -15889186, 5404136, 3229087),
        (3086633, 505637, 34112233, -14029161, 16711680, 3689533),
        (3365177, 492154, 24893413, -13747901, 16213222, 3705554)),
    "six_corners_v_over_11000_texels": tilted(
        2024, 6610, 5, 0, dict(perspective="every8", tolerance=655),
        (704394, 1273384, -3214759, 2801969, 16711680, 1577076),
        (651524, 1205479, -3269689, 8060021, 16424427, 1594015),
        (511717, 327702, -3859516, 27554219, 12711250, 1851026),
        (3522572, -2677176, -5603198, -663095185, 0, 4131304),
        (3852635, -2607057, -5125787, -724437682, 296616, 4015862),
        (4319553, -1834898, -3572583, -643798170, 3563008, 3070903)),
}
#: So narrow that its lines are drawn from their far ends: nothing is held in a range.
NARROW = tilted(
    2040, 21373, 893, 0, dict(clip="vertices", perspective="every16", tolerance=32768),
    (-836673, 57787365, 1601145, -2463299, 12141629, 2628), (247066, 58533332, 1383405, -1964841, 16373285, 2263),
    (1479767, 58592985, 2008275, -1406857, 16711680, 2238), (1917899, 57922241, 3186265, -1026679, 12906742, 2554),
    (1922846, 57712675, 3537654, -956914, 11717934, 2671), (1332864, 56366305, 6303946, -772926, 4080364, 3795),
    (559031, 55647008, 8451955, -1051459, 0, 4894), (-1304748, 57201394, 2116278, -2748406, 8817584, 3010))
#: The first line begins in a corner, at the range's end. q is 4,194 on it: S is raised by 2 texels.
DEEP = Found(2025, 19456, Fuzzed((
    (196608, 393216, -16056320, -20774912, 16777215, 256), (917504, 0, 31850496, 31653888, 8646378, 65536000),
    (8060928, 0, 7667712, 2162688, 0, 65536000)), Settings("snapped", perspective="every8"), 0), 0)


def mirrored(found: Found) -> Found:
    """Returns the polygon with u and v negated."""
    vertices = tuple((x, y, -u, -v, *rest) for x, y, u, v, *rest in found.each.vertices)
    return replace(found, each=replace(found.each, vertices=vertices))


HELD = TILTED | {f"{name}_mirrored": mirrored(found) for name, found in TILTED.items()} | {"deep": DEEP}
#: Level by its tolerance of a texel: that times a part of the least q is over 2^31.
TOLERANT = Found(404, 18899, polygons.polygon(404, 18899, PERSPECTIVE), 0)
ALL = HELD | {"eight_corners_left_of_the_frame": NARROW, "tolerance_of_a_texel": TOLERANT}


def set_up(found: Found) -> tuple[list[tuple], model.Polygon]:
    """Returns the adapted vertices, and the polygon."""
    size = textures(found.seed, found.block)[found.each.texture].texels.shape[::-1]
    vertices = model.adapt(found.each.vertices, found.each.settings, max(size))
    return vertices, model.set_up(vertices, *frame_size(found.block), True, found.each.settings, size)


def test_they_are_drawn_within_their_bounds() -> None:
    """The 68020 draws the model's pixels, all within their bounds."""
    drawn = guest_frames.draw([(scene(each.seed, each.block, [each.each]), "addx") for each in ALL.values()],
                              fuzz.MACHINE, timed=False)
    for (name, found), digests in zip(ALL.items(), drawn):
        fault = fuzz.compare(fuzz.check(found.each, found.seed, found.block), {fuzz.MACHINE: digests[0]})
        assert fault is None, f"{name}: {fault}"


@pytest.mark.parametrize("name", HELD)
def test_the_range_holds_a_first_pixel(name: str) -> None:
    """Without that the polygons would test nothing."""
    vertices, polygon = set_up(ALL[name])
    p, y = polygon.perspective, ALL[name].line
    assert polygon.is_level and bool(p.tilt) == (len(vertices) > 3)
    found = p.quotients(np.array([polygon.lines[y - polygon.top].left]), y)[1]
    assert any(c > high or c < low for c, low, high in zip(found, p.low, p.high))


def test_the_narrow_one_is_drawn_from_far_ends() -> None:
    """Its frame begins right of most of its corners."""
    assert not set_up(NARROW)[1].is_level


def test_lines_whose_q_does_not_grow_are_judged() -> None:
    """It grows, but by less than a step's unit: found by the fuzzer's perspective, seed 303."""
    found = Found(303, 21156, polygons.polygon(303, 21156, PERSPECTIVE), 0)
    _, polygon = set_up(found)
    assert polygon.records and not polygon.is_level and not polygon.constants.dqdx
    assert not fuzz.check(found.each, found.seed, found.block).verdict.complaint


def test_a_first_pixel_past_a_rounded_edge_lowers_its_line() -> None:
    """It is 0.14 texels beyond the range's end: found by the fuzzer's perspective, seed 303, polygon 93770."""
    found = Found(303, 93770, polygons.polygon(303, 93770, PERSPECTIVE), 0)
    assert not fuzz.check(found.each, found.seed, found.block).verdict.complaint
    corners = [(2, 934, 0), (4, 0, 0), (0, 934, 255)]
    vertices = [(x << 16, y << 16, s << 16, 0, 0, 1 << 16 | (not y) << 11) for x, y, s in corners]
    settings = Settings("subpixel", perspective="every16", tolerance=65536)
    assert not bounds.judge(vertices, settings, 8, 1024).complaint
    adapted = model.adapt(vertices, settings, 256)
    made = model.set_up(adapted, 8, 1024, True, settings, (256, 256))
    _, (u, *_) = bounds_perspective.all_errors(adapted, made, 1.0)
    assert -0.15 < u.error.min() < -0.14


def test_steps_make_up_for_what_the_range_takes(monkeypatch) -> None:
    """Otherwise a line from the range's end falls below the exact value, by more than its border's texel."""
    monkeypatch.setattr(level_reciprocal, "find", lambda *_: None)  # their lines are not clamped
    assert not fuzz.check(DEEP.each, DEEP.seed, DEEP.block).verdict.complaint
    monkeypatch.setattr(level, "regained", lambda *_: 0)
    assert "below the exact value" in fuzz.check(DEEP.each, DEEP.seed, DEEP.block).verdict.complaint


def test_the_first_pixels_error_is_stretched() -> None:
    """What the range adds to the first pixel, where q is greater than at the last, counts for more there."""
    found = ALL["seven_corners_6_texels_off_mirrored"]
    off, allowed = next((abs(error - wanted), allowed) for key, y, _, _, error, wanted, allowed
                        in bounds_perspective.line_errors(*set_up(found)) if (key, y) == ("u", found.line))
    assert off[0] > 3 and 1.03 * off[0] < off[-1] == off.max() <= allowed < 1.04 * off[0]
