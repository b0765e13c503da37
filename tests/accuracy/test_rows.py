"""What is computed for all lines of a polygon at once is what is computed for each alone."""

import random
from collections.abc import Iterator

import numpy as np
import pytest

from tmap.fuzz import fuzz, polygons
from tmap.ideal import bounds, bounds_fetched, check_perspective, ideal, perspective
from tmap.ideal.bounds_perspective import all_errors
from tmap.ideal.rows import Rows
from tmap.model import model

SEED = 28
FAR = 1 << 30


def rows_of(rng: random.Random, reach: int = 200) -> Rows:
    """Some rows, one of them of a pixel."""
    lefts = [rng.randint(-reach, reach) for _ in range(9)]
    counts = [1, *(rng.randint(1, 40) for _ in lefts[1:])]
    return Rows(*(np.array(each) for each in (sorted(rng.sample(range(300), len(lefts))), lefts,
                                              [a + n for a, n in zip(lefts, counts)])))


def test_first_pixels_are_those_of_each_lines_extent() -> None:
    """Also beyond the coordinates for which int64 is enough, on vertices and on level edges."""
    rng, seen = random.Random(SEED), 0
    for _ in range(600):
        reach, unit = rng.choice((1 << 18, 1 << 24, FAR, 1 << 32)), rng.choice((1, 1 << 15, 1 << 16))
        outline = [tuple(rng.randint(-reach, reach) // unit * unit for _ in range(2)) for _ in range(rng.randint(3, 7))]
        ys = [y for _, y in outline]
        top = max(-(-min(ys) >> 16), -50)
        lines = range(top, min(max(ys) >> 16, top + 60) + 1)
        if not lines:
            continue
        found = ideal.first_pixels(outline, lines.start, lines.stop + 3)
        for y, left, right in zip(lines, *found.tolist()):
            assert [left, right] == [-(-n // (d << 16)) for n, d in ideal.extent(outline, y)], (outline, y)
            seen += 1
        if lines.stop == (max(ys) >> 16) + 1:
            assert (found[:, len(lines):] == [[ideal.NEVER], [-ideal.NEVER]]).all()
    assert seen > 5000


def test_planes_errors_are_those_of_each_pixel() -> None:
    rng = random.Random(SEED)
    for _ in range(100):
        points = [(rng.randint(-FAR, FAR), rng.randint(-FAR, FAR)) for _ in range(3)]
        plane = ideal.Plane(points, [rng.randint(-1 << 24, 1 << 24) for _ in range(3)])
        rows = rows_of(rng)
        ys = rows.spread(rows.ys)
        found = np.array([rng.randrange(1 << 32) for _ in ys])
        wanted = [plane.error(*at) for at in zip(found.tolist(), rows.columns.tolist(), ys.tolist())]
        assert plane.errors_at(found, rows.columns, ys).tolist() == wanted
        assert np.allclose(plane.row_errors(found, rows), wanted, rtol=0, atol=2**-30)


def in_perspective(count: int) -> Iterator[tuple]:
    """Yields the first polygons that the fuzzer draws in perspective, if they have an ideal: number, polygon, adapted
    vertices, set-up."""
    for number in range(count):
        each = polygons.polygon(SEED, number, "perspective")
        adapted = model.adapt(each.vertices, each.settings, 256)
        made = model.set_up(adapted, *polygons.frame_size(0), True, each.settings, (256, 256))
        if made and made.perspective and bounds.has_ideal(adapted, each.settings):
            yield number, each, adapted, made


def test_curves_errors_are_those_of_each_pixel() -> None:
    """Of polygons that the fuzzer draws in perspective."""
    seen = 0
    for number, _, adapted, polygon in in_perspective(200):
        rows, both = all_errors(adapted, polygon)
        three = [adapted[k] for k in ideal.corners(adapted)]
        if polygon.columns:
            three = [(v[1], v[0], *v[2:]) for v in three]
        for curve, made in zip(perspective.curves_through(three), both):
            for at in random.Random(number).sample(range(len(made.found)), min(len(made.found), 50)):
                y, x = int(rows.spread(rows.ys)[at]), int(rows.columns[at])
                assert abs(made.error[at] - curve.error(int(made.found[at]), x, y)) < 2**-32
                seen += 1
    assert seen > 2000


@pytest.mark.parametrize("side", [1, 8, 37, 256])
def test_rows_with_far_texels_are_those_that_are_complained_about(side: int) -> None:
    rng, found = random.Random(SEED), []
    for _ in range(300):
        rows = rows_of(rng)
        n, noise = len(rows.columns), np.random.default_rng(rng.randrange(1 << 30))
        values = noise.integers(0, 1 << 32, n)
        errors = noise.uniform(-1, 1, n) * rng.choice((1e-4, 0.1, side))
        texels = ((values >> 16) + (noise.random(n) < 0.02) * rng.choice((0, 1, -1))) % side
        allowed = noise.uniform(0, rng.choice((1e-4, 0.2, side)), (2, len(rows)))
        judged = []
        for k in range(len(rows)):
            out, part = bounds.Verdict(), rows.part(k)
            bounds_fetched.judge("u", texels[part], values[part], errors[part], side, 0, 0, tuple(allowed[:, k]), out)
            judged.append(bool(out.complaint))
        assert bounds_fetched.far_rows(rows, texels, values, errors, side, allowed).tolist() == judged
        found += judged
    assert (side == 1 or any(found)) and not all(found)


def test_every_suspected_row_is_complained_about(monkeypatch) -> None:
    """With bounds and tolerances made a tenth, some rows of the fuzzer's polygons exceed them; each verdict has words
    if and only if a row, judged alone, has."""
    words = 0
    for number, each, adapted, polygon in in_perspective(150):
        rows, both = all_errors(adapted, polygon)
        for made in both:
            made.allowed = made.allowed / 10
        monkeypatch.setattr(check_perspective, "all_errors", lambda *_: (rows, both))
        setting, more, size = each.settings.perspective, each.settings.tolerance * ideal.UNIT, (256, 256)
        out, alone = bounds.Verdict(), bounds.Verdict()
        check_perspective.check_texels(adapted, polygon, setting, more, size, out)
        sure = check_perspective.first_drawn(polygon.columns or polygon, rows) if both else []
        for k in range(len(rows)):
            for made in both:
                check_perspective.check_line(polygon, made, k, rows, sure[rows.part(k)] & (len(adapted) == 3), setting,
                                             more, 256, made.found[rows.part(k)] >> 16 & 255, alone)
        assert out.complaint == alone.complaint
        words += bool(out.complaint)
    assert words > 10


def test_columns_of_an_outline_that_crosses_itself() -> None:
    """They cover other pixels than its lines do; light is drawn over them all the same."""
    each = polygons.polygon(101, 1231, "perspective")
    assert each.settings.mapper == "lit"
    assert (fuzz.check(each, 101, 1).frame != 7).any()
