"""The integer model of c/mesh and src68k/mesh: from a frame's meshes to polygons on the screen.

Points, depths, s, t and shades are 16.16; a vertex is (x, y, s, t, shade, w).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from tmap.base.fixed import M32, ONE, mul_div, signed
from tmap.model import mesh16, trees
from tmap.scene_file.meshes import ENVIRONMENT, FOG, LIT
from tmap.scene_file.scene_file import vertices_at
from tmap.setup import planarity

#: A polygon of a frame: number of the material, vertices.
Drawn = tuple[int, list[tuple]]
#: The same, with the kinds of values that are marked as planar.
Placed = tuple[int, list[tuple], int]
#: A step of a frame: "draw" polygons; "begin" a z buffer (tmap.model.depths) for faces, "fill" it with faces that are
#: drawn, "fill_first" if they are a tree's and the first ones, "test" a face, which its polygons draw aside. The first
#: list has whole faces.
Step = tuple[str, list[Placed], list[Placed]]
Z = -2  # TREE_Z
#: Kinds of values that are planar of faces in fog: depths, which it follows, are on no plane over the screen.
FOGGY = planarity.IN_SPACE - planarity.SHADES + planarity.ROUGH
CORNERS_MAX = 62  # a convex face cannot get more: mesh_clip gives up


@dataclass
class Point:
    """A point before the camera; ``screen`` is None unless it is inside all borders."""

    x: int
    y: int
    w: int
    screen: tuple[int, int] | None


def depths(x: int, y: int, w: int, near: int) -> tuple[int, ...]:
    """Returns how far inside each border a point is: near, left, right, above, below."""
    return w - near, w + x, w - x, w + y, w - y


def transform(scene, points, view) -> list[Point]:
    """mesh_transform_wide: rows of x, y, z; ``view``: a row of the views."""
    rows = [(*view[3 * k:3 * k + 3], view[9 + k]) for k in range(3)]
    made = []
    for px, py, pz in points:
        x, y, w = (signed((a * px + b * py + c * pz + (move << 30) + (1 << 29)) >> 30)
                   for a, b, c, move in rows)
        inside = min(depths(x, y, w, scene.near_plane)) >= 0
        made.append(Point(x, y, w, project(scene, x, y, w) if inside else None))
    return made


def project(scene, x: int, y: int, w: int) -> tuple[int, int]:
    """Projects a point before the camera to the screen."""
    scale = ONE << scene.guard
    return (mul_div(x, scale, w) + (scene.width << 15), mul_div(y, scale, w) + (scene.height << 15))


def looks(normals, factors, base: int, low: int, high: int) -> list[int]:
    """mesh_attributes: computes one field of all normals."""
    a, b, c = factors
    return [min(max(base + ((a * x + b * y + c * z) >> 5), low), high) for x, y, z, _ in normals]


def looks_of(instance, normals, view) -> tuple[list[int], list[int], list[int]]:
    """Returns s, t and shade of an instance's normals; those that it does not use are empty."""
    s, t, shade = [], [], []
    if instance.flags & ENVIRONMENT:
        s, t = (looks(normals, view[k:k + 3], 128 << 16, 0, 256 << 16) for k in (15, 18))
    if instance.flags & LIT:
        shade = looks(normals, view[21:24], instance.dark, instance.dark, instance.bright)
    return s, t, shade


def faded(instance, vertices: list[tuple]) -> list[tuple]:
    """mesh_fade: vertices with the shades of their depths, if the instance has fog."""
    if not instance.flags & FOG:
        return vertices
    near, far, dark, bright = instance.fog_near, instance.fog_far, instance.dark, instance.bright
    return [(*v[:4], bright - mul_div(min(max(v[5], near), far) - near, bright - dark, far - near), v[5])
            for v in vertices]


def is_seen(face, view) -> bool:
    """Returns true if a face is seen from the front."""
    return signed(sum(n * e for n, e in zip(face[:3], view[12:15])) >> 30) > face[3]


def cut(inside: tuple, outside: tuple, border: int, part: int, whole: int, near: int) -> tuple:
    """mesh_cut, then makes the border's coordinate exact. Order: x, y, s, t, shade, w."""
    point = []
    for a, b in zip(inside, outside):
        way = (abs(b - a) * part + (whole >> 1)) // whole
        point.append(a + way if b > a else a - way)
    if border == 0:
        point[5] = near
    else:
        point[(border - 1) // 2] = point[5] if border in (2, 4) else -point[5]
    return tuple(point)


def clip(vertices: list[tuple], near: int) -> list[tuple]:
    """mesh_clip: returns the part inside all borders of a polygon before the camera
    (x, y, s, t, shade, w)."""
    for border in range(5):
        inner = [depths(v[0], v[1], v[5], near)[border] for v in vertices]
        if not vertices or min(inner) >= 0:
            continue
        made = []
        for k, (vertex, here) in enumerate(zip(vertices, inner)):
            last, before = vertices[k - 1], inner[k - 1]
            if len(made) > CORNERS_MAX:
                return []
            if here >= 0:
                if before < 0 < here:
                    made.append(cut(vertex, last, border, here, here - before, near))
                made.append(vertex)
            elif before > 0:
                made.append(cut(last, vertex, border, before, before - here, near))
        vertices = made
    return vertices


def polygons_of(material, vertices: list[tuple]) -> list[list[tuple]]:
    """Returns the polygon, or a fan of triangles if its material's gradients need triangles."""
    if len(vertices) == 3 or material.mapper == "flat" or material.gradients != "polygon":
        return [vertices]
    return planarity.fan(vertices)


def transform16(scene, instance, mesh, row) -> mesh16.Places | None:
    """Returns the places of an instance with 16-bit operands; None if it has no such factors (``row`` is
    None, or not for its material) or a point of a face that is seen is behind the eye."""
    if row is None or not mesh16.is_used(scene.materials[instance.material], row):
        return None
    points = mesh16.all_points(scene)[mesh.point:mesh.point + mesh.points]
    needed = np.zeros(mesh.points, bool)
    for face in scene.faces[mesh.face:mesh.face + mesh.faces].tolist():
        if mesh16.is_seen(face, row):
            first = mesh.corner + face[4]
            needed[scene.corners[first:first + face[5], 0]] = True
    return mesh16.transform(points, row, (scene.width, scene.height), needed)


def with_places(points: list[Point], places: mesh16.Places, row) -> list[Point]:
    """Returns the points with the places of those that are on the screen."""
    made = []
    for point, x, y, w, is_shown in zip(points, *(column.tolist() for column in vars(places).values())):
        made.append(Point(0, 0, w << row[mesh16.DEPTH_SHIFT], (x << 12, y << 12)) if is_shown else point)
    return made


def faces_of(scene, instance, number: int) -> list[tuple[int, list[tuple], int]]:
    """Returns the faces of an instance that may be seen in a frame: greatest depth, drawn vertices
    (fewer than 3 if nothing is left), number in the mesh."""
    age = number - instance.first_frame
    if not 0 <= age < instance.views:
        return []
    mesh, view = scene.meshes[instance.mesh], scene.views[instance.view + age].tolist()
    row = scene.views16[instance.view16 + age].tolist() if instance.view16 >= 0 else None
    wide = points = transform(scene, scene.points[mesh.point:mesh.point + mesh.points].tolist(), view)
    places = transform16(scene, instance, mesh, row)
    if places:
        points = with_places(wide, places, row)
    normals = scene.normals[mesh.normal:mesh.normal + mesh.normals].tolist()
    made_s, made_t, shades = looks_of(instance, normals, view)
    made = []
    for which, face in enumerate(scene.faces[mesh.face:mesh.face + mesh.faces].tolist()):
        if not (mesh16.is_seen(face, row) if places else is_seen(face, view)):
            continue
        first = mesh.corner + face[4]
        corners = scene.corners[first:first + face[5]].tolist()
        used = [points[point] for point, *_ in corners]
        cut = [wide[point] for point, *_ in corners]
        borders = zip(*(depths(p.x, p.y, p.w, scene.near_plane) for p in cut))
        if not places and any(max(border) < 0 for border in borders):
            continue
        rests = [(made_s[n] if made_s else s, made_t[n] if made_t else t,
                  shades[n] if shades else 0) for _, n, s, t in corners]
        if all(p.screen for p in used):
            vertices = [(*p.screen, *rest, p.w) for p, rest in zip(used, rests)]
        else:
            vertices = [(*project(scene, v[0], v[1], v[5]), *v[2:]) for v in clip(
                [(p.x, p.y, *rest, p.w) for p, rest in zip(cut, rests)], scene.near_plane)]
        order = max(0, *(p.w for p in used)) if not places else \
            max(int(places.depth[point]) for point, *_ in corners) << row[mesh16.DEPTH_SHIFT] & M32
        made.append((order, faded(instance, vertices), which))
    return made


def ordered(scene, instances, number: int) -> list[Placed]:
    """Returns the faces, whole, of instances that are drawn together, in drawing order: by their tree, or
    by depth if they have none."""
    tree, faces, eye = instances[0].tree, [], None
    for instance in instances:
        for depth, vertices, which in faces_of(scene, instance, number):
            key = -depth if tree < 0 else int(scene.slots[instance.slot + which, 0])
            faces.append((key, instance.material, vertices, FOGGY if instance.flags & FOG else planarity.IN_SPACE))
            eye = scene.views[instance.view + number - instance.first_frame].tolist()[12:15]
    if tree >= 0 and faces:
        place = {slot: rank for rank, slot in enumerate(trees.walk(scene.nodes.tolist(), tree, eye))}
        faces = [(place[slot], *face) for slot, *face in faces]
    faces.sort(key=lambda face: face[0])
    return [tuple(face) for _, *face in faces if len(face[1]) >= 3]


def parts_of(scene, face: Placed) -> list[Placed]:
    """Returns the polygons that draw a mesh's face."""
    material, vertices, vouched = face
    return [(material, part, vouched) for part in polygons_of(scene.materials[material], vertices)]


def group_steps(scene, groups, number: int) -> Iterator[Step]:
    """Yields the steps of instances at one place in the scene's order, a group for each tree."""
    tested = ordered(scene, groups[0], number) if groups[0][0].tree == Z else []
    if tested:
        yield "begin", tested, []
    for place, group in enumerate(groups[groups[0][0].tree == Z:]):
        faces = ordered(scene, group, number)
        yield "draw", faces, [part for face in faces for part in parts_of(scene, face)]
        if tested:
            yield "fill_first" if not place and group[0].tree >= 0 else "fill", faces, []
    for face in tested:
        yield "test", [face], parts_of(scene, face)


def steps_at(scene, number: int) -> Iterator[Step]:
    """Yields what is done in a frame."""
    groups: dict[int, list] = {}  # instances that are drawn together, by the object that follows them
    for (before, _), group in groupby(scene.instances, lambda each: (each.before, each.tree)):
        groups.setdefault(before, []).append(list(group))
    shown = [place for place, obj in enumerate(scene.objects)
             if obj.first_frame <= number < obj.first_frame + obj.poses]
    for place in sorted({*shown, *groups}):
        if place in groups:
            yield from group_steps(scene, groups[place], number)
        if place < len(scene.objects):
            obj = scene.objects[place]
            vertices = vertices_at(scene, obj, number)
            if vertices:
                yield "draw", [], [(obj.material, vertices, obj.planar)]


def placed_at(scene, number: int) -> list[Placed]:
    """Returns a frame's polygons in drawing order: each one's material, its vertices on the screen,
    and the kinds of values that are marked as planar."""
    return [part for *_, parts in steps_at(scene, number) for part in parts]


def polygons_at(scene, number: int) -> list[Drawn]:
    """Returns the same with polygons whose values are not planar split into triangles, except those
    of texture units."""
    def longer(which: int) -> int:
        texture = scene.materials[which].texture
        return max(scene.textures[texture].texels.shape) if texture >= 0 else 256

    return [(which, part) for which, vertices, vouched in placed_at(scene, number)
            for part in planarity.parts(vertices, scene.materials[which], scene.frame_shape,
                                        longer(which), vouched)]
