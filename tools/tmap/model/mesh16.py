"""The integer model of meshes with 16-bit operands: points, their places on the screen, faces seen."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import mul_div, signed
from tmap.build import layout
from tmap.setup import snapped

LIMITS = layout.load().constants
UNIT16 = LIMITS["MESH_UNIT16"]
#: Columns of a row of the views16 as they follow each other: w, x and y, each the move and three factors.
W, X, Y = 0, 5, 10
DIVISOR_SHIFT, DEPTH_SHIFT, SEEN_SHIFT, EYE, IS_USED = 4, 9, 14, 15, 18


@dataclass
class Places:
    """Points: x and y in 1/16 pixel; the depths that they were divided by; which ones are on the screen."""

    x: np.ndarray
    y: np.ndarray
    depth: np.ndarray
    shown: np.ndarray


def reach(points: np.ndarray) -> int:
    """The largest coordinate, 16.16, of which MESH_UNIT16 units are one."""
    return max(int(abs(points).max()), 1)


def points_of(points: np.ndarray) -> np.ndarray:
    """mesh_points16: the points of a mesh in 16 bits."""
    return mul_div(points, UNIT16, reach(points))


def all_points(scene) -> np.ndarray:
    """The points of all meshes; of meshes that share points the last one's."""
    made = np.zeros_like(scene.points)
    for mesh in scene.meshes:
        at = slice(mesh.point, mesh.point + mesh.points)
        made[at] = points_of(scene.points[at])
    return made


def sums(points: np.ndarray, row: list[int], at: int) -> np.ndarray:
    """The sums of a row's products, modulo 2^32; its first sums have 16 bits."""
    x, y, z = points.T
    move, a, b, c = row[at:at + 4]
    return signed(signed(a + y, 16) * signed(b + x, 16) + c * z + move - x * y)


def transform(points: np.ndarray, row: list[int], frame: tuple[int, int],
              needed: np.ndarray | None = None) -> Places | None:
    """mesh_transform: the places of 16-bit points; None if one is behind the eye. ``frame``: width and
    height; ``needed``: which points are looked at, all by default; others may be anywhere."""
    right, bottom = 16 * min(frame[0], snapped.WIDTH), 16 * frame[1]
    depth = sums(points, row, W) >> row[DIVISOR_SHIFT]
    if needed is not None:
        depth = np.where(needed, depth, np.maximum(depth, 1))
    if (depth <= 0).any():
        return None
    x, y = ((sums(points, row, at) & 0xFFFFFFFF) // depth for at in (X, Y))
    return Places(x, y, depth, (x <= right) & (y <= bottom))


def is_used(material, row: list[int]) -> bool:
    """Returns true if a material's points are tried with these factors."""
    return material.edges == "snapped" and material.perspective == "none" and bool(row[IS_USED])


def is_seen(face, row: list[int]) -> bool:
    """mesh_faces: returns true if a face is seen from the front."""
    return sum((n >> 16) * e for n, e in zip(face[:3], row[EYE:EYE + 3])) >> row[SEEN_SHIFT] > face[3]
