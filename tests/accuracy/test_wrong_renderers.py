"""Every property detects a wrong renderer: the model with one mistake added.

The unmodified model satisfies all properties on the same cases (tests/accuracy/test_properties.py).
"""

from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import property_cases
from tests.helpers.properties import SIDE
from tmap.base.fixed import M32, ONE, mul_div, signed
from tmap.model import model
from tmap.setup import clip, edges as model_edges, planarity, polygon as model_polygon, texturing
from tmap.setup.edges import Edge

CASES = 1000  # most mistakes show in the first hundred cases, those of rounding alone need more


def floor_plus_one(patch) -> None:
    """Computes ceil(x) as floor(x) + 1: a pixel or line exactly on an edge is left out."""
    patch.setattr(model_edges, "ceil16", lambda x: (x >> 16) + 1)


def right_included(patch) -> None:
    """Wrong fill rule: the first pixel right of the right edge is drawn too."""
    right = model_polygon.Line
    patch.setattr(model_polygon, "Line", lambda left, end: right(left, end + (end > left)))


def bottom_included(patch) -> None:
    """Wrong fill rule: the last line is repeated below."""
    right = model.set_up

    def set_up(vertices, width, height, *rest):
        polygon = right(vertices, width, height, *rest)
        if polygon and polygon.top + len(polygon.lines) < height:
            polygon.lines.append(replace(polygon.lines[-1]))
        return polygon

    patch.setattr(model, "set_up", set_up)


def edges_without_prestep(patch) -> None:
    """The first line starts at the upper vertex's x."""
    patch.setattr(Edge, "at", lambda e, line: e.upper[0] + (line - e.top) * e.slope)


def texture_without_prestep(patch) -> None:
    """The first pixel's centre has the edge's u and v."""
    right = model_polygon.edge_starts
    patch.setattr(model_polygon, "edge_starts",
                  lambda t, e, settings: right(t, e, replace(settings, start="truncated")))


def short_gradients(patch) -> None:
    """Steps of u and v keep only 8 fraction bits."""
    right = texturing.step
    patch.setattr(texturing, "step", lambda gradient, spare: right(gradient, spare) & ~0xFF)


def edges_that_drift(patch) -> None:
    """Slopes lose 8 bits, on every line."""
    right = Edge.slope.func
    patch.setattr(Edge, "slope", property(lambda e: right(e) & ~0xFF))


def spans_that_drift(patch) -> None:
    """Steps lose 6 bits, in every pixel."""
    right = model.coordinates

    def coordinates(line, mapper="affine"):
        n = np.arange(line.right - line.left)
        lost = (signed(step) & 0x3F for step in (line.dudx, line.dvdx))
        return tuple(c - n * x & M32 for c, x in zip(right(line, mapper), lost))

    patch.setattr(model, "coordinates", coordinates)


def edges_in_list_order(patch) -> None:
    """An edge starts at the end that comes first in the list: neighbours disagree."""
    right = model_polygon.side

    class FromBelow(Edge):
        def at(self, line: int) -> int:
            width, height = self.lower[0] - self.upper[0], self.lower[1] - self.upper[1]
            x = self.lower[0] - mul_div(width, self.lower[1] - (self.end - 1 << 16), height)
            return x - (self.end - 1 - line) * self.slope

    def side(vertices, start, direction, *rest):
        edges = right(vertices, start, direction, *rest)
        return edges if direction > 0 else [FromBelow(**vars(e)) for e in edges]

    patch.setattr(model_polygon, "side", side)


def edges_that_lean(patch) -> None:
    """Edges that run down to the left begin a pixel early: inner ones cross the outline."""
    right = Edge.column
    patch.setattr(Edge, "column",
                  lambda e, line: right(e, line) - (e.lower[0] < e.upper[0] and line > e.top))


def first_three_vertices(patch) -> None:
    """The texture plane runs through the first vertices of the list."""
    right = model_polygon.plane
    patch.setattr(model_polygon, "plane",
                  lambda vertices, corners, *rest: right(vertices, (0, 1, 2), *rest))


def seen_from_the_corner(patch) -> None:
    """u and v are computed relative to the frame's corner, not to the polygon."""
    right = model_polygon.plane
    patch.setattr(model_polygon, "plane", lambda vertices, corners, box, settings: right(
        vertices, corners, (0, 0, *box[2:]), settings))


def clamped(patch) -> None:
    """s and t are clamped to the map's borders instead of repeating."""
    right = model.adapt
    patch.setattr(model, "adapt", lambda *given: [
        (x, y, *(min(max(c, 0), SIDE - 1) for c in uv)) for x, y, *uv in right(*given)])


def cut_to_24_bits(patch) -> None:
    """u and v lose their sign: values left of map 0 start elsewhere."""
    right = model.adapt
    patch.setattr(model, "adapt", lambda *given: [
        (x, y, *(c & SIDE - 1 for c in uv)) for x, y, *uv in right(*given)])


def not_held(patch) -> None:
    """Lines are not clamped at their ends."""
    patch.setattr(model_polygon, "hold", lambda lines, ranges: None)


def planes_trusted(patch) -> None:
    """The plane is assumed to run through all vertices."""
    patch.setattr(model_polygon, "plane_range", lambda vertices, t: tuple(
        [f(v[k] for v in vertices) for k in (2, 3)] for f in (min, max)))


def rows_left(patch) -> None:
    """Generated code also draws polygons that leave their row of the map."""
    patch.setattr(model_polygon, "stays_in_row", lambda line: True)


def rows_left_by_a_texel(patch) -> None:
    """Generated code also draws polygons that leave their row of the map by one texel."""
    right = model_polygon.stays_in_row
    patch.setattr(model_polygon, "stays_in_row", lambda line: right(line) or any(
        right(replace(line, u=line.u + way)) for way in (-ONE, ONE)))


def cut_to_pixels(patch) -> None:
    """New vertices at the border are moved to whole pixels."""
    patch.setattr(clip, "mul_div", lambda *given: mul_div(*given) & ~0xFFFF)


def other_vertices_ignored(patch) -> None:
    """The planes run through three corners, whatever values the other vertices have."""
    patch.setattr(model, "parts", lambda vertices, *rest: [vertices])


def planar_ones_cut(patch) -> None:
    """All polygons are drawn as triangles."""
    patch.setattr(model, "parts", lambda vertices, *rest: planarity.fan(vertices))


def last_triangle_left_out(patch) -> None:
    """The last triangle of a fan is left out."""
    right = planarity.fan
    patch.setattr(planarity, "fan", lambda vertices: right(vertices)[:-1])


#: A mistake, and the properties that must detect it.
WRONG = {
    floor_plus_one: ("watertight",),
    right_included: ("watertight", "splitting"),
    bottom_included: ("watertight", "splitting"),
    edges_without_prestep: ("watertight",),
    texture_without_prestep: ("splitting",),
    short_gradients: ("splitting",),
    edges_that_drift: ("watertight",),
    spans_that_drift: ("splitting",),
    edges_in_list_order: ("watertight", "reversal"),
    edges_that_lean: ("watertight",),
    first_three_vertices: ("rotation", "reversal"),
    seen_from_the_corner: ("translation",),
    clamped: ("wrapping",),
    cut_to_24_bits: ("splitting", "wrapping"),
    not_held: ("held",),
    planes_trusted: ("held",),
    rows_left: ("rows_kept",),
    rows_left_by_a_texel: ("rows_kept",),
    cut_to_pixels: ("watertight",),
    other_vertices_ignored: ("uneven",),
    planar_ones_cut: ("uneven",),
    last_triangle_left_out: ("uneven",),
}


@pytest.mark.parametrize("wrong, name", [(wrong, name) for wrong, names in WRONG.items()
                                         for name in names],
                         ids=lambda value: getattr(value, "__name__", value))
def test_mistake_is_noticed(monkeypatch, wrong, name: str) -> None:
    wrong(monkeypatch)
    assert any(property_cases.complaints(name, 1, CASES)), f"{name} does not notice it"


def test_every_property_notices_something() -> None:
    assert {name for names in WRONG.values() for name in names} == set(property_cases.CHECKS)
