"""Lights of a scene: their fields, and how bright they make what they shine on.

Brightness is a number: 0 is the scene's ambient light, 1 and more is full light. A light adds to it
its own brightness times the cosine of the angle at which it falls on a surface, nothing from behind.
A light with a place also grows weaker with the distance d: by (1 - d^2 / reach^2)^2, to 0 at its reach.
"""

from dataclasses import dataclass

import numpy as np

from tmap.base.fields import REQUIRED, choice, fail, number, rows, table
from tmap.base.linear import length, product
from tmap.compiler import hierarchy, parts, space

COUNT_MAX = 64
USUAL = [0.5, -1, -1]  # the direction if a scene says nothing of light
AMBIENT = 0.25


def schema() -> dict:
    """Returns the fields of a scene for light."""
    direction = rows(number(-space.AWAY, space.AWAY), 3, 3)
    light = table({"direction": (direction, None, "the way that it shines: x, y, z of any length but 0; needed unless "
                                                  "there are `lights`"),
                   "ambient": (number(0, 1), AMBIENT, "brightness of faces that turn away from it")})
    one = choice({
        "direction": {"direction": (direction, REQUIRED,
                                    "the way that it shines, everywhere: x, y, z of any length but 0")},
        "position": {"position": (rows(number(-space.AWAY, space.AWAY, "units"), 3, 3), REQUIRED,
                                  "it is a lamp at this place: x, y, z"),
                     "reach": (number(1e-3, space.AWAY, "units"), REQUIRED,
                               "the distance from which on it gives no light; before that its brightness is "
                               "multiplied by (1 - distance^2 / reach^2)^2")}},
        {"brightness": (number(0, 16), 1, "of a face straight before it: 1 is full light, 0 the ambient one; "
                                          "several lights add up, to full light at most")})
    return {"light": (light, None, "light on objects in space; without it, "
                                   f"`{{ direction = {USUAL}, ambient = {AMBIENT} }}`"),
            "lights": (rows(one, 1, COUNT_MAX), None,
                       "several lights, in place of `direction` in `[light]`; they do not move")}


def check(spec: dict, where: str) -> None:
    """Refuses directions without length, and a direction beside a list of lights; fills in what a scene
    leaves out."""
    several = spec["lights"]
    spec["light"] = light = spec["light"] or {"direction": None if several else USUAL, "ambient": AMBIENT}
    if several and light["direction"] is not None:
        fail(f"{where}light.direction", "there are lights too; make it one of them")
    if not several and light["direction"] is None:
        fail(f"{where}light.direction", "is missing")
    places = [(each, f"{where}lights[{k}]") for k, each in enumerate(several or [])]
    for each, at in places or [(light, f"{where}light")]:
        if "direction" in each:
            space.check_length(each["direction"], f"{at}.direction")


def fall(light: dict, place: np.ndarray) -> tuple[np.ndarray, float]:
    """Returns the unit vector from a place to one of ``lights``, and its brightness there. The vector is
    0 at the light's own place."""
    if "direction" in light:
        return -space.unit(light["direction"]), light["brightness"]
    way = np.array(light["position"]) - place
    part = length(way) / light["reach"]
    if not way.any() or part >= 1:
        return np.zeros(3), light["brightness"] if part < 1 else 0.0
    left = 1 - part * part
    return space.unit(way), light["brightness"] * left * left


def towards(spec: dict, place: np.ndarray) -> np.ndarray:
    """Returns the light at a place as one vector, for the product with unit normals: the sum of the unit
    vectors to all lights, each times its brightness there; its length is 1 at most."""
    if not spec["lights"]:
        return -space.unit(spec["light"]["direction"])
    total = np.zeros(3)
    for way, bright in (fall(light, place) for light in spec["lights"]):
        total = total + way * bright
    return total / max(1.0, length(total))


def is_lit_still(spec: dict, obj: dict, material: dict) -> bool:
    """Returns True if several lights shine on an object in space that stands still."""
    return bool(spec["lights"]) and parts.has_light(material) and hierarchy.is_still(obj)


def needs_normals(spec: dict, obj: dict, material: dict) -> bool:
    """Returns True if the shades of such an object cannot be computed here, as s and t need its normals."""
    return is_lit_still(spec, obj, material) and obj["mapping"] == "environment"


def is_baked(spec: dict, obj: dict, material: dict) -> bool:
    """Returns True if the shades of an object in space are computed here."""
    return is_lit_still(spec, obj, material) and obj["mapping"] != "environment"


@dataclass(frozen=True)
class Baking:
    """Lights, and where the mesh is on which they shine: numbers alone, so that equal ones have equal
    texts."""

    lights: tuple[dict, ...]
    turn: tuple[tuple[float, ...], ...]
    move: tuple[float, ...]

    def without(self, move: np.ndarray) -> "Baking":
        """Returns the same for a mesh that is already turned, and moved by ``move``."""
        still = tuple(map(tuple, np.eye(3).tolist()))
        return Baking(self.lights, still, tuple((np.array(self.move) - move).tolist()))

    def brightness(self, place: np.ndarray, normal: np.ndarray) -> float:
        """Returns the brightness, 0 to 1, of a surface at a place of the mesh, with a normal of any length
        but 0. A light at that place shines straight on it."""
        turn, total = np.array(self.turn), 0.0
        place, normal = product(turn, place) + self.move, product(turn, space.unit(normal))
        for way, bright in (fall(light, place) for light in self.lights):
            total += bright * (max(float(product(way, normal)), 0.0) if way.any() else 1.0)
        return min(total, 1.0)


def baking_of(spec: dict, obj: dict, material: dict) -> Baking | None:
    """Returns what the shades of a mesh are computed from; None if they are the Amiga's work."""
    if not is_baked(spec, obj, material):
        return None
    turn, move = hierarchy.placed_at(obj, obj["first"], spec["frames"])
    return Baking(tuple(spec["lights"]), tuple(map(tuple, turn.tolist())), tuple(move.tolist()))


def factors(spec: dict, obj: dict, material: dict, turn: np.ndarray, position: np.ndarray) -> np.ndarray:
    """Returns what the rows of an object's normals are multiplied by to get brightness: the light in the
    mesh's space, or, where they hold brightness already, 1 for that."""
    if is_baked(spec, obj, material):
        return np.array([1.0, 0.0, 0.0])
    return product(turn.T, towards(spec, position))
