"""Glide's modes with prices: their pictures, their errors, and what costs nothing."""

import json

import numpy as np
import pytest

from tests.helpers.arrays import check_equal
from tests.helpers import mode_points
from tmap.accuracy import glide_errors
from tmap.base.paths import BASELINE
from tmap.bench import bench
from tmap.bench.modes import measure, modes
from tmap.bench.modes.glide import EVERY, FORMATS, MODES, SMALL
from tmap.bench.modes.modes import KINDS
from tmap.glide.lod import level_of_detail
from tmap.glide.polygon import points
from tmap.glide.state import FORMATS as ALL_FORMATS
from tmap.glide.words import FORMATS as NAMES
from tmap.ideal.texels import error
from tmap.model.model import Settings, render
from tmap.report import readme_modes

MACHINES = tuple(bench.CONDITIONS)


def test_modes_show_what_their_names_say() -> None:
    """Every format has a mode; names are unique; polygons are large and show several colours."""
    assert len({mode.title for mode in EVERY.values()}) == len(EVERY)
    assert FORMATS.keys() == NAMES.keys() and set(NAMES.values()) == ALL_FORMATS.keys()
    assert {name for names in FORMATS.values() for name in names} <= EVERY.keys()
    for mode in EVERY.values():
        frames, pixels = measure.shown(mode)
        assert 1900 < pixels < 2100 and len(np.unique(frames[measure.FIRST])) > 8, mode.name
    assert {measure.shown(mode)[1] for mode in SMALL.values()} == {8}


def test_steps_are_of_modes() -> None:
    """Each step is between two modes with one polygon on the screen. A feature that has no effect
    gives the same picture as without it, unless another level of the map is shown."""
    for step in (*readme_modes.STEPS, *readme_modes.UNCALLED):
        assert EVERY[step.without].vertices[0][:2] == EVERY[step.on].vertices[0][:2], step
        assert measure.shown(EVERY[step.without])[1] == measure.shown(EVERY[step.on])[1]
    for step in readme_modes.UNCALLED:
        assert step.small in SMALL
        without, on = EVERY[step.without], EVERY[step.on]
        if without.polygon == on.polygon or on.polygon == "level":
            frames = [measure.shown(mode)[0][measure.FIRST] for mode in (without, on)]
            check_equal(*reversed(frames), f"{step}: row, column")


def drawn_levels(name: str, number: int = 0) -> np.ndarray:
    """The levels of detail, 8.8, of a mode's pixels."""
    mode = EVERY[name]
    scene, corners = measure.scene_of(mode), mode.vertices[:mode.corners]
    unit = glide_errors.pixels_of(mode, "noise").units[number]
    frame = np.zeros((measure.HEIGHT, measure.WIDTH), np.uint32)
    _, at = points([v[:2] for v in corners], [(*v[2:4], v[5]) for v in corners],
                   bool(unit.modes.perspective), frame,
                   Settings(scene.materials[0].edges, mapper="tiled"))
    return level_of_detail(unit.modes, at.base, at.w, at.x, at.y)


def factors(name: str) -> np.ndarray:
    """The detail factors of a mode's pixels, before their limit."""
    modes_ = glide_errors.pixels_of(EVERY[name], "noise").units[0].modes
    return (modes_.detail_bias * 256 - drawn_levels(name) << modes_.detail_scale) >> 8


def test_levels_are_priced_where_they_differ() -> None:
    """Far polygons cross three levels; those of a constant level have one; magnified trilinear
    filtering has no fraction; a detail texture is shown fully, fades, and disappears."""
    for name in ("glide_mip_point", "glide_mip_bilinear", "glide_trilinear", "glide_mip_bilinear_dither"):
        assert len(np.unique(drawn_levels(name) >> 8)) >= 3, name
    for name in ("glide_mip_level", "glide_trilinear_level"):
        found = np.unique(drawn_levels(name))
        assert len(found) == 1 and found[0] > 3 * 256 and found[0] & 255, name
    assert np.unique(drawn_levels("glide_trilinear_double")).tolist() == [3 * 256]
    assert factors("glide_detail_near").min() >= 255
    assert factors("glide_detail").min() < 64 and factors("glide_detail").max() > 192
    assert factors("glide_detail_away").max() <= 0


#: The largest error of a coordinate, in texels of 8 units: steps of S and T are rounded to 1/2^17
#: unit and taken 80 times at most, those of W to 1/2^31 and weighted with s, 1,200 at most; divided
#: by a W of at least 1/3.1 that is 0.0006 unit * 3.1 and 0.00005 * 3.1^2, below 1/1000 texel.
COORDINATE = 1 / 1000
#: The error of a bilinear sample, relative to the difference of neighbours: fractions of two axes
#: are cut to steps of 1/16, or of 1/256 in Voodoo 2 (tests/glide/test_ideal.py: weights_error).
STEP, STEP_8 = (2 * (1 / steps + COORDINATE) for steps in (16, 256))
#: The difference of neighbours in the smooth picture: along both axes of sin(x + y), rounded; and
#: texels of 565 have 5 bits, each off by half of 8 at most.
SLOPE = 100 * 2 * np.pi / 32 + 1 + 8
CUT = 1  # of a result to 8 bits


@pytest.mark.parametrize("name, steps", [
    ("glide_bilinear", STEP), ("glide_bilinear_8", STEP_8), ("glide_double", STEP),
    ("glide_eightfold", STEP), ("glide_bilinear_perspective", STEP),
    ("glide_level_bilinear", STEP), ("glide_decal", STEP), ("glide_detail_away", STEP),
    ("glide_trilinear_double", STEP)])
def test_bilinear_errors_are_those_of_weights(name, steps) -> None:
    """The smooth picture has small steps, noise has steps up to 255."""
    for kind, slope in zip(KINDS, (SLOPE, 255)):
        off = glide_errors.error_of(EVERY[name], kind)
        assert 0 < off.rms < off.most <= steps * slope + CUT, (kind, off)


@pytest.mark.parametrize("name", [
    "glide_copy", "glide_point", "glide_point_clamp", "glide_point_inside", "glide_level_point",
    "glide_point_565", *(names[0] for names in FORMATS.values())])
def test_point_sampling_without_perspective_is_exact(name) -> None:
    """Exact on both pictures, in frames of both widths; frames of 565 show the texels' bits."""
    for kind in KINDS:
        mode_points.check(EVERY[name], glide_errors, kind, lambda on: on.surfaces[0])


def test_what_is_meant_is_nearer() -> None:
    """Trilinear filtering, and dithering of levels, are nearer to the exact result than bilinear
    samples of one level; 8 bits of weights are nearer than 4."""
    def rms(name: str, how: str = "") -> float:
        mode = EVERY[name]
        on, scene = glide_errors.pixels_of(mode, "noise"), measure.scene_of(mode, "noise")
        found = scene.pixel.picture(render(scene, measure.FIRST))[on.y, on.x]
        return error(found, glide_errors.intended(on, how or mode.filter)).rms

    one_level = rms("glide_mip_bilinear", "trilinear")
    assert rms("glide_trilinear") < rms("glide_mip_bilinear_dither") < one_level
    assert rms("glide_bilinear_8") < rms("glide_bilinear") / 4


def test_pictures_are_what_they_say() -> None:
    """Smooth pictures have small steps across all borders, noise has large ones; one kind has
    alpha."""
    for name, (side, seed, sheer) in modes.PICTURES.items():
        for kind, most in zip(KINDS, (20 * 32 / side + 1, 255)):
            found = modes.picture(kind, seed, side, sheer).astype(int)
            steps = [abs(found - np.roll(found, 1, axis)).max() for axis in (0, 1)]
            assert max(steps) <= most and (kind == "smooth" or min(steps) > 200), (name, kind)
            assert (len(np.unique(found[..., 3])) > 1) == sheer, (name, kind)


@pytest.fixture(scope="module")
def baseline() -> dict:
    return json.loads(BASELINE.read_text())


@pytest.mark.parametrize("step", readme_modes.UNCALLED, ids=lambda step: step.title)
def test_only_what_is_called_for_costs(baseline, step) -> None:
    """A feature without effect on a polygon costs at most a fixed amount per polygon, no more than
    the plain polygon's whole set-up, since it reads the same corners and planes once more. The
    limit is the cost of a triangle of 8 pixels, plus the uncertainty of two figures."""
    rows = readme_modes.rows_of(baseline)
    for machine in MACHINES:
        with_it, without, small = (readme_modes.polygon(rows, name, machine)
                                   for name in (step.on, step.without, step.small))
        doubt = 2 * bench.DOUBT * bench.CYCLES_PER_TICK
        assert with_it - without <= small + doubt, (
            f"{step.title}, {machine}: {with_it - without:,.0f} cycles more a polygon of 2,003 "
            f"pixels; setting one up takes {small:,.0f}; if the code is other than when these were "
            "measured: scripts/tmap bench -o build/bench --accept")


def test_accuracy_tells_of_modes(tmp_path, capsys, monkeypatch) -> None:
    mode_points.check_table(tmp_path, capsys, monkeypatch, "glide", MODES[:4])
