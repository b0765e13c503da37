"""Fog of a scene: its fields, and which materials fade into it.

A corner's shade is the fog: full up to the depth ``near``, none from ``far`` on, evenly between. Textures
fade through a light table that leads to the fog's colour, flat colours become ramps from it.
"""

from tmap.base.fields import REQUIRED, colour, fail, join, number, table
from tmap.base.fixed import ONE, fix
from tmap.setup.shading import LIT

STEPS = 32  # palette entries from the fog to a flat colour


def schema(limits: dict[str, int]) -> dict:
    """Returns the fields of a scene for fog."""
    depth = number(0, limits["W_MAX"] / ONE, "units")
    fog = table({"colour": (colour, REQUIRED, "what materials with `fog` fade into"),
                 "near": (depth, REQUIRED, "the depth up to which there is no fog"),
                 "far": (depth, REQUIRED, "the depth from which on all is fog; above `near`")})
    return {"fog": (fog, None, "fades objects in space whose material has `fog` with their depth")}


def is_foggy(material: dict) -> bool:
    """Returns True if a checked material fades into the fog: its shades are the fog's, not the light's."""
    return bool(material.get("fog"))


def check_material(material: dict, spec: dict, at: str) -> None:
    """Refuses a material that cannot fade."""
    if not spec["fog"]:
        fail(f"{at}.fog", "the scene has no [fog]")
    if spec["format"] != "chunky":
        fail(f"{at}.fog", f'needs pixels of one byte, but format is "{spec["format"]}"')
    if "colour" in material:
        return
    if material.get("mapper") not in LIT:
        found = f'the mapper "{material["mapper"]}"' if "mapper" in material else "shades"
        fail(f"{at}.fog", "is for a colour or a texture with the mapper "
                          + " or ".join(f'"{mapper}"' for mapper in LIT) + f"; this material has {found}")


def settle(spec: dict, where: str) -> None:
    """Refuses fog that no material fades into, or that ends before it begins, and materials that cannot fade;
    gives those with a flat colour its ramp."""
    fog = spec["fog"]
    if fog and fix(fog["far"]) <= fix(fog["near"]):
        fail(f"{where}fog.far", f"must be above near, {fog['near']}")
    foggy = [name for name, material in spec["materials"].items() if is_foggy(material)]
    for name in foggy:
        material = spec["materials"][name]
        check_material(material, spec, join(f"{where}materials", name))
        if "colour" in material:
            material |= {"shades": [fog["colour"], material.pop("colour")], "steps": STEPS}
    if fog and not foggy:
        fail(f"{where}fog", "no material has `fog = true`")


def check_object(obj: dict, material: dict, in_space: bool) -> None:
    """Refuses an object on the screen whose material fades."""
    if is_foggy(material) and not in_space:
        fail(f"{obj['at']}.material", f"material {obj['material']!r} has fog, which is for objects in space")


def depths(spec: dict, material: dict) -> tuple[int, int]:
    """Returns fog_near and fog_far of an instance."""
    return (fix(spec["fog"]["near"]), fix(spec["fog"]["far"])) if is_foggy(material) else (0, 0)
