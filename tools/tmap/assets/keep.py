"""The level of the scene ``keep``, and the urns and the gem that are in it. Eight rooms of square cells on a plan, joined by
passages; each open cell has a floor and a ceiling, each side to a closed one a wall. A map covers one such
face. Faces look into the level."""

import math

import numpy as np

from tmap.assets import keep_surfaces
from tmap.assets.meshes import obj
from tmap.base.elementary import cos, sin

#: Cells, the north at the top: capital letters are rooms, small ones the passages that share their surfaces.
PLAN = ("AA BB CC",
        "AAaBBbCC",
        "a   b  c",
        "DD EE FF",
        "DDdEEeFF",
        " d  e  f",
        "GG HHHHH",
        "GGgHHHHH")
CELL, HEIGHT = 4.0, 3.0  # units
#: Steps to the neighbours; the corners of the wall to it, as parts of a cell, seen from inside from left to right.
SIDES = (((-1, 0), (0, 0), (1, 0)), ((1, 0), (1, 1), (0, 1)), ((0, -1), (0, 1), (0, 0)), ((0, 1), (1, 0), (1, 1)))
#: Of an urn: radius and height of each ring, and how many faces are in one.
PROFILE = ((0.16, 0), (0.18, 0.05), (0.1, 0.15), (0.3, 0.45), (0.34, 0.65), (0.16, 0.9), (0.22, 1.0))
AROUND = 8


def open_at(row: int, column: int) -> str:
    """Returns a cell's letter, or "" of what is closed."""
    inside = 0 <= row < len(PLAN) and 0 <= column < len(PLAN[row])
    return PLAN[row][column].strip() if inside else ""


def quads() -> list[tuple[str, list[tuple[float, float, float]]]]:
    """Returns the faces: material and four corners from the map's lower left, counterclockwise. The plan's
    columns go along x, its rows along z."""
    made, walls = [], dict.fromkeys("abcdefgh", 0)
    for row, line in enumerate(PLAN):
        for column, letter in enumerate(line):
            if letter == " ":
                continue
            room = letter.lower()

            def corner(x: float, z: float, y: float) -> tuple[float, float, float]:
                return (column + x) * CELL, y, (row + z) * CELL

            made.append((f"{room}_floor", [corner(x, z, 0) for x, z in ((0, 1), (1, 1), (1, 0), (0, 0))]))
            made.append((f"{room}_roof", [corner(x, z, HEIGHT) for x, z in ((0, 0), (1, 0), (1, 1), (0, 1))]))
            for (down, right), left_end, right_end in SIDES:
                if open_at(row + down, column + right):
                    continue
                walls[room] += 1
                made.append((f"{room}_wall{walls[room] % 3}", [corner(*left_end, 0), corner(*right_end, 0),
                                                          corner(*right_end, HEIGHT), corner(*left_end, HEIGHT)]))
    return made


def keep() -> bytes:
    """Returns the level as an OBJ file."""
    points: dict[tuple[float, ...], int] = {}
    faces: dict[str, list[str]] = {}
    for material, corners in quads():
        numbers = [points.setdefault(corner, len(points) + 1) for corner in corners]
        faces.setdefault(material, []).append("f " + " ".join(f"{n}/{k}" for k, n in enumerate(numbers, 1)))
    lines = ["# Eight rooms and their passages", *("v " + " ".join(f"{c:g}" for c in p) for p in points),
             *(f"vt {s} {t}" for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)))]
    for material in sorted(faces):
        lines += [f"usemtl {material}", *faces[material]]
    return ("\n".join(lines) + "\n").encode()


def urn() -> bytes:
    """Returns an urn: a closed surface of revolution about the y axis, 1 unit high."""
    points = [(radius * cos(turn), height, radius * sin(turn)) for radius, height in PROFILE
              for turn in (math.tau * k / AROUND for k in range(AROUND))]
    faces: list[tuple[int, ...]] = [tuple(range(1, AROUND + 1))]
    for ring in range(len(PROFILE) - 1):
        low, high = ring * AROUND + 1, (ring + 1) * AROUND + 1
        faces += [(low + k, high + k, high + (k + 1) % AROUND, low + (k + 1) % AROUND) for k in range(AROUND)]
    faces.append(tuple(range(len(points), len(points) - AROUND, -1)))
    return obj(f"An urn of {len(PROFILE) - 1} x {AROUND} faces", [np.array(p) for p in points], faces)


def gem() -> bytes:
    """Returns a gem of twelve faces about the y axis."""
    ring = [(0.4 * cos(turn), 0.0, 0.4 * sin(turn)) for turn in (math.tau * k / 6 for k in range(6))]
    faces = [face for k in range(6) for face in ((1, k + 3, (k + 1) % 6 + 3), (2, (k + 1) % 6 + 3, k + 3))]
    return obj("A gem of 12 faces", [np.array(p) for p in [(0, -0.8, 0), (0, 0.8, 0), *ring]], faces)


FILES = {"keep/keep.obj": keep, "keep/urn.obj": urn, "keep/gem.obj": gem}
PICTURES = {f"keep/{name}.png": make for name, make in keep_surfaces.PICTURES.items()}
