"""Scene files with invalid meshes, instances or views: file, offset, value, field."""

from dataclasses import replace

import numpy as np

from tests.helpers.wrong_fields import M32, Row, WrongFields
from tests.helpers import mesh_cases
from tmap.scene_file.meshes import FOG
from tmap.scene_file.scene_file import Material, Texture

UNIT = 1 << 30


def wrong_meshes() -> list[Row]:
    """Returns rows like those of wrong_pipes in glide_bad_files."""
    made = mesh_cases.before(1)
    made.textures = [Texture(np.zeros((8, 8), np.uint8)),
                     Texture(np.zeros((30, 7), np.uint8), "linear")]
    made.instances[1].flags = 0
    made.instances[8].flags, made.instances[8].fog_near, made.instances[8].fog_far = FOG, 1 << 16, 9 << 16
    made.materials = [*made.materials, Material("arbitrary", texture=1)]
    rows: list[Row] = []
    wrong = WrongFields(made, rows)
    entry = wrong.entry
    for field, values in (("near_plane", (0, 255, 1 << 30, M32)), ("guard", (0, 5, 14, M32))):
        wrong.header(field, *values)
    for field in "xyz":
        entry("points", 3, field, (2048 << 16) + 1, 2**31, said="point")
        entry("faces", 5, field, UNIT + 1, -UNIT - 1, said="face.x, y or z")
    entry("normals", 2, "x", 16385 << 16, 0xBFFF << 16, 16385, said="normal")
    entry("normals", 2, "z", 16385 << 16, said="normal")
    for field in ("xx", "yz", "zz"):
        entry("views", 4, field, UNIT + 1, 2**31, said="view.xx to zz")
    for field in ("x0", "y0", "z0"):
        entry("views", 4, field, 10240 << 16, -10240 << 16, said="view.x0, y0 or z0")
    for field in ("wx", "xz", "yy"):
        entry("views16", 2, field, 16385 << 16, 0xBFFF << 16, said="view16.wx to yz")
    for field in ("divisor_shift", "depth_shift", "seen_shift"):
        entry("views16", 3, field, 32 << 16, M32, said="view16.divisor_shift, depth_shift or seen_shift")
    entry("instances", 7, "view16", len(made.views16) - 3, -2, 2**31 - 1)
    entry("corners", 6, "point", 8 << 16, M32)
    entry("corners", 6, "point", 6, said="corner.normal")  # the lower word is the normal's
    entry("faces", 1, "corner", 21, 24, M32, said="face.corners")
    entry("faces", 1, "corners", 0, 2, 33, M32)
    for many, one, past in (("points", "point", 9), ("normals", "normal", 7), ("faces", "face", 13)):
        entry("meshes", 0, many, 0, 4097, M32)
        entry("meshes", 0, one, past, M32, said=f"mesh.{many}")
    entry("meshes", 0, "corners", 61, M32)
    entry("meshes", 0, "corners", 3, said="face.corners")
    entry("meshes", 0, "corner", 61, M32, said="mesh.corners")
    entry("instances", 1, "mesh", 2, M32)
    entry("instances", 1, "material", 10, M32)
    entry("instances", 1, "material", 4, said="instance.flags")  # shades need light
    entry("instances", 1, "material", 9, said="corner.s or t")
    entry("instances", 2, "before", 3, M32)
    entry("instances", 1, "view", 33, M32, said="instance.views")
    entry("instances", 1, "views", 0, 33, M32)
    entry("instances", 1, "first_frame", 4, M32)
    entry("instances", 1, "flags", 4, 8, M32)  # fog needs shades
    entry("instances", 4, "flags", 6)  # beside light
    entry("instances", 8, "fog_near", -1, 9 << 16, 2**31, said="instance.fog_near or fog_far")
    entry("instances", 8, "fog_far", 0, 1 << 16, (1 << 30) + 1, said="instance.fog_near or fog_far")
    entry("instances", 4, "dark", -1, 221 << 16, said="instance.dark or bright")
    entry("instances", 4, "bright", 19 << 16, 256 << 16, said="instance.dark or bright")
    entry("instances", 3, "mesh", 0, said="face.corners")  # gradients for triangles
    wrong_trees(rows)
    wrong_tested(rows)
    return rows


def wrong_trees(rows: list[Row]) -> None:
    """Adds trees with wrong planes, parts that overlap or leave the tree, and slots that are not its own."""
    made = mesh_cases.trees(1)
    made.textures = [Texture(np.zeros((8, 8), np.uint8))]  # few bytes to load
    wrong = WrongFields(made, rows)
    said = "node.front or back"
    for field in "xyz":
        wrong.entry("nodes", 2, field, UNIT + 1, -UNIT - 1, 2**31, said="node.x, y or z")
    # A tree of 2 + 2 nodes below its first, then one of a single node.
    for index, front, back in ((0, 2, 2), (1, 1, 0), (3, 0, 1), (5, 0, 0)):
        for field, right in (("front", front), ("back", back)):
            least = 0 if index else 1  # the first node may have fewer below it: then there are fewer slots
            wrong.entry("nodes", index, field, *(n for n in (0, 1, 2, 3, 5, 6, 65536, 2**31, M32 - 1, M32)
                                                 if n != right and n >= least), said=said)
    wrong.entry("nodes", 0, "front", 0, said="slot.slot")
    wrong.entry("nodes", 0, "back", 0, said="slot.slot")
    for index in range(6):
        wrong.entry("nodes", index, "slot", 99, M32, 2**31, said="node.slot or slots")
        wrong.entry("nodes", index, "slots", 65537, M32, M32 - 7, 2**31, said="node.slot or slots")
    wrong.entry("instances", 1, "tree", 1, 3, -2, said="instance.tree")
    wrong.entry("instances", 1, "tree", 5, said="slot.slot")
    wrong.entry("instances", 0, "tree", 5, 2**31 - 1, -3, said="instance.tree")
    wrong.entry("instances", 2, "tree", -1, said="nodes")
    wrong.entry("instances", 1, "slot", 13, M32, 2**31, said="instance.slot")
    wrong.entry("slots", 3, "slot", 12, M32, 2**31)
    wrong.entry("slots", 14, "slot", 6, M32)


def wrong_tested(rows: list[Row]) -> None:
    """Adds instances that cannot be tested by z, or drawn once."""
    made = mesh_cases.trees(1)
    made.textures = [Texture(np.zeros((8, 8), np.uint8))]
    made.materials = [Material("flat", edges=edges, colour=9) for edges in ("exact", "exact", "subpixel")]
    made.instances = [replace(each, material=k, flags=0, tree=tree)
                      for k, (each, tree) in enumerate(zip(made.instances, (-2, -2, -1)))]
    made.nodes, made.slots = made.nodes[:0], made.slots[:0]
    wrong = WrongFields(made, rows)
    wrong.entry("instances", 2, "tree", -2, said="instance.tree")  # its edges are not exact
    wrong.entry("instances", 1, "material", 2, said="instance.tree")
    wrong.entry("materials", 0, "edges", 0, 1, said="instance.tree")
    wrong.entry("instances", 0, "tree", -1, said="instance.tree")  # then the second is not first
    wrong.header("once", 1)
