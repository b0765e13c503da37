"""Checks polygons with depth by the bounds of tools/tmap/ideal/bounds_perspective.py.

All rows are judged at once; what is said about a row that exceeds them is found for that row alone.
"""

import numpy as np

from tmap.ideal import bounds_fetched, ideal
from tmap.ideal.bounds_perspective import BOUNDLESS, TOLERANCE, Errors, all_errors
from tmap.ideal.ideal import UNIT, gathered, inner_rows
from tmap.ideal.perspective import FLOAT, curves
from tmap.ideal.rows import Rows
from tmap.setup import spans


def first_drawn(polygon, rows: Rows) -> np.ndarray:
    """Returns which pixels of a triangle must not be below the exact value: those that are drawn first, or all if
    depth does not change along lines and the first is inside the exact polygon. One outside may be beyond the range of
    the vertices' values: what holds it there lowers its line."""
    ends = np.array([(line.left, line.right - 1) for line in polygon.lines])[rows.ys - polygon.top]
    if polygon.is_level and not polygon.perspective.q.dx:
        return rows.spread(rows.lefts == ends[:, 0])
    afar = not polygon.is_level and polygon.constants and polygon.constants.leftwards
    return (rows.columns == rows.spread(ends[:, 1 if afar else 0])) & (not polygon.is_level)


def check_texels(vertices, polygon, asked: str, tolerance: float, size: tuple[int, int],
                 out) -> None:
    """Adds the error of u and v at every pixel inside the exact polygon to a Verdict, and judges
    the texels; ``asked``: the material's setting, ``tolerance``: in texels, ``size``: the map's."""
    rows, made = all_errors(vertices, polygon, tolerance)
    if not made:
        return
    sure = first_drawn(polygon.columns or polygon, rows) & (len(vertices) == 3)
    most = min([TOLERANCE.get(polygon.setting, BOUNDLESS)]
               + [tolerance + FLOAT] * (polygon.setting != asked))
    noted, suspects = [], []
    texels = [spans.repeated(each.found, side) for each, side in zip(made, size)]
    for each, side, shown in zip(made, size, texels):
        off, bent = abs(each.error - each.wanted), rows.most(abs(each.wanted))
        k = int(abs(each.error).argmax())
        allowed = rows.spread(each.allowed)
        noted.append((abs(each.error[k]), min(abs(each.wanted[k]) + allowed[k], BOUNDLESS)))
        judged = each.allowed < BOUNDLESS
        ratio = rows.most(off) / each.allowed
        out.texel_ratio = max(out.texel_ratio, float(ratio[judged].max(initial=0.0)))
        far_off = (rows.some(sure & (each.error < -FLOAT) | (off > allowed)) | bounds_fetched.far_rows(
            rows, shown, each.found, each.error - each.wanted, side, [each.allowed] * 2))
        suspects.append((bent > most) | far_off & judged)
    out.note(*max(noted, key=lambda pair: pair[0]))
    for number in np.flatnonzero(np.logical_or(*suspects)).tolist():
        part = rows.part(number)
        for each, side, shown in zip(made, size, texels):
            check_line(polygon, each, number, rows, sure[part], asked, tolerance, side, shown[part], out)


def check_line(polygon, each: Errors, number: int, rows: Rows, sure: np.ndarray, asked: str, tolerance: float,
               side: int, texels: np.ndarray, out) -> None:
    """Adds the complaints about u or v of a row to a Verdict. ``sure``: the pixels that must not be below the exact
    values; ``texels``: what they show; others as in ``check_texels``."""
    key, kind, y, part = each.key, "column" if polygon.columns else "line", rows.ys[number], rows.part(number)
    columns, error, wanted, allowed = rows.columns[part], each.error[part], each.wanted[part], each.allowed[number]
    bent = float(abs(wanted).max())
    if polygon.setting in TOLERANCE and bent > TOLERANCE[polygon.setting]:
        out.complain(f"{key} on {kind} {y}: pieces of {polygon.exact} for {polygon.setting} bend {bent:.9f} texels")
    if polygon.setting != asked and bent > tolerance + FLOAT:
        out.complain(f"{key} on {kind} {y}: pieces of {polygon.setting} instead of {asked} "
                     f"bend {bent:.9f} texels, the tolerance is {tolerance:.9f}")
    if allowed >= BOUNDLESS:
        return
    if (error[sure] < -FLOAT).any():
        out.complain(f"{key} on {kind} {y} is {-error.min():.9f} below the exact value")
    off = error - wanted
    bounds_fetched.judge(key, texels, each.found[part], off, side, int(columns[0]), y, (allowed, allowed), out)
    k = int(abs(off).argmax())
    if abs(off[k]) > allowed:
        out.complain(f"{key} at pixel {columns[k]} of {kind} {y} is {abs(off[k]):.9f} off what the "
                     f"setting intends, {allowed:.9f} are allowed")


def check_flattened(vertices, polygon, tolerance: float | None, size: tuple[int, int], out) -> None:
    """Judges a polygon that is drawn affine though w differs: by its tolerance, or (None) because
    its planes are not accurate enough; out.unsure counts those."""
    out.unsure += tolerance is None
    spread, t = 1 if len(vertices) == 3 else 3, polygon.texturing
    numbers, rows, drawn = inner_rows(vertices, polygon)
    if not numbers:
        return
    made, noted = [], []
    for key, curve, found in zip((2, 3), curves(vertices), gathered(polygon, numbers, rows, drawn)):
        plane, values = ideal.plane_of(vertices, key), [v[key] for v in vertices]
        bound = np.maximum(*(plane.bound(i, rows.ys, t, t.cuts[key - 2]) for i in (rows.lefts, rows.ends - 1))) + (
            spread * (max(values) - min(values)) * UNIT if tolerance is None else tolerance)
        each = Errors("uv"[key - 2], found, curve.row_errors(found, rows), np.zeros(len(found)), bound)
        k, side, ratio = int(abs(each.error).argmax()), size[key - 2], rows.most(abs(each.error)) / bound
        noted.append((abs(each.error[k]), rows.spread(bound)[k]))
        out.texel_ratio = max(out.texel_ratio, float(ratio.max()))
        texels = spans.repeated(each.found, side)
        made.append((each, side, texels, rows.some(abs(each.error) > rows.spread(bound)) | bounds_fetched.far_rows(
            rows, texels, each.found, each.error, side, [bound] * 2)))
    out.note(*max(noted, key=lambda pair: pair[0]))
    for number in np.flatnonzero(np.logical_or(*(suspects for *_, suspects in made))).tolist():
        for each, side, texels, _ in made:
            check_affine_line(each, number, rows, side, texels[rows.part(number)], out)


def check_affine_line(each: Errors, number: int, rows: Rows, side: int, texels: np.ndarray, out) -> None:
    """Adds the complaints about u or v of a row of a polygon that is drawn affine though w differs to a Verdict;
    ``side``: the map's; ``texels``: what the row shows."""
    part, y, bound = rows.part(number), rows.ys[number], each.allowed[number]
    found, error, columns = each.found[part], each.error[part], rows.columns[part]
    bounds_fetched.judge(each.key, texels, found, error, side, int(columns[0]), y, (bound, bound), out)
    k = int(abs(error).argmax())
    if abs(error[k]) > bound:
        out.complain(f"{each.key} at pixel ({columns[k]}, {y}) of a polygon drawn affine is "
                     f"{abs(error[k]):.9f} off, {bound:.9f} are allowed")
