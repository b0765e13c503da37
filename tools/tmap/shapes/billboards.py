"""Billboards: upright pictures in space that always face the camera. Each is a rectangle parallel to the screen; all
of it has one depth, so that it is drawn without perspective and the picture's rows stay rows."""

import numpy as np

from tmap.base.fields import REQUIRED, fail, number, one_of, rows
from tmap.shapes.mesh_file import Shape

LIMITS = 1e-3, 1e4  # units of a side
#: What it has of other objects in space, and what they have instead of the rest.
SHARED = ("name", "parent", "position", "size", "keys")
FIXED = {"rotation": [0, 0, 0], "axis": [0, 1, 0], "turns": 0, "mapping": None, "normals": None, "crease": None,
         "triangles": False, "two_sided": False, "projector": None, "grid": None}


def fields(placing: dict) -> dict:
    """Returns the fields of a billboard, given those of all objects in space."""
    own = {"billboard": (rows(number(*LIMITS, "units"), 2, 2), REQUIRED,
                         "width and height of a picture that always faces the camera; `position` is the middle of its "
                         "lower side"),
           "order": (one_of("depth", "z"), "depth",
                     "by depth; or tested pixel by pixel against all that is drawn with it, as other objects with `z`")}
    return own | {name: placing[name] for name in SHARED}


def is_billboard(obj: dict) -> bool:
    """Returns true if an object is a billboard."""
    return "billboard" in obj


def complete(objects: list[dict], where: str) -> None:
    """Fills in the fields that billboards have not, but other objects in space have."""
    for i, obj in enumerate(objects):
        if not is_billboard(obj):
            continue
        obj |= FIXED
        for k, key in enumerate(obj["keys"] or []):
            if key["rotation"] is not None:
                fail(f"{where}objects[{i}].keys[{k}].rotation", "a billboard always faces the camera")


def shape_of(obj: dict, extent: tuple[float, float]) -> Shape:
    """Returns the rectangle that shows the whole of a map; ``extent``: s and t at the map's far ends."""
    (width, height), (s, t) = obj["billboard"], extent
    left, right = -width / 2, width / 2
    points = np.array([[left, 0, 0], [right, 0, 0], [right, height, 0], [left, height, 0]])
    return Shape(points, [[0, 1, 2, 3]], [[(0.0, t), (s, t), (s, 0.0), (0.0, 0.0)]])


def turned(axes: np.ndarray) -> np.ndarray:
    """Returns the rotation that faces a camera, whose ``axes`` are right, down and forward."""
    return axes.T * (1, -1, -1)
