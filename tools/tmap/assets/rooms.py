"""The mesh of the scene ``rooms``: three rooms, with doors in the walls between them, and beams and crates
that cross each other. All are closed boxes; each has its material and texture coordinates."""

import math
from dataclasses import dataclass

import numpy as np

from tmap.base.elementary import cos, sin
from tmap.base.linear import product

LENGTH, WIDTH, HEIGHT, THICK = 24.0, 8.0, 3.2, 0.3
SCALE = 0.25  # maps for a unit
#: A box's sides: corners, bit k says which end of axis k; the axes of s and t.
SIDES = (((0, 2, 3, 1), 0, 1), ((4, 5, 7, 6), 0, 1), ((0, 4, 6, 2), 2, 1), ((1, 3, 7, 5), 2, 1),
         ((0, 1, 5, 4), 0, 2), ((2, 6, 7, 3), 0, 2))


@dataclass
class Box:
    """A box around a middle, turned about the y and then the z axis (degrees)."""

    material: str
    middle: tuple[float, float, float]
    size: tuple[float, float, float]
    turns: tuple[float, float] = (0.0, 0.0)

    def corners(self) -> np.ndarray:
        """Returns the corners, by bits as in SIDES."""
        y, z = map(math.radians, self.turns)
        about_y = np.array([[cos(y), 0, sin(y)], [0, 1, 0], [-sin(y), 0, cos(y)]])
        about_z = np.array([[cos(z), -sin(z), 0], [sin(z), cos(z), 0], [0, 0, 1]])
        ends = np.array([[(k >> axis & 1) - 0.5 for axis in range(3)] for k in range(8)]) * self.size
        return product(ends, product(about_z, about_y).T) + self.middle


def between(material: str, low: tuple[float, ...], high: tuple[float, ...]) -> Box:
    """Returns a box by two of its corners."""
    return Box(material, *(tuple(part) for part in ((np.array(low) + high) / 2, np.array(high) - low)))


def wall(z: float, left: float, right: float, height: float) -> list[Box]:
    """Returns a wall across the house with a door from x ``left`` to ``right``: what is beside and above
    it."""
    back, half = z - THICK, WIDTH / 2
    return [between("wall", (-half, 0, back), (left, HEIGHT, z)),
            between("wall", (right, 0, back), (half, HEIGHT, z)),
            between("wall", (left, height, back), (right, HEIGHT, z))]


def boxes() -> list[Box]:
    """Returns all of the house, and what is in it."""
    half, end, top = WIDTH / 2, -LENGTH, HEIGHT
    return [between("floor", (-half, -THICK, end), (half, 0, 0)),
            between("roof", (-half, top, end), (half, top + THICK, 0)),
            between("wall", (-half - THICK, 0, end), (-half, top, 0)),
            between("wall", (half, 0, end), (half + THICK, top, 0)),
            between("wall", (-half, 0, end - THICK), (half, top, end)),
            between("wall", (-half, 0, 0), (half, top, THICK)),
            *wall(-8, -1.2, 0.8, 2.3), *wall(-16, 1.0, 2.8, 2.3),
            Box("beam", (0, 2.7, -4), (9, 0.3, 0.3), (40, 0)),
            Box("beam", (0, 2.7, -4), (9, 0.3, 0.3), (-40, 0)),
            Box("beam", (0.5, 1.6, -12), (4.6, 0.35, 0.35), (0, 38)),
            Box("beam", (0.5, 1.6, -12), (4.6, 0.35, 0.35), (0, -38)),
            Box("beam", (0.5, 1.6, -12), (0.3, 3.2, 0.3), (45, 0)),
            Box("beam", (0.5, 1.6, -12), (0.25, 0.25, 5), (20, 0)),
            Box("crate", (-2.6, 0.6, -9.3), (1.2, 1.2, 1.2), (20, 0)),
            Box("crate", (-2.1, 0.5, -9.8), (1, 1, 1), (55, 0)),
            Box("crate", (2.9, 0.5, -6.8), (1, 1, 1), (30, 0)),
            Box("crate", (-2.6, 0.4, -3), (0.8, 0.8, 0.8), (15, 0)),
            Box("crate", (2.2, 0.7, -19), (1.4, 1.4, 1.4), (25, 0)),
            Box("crate", (2.5, 1.2, -19.4), (0.9, 0.9, 0.9), (50, 30)),
            Box("beam", (-1.5, 1.5, -20), (5, 0.4, 0.4), (30, 25)),
            Box("beam", (-1.5, 1.5, -20), (5, 0.4, 0.4), (-50, -15))]


def rooms() -> bytes:
    """Returns the OBJ file. Maps are as wide as they are high: 1 / SCALE units."""
    points: list[str] = []
    texels: list[str] = []
    faces: list[str] = []
    for box in boxes():
        first, size = len(points) + 1, box.size
        points += ["v " + " ".join(f"{c:.4f}" for c in corner) for corner in box.corners()]
        faces.append(f"usemtl {box.material}")
        for ring, s, t in SIDES:
            places = [(size[s] * (k >> s & 1) * SCALE, size[t] * (k >> t & 1) * SCALE) for k in ring]
            faces.append("f " + " ".join(f"{first + k}/{len(texels) + i + 1}" for i, k in enumerate(ring)))
            texels += [f"vt {u:.4f} {v:.4f}" for u, v in places]
    title = "# Three rooms, with beams and crates that cross each other"
    return ("\n".join([title, *points, *texels, *faces]) + "\n").encode()


FILES = {"rooms.obj": rooms}
