"""Objects in space: compiles meshes, camera and light of a scene's TOML.

Lengths are the scene's units. An object's keys count frames from its appearance, a camera's from
the scene's first frame. Between keys positions move straight, rotations by the shortest way.
"""

from pathlib import Path

import numpy as np

from tmap.base.fields import (REQUIRED, fail, flag, integer, join, named, number, one_of, reader, rows,
                              table, text)
from tmap.base.fixed import ONE, fix
from tmap.base.linear import length, product
from tmap.build import layout
from tmap.compiler import (fog, glide, grids, hierarchy, lights, materials, mesh_build, mtl_file, orders, parts,
                           projectors as scene_projectors, space, visible)
from tmap.compiler.map_range import Map, check_corners, inside_map, map_of
from tmap.compiler.mesh_build import Wishes
from tmap.scene_file.meshes import ENVIRONMENT, FOG, LIT, UNIT_30, Instance, Mesh, empty
from tmap.scene_file.textures import UNITS
from tmap.shapes import billboards, mesh_file

FACTOR_BITS = 7  # fraction bits of the factors that normals are multiplied by
RADIUS = 127.0  # of an environment in its map, in s or t


@reader(f'table of names: text; or `"{mtl_file.FILE}"`')
def materials_of_parts(value, where):
    """A table from the file's materials to the scene's, or the word for the file's own."""
    if isinstance(value, str) and value != mtl_file.FILE:
        fail(where, f'must be a table or "{mtl_file.FILE}"')
    return value if isinstance(value, str) else named(text)(value, where)


def object_schema(limits: dict[str, int]) -> dict[str, dict]:
    """Returns the fields of objects in space, by the field that identifies their kind."""
    most, corners = limits["MESH_COUNT_MAX"], limits["MESH_CORNERS_MAX"]
    reach, angles = number(-1e6, 1e6, "units"), rows(number(-3600, 3600, "degrees"), 3, 3)
    place = rows(number(-space.AWAY, space.AWAY, "units"), 3, 3)
    texel = rows(number(1 - limits["POLYGON_FAR"], limits["POLYGON_FAR"] - 1), 2, 2)
    key = table({"frame": (integer(0, limits["SCENE_FRAMES_MAX"]), REQUIRED,
                           "the key's frame, counted from the object's `first`"),
                 "position": (place, None, "`position` in this frame; without it, the object's"),
                 "rotation": (angles, None, "`rotation` in this frame; without it, the object's")})
    placing = hierarchy.FIELDS | grids.FIELDS | {
        "position": (place, [0, 0, 0], "where the mesh's origin is: x, y, z"),
        "rotation": (angles, [0, 0, 0], "turns it about x, then y, then z"),
        "size": (number(1e-6, 1e6), 1, "factor of all points, before rotation and position"),
        "axis": (rows(number(-1, 1), 3, 3), [0, 1, 0], "the axis about which `turns` turns; any length but 0"),
        "turns": (number(-1000, 1000, "turns"), 0, "steady turns about `axis` in the scene's frames, after `rotation`"),
        "keys": (rows(key, 1, space.KEYS_MAX), None,
                 "a motion: between keys positions move straight and rotations by the shortest way"),
        "mapping": (one_of("uv", "environment", "shade", "none"), None,
                    "where s and t come from: the corners, or, in a mirror of its surroundings, the normals; without "
                    "it, what the material takes"),
        "normals": (one_of("file", "smooth", "faces"), None,
                    "normals for light and mirrors; without it, the file's, or else smooth ones"),
        "crease": (number(0, 180, "degrees"), None, "edges that are sharper stay sharp among smooth normals"),
        "triangles": (flag, False, "cuts all faces into triangles"),
        "two_sided": (flag, False, "draws faces seen from behind too"),
        "projector": (text, None, "the one of `[projectors]` that throws the material's second Glide unit"),
        "order": (one_of("depth", "bsp", "z"), "depth",
                  "which faces are drawn first: the farthest, by their greatest depth, or those that a tree of all "
                  "neighbours with `bsp` puts behind, which is right [everywhere](../../c/mesh/README.md); `z`: behind or "
                  "before its neighbours pixel by pixel, also where it moves through them")}
    uvs = rows(rows(texel, 3, corners), 1, most)
    return {"mesh": {"mesh": (text, REQUIRED, "an OBJ file, [with limits](README.md#models), beside the scene"),
                     "materials": (materials_of_parts, None, "the scene's materials for those of the file, in place of "
                                                             "`material`; or the file's own")} | placing,
            "points": {"points": (rows(rows(reach, 3, 3), 3, most), REQUIRED, "places: x, y, z"),
                       "faces": (rows(rows(integer(0, most - 1), 3, corners), 1, most), REQUIRED,
                                 "polygons: numbers of their points from 0, counterclockwise seen from the front"),
                       "uvs": (uvs, None, "s and t at each corner of each face; one entry alone is for all faces"),
                       "uvs1": (uvs, None, "the same for a second Glide unit with `own`")} | placing,
            "billboard": billboards.fields(placing)}


def schema(limits: dict[str, int]) -> dict:
    """Returns the fields of a scene for camera, projectors and light."""
    camera = table(space.camera_fields(limits, [0, 0, 0])
                   | {"near": (number(limits["W_MIN"] / ONE, 1000, "units"), 0.125,
                               "what is nearer than this is cut off")})
    return {"camera": (camera, None, "where objects in space are seen from; they need it"),
            "visible": (one_of(*visible.WAYS), "painter",
                        "how hidden pixels of objects in space are found: nearer faces are drawn over them, or faces "
                        "from the nearest on, each pixel once; the same picture"),
            **lights.schema(),
            **fog.schema(limits),
            "projectors": (named(scene_projectors.schema(limits)), {}, "pictures thrown on objects in space")}


def is_mesh(obj: dict) -> bool:
    """Returns True if an object is one in space."""
    return "mesh" in obj or "points" in obj or billboards.is_billboard(obj)


def lives_of(obj: dict, count: int) -> int:
    """Returns the number of frames of the first ``count`` that show an object; below 1: none."""
    last = count - 1 if obj["last"] is None else min(obj["last"], count - 1)
    return last - obj["first"] + 1


def fill_keys(spec: dict, names: tuple[str, ...], where: str) -> None:
    """Fills in fields that keys leave out; refuses keys that are not in order, and fields that are
    missing in both places."""
    for key, at in space.stops(spec, where):
        for name in names:
            key[name] = spec[name] if key[name] is None else key[name]
            if key[name] is None:
                fail(f"{at}.{name}", "is missing" + " here and beside keys" * (key is not spec))
    space.check_keys(spec["keys"], f"{where}.keys")


def check_view(spec: dict, where: str) -> None:
    """Refuses a camera or projector with invalid keys or upward direction; fills in fields that
    keys leave out."""
    space.check_length(spec["up"], f"{where}.up")
    fill_keys(spec, space.LENS, where)
    for stop, at in space.stops(spec, where):
        space.check_length(stop["up"], f"{at}.up")


def check_camera(spec: dict, where: str) -> None:
    """Refuses a camera whose field of view is too narrow for the scene's frames."""
    check_view(spec["camera"], where)
    most = 1 << layout.load().constants["GUARD_MAX"]
    for stop, at in space.stops(spec["camera"], where):
        focal = max(space.focal_lengths(spec, stop["fov"]))
        if focal > most:
            fail(f"{at}.fov", f"is too narrow for {spec['width']} pixels: a focal length of {focal:.0f} "
                              f"pixels; {most} at most")


def check_object(obj: dict, material: dict, projectors: dict, where: str) -> None:
    """Refuses an object in space that its material does not draw; fills in its mapping and the
    fields that its keys leave out."""
    space.check_length(obj["axis"], f"{where}.axis")
    fill_keys(obj, ("position", "rotation"), where)
    scene_projectors.check_object(obj, material, projectors, where)
    allowed, name = parts.mappings_of(material), obj["material"]
    obj["mapping"] = obj["mapping"] or allowed[0]
    if obj["mapping"] not in allowed:
        fail(f"{where}.mapping", f'"{obj["mapping"]}", but material {name!r} takes '
                                 f"{' or '.join(allowed)}")
    for field in ("normals", "crease"):
        if obj[field] is not None and not parts.takes_normals(material, obj["mapping"]):
            fail(f"{where}.{field}", f"material {name!r} has no use for them")
    if obj["order"] == "bsp" and glide.has_own(material):
        fail(f"{where}.order", f"material {name!r} has coordinates of a second unit, whose faces are no mesh's; "
                               'they have order "depth"')
    if obj["order"] == "bsp" and obj["parent"] is not None:
        fail(f"{where}.order", '"bsp" is for objects without a parent')
    if obj["order"] == "z":
        visible.check_tested(material, name, where)
    if obj["crease"] is not None and obj["normals"] not in (None, "smooth"):
        fail(f"{where}.crease", f'goes with normals "smooth", not "{obj["normals"]}"')
    if obj["crease"] is not None:
        obj["normals"] = "smooth"


def check(spec: dict, where: str) -> None:
    """Refuses invalid camera, projectors, light and objects; fills in fields that keys leave
    out."""
    if spec["camera"]:
        check_camera(spec, f"{where}camera")
    for name, projector in spec["projectors"].items():
        check_view(projector, join(f"{where}projectors", name))
    lights.check(spec, where)
    for obj in filter(is_mesh, spec["objects"]):
        if not spec["camera"]:
            fail(f"{where}camera", f"is missing; {obj['at'].removeprefix(where)} has a mesh")
        parts.settle(obj, spec["materials"])
        check_object(obj, spec["materials"][obj["material"]], spec["projectors"], obj["at"])
        if obj["order"] == "z" and spec["format"] != "chunky":
            fail(f"{obj['at']}.order", f'"z" needs pixels of one byte, but format is "{spec["format"]}"')
        if spec["visible"] == "once" and obj["order"] != "z":
            visible.check_once(spec["materials"][obj["material"]], obj, where)


def complete(values: list | None, drawn: list[int]) -> bool:
    """Returns True if each of these faces has values at its corners."""
    return values is not None and all(values[k] is not None for k in drawn)


def rounded(values, bits: int) -> list[int]:
    """Rounds to the nearest numbers with this many fraction bits."""
    return np.rint(np.asarray(values) * 2.0 ** bits).astype(np.int64).ravel().tolist()


class Space:
    """Collects the meshes, instances and views of a scene."""

    def __init__(self, spec: dict, count: int, folder: Path, where: str) -> None:
        self.spec, self.count, self.folder, self.where = spec, count, folder, where
        self.rows = {name: [] for name in ("points", "normals", "corners", "faces")}
        self.trees = orders.Trees(self)
        self.meshes: list[Mesh] = []
        self.asked: dict[str, int] = {}  # number of the mesh by wishes
        self.known: dict[tuple, int] = {}  # number of the mesh by content
        self.shapes: dict[tuple, mesh_file.Shape] = {}  # by file and extent of the map
        self.notes: dict[str, str] = {}  # what users should know, by mesh
        self.instances: list[Instance] = []
        self.views: list[list[int]] = []
        self.cameras: dict[int, space.View] = {}  # by frame: every object asks for it
        self.limits = layout.load().constants
        self.guard = 0
        if spec["camera"]:
            narrowest = min(stop["fov"] for stop, _ in space.stops(spec["camera"], ""))
            self.guard = space.guard_bits(spec["width"], spec["height"], max(space.focal_lengths(spec, narrowest)))

    def wishes_of(self, obj: dict, material: dict) -> Wishes:
        """Returns how an object's mesh is drawn."""
        mapper = materials.mapper_of(material)
        return Wishes(
            obj["whole_size"], obj["normals"], 180.0 if obj["crease"] is None else obj["crease"], obj["mapping"],
            parts.has_light(material),
            obj["triangles"] or mapper != "flat" and material["gradients"] == "polygon",
            mapper != "flat" and material["gradients"] == "plane", obj["two_sided"],
            obj["names"], obj["order"] == "bsp", obj["grid"],
            lights.baking_of(self.spec, obj, material), mapper == "lit")

    def tables_of(self, obj: dict, material: dict, where: str, uvs: str = "uvs"
                  ) -> mesh_build.Tables | None:
        """Returns the tables of an object with a Glide unit, with the coordinates of one field; None if
        it has no faces."""
        return self.build(obj, "glide", map_of(material, None), self.wishes_of(obj, material),
                          where, uvs)

    def mesh_of(self, obj: dict, material: dict, texture: dict | None, where: str) -> int | None:
        """Returns the number of an object's mesh; None if it has no faces. Equal meshes have the
        same number."""
        mapper, shown = materials.mapper_of(material), map_of(material, texture)
        wishes = self.wishes_of(obj, material)
        source = [obj.get(name) for name in ("mesh", "points", "faces", "uvs", "billboard")]
        key = repr((source, shown, mapper in ("arbitrary", *UNITS), wishes))
        if key not in self.asked:
            made = self.build(obj, mapper, shown, wishes, where)
            if made is None:
                return None
            if mapper == "arbitrary":
                made.corners[:, 2:4] = inside_map(made.corners[:, 2:4], texture)
            if made.key not in self.known:
                self.known[made.key] = self.store(made, where)
            self.asked[key] = self.known[made.key]
        return self.asked[key]

    def shape_of(self, reference: str, at: str, extent: tuple[float, float]) -> mesh_file.Shape:
        """Returns the mesh of an OBJ file, which is read once."""
        if (reference, extent) not in self.shapes:
            self.shapes[reference, extent] = mesh_file.load(reference, self.folder, at, extent)
        return self.shapes[reference, extent]

    def build(self, obj: dict, mapper: str, shown: Map, wishes: Wishes, where: str,
              uvs: str = "uvs", placing: orders.Placing | None = None) -> mesh_build.Tables | None:
        """Builds the tables of an object's mesh, None if it is a part without faces; refuses one that
        the material cannot draw. ``uvs``: the field with s and t; ``placing``: where the mesh is put
        before it is rounded."""
        at = f"{where}." + ("mesh" if "mesh" in obj else "faces" if "faces" in obj else "billboard")
        file = f"{at}: {obj['mesh']}" if "mesh" in obj else at
        if "mesh" in obj:
            shape = self.shape_of(obj["mesh"], at, shown.extent)
        elif billboards.is_billboard(obj):
            shape = billboards.shape_of(obj, shown.extent)
        else:
            shape = mesh_file.listed(obj, where, uvs)
        if obj["names"] is not None:
            parts.check_names(obj, shape, where)
        drawn = shape.drawn(obj["names"])
        if obj["normals"] == "file" and not complete(shape.normals, drawn):
            fail(f"{where}.normals", '"file", but not every corner has a normal there')
        if obj["mapping"] == "uv":
            if not complete(shape.texels, drawn):
                fail(f"{where}.mapping", '"uv" needs texture coordinates at every corner')
            for k in drawn:
                texels_at = shape.at(k, file) if "mesh" in obj else f"{where}.{uvs}"
                check_corners([(0, 0, *texel) for texel in shape.texels[k]], mapper, shown, texels_at)
        if placing:
            shape, wishes = orders.placed(shape, wishes, placing, file)
        made = mesh_build.build(shape, wishes, file)
        if made and made.left_out:
            count = len(made.left_out)
            self.notes[obj.get("mesh", where)] = f"{made.left_out[0]}: has no area and is left out" \
                                                 + f", the first of {count} such faces" * (count > 1)
        return made

    def store(self, made: mesh_build.Tables, where: str) -> int:
        """Appends a mesh; returns its number."""
        firsts = []
        for name, stored in self.rows.items():
            added = getattr(made, name)
            firsts += [len(stored), len(added)]
            stored += added.tolist()
            if len(stored) > self.limits["SCENE_COUNT_MAX"]:
                fail(where, f"more than {self.limits['SCENE_COUNT_MAX']} {name} of meshes in "
                            "the scene")
        self.meshes.append(Mesh(*firsts))
        return len(self.meshes) - 1

    def seen(self, obj: dict, frame: int, shades: float) -> tuple[np.ndarray, ...]:
        """Returns an object's view before rounding: factors, a row each for x, y and w; the move;
        the eye in the mesh's space; factors of normals for s, t and shade. ``shades``: the
        difference of bright and dark."""
        spec, guard = self.spec, 2.0 ** self.guard
        if frame not in self.cameras:
            self.cameras[frame] = space.camera_at(spec["camera"], frame, f"{self.where}camera")
        axes, eye, fov = self.cameras[frame]
        turn, position = hierarchy.placed_at(obj, frame, spec["frames"])
        if billboards.is_billboard(obj):
            turn = billboards.turned(axes)
        lens = np.array([*space.focal_lengths(spec, fov) / guard, 1.0])
        seen = product(axes, turn)
        material = spec["materials"][obj["material"]]
        light = lights.factors(spec, obj, material, turn, position) * shades
        return (lens[:, None] * seen, lens * product(axes, position - eye),
                product(turn.T, eye - position), np.array([RADIUS * seen[0], RADIUS * seen[1], light]))

    def view(self, obj: dict, frame: int, shades: float, where: str) -> list[int]:
        """Returns an object's row of the views."""
        factors, move, eye, looks = self.seen(obj, frame, shades)
        move, seen_from = rounded(move, 16), rounded(eye, 16)
        away = self.limits["MESH_AWAY"]
        if max(map(abs, move)) >= away * ONE or max(map(abs, seen_from)) >= 1 << 31:
            fail(where, f"is {away} units or more from the camera in frame {frame}")
        matrix = np.clip(rounded(factors, 30), -UNIT_30, UNIT_30).tolist()
        return [*matrix, *move, *seen_from, *rounded(looks, FACTOR_BITS), 0]

    def check_together(self, mesh: Mesh, before: int, where: str) -> None:
        """Refuses a mesh if the meshes drawn together would have too many points, normals or
        faces."""
        for noun in ("points", "normals", "faces"):
            total = getattr(mesh, noun) + sum(getattr(self.meshes[i.mesh], noun)
                                              for i in self.instances if i.before == before)
            if total > self.limits["SCENE_COUNT_MAX"]:
                fail(where, f"more than {self.limits['SCENE_COUNT_MAX']} {noun} in meshes one "
                            "after the other")

    def place(self, obj: dict, look: tuple, before: int, where: str) -> None:
        """Adds an object. ``look``: its material's number, the material, texture and ramp."""
        _, material, texture, _ = look
        if lights.needs_normals(self.spec, obj, material):
            self.notes[f"{where}.mapping"] = f'{where}.mapping: "environment" needs the normals, so all lights are ' \
                                             "taken as one direction, as those of an object that moves"
        if obj["order"] == "bsp":
            if lives_of(obj, self.count) >= 1:
                self.trees.add(obj, look, before, where)
            return
        if obj["order"] != "z":
            self.trees.close()
        mesh = self.mesh_of(obj, material, texture, where)
        if mesh is not None:
            self.add_instance(mesh, obj, look, before, where)

    def add_instance(self, mesh: int, obj: dict, look: tuple, before: int, where: str, tree: int = -1,
                     slot: int = 0) -> None:
        """Adds an object with a mesh. ``tree``, ``slot``: as in struct scene_instance."""
        number, material, _, ramp = look
        lives = lives_of(obj, self.count)
        if lives < 1:
            return
        self.check_together(self.meshes[mesh], before, where)
        flags = ENVIRONMENT * (obj["mapping"] == "environment") \
            | (FOG if fog.is_foggy(material) else LIT * (ramp is not None))
        dark = bright = 0.0
        if ramp:
            ambient = 0 if flags & FOG else self.spec["light"]["ambient"] * (materials.SHADES - 1)
            dark, bright = (materials.shade_pixel(shade, ramp)
                            for shade in (ambient, materials.SHADES - 1))
        made = Instance(mesh, number, before, len(self.views), lives, obj["first"], flags, fix(dark), fix(bright),
                        -1, self.limits["TREE_Z"] if obj["order"] == "z" else tree, slot, *fog.depths(self.spec, material))
        at = len(self.instances)
        while obj["order"] == "z" and at and self.instances[at - 1].before == before \
                and self.instances[at - 1].tree != made.tree:
            at -= 1  # before those that it is tested against
        self.instances.insert(at, made)
        shades = 0.0 if flags & FOG else bright - dark
        self.views += [self.view(obj, obj["first"] + age, shades, where)
                       for age in range(lives)]
        if len(self.views) > self.limits["SCENE_COUNT_MAX"]:
            fail(where, f"more than {self.limits['SCENE_COUNT_MAX']} frames of meshes in the scene")

    def tables(self) -> dict:
        """Returns the tables as fields of a Scene."""
        self.trees.close()
        stored_all = self.rows | {"views": self.views, "nodes": self.trees.nodes, "slots": self.trees.slots}
        made = {name: np.array(stored, np.int64) if stored else empty(name)
                for name, stored in stored_all.items()}
        if self.instances:
            near = fix(self.spec["camera"]["near"])
            made |= {"near_plane": near, "guard": self.guard}
        return made | {"meshes": self.meshes, "instances": self.instances}
