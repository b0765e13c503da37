"""How hidden pixels of objects in space are found, and which materials can be drawn so."""

from tmap.base.fields import fail
from tmap.compiler import materials
from tmap.scene_file.meshes import NOT_ONCE
from tmap.scene_file.textures import UNITS

WAYS = ("painter", "once")  # values of the scene's key ``visible``


def check_tested(material: dict, name: str, where: str) -> None:
    """Refuses a material whose pixels are not tested one by one."""
    mapper = materials.mapper_of(material)
    if mapper in UNITS:
        fail(f"{where}.order", f'"z" is not for material {name!r}: a texture unit draws it')
    if material["edges"] not in ("snapped", "exact"):
        fail(f"{where}.order", f'"z" needs edges "snapped" or "exact", but material {name!r} has "{material["edges"]}"')


def check_once(material: dict, obj: dict, where: str) -> None:
    """Refuses a material whose pixels cannot be drawn once."""
    mapper = materials.mapper_of(material)
    if mapper in NOT_ONCE:
        fail(f"{where}visible", f'"once" is not for mapper "{mapper}", which material {obj["material"]!r} has')
    if material["edges"] != "exact":
        fail(f"{where}visible", f'"once" needs edges "exact"; material {obj["material"]!r} has "{material["edges"]}"')
