"""Calls of the routines that make batches of triangles from faces: mesh_gather, mesh_link; mesh_vertices."""

from dataclasses import dataclass

import numpy as np

from tmap.bench.examples.example import longs
from tmap.bench.mesh import COUNT, shade_of, table
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.scene_file.meshes import ENVIRONMENT, LIT
from tmap.setup import shading, snapped


@dataclass
class Gathered:
    """Faces for mesh_gather: points (x, y in 1/16 pixel, None: out of range), attributes of normals (s,
    t, shade), and faces: (instance, corners of (point, normal, s, t)). ``others``: instances of another
    material."""

    mapper: str
    points: list
    attributes: list
    faces: list
    flags: int = 0
    scale: int = 0
    room: int = 64  # triangles of the list
    others: tuple[int, ...] = ()
    is_linked: bool = False  # mesh_link: vertices are places

    def values(self, corners) -> list[tuple[int, ...]] | None:
        """What the corners' vertices get besides a place; None if it is out of range."""
        own = [self.attributes[normal] for _, normal, _, _ in corners]
        if self.mapper == "flat" or self.is_linked:
            return [()] * len(corners)
        if self.mapper == "gouraud":
            return [(shade_of(shade) + snapped.RAISED << 4,) for _, _, shade in own]
        pairs = [at[:2] for at in own] if self.flags & ENVIRONMENT else [c[2:] for c in corners]
        levels = [(shade_of(at[2] >> 2) << 4,) if self.mapper in shading.LIT else () for at in own]
        pairs = [[value * self.scale + 0x8000 >> 16 if self.scale else value for value in pair]
                 for pair in pairs]
        reach = snapped.TEXELS << 16
        if any(not -reach <= value < reach for pair in pairs for value in pair):
            return None
        return [tuple(value + snapped.RAISED << 4 for value in pair) + level
                for pair, level in zip(pairs, levels)]

    def is_linkable(self, corners) -> bool:
        """Returns true if mesh_orders gives a face its corners."""
        places = [self.points[point] for point, *_ in corners]
        ys = [place[1] for place in places if place]
        return len(corners) <= snapped.CORNERS and None not in places and max(ys) - min(ys) < 16 * snapped.LINES

    def taken(self) -> list[tuple[list[int], list[tuple]]]:
        """The places and values of the faces that are taken."""
        made, triangles = [], 0
        for instance, corners in self.faces:
            places = [self.points[point] for point, *_ in corners]
            values = self.values(corners) if instance not in self.others and self.is_linkable(corners) else None
            if values is None or triangles > self.room - (snapped.CORNERS - 2):
                return made
            made.append(([x + 16 << 16 | y + 15 for x, y in places], values))
            triangles += len(corners) - 2
        return made


def gather_trial(arena: Arena, these: Gathered, title: str = "") -> Trial:
    """Faces that become triangles of a batch, up to one that cannot."""
    known = layout.load()
    size, face_size, vertex_size, place_size = (
        known.struct(name).size for name in ("mesh_face", "scene_face", "snapped_vertex", "mesh_place"))
    stored = [(-1 if p is None else p[0] + 16 << 16 | p[1] + 15, 0, 0, 0) for p in these.points]
    corners_at = table(arena, "scene_corner", [c for _, corners in these.faces for c in corners])
    sizes = [len(corners) for _, corners in these.faces]
    faces_at = table(arena, "scene_face", [[0, 0, 0, 0, sum(sizes[:k]), count]
                                           for k, count in enumerate(sizes)])
    common = {"corners": corners_at,
              "places": arena.add(b"".join(map(longs, stored)), name="places"),
              "attributes": arena.add(b"".join(longs((*a, 0)) for a in these.attributes),
                                      name="attributes")}
    materials = [arena.blank(16, name) for name in ("material", "another")]
    placed = [arena.struct("mesh_placed", common | {"material": materials[k in these.others]},
                           mesh=0, points=0, view=0, view16=0, fog=0, flags=these.flags)
              for k in range(1 + max(instance for instance, _ in these.faces))]
    first = arena.blank(size * len(these.faces), "faces")
    for k, (instance, corners) in enumerate(these.faces):
        at, more = first + size * k, k + 1 < len(these.faces)
        links = [common["places"] + place_size * point for point, *_ in corners] if these.is_linkable(corners) else []
        links += [0] * (4 - len(links))
        row = [0, more * (at + size), faces_at + k * face_size, placed[instance], *links]
        arena.data[at:at + size] = longs(row)
        arena.pointers += [at + 4 * n for n, value in enumerate(row) if value]
    done, rooms = these.taken(), these.room + 2
    vertices = arena.room("snapped_vertex", 3 * rooms + 4)
    listed = arena.room("triangle", rooms)
    plan_at = arena.struct("gather_plan", {
        "from": first, "vertices": vertices, "list": listed,
        "full": listed + 12 * (these.room - (snapped.CORNERS - 2)), "material": materials[0]},
        flags=these.flags, values=snapped.VALUES[these.mapper] + (these.mapper in shading.LIT), scale=these.scale,
        last=0, placed=0, corners=0)
    writes, at, to = [], vertices, listed
    for _, corners in these.faces[:len(done)] if these.is_linked else ():
        for k in range(2, len(corners)):
            writes += [Write(to + 4 * n, longs((common["places"] + place_size * corners[which][0],)), pointer=True)
                       for n, which in enumerate((0, k - 1, k))]
            to += 12
    for places, values in () if these.is_linked else done:
        for k, (place, value) in enumerate(zip(places, values)):
            writes.append(Write(at + vertex_size * k, longs((place, *value))))
        for k in range(2, len(places)):
            writes += [Write(to + 4 * n, longs((at + vertex_size * which,)), pointer=True)
                       for n, which in enumerate((0, k - 1, k))]
            to += 12
        at += vertex_size * len(places)
    writes += [*fields(plan_at, "gather_plan", {}, {"last": to}),
               anything(to, 24) if these.is_linked else anything(at, vertex_size * snapped.CORNERS)]
    if not these.is_linked:
        writes.append(anything(plan_at + known.struct("gather_plan").fields["placed"]["offset"], 8))
    is_all = len(done) == len(these.faces)
    return Trial(Case("mesh_link" if these.is_linked else "mesh_gather", arena, pointers={"a0": plan_at}), title,
                 {"d0": 0} if is_all else {},
                 near_ends={} if is_all else {"d0": first + size * len(done)}, writes=writes)


def link_case(corners: int):
    """COUNT faces of the same points."""
    these = Gathered("flat", [(100, 200), (300, 250), (150, 500), (90, 300)], [(0, 0, 0)],
                     [(0, [(k, 0, 0, 0) for k in range(corners)])] * COUNT, room=2 * COUNT + 2, is_linked=True)
    trial = gather_trial(Arena(), these)
    assert len(these.taken()) == COUNT
    return trial.row(COUNT)


def gather_case(mapper: str):
    """COUNT triangles of three points."""
    flags = {"gouraud": LIT, "affine": ENVIRONMENT}.get(mapper, 0)
    these = Gathered(mapper, [(100, 200), (300, 250), (150, 500)],
                     [(1 << 16, 2 << 20, 3 << 17), (5 << 19, 0, 1 << 16), (1 << 20, 1 << 21, 1 << 20)],
                     [(0, [(k, k, 0, 0) for k in range(3)])] * COUNT, flags, room=COUNT + 2)
    trial = gather_trial(Arena(), these)
    assert len(these.taken()) == COUNT
    return trial.row(COUNT)


def vertices_trial(arena: Arena, points, attributes, corners, flags: int, title: str = "") -> Trial:
    """A face's vertices. ``points``: x, y, w, screen x and y, outside; ``attributes``: s, t, shade; ``corners``: numbers
    of a point and of a normal, s, t."""
    size = layout.load().struct("vertex").size
    placed = arena.struct("mesh_placed", {
        "points": arena.add(b"".join(longs((*p, 0, 0)) for p in points), name="points"),
        "attributes": arena.add(b"".join(longs((*each, 0)) for each in attributes), name="attributes"),
        "corners": table(arena, "scene_corner", [(0, 0, 0, 0), *corners])},
        mesh=0, material=0, view=0, view16=0, places=0, flags=flags, fog=0)
    face = arena.struct("mesh_face", {"face": table(arena, "scene_face", [[0, 0, 0, 0, 1, len(corners)]]),
                                      "placed": placed}, order=0, next=0, a=0, b=0, c=0, d=0)
    borders = int(np.bitwise_or.reduce([points[corner[0]][5] for corner in corners]))
    to, writes = arena.room("vertex", len(corners), "to"), []
    for at, (point, normal, s, t) in zip(range(to, to + size * len(corners), size), corners):
        x, y, w, *screen, _ = points[point]
        own_s, own_t, shade = attributes[normal]
        writes.append(Write(at, longs((*((x, y) if borders else screen), *((own_s, own_t) if flags & ENVIRONMENT else (s, t)),
                                       shade if flags & LIT else 0, w))))
    return Trial(Case("mesh_vertices", arena, pointers={"a0": face, "a1": to}), title, {"d0": borders}, writes=writes)


def vertices_case(flags: int):
    """Four corners inside all borders."""
    return vertices_trial(Arena(), [(k, k, k, k, k, 0) for k in range(4)], [(k, k, k) for k in range(4)],
                          [(k, k, k, k) for k in range(4)], flags).row(1)


#: Names of rows and what makes each: units, case and check.
CASES = {f"mesh_gather_{mapper}": lambda mapper=mapper: gather_case(mapper) 
         for mapper in ("flat", "gouraud", "affine", "lit")} | {
    "mesh_link": lambda: link_case(3), "mesh_link_quads": lambda: link_case(4),
    "mesh_vertices": lambda: vertices_case(0), "mesh_vertices_lit": lambda: vertices_case(LIT)}
