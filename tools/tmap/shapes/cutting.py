"""Cuts polygons into triangles, exactly: on whole numbers, as seen along an axis.

A corner is (u, v), a pair of integers; polygons run counterclockwise.
"""

from itertools import combinations

import numpy as np

Corner = tuple[int, int]
STEEP = 0.125  # cosine of a normal and an axis along which too little is seen of a polygon


def flat(places: np.ndarray, normal: np.ndarray, axis: int) -> list[Corner]:
    """Returns a polygon's corners as seen along an axis, in the order that makes a polygon with this
    normal run counterclockwise. ``places``: int64 [n, 3]."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    return list(map(tuple, places[:, [u, v] if normal[axis] > 0 else [v, u]].tolist()))


def turn(a: Corner, b: Corner, c: Corner) -> int:
    """Returns twice the area of a triangle: above 0 if it runs counterclockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def crosses(corners: list[Corner]) -> bool:
    """Returns True if two sides cross each other inside both. Sides may touch and lie on each
    other, as those do that join a hole to the border."""
    def parts(a, b, c, d):  # True if c and d lie on different sides of the line from a to b
        return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) and turn(a, b, c) and turn(a, b, d)

    sides = [(corners[k - 1], corner) for k, corner in enumerate(corners)]
    return any(parts(a, b, c, d) and parts(c, d, a, b) for (a, b), (c, d) in combinations(sides, 2))


def is_ear(u: Corner, v: Corner, w: Corner, blunt: list[Corner]) -> bool:
    """Returns True if a polygon's corner v, with its neighbours, is a triangle with no other corner
    in it. ``blunt``: corners of 180 degrees and more; if any corner is inside, one of these is."""
    return turn(u, v, w) > 0 and not any(
        p not in (u, v, w) and turn(u, v, p) >= 0 and turn(v, w, p) >= 0 and turn(w, u, p) >= 0
        for p in blunt)


def is_spike(u: Corner, v: Corner, w: Corner) -> bool:
    """Returns True if the sides from a corner v to its neighbours lie on each other, or one has no
    length."""
    return turn(u, v, w) == 0 and (u[0] - v[0]) * (w[0] - v[0]) + (u[1] - v[1]) * (w[1] - v[1]) >= 0


def ears(corners: list[Corner]) -> list[list[int]] | None:
    """Returns the triangles of a polygon, each by its corners' numbers, by cutting off the ear with
    the shortest cut again and again; None if the polygon crosses itself in a way that stops this."""
    left, made = list(range(len(corners))), []
    while len(left) >= 3:
        around = [(corners[left[k - 1]], corners[left[k]], corners[left[(k + 1) % len(left)]])
                  for k in range(len(left))]
        spike = next((k for k, each in enumerate(around) if is_spike(*each)), None)
        if spike is not None:
            del left[spike]
            continue
        blunt = [v for u, v, w in around if turn(u, v, w) <= 0]
        found = [(abs(w[0] - u[0]) + abs(w[1] - u[1]), k)
                 for k, (u, v, w) in enumerate(around) if is_ear(u, v, w, blunt)]
        if not found:
            return None
        k = min(found)[1]
        made.append(sorted([left[k - 1], left[k], left[(k + 1) % len(left)]]))
        del left[k]
    return made


def fan(corners: int) -> list[list[int]]:
    """Returns the triangles that share a polygon's first corner."""
    return [[0, k - 1, k] for k in range(2, corners)]


def triangles(corners: list[Corner]) -> list[list[int]] | None:
    """Returns the triangles of a polygon: a fan if all of it runs counterclockwise, else ears; None
    if the polygon crosses itself."""
    if crosses(corners):
        return None
    plain = fan(len(corners))
    return plain if all(turn(*(corners[k] for k in each)) > 0 for each in plain) else ears(corners)


def triangles_in_space(places: np.ndarray, normal: np.ndarray) -> list[list[int]] | None:
    """Returns the triangles of a polygon; None if it crosses itself. It is seen along the axis that is
    nearest to its unit normal or, as bent ones may cross themselves there only, along another."""
    for axis in np.argsort(-abs(normal), kind="stable").tolist():
        if abs(normal[axis]) < STEEP:
            break
        found = triangles(flat(places, normal, axis))
        if found is not None:
            return found
    return None
