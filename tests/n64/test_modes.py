"""The modes with prices: their pictures, their errors, and their table."""

from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import mode_points
from tmap.accuracy import n64_errors
from tmap.base.errors import UserError
from tmap.bench.modes import measure
from tmap.bench.modes.measure import FIRST, scene_of
from tmap.bench.modes.modes import KINDS
from tmap.bench.modes.n64 import EVERY, FORMATS, MODES
from tmap.guest import guest_frames
from tmap.ideal import n64
from tmap.model import model
from tmap.n64.combiner import Sources, combine
from tmap.n64.lod import choose
from tmap.scene_file.scene_file import IDENTITY
from tmap.scene_file.units import state_at

N = 65536
#: The largest error of a coordinate, in texels: cut to 1/32, and with perspective S and W cut to 16
#: bits and the reciprocal's error (tests/n64/test_model_polygons.py: units).
CUT, STEEPEST = 1 / 32, 100 * 2 * np.pi / 32  # of the smooth picture, a texel


def test_modes_show_what_their_names_say() -> None:
    """Every format has a mode; names are unique; polygons are large and show several colours."""
    assert len({mode.title for mode in EVERY.values()}) == len(EVERY)
    assert {name for names in FORMATS.values() for name in names} <= EVERY.keys()
    for mode in EVERY.values():
        frames, pixels = measure.shown(mode)
        assert 1900 < pixels < 2100 and len(np.unique(frames[FIRST])) > 8, mode.name


def test_far_and_near_cross_levels() -> None:
    """Prices of levels of detail include their choice: distances range from less than a texel a
    pixel to level 3, or to more than one texel."""
    for name, most in (("trilinear", 8), ("sharpen", 1), ("detail", 1)):
        mode = EVERY[name]
        found = n64_errors.pixels_of(mode, "noise")
        distance = found.surface.distance(found.x, found.y)
        assert (distance < 1).any() and distance.max() > most, (name, distance.max())


@pytest.mark.parametrize("name", ["trilinear", "sharpen", "detail"])
def test_ideal_levels_are_the_hardwares(name) -> None:
    """For distances that are multiples of 1/32 texel the tiles are the same, and fractions differ
    by less than 1/256, which is cut off; if both tiles are the same the fraction does not
    matter."""
    state = state_at(scene_of(EVERY[name]), 0, FIRST)
    lod = np.arange(1, 1 << 11)
    tile0, tile1, fraction = choose(state, lod, np.zeros(lod.size, bool))
    near, far, rest = n64.pairs(state, lod / 32)
    fraction = (fraction + 256 & 511) - 256
    blended = tile0 != tile1
    assert (near == tile0).all() and (far == tile1)[blended].all()
    assert (np.abs(rest - fraction / 256)[blended] < 1 / 256).all()
    assert ((rest == 0) | (near == far))[~blended].all()


@pytest.mark.parametrize("name", [mode.name for mode in MODES if not mode.name.startswith("yuv")])
def test_ideal_combiner_is_near_the_hardwares(name) -> None:
    """A cycle rounds by 1/2; using 255/256 instead of 255/255 costs 1 at most."""
    state = state_at(scene_of(EVERY[name]), 0, FIRST)
    rng = np.random.default_rng(5)
    texel0, texel1, shade = rng.integers(0, 256, (3, 500, 4))
    fraction = rng.integers(0, 256, 500)
    found = combine(state, Sources(texel0, texel1, shade, fraction))
    wanted = n64.combined(state, n64.Texels(texel0 * 1.0, texel1 * 1.0, fraction / 256),
                          shade * 1.0)
    assert np.abs(found - wanted).max() <= 1.5 * (1 + state.modes.cycle)


@pytest.mark.parametrize("name", ["threepoint", "threepoint_rgba32", "wrap", "modulate_primitive"])
def test_errors_are_within_what_coordinates_may_be_off(name) -> None:
    """On the smooth picture, whose texels are rounded to 5 bits (8 / 2 more a step): the sum of the
    cut of both axes, the filter's rounding and the combiner's."""
    error = n64_errors.error_of(EVERY[name], KINDS[0])
    assert 0 < error.rms <= error.most <= 2 * CUT * (STEEPEST + 9) + 0.5 + 1.5


@pytest.mark.parametrize("name", ["copy", "point", "copy_16", "point_16", "point_ci8"])
def test_point_sampling_without_perspective_is_exact(name) -> None:
    """Exact on both pictures, in frames of both widths."""
    for kind in KINDS:
        mode_points.check(EVERY[name], n64_errors, kind, lambda on: on.surface)


def test_pages_keep_all_bits_of_u() -> None:
    """Holds too if v wraps within a line: this quadrilateral has pixels whose u is less than
    1/65536 from a texel's edge, and lines on which t crosses 0."""
    corners = [(843658, -792746, 0, 0), (10613762, 1150574, 64 * N, 0),
               (9642102, 6035626, 64 * N, 32 * N), (-128002, 4092306, 0, 32 * N)]
    whole = scene_of(EVERY["point"])
    scene = replace(whole, width=160, height=96, frames=2, poses=np.array([IDENTITY]),
                    vertices=np.array([(*corner, 0, N) for corner in corners]),
                    objects=[replace(whole.objects[0], vertices=4, poses=1)])
    settings = model.Settings(edges=scene.materials[0].edges)
    made = model.set_up(corners, 160, 96, True, settings, (256, 256))
    assert made.texturing.u_cut, "v does not wrap: the polygon tests nothing"
    digests, = guest_frames.draw([(scene, "addx")], "a1200-fast", timed=False)
    assert guest_frames.is_models(model.render(scene, FIRST), digests[FIRST]), (
        "the page's spans do not show the texels of the passes")


def test_accuracy_tells_of_modes(tmp_path, capsys, monkeypatch) -> None:
    mode_points.check_table(tmp_path, capsys, monkeypatch, "n64", MODES[:4])


def test_a_wrong_picture_is_no_figure(monkeypatch) -> None:
    """A mode whose frames are not the model's has no row."""
    mode = EVERY["copy"]
    frames, pixels = measure.shown(mode)
    frames = [frame ^ (number == measure.AGAIN) for number, frame in enumerate(frames)]
    monkeypatch.setattr(measure, "shown", lambda _: (frames, pixels))
    with pytest.raises(UserError, match="mode copy, a1200-fast: frame 2: .* pixels are not the model's; pixel"):
        measure.measure("a1200-fast", ["copy"], plain=False)
