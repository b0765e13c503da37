"""Properties and derived bounds detect wrong renderers: the model with one mistake added.

The unmodified model satisfies all properties on the same cases (tests/accuracy/test_properties.py).
"""

from dataclasses import replace

import numpy as np
import pytest

from tests.accuracy.test_bounds import triangles, worst
from tests.helpers import property_cases
from tests.helpers.properties import SIDE
from tmap.base.fixed import M32, ONE, mul_div, signed
from tmap.model import model
from tmap.setup import clip, edges, planarity, polygon, texturing
from tmap.setup.edges import Edge

CASES = 1000  # most mistakes show in the first hundred cases, those of rounding alone need more
BOUNDS = "bounds"  # of tools/tmap/ideal/bounds.py, which is no property


def with_last_line_twice(right):
    def set_up(vertices, width, height, *rest):
        made = right(vertices, width, height, *rest)
        if made and made.top + len(made.lines) < height:
            made.lines.append(replace(made.lines[-1]))
        return made
    return set_up


def drifting(right):
    def coordinates(line, mapper="affine"):
        n = np.arange(line.right - line.left)
        lost = (signed(step) & 0x3F for step in (line.dudx, line.dvdx))
        return tuple(c - n * x & M32 for c, x in zip(right(line, mapper), lost))
    return coordinates


class FromBelow(Edge):
    """An edge that starts at its lower end."""

    def at(self, line: int) -> int:
        width, height = self.lower[0] - self.upper[0], self.lower[1] - self.upper[1]
        x = self.lower[0] - mul_div(width, self.lower[1] - (self.end - 1 << 16), height)
        return x - (self.end - 1 - line) * self.slope


def in_list_order(right):
    def side(vertices, start, direction, *rest):
        made = right(vertices, start, direction, *rest)
        return made if direction > 0 else [FromBelow(**vars(e)) for e in made]
    return side


#: Each mistake: module or class, name, the replacement of the right one, what must detect it.
WRONG = {
    "ceil(x) is floor(x) + 1: a pixel or line exactly on an edge is left out": (
        edges, "ceil16", lambda right: lambda x: (x >> 16) + 1, "watertight bounds"),
    "pixels are those whose centre is nearest to the edge": (
        Edge, "column", lambda right: lambda e, y: e.at(y) + 0x8000 >> 16, "bounds"),
    "fill rule: the first pixel right of the right edge is drawn too": (
        polygon, "Line", lambda right: lambda left, end: right(left, end + (end > left)),
        "watertight splitting bounds"),
    "fill rule: the last line is repeated below": (
        model, "set_up", with_last_line_twice, "watertight splitting"),
    "the first line starts at the upper vertex's x": (
        Edge, "at", lambda right: lambda e, line: e.upper[0] + (line - e.top) * e.slope,
        "watertight bounds"),
    "the first pixel's centre has the edge's u and v": (
        polygon, "edge_starts",
        lambda right: lambda t, e, settings: right(t, e, replace(settings, start="truncated")),
        "splitting"),
    "a line starts half a step too far": (
        texturing, "on_plane", lambda right: lambda t, *at: tuple(
            c + (step >> 1) for c, step in zip(right(t, *at), (t.dudx, t.dvdx))), "bounds"),
    "steps of u and v keep only 8 fraction bits": (
        texturing, "step", lambda right: lambda gradient, spare: right(gradient, spare) & ~0xFF,
        "splitting bounds"),
    "slopes lose 8 bits, on every line": (
        Edge, "slope", lambda right: property(lambda e: right.func(e) & ~0xFF),
        "watertight bounds"),
    "steps lose 6 bits, in every pixel": (
        model, "coordinates", drifting, "splitting"),
    "an edge starts at the end that comes first in the list: neighbours disagree": (
        polygon, "side", in_list_order, "watertight reversal"),
    "edges that run down to the left begin a pixel early: inner ones cross the outline": (
        Edge, "column", lambda right: lambda e, line: right(e, line) - (
            e.lower[0] < e.upper[0] and line > e.top), "watertight"),
    "the texture plane runs through the first vertices of the list": (
        polygon, "plane", lambda right: lambda vertices, corners, *rest: right(
            vertices, (0, 1, 2), *rest), "rotation reversal"),
    "u and v are computed relative to the frame's corner, not to the polygon": (
        polygon, "plane", lambda right: lambda vertices, corners, box, *rest: right(
            vertices, corners, (0, 0, *box[2:]), *rest), "translation"),
    "s and t are clamped to the map's borders instead of repeating": (
        model, "adapt", lambda right: lambda *given: [
            (x, y, *(min(max(c, 0), SIDE - 1) for c in uv)) for x, y, *uv in right(*given)],
        "wrapping"),
    "u and v lose their sign: values left of map 0 start elsewhere": (
        model, "adapt", lambda right: lambda *given: [
            (x, y, *(c & SIDE - 1 for c in uv)) for x, y, *uv in right(*given)],
        "splitting wrapping"),
    "lines are not clamped at their ends": (
        polygon, "clamp", lambda right: lambda lines, ranges: None, "held"),
    "the plane is assumed to run through all vertices": (
        polygon, "plane_range", lambda right: lambda vertices, t: tuple(
            [f(v[k] for v in vertices) for k in (2, 3)] for f in (min, max)), "held"),
    "generated code also draws polygons that leave their row of the map": (
        polygon, "stays_in_row", lambda right: lambda line: True, "rows_kept"),
    "generated code also draws polygons that leave their row of the map by one texel": (
        polygon, "stays_in_row", lambda right: lambda line: right(line) or any(
            right(replace(line, u=line.u + way)) for way in (-ONE, ONE)), "rows_kept"),
    "new vertices at the border are moved to whole pixels": (
        clip, "mul_div", lambda right: lambda *given: right(*given) & ~0xFFFF, "watertight"),
    "the planes run through three corners, whatever values the other vertices have": (
        model, "parts", lambda right: lambda vertices, *rest: [vertices], "uneven"),
    "all polygons are drawn as triangles": (
        model, "parts", lambda right: lambda vertices, *rest: planarity.fan(vertices), "uneven"),
    "the last triangle of a fan is left out": (
        planarity, "fan", lambda right: lambda vertices: right(vertices)[:-1], "uneven"),
}


def noticed(name: str) -> bool:
    """Returns whether a property is violated, or a bound exceeded by ordinary triangles under the
    usual settings."""
    if name != BOUNDS:
        return any(property_cases.complaints(name, 1, CASES))
    snapped = [[(x + 0x8000 & ~0xFFFF, y + 0x8000 & ~0xFFFF, *rest) for x, y, *rest in p]
               for p in triangles(10)]
    return bool(worst(model.Settings(), triangles(20) + snapped).complaint)


@pytest.mark.parametrize("mistake, name", [(mistake, name) for mistake, (*_, names) in WRONG.items()
                                           for name in names.split()])
def test_mistake_is_noticed(monkeypatch, mistake: str, name: str) -> None:
    where, attribute, replacement, _ = WRONG[mistake]
    monkeypatch.setattr(where, attribute, replacement(getattr(where, attribute)))
    assert noticed(name), f"{name} does not notice it"


def test_every_property_notices_something() -> None:
    """The right renderer keeps the bounds; tests/accuracy/test_properties.py has the properties."""
    assert not noticed(BOUNDS)
    assert {name for *_, names in WRONG.values() for name in names.split()} == {
        BOUNDS, *property_cases.CHECKS}
