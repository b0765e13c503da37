"""Cuts faces along a grid, so that a light that changes over them has corners inside.

The planes of the grid are a pitch apart, through the mesh's origin, across its axes. Where one cuts an
edge, the new corner depends on the edge's ends alone, in either direction, and all faces are cut by the
planes in the same order: so neighbours get the same corners along the edge that they share.
"""

import math

from tmap.base.fields import number
from tmap.base.fixed import ONE

FIELDS = {"grid": (number(1 / 16, 2048, "units"), None,
                   "cuts faces along planes this far apart, across the mesh's own axes, so that light has corners "
                   "inside large faces; all that shares edges needs the same")}
#: A corner: x, y and z in 1/65536, then values that change evenly over the face.
Corner = tuple


def planes(low: int, high: int, pitch: float) -> range:
    """Returns the numbers of all planes between two places on an axis, and some more at the ends."""
    return range(math.floor(low / ONE / pitch), math.ceil(high / ONE / pitch) + 1)


def between(a: Corner, b: Corner, axis: int, at: int) -> Corner:
    """Returns the corner where a plane cuts an edge, the same in both directions: its place rounded to the
    nearest, on the plane itself."""
    if a > b:
        a, b = b, a
    part, whole = at - a[axis], b[axis] - a[axis]
    if whole < 0:
        part, whole = -part, -whole
    return (*(m + (2 * (n - m) * part + whole) // (2 * whole) for m, n in zip(a[:3], b[:3])),
            *(m + (n - m) * (part / whole) for m, n in zip(a[3:], b[3:])))


def halves(corners: list[Corner], axis: int, at: int) -> tuple[list[Corner], list[Corner]]:
    """Returns the parts of a convex face below and above a plane."""
    below, above = [], []
    for k, corner in enumerate(corners):
        last = corners[k - 1]
        if (last[axis] < at < corner[axis]) or (corner[axis] < at < last[axis]):
            new = between(last, corner, axis, at)
            below.append(new)
            above.append(new)
        if corner[axis] <= at:
            below.append(corner)
        if corner[axis] >= at:
            above.append(corner)
    return below, above


def has_area(corners: list[Corner]) -> bool:
    """Returns True if the corners are not all on one line."""
    ring = [tuple(n - m for n, m in zip(corner[:3], corners[0][:3])) for corner in corners[1:]]
    return any(any(a[i] * b[j] != a[j] * b[i] for i, j in ((0, 1), (1, 2), (2, 0))) for a, b in zip(ring, ring[1:]))


def cells(corners: list[Corner], pitch: float, most: int) -> list[list[Corner]] | None:
    """Returns the parts of a convex face; None if they are more than ``most``."""
    parts = [corners]
    for axis in range(3):
        cut = []
        for rest in parts:
            low, high = (f(corner[axis] for corner in rest) for f in (min, max))
            numbers = planes(low, high, pitch)
            if len(numbers) > most + 3:
                return None
            for at in (round(number * pitch * ONE) for number in numbers):
                if low < at < high:
                    below, rest = halves(rest, axis, at)
                    cut.append(below)
            cut.append(rest)
            if len(cut) > most:
                return None
        parts = cut
    tidy = [[corner for k, corner in enumerate(part) if corner[:3] != part[k - 1][:3]] for part in parts]
    return [part for part in tidy if len(part) >= 3 and has_area(part)]
