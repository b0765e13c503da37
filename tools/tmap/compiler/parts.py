"""Objects of several materials become one object for each, all from the same file; and what
materials take of an object's fields."""

from tmap.base.fields import fail, join
from tmap.compiler import fog, materials
from tmap.compiler.glide import has_own
from tmap.shapes.mesh_file import Shape

#: Mappings that a mapper takes; all other mappers take "uv" or "environment".
MAPPINGS = {"gouraud": ("shade",), "flat": ("none",), "arbitrary": ("uv",)}


def has_light(material: dict) -> bool:
    """Returns True if a material takes shades from the light."""
    return not fog.is_foggy(material) and (materials.mapper_of(material) == "gouraud" or materials.has_shades(material))


def mappings_of(material: dict) -> tuple[str, ...]:
    """Returns the mappings that a material takes, its usual one first."""
    mapper = materials.mapper_of(material)
    return MAPPINGS.get("flat" if mapper == "gouraud" and fog.is_foggy(material) else mapper, ("uv", "environment"))


def takes_normals(material: dict, mapping: str | None) -> bool:
    """Returns True if a material with this mapping, if it takes it, is drawn by normals."""
    return has_light(material) or mapping == "environment" and mapping in mappings_of(material)


def split(objects: list[dict], scene_materials: dict, where: str) -> list[dict]:
    """Returns the objects of a scene, those with ``materials`` once for each material of the scene
    that the table names. Adds ``at``, the object's place for messages, and ``names``, the file's
    materials of the part; None: all faces."""
    made = []
    for i, obj in enumerate(objects):
        at, named = f"{where}objects[{i}]", obj.get("materials")
        fields = {f"{at}.material": obj["material"]}
        if named is None and obj["material"] is None:
            fail(f"{at}.material", "is missing")
        if named is not None:
            if obj["material"] is not None:
                fail(f"{at}.materials", "there is a material for the whole object too")
            if not named:
                fail(f"{at}.materials", "names no material")
            fields = {join(f"{at}.materials", name): material for name, material in named.items()}
        for field, material in fields.items():
            if material not in scene_materials:
                fail(field, f"there is no material {material!r}")
        made += [obj | {"material": material, "at": at, "names": named and tuple(
            name for name, its in named.items() if its == material)}
                 for material in dict.fromkeys(fields.values())]
    return made


def check_names(obj: dict, shape: Shape, where: str) -> None:
    """Refuses a file with faces of a material that an object's table lacks. Entries that the file
    does not use are no fault, so that files can share a table."""
    for k, name in enumerate(shape.materials):
        if name not in obj["materials"]:
            fail(f"{where}.materials", f"{shape.at(k, obj['mesh'])}: " + (
                f"a face of material {name!r}, which has no entry" if name else
                'a face before the first usemtl, which needs the entry ""'))


def settle(obj: dict, scene_materials: dict) -> None:
    """Drops fields that a part's material has no use for but another part's has."""
    if obj["names"] is None:
        return
    own = scene_materials[obj["material"]]
    all_ = [scene_materials[name] for name in obj["materials"].values()]
    mapping = obj["mapping"]
    if not takes_normals(own, mapping) and any(takes_normals(each, mapping) for each in all_):
        obj["normals"] = obj["crease"] = None
    if mapping not in mappings_of(own) and any(mapping in mappings_of(each) for each in all_):
        obj["mapping"] = None
    if not has_own(own) and any(map(has_own, all_)):
        obj["projector"] = None
