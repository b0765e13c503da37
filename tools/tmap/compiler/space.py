"""Cameras and motion in space, in floating point; the scene compiler rounds once at the end.

x is right, y up, z towards the viewer of a camera that looks along -z. Rotations are about x, then
y, then z, counterclockwise when the axis points at the viewer, in degrees.
"""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from tmap.base.elementary import atan2, cos, sin, tan
from tmap.base.fields import REQUIRED, fail, flag, integer, number, rows, table
from tmap.base.linear import length, product
from tmap.build import layout

AWAY = 1e5  # units: limit of distances from the origin
KEYS_MAX = 1000
#: A pixel's width and height on the screen, in pixels of low resolution, by the scene's key ``pixel``.
SIZES = {"1x1": (1, 1), "2x1": (2, 1), "1x2": (1, 2), "2x2": (2, 2)}
LENS = ("eye", "target", "up", "fov")  # what a camera's keys may set
GUARD_EDGE = 16  # pixels of the guard band around the frame, at least


class View(NamedTuple):
    """A camera or projector in a frame."""

    axes: np.ndarray  # rows: right, down, forward
    eye: np.ndarray
    fov: float  # degrees


def scaled(vector) -> np.ndarray:
    """Scales a vector that is not 0 by the power of two that brings its largest part to 1/2 to 1,
    so that its squares neither vanish nor overflow."""
    return np.ldexp(vector, -math.frexp(np.abs(vector).max())[1])


def unit(vector) -> np.ndarray:
    """Returns the unit vector in the direction of a vector that is not 0."""
    vector = scaled(vector)
    return vector / length(vector)


def check_length(vector: list[float], where: str) -> None:
    """Refuses a direction without length; any other length will do."""
    if not any(vector):
        fail(where, "must have a length")


def about(axis, angle: float) -> np.ndarray:
    """Returns the rotation by an angle (radians) about an axis of any length."""
    x, y, z = unit(axis)
    across = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + sin(angle) * across + (1 - cos(angle)) * product(across, across)


def rotated(degrees) -> np.ndarray:
    """Returns the rotation about x, then y, then z; read-only."""
    return rotated_about(*map(float, degrees))


@lru_cache(1000)  # every frame asks for the same few
def rotated_about(*degrees: float) -> np.ndarray:
    """Returns the rotation of three angles."""
    x, y, z = (about(axis, math.radians(angle)) for axis, angle in zip(np.eye(3), degrees))
    made = product(product(z, y), x)
    made.flags.writeable = False
    return made


def between(first: np.ndarray, second: np.ndarray, part: float) -> np.ndarray:
    """Returns the rotation at a part of the shortest way from one rotation to another."""
    way = product(second, first.T)
    axis = np.array([way[2, 1] - way[1, 2], way[0, 2] - way[2, 0], way[1, 0] - way[0, 1]])
    angle = atan2(length(axis), float(np.trace(way)) - 1)  # 2 sin and 2 cos
    if length(axis) < 1e-9:  # no turn, or a half turn: take the column that does not vanish
        if angle < 1:
            return first
        axis = (way + np.eye(3))[:, int(np.argmax(np.diag(way)))]
    return product(about(axis, part * angle), first)


def camera_fields(limits: dict[str, int], target: list | None) -> dict:
    """Returns the fields of a camera or a projector; ``target``: the default, or None."""
    place, angle = rows(number(-AWAY, AWAY, "units"), 3, 3), number(1, 170, "degrees")
    key = table({"frame": (integer(0, limits["SCENE_FRAMES_MAX"]), REQUIRED, "the scene's frame of this key"),
                 "cut": (flag, False, "jumps to this key; until its frame the view stays that of the key before"),
                 **{name: (each, None, f"`{name}` in this frame; without it, the one beside `keys`")
                    for name, each in (("eye", place), ("target", place), ("up", place), ("fov", angle))}})
    return {"eye": (place, None, "where it is: x, y, z; needed unless each key has one"),
            "target": (place, target, "the point that is in the middle of its picture"
                                      + "; needed unless each key has one" * (target is None)),
            "up": (place, [0, 1, 0], "a direction that is upright in its picture"),
            "fov": (angle, 60, "the angle of view across the picture's width"),
            "keys": (rows(key, 1, KEYS_MAX), None, "a motion: the view changes evenly from key to key, or at cuts; "
                                                   "before the first and after the last it rests")}


def at_key(keys: list[dict], frame: float) -> tuple[dict, dict, float]:
    """Returns the keys before and after a frame, and the frame's position between them, 0 to 1. They
    are the same key before the first, behind the last and before a cut."""
    before = [key for key in keys if key["frame"] <= frame]
    after = [key for key in keys if key["frame"] > frame]
    if not before or not after or after[0].get("cut"):
        only = (before or after[:1])[-1]
        return only, only, 0.0
    a, b = before[-1], after[0]
    return a, b, (frame - a["frame"]) / (b["frame"] - a["frame"])


def mixed(a: dict, b: dict, name: str, part: float) -> np.ndarray:
    """Interpolates a value linearly between two keys."""
    if a[name] == b[name]:
        return np.array(a[name])
    return np.array(a[name]) * (1 - part) + np.array(b[name]) * part


def check_keys(keys: list[dict] | None, where: str) -> None:
    """Refuses keys that are not in order."""
    for i, (a, b) in enumerate(zip(keys or [], (keys or [])[1:]), 1):
        if b["frame"] <= a["frame"]:
            fail(f"{where}[{i}].frame", f"must be above {a['frame']}, the key's before")


def stops(spec: dict, where: str) -> list[tuple[dict, str]]:
    """Returns the views between which a camera or projector changes, and their places for messages."""
    if not spec["keys"]:
        return [(spec, where)]
    return [(key, f"{where}.keys[{i}]") for i, key in enumerate(spec["keys"])]


def camera_at(spec: dict, frame: int, where: str) -> View:
    """Returns the view of a camera or projector in a frame."""
    a, b, part = at_key(spec["keys"], frame) if spec["keys"] else (spec, spec, 0.0)
    eye, target, up, fov = (mixed(a, b, name, part) for name in LENS)
    forward = target - eye
    if length(forward) < 1e-6:
        fail(where, f"eye and target are in one place in frame {frame}")
    forward, up = scaled(forward), scaled(up)
    right = np.cross(forward, up)
    if length(right) <= 1e-6 * length(forward) * length(up):
        fail(where, f"eye, target and up are on one line in frame {frame}")
    forward /= length(forward)
    right /= length(right)
    return View(np.array([right, np.cross(forward, right), forward]), eye, float(fov))


def placed_at(spec: dict, age: int, loop: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns rotation and position of an object ``age`` frames after it appeared."""
    turn, position = rotated(spec["rotation"]), np.array(spec["position"])
    if spec["keys"]:
        a, b, part = at_key(spec["keys"], age)
        position = mixed(a, b, "position", part)
        turn = between(rotated(a["rotation"]), rotated(b["rotation"]), part)
    spin = about(spec["axis"], math.tau * spec["turns"] * age / loop)
    return product(spin, turn), position


def focal_lengths(spec: dict, degrees: float) -> np.ndarray:
    """Returns the distance from the eye to the screen for a scene's horizontal field of view, in widths and in heights
    of pixels."""
    across, down = SIZES[spec["pixel"]]
    focal = spec["width"] / 2 / tan(math.radians(degrees) / 2)
    return np.array([focal, focal * across / down])


def guard_bits(width: int, height: int, focal: float) -> int:
    """Returns log2 of the smallest guard band that holds the frame with its edge, and also the longer
    focal length, so that a view's factors are at most 1."""
    reach = max(focal, width / 2 + GUARD_EDGE, height / 2 + GUARD_EDGE)
    return max(layout.load().constants["GUARD_MIN"], (math.ceil(reach) - 1).bit_length())
