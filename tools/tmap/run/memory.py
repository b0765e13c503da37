"""The memory that a scene takes on a machine, before the machine is booted.

``requests`` lists what the program ``render`` asks for, in its order: c/scene/load.c, maps_read.c, make.c and
c/programs/render.c. What texture units take while they draw is not in it: they draw without it, or say so.
"""

from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.paths import PROGRAMS
from tmap.build import layout
from tmap.guest.memory import Memory
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Scene
from tmap.scene_file.textures import Texture, ordered

PAGE, LIGHT = 1 << 16, 1 << 14
CANARIES = 2 * 4096  # around render's frame
SYSTEM = 8 << 10  # bytes at the end of the memory that are left to the system: 7 KB were seen to be in use
LARGEST = 3  # textures that a refusal names
#: Units of the maps that begin at certain multiples: bytes of a unit, units of a map, units more of a block.
UNITS = {"pages": (PAGE, 1, 0), "margins": (PAGE, 2, 1), "light": (LIGHT, 1, 0)}


def order_of(texture: Texture) -> str | None:
    """Returns the key of UNITS of a texture; None if it may be anywhere: scene_map_order in c/scene/maps.c."""
    if texture.texels.itemsize > 1:
        return None
    if texture.layout in ("page", "tiled") or texture.layout == "linear" and texture.texels.shape == (256, 256):
        return "pages"
    return texture.layout if texture.layout in UNITS else None


def map_bytes(texture: Texture) -> int:
    """Returns the bytes of a texture's map in memory."""
    if texture.layout == "page":
        return PAGE * texture.texels.itemsize
    return 2 * PAGE if texture.layout == "margins" else -(-texture.texels.nbytes // 4) * 4


def hunks(program: Path) -> list[int]:
    """Returns the bytes of a program's hunks in memory."""
    longs = [int.from_bytes(program.read_bytes()[at:at + 4], "big") for at in range(8, 40, 4)]
    return [4 * size for size in longs[3:3 + longs[0]]]


def loaded(machine: str) -> Memory:
    """Returns a machine's memory when render has been loaded."""
    memory = Memory.of(machine)
    for size in hunks(PROGRAMS / "render"):
        memory.take(size)
    memory.leave(SYSTEM)
    return memory


def needs_reciprocals(scene: Scene) -> bool:
    """Returns True if a material takes the table of reciprocals: tables_needed in c/scene/tables.c."""
    return scene.pixel.bytes == 1 and any(
        m.perspective != "none" and (m.perspective in ("every8", "every16") or m.tolerance)
        for m in scene.materials)


def tree_bytes(scene: Scene) -> list[int]:
    """Returns the requests for trees: make_trees in c/scene/make.c; where pixels are drawn once c/scene/near.c too."""
    sizes, slots = [], []  # nodes and slots of each tree
    while sum(sizes) < len(scene.nodes):
        root = sum(sizes)
        sizes.append(1 + int(scene.nodes[root, 4] + scene.nodes[root, 5]))
        slots.append(int(scene.nodes[root + sizes[-1] - 1, 6:8].sum()))
    if not sizes:
        return []
    made = [4 * max(slots), 8 * max(sizes)]
    if scene.once:
        size = {name: layout.load().struct(name).size for name in
                ("scene_near", "mesh_box", "near_slot", "scene_corner", "scene_point", "scene_bodies", "body")}
        parts = [scene.meshes[each.mesh] for each in scene.instances if each.tree >= 0]
        z = [k for k, each in enumerate(scene.instances, 1) if each.tree == layout.load().constants["TREE_Z"]]
        made += [size["scene_near"], len(scene.nodes) * size["mesh_box"], sum(slots) * size["near_slot"],
                 sum(each.corners for each in parts) * size["scene_corner"],
                 sum(each.points for each in parts) * size["scene_point"],
                 *([size["scene_bodies"], z[-1] * size["body"]] if z else [])]
    return made


def mesh_bytes(scene: Scene) -> list[int]:
    """Returns the requests for meshes: make_work in c/scene/make.c."""
    if not scene.instances:
        return []
    size = {name: layout.load().struct(name).size for name in
            ("mesh_placed", "mesh_point", "mesh_place", "mesh_attributes", "mesh_face", "mesh_point16",
             "depths", "scanline")}
    groups: dict[int, list] = {}
    for each in scene.instances:
        groups.setdefault(each.before, []).append(scene.meshes[each.mesh])
    most = max(map(len, groups.values()))
    points, normals, faces = (max(sum(getattr(mesh, table) for mesh in group) for group in groups.values())
                              for table in ("points", "normals", "faces"))
    z = layout.load().constants["TREE_Z"]
    pixels = scene.width * scene.height if any(each.tree == z for each in scene.instances) else 0
    depths = [size["depths"], 4 * pixels, scene.height * size["scanline"], pixels] if pixels else []
    return [most * size["mesh_placed"], points * size["mesh_point"], points * size["mesh_place"],
            normals * size["mesh_attributes"], faces * size["mesh_face"], points + 4 & ~3,
            *([len(scene.points) * size["mesh_point16"]] if len(scene.views16) else []), len(scene.meshes),
            *tree_bytes(scene), *depths]


def coverage_bytes(scene: Scene) -> list[int]:
    """Returns the requests of a scene whose pixels are drawn once: c/scene/coverage.c."""
    if not scene.once or not scene.instances:
        return []
    built = layout.load()
    size = {name: built.struct(name).size for name in ("coverage", "gap", "visible_part", "scanline", "scanline_step")}
    lines, room = scene.height, scene.height * (1 + built.constants["COVERAGE_GAPS"])
    tables = [each for count in (lines, room) for each in (
        count * size["scanline"], count * size["scanline_step"], 2 * count + 3 & ~3)]
    return [size["coverage"], 4 * lines, room * size["gap"], (room + lines) * size["visible_part"], *tables,
            scene.width * scene.height * scene.pixel.bytes]


def requests(scene: Scene) -> tuple[list[int], list[int]]:
    """Returns the sizes of render's requests before those for maps, and of those after them."""
    built = layout.load()
    size = {name: built.struct(name).size for name in
            ("map", "map_row", "material", "scene_scratch", "triangle_tables", "draw_counts", "n64_unit", "glide",
             "glide_pipe", "glide_tile_store")}
    texels = sum(-(-len(ordered(t)) // 4) * 4 for t in scene.textures)
    before = [len(scene_file.write(scene)) - texels, len(scene.textures) * size["map"]]
    after = [size["map_row"] * sum(scene.textures[m.texture].texels.shape[0] for m in scene.materials
                                   if m.mapper == "keyed")]
    after = after if after[0] else []
    if len(scene.units):
        after.append(len(scene.units) * size["n64_unit"])
    if len(scene.pipes):
        after += [len(scene.glide_units) * size["glide"], len(scene.pipes) * size["glide_pipe"],
                  size["glide_tile_store"]]
    after += [len(scene.materials) * size["material"], size["scene_scratch"], *coverage_bytes(scene)]
    if needs_reciprocals(scene):
        after.append(2 * built.constants["FAR_COUNT"])
    if any(m.edges == "snapped" for m in scene.materials):
        after.append(size["triangle_tables"])
    after += [*mesh_bytes(scene), *[len(scene.materials) * size["draw_counts"]] * 2]
    return before, after + [scene.width * scene.height * scene.pixel.bytes + CANARIES, scratch_bytes(scene)]


def scratch_bytes(scene: Scene) -> int:
    """Returns the bytes of scratch memory for a scene's polygons: scratch_bytes in c/polygon/scratch.h."""
    built = layout.load()
    whole = built.constants["SCRATCH_ROOM"]
    room = max(max(scene.width, scene.height) * built.constants["SCRATCH_LINE"], built.constants["SCRATCH_LEAST"])
    return built.struct("scratch").size - whole + (whole if len(scene.units) or len(scene.pipes) else room)


def take_maps(memory: Memory, textures: list[Texture]) -> bool:
    """Takes the maps' memory as scene_take_maps does; returns False if there is not enough."""
    for order, (unit, each, rest) in UNITS.items():
        left, kinds = sum(order_of(t) == order for t in textures), ["fast", "chip"]
        while left and kinds:
            units = memory.take_units(unit, left * each + rest, kinds[0])
            here = max(units - rest, 0) // each
            left -= here
            if not here:
                del kinds[0]
        if left:
            return False
    return all([memory.take(map_bytes(t)) for t in textures if not order_of(t)])


def fits(scene: Scene, machine: str) -> bool:
    """Returns True if render can load and draw a scene on a machine."""
    memory = loaded(machine)
    before, after = requests(scene)
    return all([memory.take(size) for size in before]) and take_maps(memory, scene.textures) \
        and all([memory.take(size) for size in after])


def for_textures(scene: Scene, machine: str) -> dict[str, int]:
    """Returns the bytes of each kind of memory that the textures take, with the blocks' ends."""
    memory = loaded(machine)
    for size in requests(scene)[0]:
        memory.take(size)
    before = dict(memory.taken)
    take_maps(memory, scene.textures)
    return {kind: size - before.get(kind, 0) for kind, size in memory.taken.items() if size > before.get(kind, 0)}


def shared(scene: Scene) -> dict[str, int]:
    """Returns the number of maps that share pages, and of these pages."""
    pages = [texture.maps for texture in scene.textures if texture.maps > 1]
    return {"maps": sum(pages), "pages": len(pages)}


def check(scene: Scene, machine: str, name: str) -> None:
    """Refuses a scene that does not fit a machine; ``name``: of its file."""
    if fits(scene, machine):
        return
    before, after = requests(scene)
    maps = sum(map(map_bytes, scene.textures))
    whole = maps + sum(before) + sum(after)
    free = " and ".join(f"{size:,} bytes of {kind} RAM" for kind, size in loaded(machine).free().items())
    largest = sorted(scene.textures, key=map_bytes, reverse=True)[:LARGEST]
    said = ", ".join(f"{texture.name} {map_bytes(texture):,}" for texture in largest)
    raise UserError(f"{name}: textures: no room on {machine}: the scene needs {whole:,} bytes, "
                    f"{maps:,} of them for textures; free are {free}"
                    + (f"; the largest textures: {said}" if largest else ""))
