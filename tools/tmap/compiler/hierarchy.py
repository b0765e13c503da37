"""Moving parts: objects in space whose place, rotation and size are in the space of another object."""

import math

import numpy as np

from tmap.base.fields import fail, text
from tmap.base.linear import product
from tmap.compiler import space

FIELDS = {"name": (text, None, "what other objects call it as their `parent`"),
          "parent": (text, None, "the object in whose space this one is: place, rotation and size count from there")}


def check(objects: list[dict], where: str) -> None:
    """Refuses names that two objects have, parents that do not exist and circles of parents. Gives each
    object in space ``above``: its parent, that one's parent and so on; and multiplies its size by
    theirs."""
    named: dict[str, dict] = {}
    parts = [(f"{where}objects[{i}]", obj) for i, obj in enumerate(objects) if "parent" in obj]
    for at, obj in parts:
        if obj["name"] in named:
            fail(f"{at}.name", f"another object is called {obj['name']!r} too")
        if obj["name"] is not None:
            named[obj["name"]] = obj
    for at, obj in parts:
        obj["above"], child = [], obj
        while child["parent"] is not None:
            if child["parent"] not in named:
                fail(f"{at}.parent", f"there is no object in space called {child['parent']!r}")
            child = named[child["parent"]]
            way = [obj, *obj["above"]]
            if any(child is each for each in way):
                names = [repr(each["name"]) for each in (*way, child) if each["name"] is not None]
                fail(f"{at}.parent", f"leads in a circle: {' in '.join(names)}")
            obj["above"].append(child)
    for _, obj in parts:
        obj["whole_size"] = math.prod(each["size"] for each in (obj, *obj["above"]))


def is_still(obj: dict) -> bool:
    """Returns True if neither an object in space nor one above it moves."""
    return not any(each["keys"] or each["turns"] for each in (obj, *obj["above"]))


def placed_at(obj: dict, frame: int, loop: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns rotation and position in space of an object in a frame of the scene: the product of its
    own and those above it. Each one's motion starts with its own first frame."""
    turn, position = space.placed_at(obj, frame - obj["first"], loop)
    for parent in obj["above"]:
        above, origin = space.placed_at(parent, frame - parent["first"], loop)
        turn, position = product(above, turn), product(above, parent["size"] * position) + origin
    return turn, position
