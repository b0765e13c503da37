"""The exact picture of a mesh's faces, and the bounds of the drawn picture's errors.

Everything exact is computed from the points, s and t of the scene file and a camera in fractions;
no number of tools/tmap/model/mesh.py is used. The errors of corners are in
tools/tmap/ideal/mesh.py, those of a polygon against its vertices in tools/tmap/ideal/bounds.py and
tools/tmap/ideal/bounds_perspective.py. This file connects the two.

**Pixels.** Every corner of the drawn polygon corresponds to a place on an exact edge, and is within
off_screen of it on the screen. An edge between two corners is off by no more than its ends, each
weighted by its nearness. A pixel that is wrongly drawn or left out is between a drawn edge and the
exact one: no farther from the drawn edge than that error, times sqrt(2) for x and y together. (Of
the borders only the near plane is ever inside the frame.) Edges that are stepped are off by another
half unit per line, snapped corners by 1/32 pixel in x and y.

**u and v.** At a pixel, with the exact u = N / Q, N and Q being u / w and 1 / w, the function
A = N - u Q is affine over the screen and 0 at the pixel. Corner i, drawn at (x', y') with u' and
w', corresponds to a place (U, W) where A is (U - u) / W. The pixel has the barycentric coordinates
l in the three corners of the drawn curve. So that curve is off the exact u by the sum of
l ((u' - u) / w' - A(x', y')) over q, the sum of l / w'. With e the corner's error, f that of its
u', and o the one on the screen, the term in brackets is at most

    f / w' + (|u' - u| + f) e / (w' (w' - e)) + (|A_x| + |A_y|) o.

If the planes of 1 / w are not accurate enough, polygons are drawn affine
(c/perspective/perspective.h). Then the exact u and the drawn one are both in the range of the
corners, and may be that far apart.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from tmap.base.linear import length, product, whole_numbers
from tmap.compiler.objects import RADIUS
from tmap.ideal import bounds, bounds_perspective, ideal, mesh as ideal_mesh, perspective
from tmap.ideal.ideal import UNIT
from tmap.model import mesh as model_mesh, mesh16, model
from tmap.scene_file.meshes import ENVIRONMENT, FOG, LIT, ONE, UNIT_14, Instance
from tmap.setup import planarity
from tmap.setup.texturing import Settings

FLOAT = 1 + 2.0**-24  # relative roundings in this file
EXTRA = 24  # bits of exact texels beyond 1/65536


@dataclass
class Camera:
    """A view's numbers before they are rounded to the file's formats."""

    factors: list[list]  # rows of x, y and w, by the mesh's axes
    move: list
    eye: tuple  # in the mesh
    looks: list[list]  # a normal times these rows is an environment's s and t, and a shade
    guard: int
    width: int
    height: int
    near: Fraction


@dataclass
class Verdict(bounds.Verdict):
    """The errors of a frame's faces; ``unsure``: faces drawn affine though their depth varies."""

    faces: int = 0  # drawn

    def errors(self, error: np.ndarray, wanted: np.ndarray, bound: np.ndarray, what: str) -> None:
        """Adds errors; ``wanted``: those that the setting intends."""
        k = int(abs(error).argmax())
        self.note(abs(error[k]), abs(wanted[k]) + bound[k])
        ratio = abs(error - wanted) / bound
        k = int(ratio.argmax())
        self.texel_ratio = max(self.texel_ratio, float(ratio[k]))
        if ratio[k] > FLOAT:
            self.complain(f"{what.format(k)} is {error[k] - wanted[k]:.9f} off the exact face, "
                          f"{bound[k]:.9f} are allowed")

    def merge(self, other: "Verdict") -> None:
        """Takes the worse of both."""
        super().merge(other)
        self.faces += other.faces


def cross(p, q) -> list:
    """Returns the vector product."""
    return [p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3] for k in range(3)]


def dot(p, q):
    """Returns the scalar product of two vectors."""
    return sum(a * b for a, b in zip(p, q))


class Face:
    """A face before the camera. ``corners``: (x, y, w, u, v, shade), fractions; ``height``: the
    eye's height above its front, infinite if the face is seen from both sides."""

    def __init__(self, camera: Camera, corners: list[tuple], height: float) -> None:
        self.camera, self.corners, self.height = camera, corners, height
        self.lines: dict[int, list[np.ndarray]] = {}
        #: A ray (x / w, y / w, 1) times these rows is u / w, v / w and 1 / w.
        self.rows: list[list[Fraction]] | None = None
        most = 0
        for a, b in zip(corners[1:], corners[2:]):
            three = corners[0], a, b
            opposite = [cross(a, b), cross(b, corners[0]), cross(corners[0], a)]
            whole = dot(opposite[0], corners[0])
            if abs(whole) > most:
                most = abs(whole)
                self.rows = [[dot(values, column) / whole for column in zip(*opposite)]
                             for values in (*zip(*(p[3:5] for p in three)), (1, 1, 1))]

    def is_flat(self) -> bool:
        """Returns true if every corner is on the plane, with u and v."""
        return self.rows is None or all(
            dot(row, corner[:3]) == value for corner in self.corners
            for row, value in zip(self.rows, (*corner[3:5], 1)))

    @cached_property
    def extents(self) -> dict[int, tuple[int, int]]:
        """{line: (first pixel, end)} of the part beyond the near plane, in the frame."""
        c, found = self.camera, {}
        outline = [tuple(ONE * p for p in ideal_mesh.screen(c.guard, c.width, c.height, *v[:3]))
                   for v in ideal_mesh.clip(self.corners, c.near)]
        if len(outline) < 3 or self.rows is None:
            return found
        ends = [math.ceil(f(y for _, y in outline) / ONE) for f in (min, max)]
        scale, (whole,) = whole_numbers([[p for point in outline for p in point]])
        corners = [*zip(whole[::2], whole[1::2])]
        for line in range(max(ends[0], 0), min(ends[1], c.height)):
            first, end = (min(max(-(-n // (d * scale * ONE)), 0), c.width)
                          for n, d in ideal.extent(corners, line, scale))
            if first < end:
                found[line] = first, end
        return found

    @cached_property
    def whole_rows(self) -> tuple[int, list[list[int]]]:
        """The rows as whole numbers, and by which number they are larger."""
        return whole_numbers(self.rows)

    def along(self, row: list[int], line: int) -> tuple[int, int]:
        """Returns a row on a line of the screen, times 2^(guard + 1): its value at pixel 0 and its growth per pixel."""
        c = self.camera
        return (row[1] * (2 * line - c.height) - row[0] * c.width + (row[2] << c.guard + 1), 2 * row[0])

    def texels(self, line: int, first: int, end: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """u and v of a line's pixels, 1/65536 with EXTRA more bits, object arrays, and 1 / w."""
        common, rows = self.whole_rows
        common <<= self.camera.guard + 1
        (ua, ub), (va, vb), (qa, qb) = (self.along(row, line) for row in rows)
        near = [qa + qb * i for i in range(first, end)]
        u, v = (np.array([((a + b * i) << 16 + EXTRA) // q for i, q in enumerate(near, first)], object)
                for a, b in ((ua, ub), (va, vb)))
        return u, v, np.array([q / common for q in near])

    def values(self, line: int) -> list[np.ndarray]:
        """u and v of all pixels of a line, float64 texels, computed once."""
        if line not in self.lines:
            self.lines[line] = [np.array([n / (1 << 16 + EXTRA) for n in c])
                                for c in self.texels(line, *self.extents[line])[:2]]
        return self.lines[line]


def exact_faces(scene, instance: Instance, camera: Camera, longer: int = 256) -> list[Face]:
    """An instance's faces before the exact camera; ``longer``: texels of its map's longer side."""
    mesh, made = scene.meshes[instance.mesh], []
    points = scene.points[mesh.point:mesh.point + mesh.points].tolist()
    places = [ideal_mesh.camera(camera.factors, camera.move, point) for point in points]
    normals = scene.normals[mesh.normal:mesh.normal + mesh.normals].tolist()
    for row in scene.faces[mesh.face:mesh.face + mesh.faces].tolist():
        corners, first = [], mesh.corner + row[4]
        rows = scene.corners[first:first + row[5]].tolist()
        for point, normal, *texels in rows:
            looks = [dot(look, normals[normal][:3]) / UNIT_14 for look in camera.looks]
            if instance.flags & ENVIRONMENT:
                texels = [min(max(128 + look, 0), 256) * ONE for look in looks[:2]]
            shade = ideal_mesh.shade(instance, looks[2], places[point][2])
            corners.append((*places[point], *(Fraction(c) * longer / (256 * ONE) for c in texels), shade))
        ring = [[Fraction(c, ONE) for c in points[corner[0]]] for corner in rows]
        ways = [[a - b for a, b in zip(p, ring[0])] for p in ring]
        normal = [sum(part) for part in zip(*(cross(p, q) for p, q in zip(ways[1:], ways[2:])))]
        over = dot(normal, [Fraction(e) - p for e, p in zip(camera.eye, ring[0])])
        size = math.sqrt(float(dot(normal, normal)))
        made.append(Face(camera, corners, float(over) / size if any(row[:3]) else math.inf))
    return made


class Drawn:
    """What the model draws of an instance in a frame. ``vertices``: by the face's number, (x, y, s, t, shade, w) of
    each that has any; ``short``: the view's factors for 16-bit operands if it is drawn with them."""

    def __init__(self, scene, instance: Instance, number: int) -> None:
        self.scene, self.mesh, self.short = scene, scene.meshes[instance.mesh], None
        self.vertices = {which: made for _, made, which in model_mesh.faces_of(scene, instance, number)
                         if len(made) >= 3}
        age, mesh = number - instance.first_frame, self.mesh
        points = scene.points[mesh.point:mesh.point + mesh.points]
        self.reach = float(abs(points).max()) / ONE
        self.places = model_mesh.transform(scene, points.tolist(), scene.views[instance.view + age].tolist())
        if instance.view16 >= 0:
            row = scene.views16[instance.view16 + age].tolist()
            self.short = row if model_mesh.transform16(scene, instance, mesh, row) else None

    def is_cut(self, row: list[int]) -> bool:
        """Returns true if a corner of a face is outside a border; ``row``: from the table of faces."""
        first = self.mesh.corner + row[4]
        return any(self.places[point].screen is None for point in self.scene.corners[first:first + row[5], 0])


def near_an_edge(pixel: tuple[int, int], vertices, off: list[float]) -> bool:
    """True if a pixel is as near a drawn edge as the exact edge may be; ``off``: vertices'."""
    here = np.array(pixel, float)
    places = [np.array(v[:2], float) * UNIT for v in vertices]
    for a, b, off_a, off_b in zip(places, places[1:] + places[:1], off, off[1:] + off[:1]):
        side = length(b - a)
        part = float(product(here - a, b - a)) / (side * side) if side else 0.0
        part = min(max(part, 0.0), 1.0)
        most = max(off_a, off_b)
        # The exact edge's nearest place is equally far along it, up to the ends' errors.
        doubt = min(2 * most / (side - 2 * most), 1.0) if side > 2 * most else 1.0
        allowed = min(part * off_b + (1 - part) * off_a + doubt * abs(off_a - off_b), most)
        if length(a + part * (b - a) - here) <= math.sqrt(2) * allowed * FLOAT:
            return True
    return False


def shares(three, first: int, count: int, line: int) -> np.ndarray:
    """Returns the barycentric coordinates of a line's pixels in three corners: [corner][pixel]."""
    (x0, y0), (x1, y1), (x2, y2) = (v[:2] for v in three)
    whole = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    x, y, k = (first << 16) - x0, (line << 16) - y0, np.arange(count)
    second = (x * (y2 - y0) - (x2 - x0) * y) / whole + k * (((y2 - y0) << 16) / whole)
    third = ((x1 - x0) * y - x * (y1 - y0)) / whole - k * (((y1 - y0) << 16) / whole)
    return np.array([1 - second - third, second, third])


def curve_bound(face: Face, three, key: int, columns: np.ndarray, line: int, exact: np.ndarray,
                errors: tuple[float, float, list[float]]) -> np.ndarray:
    """Returns the largest error of the curve through three drawn corners against the exact one,
    texels. ``key``: 2 for u, 3 for v; ``errors``: of a corner's place, of its u, and of each corner
    on the screen."""
    e, f, off = errors
    l = shares(three, int(columns[0]), len(columns), line)
    scale = 2.0**face.camera.guard
    slope = sum(abs(float(face.rows[key - 2][k]) / scale - exact * (float(face.rows[2][k]) / scale))
                for k in (0, 1))
    total, q = np.zeros(len(columns)), np.zeros(len(columns))
    for share, corner, o in zip(l, three, off):
        w = corner[4] * UNIT
        way = abs(corner[key] * UNIT - exact) + f
        total += abs(share) * (f / w + way * e / (w * (w - e)) + slope * o)
        q += share / w
    return np.where(q > 0, total / np.where(q > 0, q, 1), np.inf) * FLOAT


def drawn_errors(adapted, polygon: model.Polygon) -> Iterator[tuple]:
    """Yields (key, line, columns, error, intended error, bound, the drawn curve's values) against
    the curve or plane of the drawn vertices; texels."""
    if polygon.perspective:
        curves = perspective.curves(adapted)
        for noun, y, columns, error, wanted, allowed in bounds_perspective.errors_by_lines(adapted, polygon):
            key = 2 + "uv".index(noun)
            yield key, y, columns, error, wanted, allowed, curves[key - 2].values(columns, y)
        return
    t, planes = polygon.texturing, [ideal.plane_of(adapted, key) for key in (2, 3)]
    for y, line in enumerate(polygon.lines, polygon.top):
        columns = np.arange(line.left, line.right)
        for key, plane, found in zip((2, 3), planes, model.coordinates(line)) if len(columns) else ():
            bound = np.array([plane.bound(i, y, t, t.cuts[key - 2]) for i in columns.tolist()])
            first = float(plane.at(line.left << 16, y << 16)) * UNIT
            yield (key, y, columns, plane.errors(found, columns, y), 0 * bound, bound,
                   first + (columns - line.left) * (plane.nx / plane.d))


def check_texels(face: Face, adapted, polygon: model.Polygon, errors, out: Verdict) -> None:
    """Adds u and v of all pixels that are in both the exact face and the drawn one; ``errors``:
    those of ``curve_bound``, but of all corners."""
    order, (e, f, off) = ideal.corners(adapted), errors
    three, errors = [adapted[k] for k in order], (e, f, [off[k] for k in order])
    flattened = not polygon.perspective and len({v[4] for v in adapted}) > 1
    out.unsure += flattened
    for key, y, *arrays in drawn_errors(adapted, polygon):
        first, end = face.extents.get(y, (0, 0))
        inside = (arrays[0] >= first) & (arrays[0] < end)
        if not inside.any():
            continue
        columns, error, wanted, allowed, values = (a[inside] for a in arrays)
        exact = face.values(y)[key - 2][int(columns[0]) - first:int(columns[-1]) + 1 - first]
        if flattened:
            ends = [v[key] * UNIT for v in adapted]
            bound = allowed + max(ends) - min(ends) + 2 * f
        else:
            bound = allowed + curve_bound(face, three, key, columns, y, exact, errors)
        out.errors(error + values - exact, wanted, bound, f"{'uv'[key - 2]}, pixel {{}} of those from "
                   f"({columns[0]}, {y}) on,")


def check_pixels(face: Face, vertices, polygons: list[model.Polygon], off: list[float],
                 out: Verdict) -> None:
    """Adds the pixels that are wrongly drawn or left out. ``polygons``: that the face is drawn as."""
    drawn: dict[int, set[int]] = {}
    for polygon in polygons:
        for y, line in enumerate(polygon.lines, polygon.top):
            drawn.setdefault(y, set()).update(range(line.left, line.right))
    for y in drawn.keys() | face.extents.keys():
        ours, exact = drawn.get(y, set()), range(*face.extents.get(y, (0, 0)))
        wrong = ours ^ set(exact)
        out.coverage_errors += len(wrong)
        for x in sorted(wrong):
            if not near_an_edge((x, y), vertices, off):
                out.complain(f"has pixel ({x}, {y}) {'drawn' if x in ours else 'left out'}, far from "
                             "all edges")


def check_attributes(instance: Instance, vertices, face: Face, longer: int, e: float, out: Verdict) -> None:
    """Adds the values that normals or depths gave to the corners of a face that is not cut."""
    light, turned = face.camera.looks[2], ideal_mesh.look_error(RADIUS)
    columns = [(2, 3, turned, longer / 256), (3, 4, turned, longer / 256)] * bool(instance.flags & ENVIRONMENT)
    if instance.flags & (LIT | FOG):
        columns.append((4, 5, ideal_mesh.fog_error(instance, e) if instance.flags & FOG else
                        ideal_mesh.look_error(math.sqrt(float(dot(light, light)))), 1))
    for ours, exact, most, scale in columns:
        error = np.array([v[ours] * UNIT * scale - float(c[exact])
                          for v, c in zip(vertices, face.corners, strict=True)])
        bound = np.full(len(error), most * scale)
        out.errors(error, 0 * error, bound, f"{('s', 't', 'the shade')[ours - 2]} of corner {{}}")


def judge_face(scene, instance: Instance, drawn: Drawn, which: int, row: list[int], face: Face) -> Verdict:
    """Checks one face of a frame against its bounds; ``which``: its number; ``row``: from the table of faces."""
    out, material, camera = Verdict(), scene.materials[instance.material], face.camera
    reach, short = drawn.reach, drawn.short
    vertices, cut = drawn.vertices.get(which, []), drawn.is_cut(row)
    longer = max(scene.textures[material.texture].texels.shape) if material.texture >= 0 else 256
    polygons: list[model.Polygon] = []
    doubt = ideal_mesh.seen_error(camera.eye, reach, short and short[mesh16.SEEN_SHIFT])
    if vertices:
        pieces = planarity.parts(vertices, material, scene.frame_shape, longer, planarity.ALL)
        made = [model.prepare_polygon(scene, instance.material, piece) for piece in pieces]
        polygons = [polygon for polygon in made if polygon]
        out.faces, out.pixels = 1, sum(polygon.pixels for polygon in polygons)
        if face.height < -doubt:
            out.complain(f"is drawn, though the eye is {-face.height} behind its plane")
            return out
    elif face.height <= doubt:
        if face.height > 0:
            out.coverage_errors = sum(end - first for first, end in face.extents.values())
        return out
    settings = Settings.of(material)
    e = ideal_mesh.corner_error(reach, cut)
    off = [ideal_mesh.off_screen(camera.guard, v[5] * UNIT - e, e) for v in vertices]
    if settings.edges != "integer" and settings.clip == "scissor":
        rounded = ideal_mesh.edge_error(settings.edges, camera.height, bool(short))
        check_pixels(face, vertices, polygons, [o + rounded for o in off], out)
    if not polygons:
        return out
    if not cut:
        check_attributes(instance, vertices, face, longer, e, out)
    if settings.perspective != "none":
        f = ideal_mesh.look_error(RADIUS) if instance.flags & ENVIRONMENT else 0.0
        f = (f + ideal_mesh.CUT * cut) * longer / 256 + UNIT * (longer != 256)
        check_texels(face, model.adapt(vertices, settings, longer), polygons[0], (e, f, off), out)
    return out


def judge(scene, number: int, instance: Instance, faces: list[Face]) -> Verdict:
    """Checks all faces of an instance in a frame against their bounds."""
    out, mesh = Verdict(), scene.meshes[instance.mesh]
    rows, drawn = scene.faces[mesh.face:mesh.face + mesh.faces].tolist(), Drawn(scene, instance, number)
    for k, (row, face) in enumerate(zip(rows, faces, strict=True)):
        if not face.is_flat():
            raise ValueError(f"face {k} does not lie on a plane")
        found = judge_face(scene, instance, drawn, k, row, face)
        if found.complaint:
            found.complaint = f"face {k} {found.complaint}"
        out.merge(found)
    return out


def picture(camera: Camera, faces: list[Face], colour) -> np.ndarray:
    """Returns the exact picture of faces, int16 (height, width): the nearest face at each pixel, -1
    where there is none. ``colour``: the function from arrays of whole texels u and v to colours."""
    frame = np.full((camera.height, camera.width), -1, np.int16)
    nearest = np.zeros(frame.shape)
    for face in faces:
        for y, (first, end) in face.extents.items() if face.height > 0 else ():
            u, v, near = face.texels(y, first, end)
            shown = near > nearest[y, first:end]
            values = colour(*((c >> 16 + EXTRA).astype(np.int64) for c in (u, v)))
            frame[y, first:end][shown] = values[shown]
            nearest[y, first:end][shown] = near[shown]
    return frame
