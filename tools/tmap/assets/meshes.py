"""The meshes of the scenes, as Wavefront OBJ files: triangles and quadrilaterals, without texture
coordinates and normals, counterclockwise seen from outside."""

import math

import numpy as np

from tmap.base.elementary import cos, sin
from tmap.base.linear import length, product

Point = np.ndarray | tuple[float, float, float]


def obj(title: str, points: list[Point], faces: list[tuple[int, ...]]) -> bytes:
    """Returns an OBJ file; faces count points from 1."""
    lines = [f"# {title}", *("v " + " ".join(f"{c:.4f}" for c in point) for point in points),
             *("f " + " ".join(map(str, face)) for face in faces)]
    return ("\n".join(lines) + "\n").encode()


def tube(along: int, around: int) -> list[tuple[int, ...]]:
    """Returns the faces of a closed tube: ``along`` sections of ``around`` points each."""
    faces = []
    for i in range(along):
        here, there = i * around + 1, (i + 1) % along * around + 1
        faces += [(here + k, here + n, there + n, there + k)
                  for k, n in ((k, (k + 1) % around) for k in range(around))]
    return faces


def knot() -> bytes:
    """A tube, 0.42 thick, around the (2, 3) torus knot, which extends from radius 1 to 3."""
    along, around, thick = 48, 8, 0.42
    points = []
    for i in range(along):
        points += section(math.tau * i / along, around, thick)
    return obj(f"A tube round the (2, 3) torus knot of {along} x {around} faces", points,
               tube(along, around))


def line(angle: float) -> np.ndarray:
    """Returns a point of the knot's line for an angle of 0 to 2 pi."""
    reach = 2 + cos(3 * angle)
    return np.array([reach * cos(2 * angle), reach * sin(2 * angle), sin(3 * angle)])


def section(angle: float, around: int, thick: float) -> list[np.ndarray]:
    """Returns the corners of a section of the knot, counterclockwise when seen against the line's
    direction. The first corner points away from the knot's axis."""
    along = line(angle + 1e-4) - line(angle - 1e-4)
    along /= length(along)
    out = line(angle) * (1, 1, 0)
    out -= along * product(out, along)
    out /= length(out)
    side = np.cross(along, out)
    turns = (math.tau * k / around for k in range(around))
    return [line(angle) + thick * (cos(t) * out + sin(t) * side) for t in turns]


FILES = {"knot.obj": knot}
