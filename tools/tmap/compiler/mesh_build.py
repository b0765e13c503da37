"""Converts a scene's mesh to the tables of a scene file.

Faces keep their corners unless triangles are needed: for a concave or bent face, for the material's
gradients "polygon", or for gradients "plane" if s and t or shades are not planar.
"""

import functools
import math
import operator
from dataclasses import dataclass

import numpy as np

from tmap.base.elementary import cos
from tmap.base.fields import fail
from tmap.base.fixed import ONE, fix
from tmap.base.linear import length, off_plane, product
from tmap.build import layout
from tmap.compiler import grids, space
from tmap.compiler.lights import Baking
from tmap.scene_file.meshes import UNIT_14, UNIT_30
from tmap.shapes import cutting
from tmap.shapes.mesh_file import Shape, check_counts

FLAT = 1 / 256  # tolerance for corners off a face's plane and for dents, as a part of its size
UNEVEN = 1 / 64  # tolerance for s and t off a plane, in their units
ROUNDING = 1e-9  # of an angle's cosine: faces at the angle of a crease itself are smooth
CORNERS_MAX = 128  # of a face before it is cut; the time for that grows with their cube
SMALL = 2.0 ** -15  # length of two units: below it, points are rounded too much to judge


@dataclass
class Wishes:
    """How a mesh is drawn."""

    size: float = 1.0
    normals: str | None = None  # "file", "smooth", "faces"; None: "file", else "smooth"
    crease: float = 180.0  # degrees; "smooth" leaves sharper edges sharp
    mapping: str = "none"  # "uv", "environment", "shade"
    light: bool = False  # corners have shades
    triangles: bool = False  # cut all faces into triangles
    planes: bool = False  # cut faces whose values are not planar
    two_sided: bool = False
    names: tuple[str, ...] | None = None  # materials of the file whose faces are drawn; None: all
    level: bool = False  # cut faces whose corners are not on one plane, but for rounding
    grid: float | None = None  # units between the planes that cut all faces
    baking: Baking | None = None  # lights that are computed here: normals become brightness
    one_shade: bool = False  # baked faces have one brightness

    @property
    def turns_normals(self) -> bool:
        """Returns True if s and t or shades are computed from normals."""
        return self.light or self.mapping == "environment"


@dataclass
class Tables:
    """Rows of the scene file's tables; indices from 0."""

    points: np.ndarray
    normals: np.ndarray
    corners: np.ndarray
    faces: np.ndarray
    sources: list[str]  # where each face is from, for messages
    left_out: list[str]  # where faces without area are

    @property
    def key(self) -> tuple:
        """Equal for equal meshes."""
        return tuple(a.tobytes() for a in (self.points, self.normals, self.corners, self.faces))


@dataclass
class Face:
    """A polygon with its corners in order."""

    points: list[int]
    texels: list[tuple[float, float]] | None
    normals: list[tuple[float, float, float]] | None
    normal: np.ndarray  # unit
    at: str  # its place in the file, for messages
    number: int  # in the shape

    def part(self, kept: list[int]) -> "Face":
        """Returns the polygon of some of the corners, with the same normal."""
        def chosen(of):
            return None if of is None else [of[k] for k in kept]
        return Face(chosen(self.points), chosen(self.texels), chosen(self.normals), self.normal, self.at,
                    self.number)


def newell(ring: np.ndarray) -> np.ndarray:
    """Returns a polygon's normal, whose length is twice the area."""
    points = ring.tolist()
    rays = [[c - c0 for c, c0 in zip(point, points[0])] for point in points]
    areas = [(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
             for (ax, ay, az), (bx, by, bz) in zip(rays, rays[1:] + rays[:1])]
    return np.array([functools.reduce(operator.add, along) for along in zip(*areas)])


def size_of(ring: np.ndarray) -> float:
    """Returns the longest extent of a polygon along an axis."""
    return float(np.ptp(ring, axis=0).max())


def unit_normal(ring: np.ndarray, at: str = "") -> np.ndarray | None:
    """Returns the unit normal of a polygon; None if it has no area. Refuses a polygon whose areas
    cancel each other out because its sides cross. ``at``: its place, for messages."""
    normal, least = newell(ring), 2 * size_of(ring) * SMALL
    if length(normal) > least:
        return normal / length(normal)
    widest = max(np.cross(ring[1:-1] - ring[0], ring[2:] - ring[0]), key=length)
    seen = cutting.flat(np.rint(ring * ONE).astype(np.int64), widest, int(abs(widest).argmax()))
    if length(widest) > least and cutting.crosses(seen):
        fail(at, "crosses itself")
    return None


def is_convex(ring: np.ndarray, normal: np.ndarray, where: str) -> bool:
    """Returns True if a polygon has no dent; refuses a plane one that goes round more than once. A bent
    one may only seem to, as seen along its normal."""
    sides = np.roll(ring, -1, axis=0) - ring
    before, around, dented = np.roll(sides, 1, axis=0), 0.0, False
    turns = product(np.cross(before, sides), normal)
    along = (before * sides).sum(axis=1)
    for turn, ahead, both in zip(turns.tolist(), along.tolist(), (before + sides).tolist()):
        is_dent = turn < -max(FLAT * size_of(ring), SMALL) * (length(both) or 1.0)
        dented |= is_dent
        around += math.atan2(turn if is_dent else abs(turn), ahead)
    once = around < 3 * math.pi  # the sum is 2 pi, or 4 pi and more: the last bits do not matter
    if not once and not is_bent(ring, normal):
        fail(where, "crosses itself")
    return once and not dented


def faces_of(shape: Shape, places: np.ndarray, where: str) -> tuple[list[Face], list[str]]:
    """Returns the faces, without corners at the same place as their neighbour, and the places in the
    file of those that have no area."""
    made, left_out = [], []
    for number, points in enumerate(shape.faces):
        at = shape.at(number, where)
        kept = [k for k, p in enumerate(points) if (places[p] != places[points[k - 1]]).any()]
        if len(kept) > CORNERS_MAX:
            fail(at, f"has {len(kept)} corners; {CORNERS_MAX} at most")
        normal = unit_normal(places[[points[k] for k in kept]] / ONE, at) if len(kept) >= 3 else None
        if normal is None:
            left_out.append(at)
            continue
        face = Face(list(points), shape.texels and shape.texels[number],
                    shape.normals and shape.normals[number], normal, at, number)
        made.append(face.part(kept))
    return made, left_out


def is_bent(ring: np.ndarray, normal: np.ndarray) -> bool:
    """Returns True if corners are off the polygon's plane."""
    return float(np.ptp(product(ring, normal))) > max(FLAT * size_of(ring), 2 * SMALL)


def is_even(ring: np.ndarray, normal: np.ndarray, values: np.ndarray) -> bool:
    """Returns True if values at a polygon's corners are planar. They are taken over the two axes on
    which the polygon's projection is largest."""
    return off_plane(np.delete(ring, int(abs(normal).argmax()), 1), values) <= UNEVEN


def smooth(faces: list[Face], places: np.ndarray, crease: float) -> None:
    """Gives each corner the mean of the normals of all faces at its place, weighted by area. Faces
    whose normal is more than ``crease`` degrees from the corner's own face do not count."""
    areas = np.array([newell(places[face.points] / ONE) for face in faces])
    keys = [tuple(place) for place in places.tolist()]
    meeting: dict[tuple, list[int]] = {}  # faces at a place
    for number, face in enumerate(faces):
        for point in face.points:
            meeting.setdefault(keys[point], []).append(number)
    limit = cos(math.radians(crease)) - ROUNDING if crease < 180 else -2.0
    units = np.array([face.normal for face in faces])
    sums = {key: areas[met].sum(axis=0) for key, met in meeting.items()}
    for face, area in zip(faces, areas):
        means = []
        for key in (keys[point] for point in face.points):
            near = product(units[meeting[key]], face.normal) >= limit
            mean = sums[key] if near.all() else areas[meeting[key]][near].sum(axis=0)
            means.append(tuple(mean if length(mean) > 1e-6 * length(area) else area))
        face.normals = means


def set_normals(faces: list[Face], drawn: list[Face], places: np.ndarray, wishes: Wishes) -> None:
    """Gives every corner of the drawn faces its normal: the file's, the face's or a smooth one, which
    is of all faces, so that no seam shows between materials."""
    kind = wishes.normals
    if kind == "faces":
        for face in drawn:
            face.normals = [tuple(newell(places[face.points] / ONE))] * len(face.points)
    elif kind == "smooth" or any(face.normals is None for face in drawn):
        smooth(faces, places, wishes.crease)
    for face in drawn:
        for normal in face.normals:
            if not (np.isfinite(normal).all() and any(normal)):
                fail(face.at, "has a normal without direction")


def is_cut(face: Face, ring: np.ndarray, wishes: Wishes) -> bool:
    """Returns True if a convex face must become triangles."""
    if len(face.points) == 3:
        return False
    most = layout.load().constants["MESH_CORNERS_MAX"]
    if wishes.triangles or len(face.points) > most or is_bent(ring, face.normal):
        return True
    if wishes.level and float(np.ptp(product(ring, face.normal))) > SMALL:
        return True
    if not wishes.planes:
        return False
    if wishes.mapping == "uv" and not is_even(ring, face.normal, np.array(face.texels)):
        return True
    return wishes.turns_normals and len(set(face.normals)) > 1


def parts_of(face: Face, places: np.ndarray, wishes: Wishes) -> list[Face]:
    """Returns the convex polygons of a face: the face, or triangles. Triangles without area are
    left out."""
    ring = places[face.points] / ONE
    convex = is_convex(ring, face.normal, face.at)
    if convex and not is_cut(face, ring, wishes):
        return [face]
    cuts = cutting.triangles_in_space(places[face.points], face.normal)
    if cuts is None and not convex:
        fail(face.at, "crosses itself")
    cuts = cuts or cutting.fan(len(face.points))  # dents within the tolerance may cross by rounding
    parts = [face.part(cut) for cut in cuts]
    return [part for part in parts if unit_normal(places[part.points] / ONE) is not None]


def in_cells(face: Face, places: list[tuple], pitch: float, most: int) -> list[Face]:
    """Returns the parts of a convex face in the cells of a grid; appends their new corners to ``places``.
    Texels and unit normals change evenly along its edges; where opposite normals meet, the face's is taken."""
    texels = list(map(tuple, face.texels)) if face.texels else [()] * len(face.points)
    normals = [tuple(space.unit(n)) for n in face.normals] if face.normals else [()] * len(face.points)
    cells = grids.cells([(*places[p], *t, *n) for p, t, n in zip(face.points, texels, normals)], pitch, most)
    if cells is None:
        fail(face.at, f"the grid cuts it into more than {most} parts")
    made, first_normal = [], 3 + len(texels[0])
    for cell in cells:
        points = list(range(len(places), len(places) + len(cell)))
        places += [corner[:3] for corner in cell]
        turned = [corner[first_normal:] for corner in cell]
        turned = [n if not n or length(n) > SMALL else tuple(face.normal) for n in turned]
        made.append(Face(points, [corner[3:first_normal] for corner in cell], turned, face.normal, face.at,
                         face.number))
    return made


def bake(face: Face, ring: np.ndarray, wishes: Wishes) -> None:
    """Replaces the normals of a face by the brightness of its corners, 2.14."""
    bright = [wishes.baking.brightness(place, np.array(normal)) for place, normal in zip(ring, face.normals)]
    if wishes.one_shade:
        bright = [sum(bright) / len(bright)] * len(bright)
    face.normals = [(round(each * UNIT_14), 0, 0) for each in bright]


def lit_parts(face: Face, places: list[tuple], wishes: Wishes, most: int) -> list[Face]:
    """Returns the parts of a convex face that the grid and baked lights make; triangles where they need
    them."""
    if not (wishes.grid or wishes.baking):
        return [face]
    made = []
    for part in in_cells(face, places, wishes.grid, most) if wishes.grid else [face]:
        ring = np.array([places[p] for p in part.points]) / ONE
        if wishes.baking:
            bake(part, ring, wishes)
        cuts = [list(range(len(ring)))]
        if is_cut(part, ring, wishes):
            whole = np.array([places[p] for p in part.points], np.int64)
            cuts = cutting.triangles_in_space(whole, face.normal) or cutting.fan(len(ring))
        made += [part.part(cut) for cut in cuts if unit_normal(ring[cut]) is not None]
    return made


def numbered(rows: list[tuple]) -> tuple[np.ndarray, list[int]]:
    """Returns the distinct rows, and for each given row its index among them."""
    order = {row: i for i, row in enumerate(dict.fromkeys(rows))}
    return np.array(list(order), np.int64), [order[row] for row in rows]


def vertices(places: list[tuple], directions: list[tuple]) -> tuple[np.ndarray, np.ndarray, list[int], list[int]]:
    """Returns the rows of points and normals, and for each corner the numbers of both. ``places``,
    ``directions``: of each corner."""
    points, point_of = numbered(places)
    normals, normal_of = numbered(directions)
    if len(set(zip(point_of, normal_of))) == len(points) and 4 * len(normals) > 3 * len(points):
        # One normal a point: it gets the point's number, and triangles share vertices on the Amiga.
        first = dict(zip(point_of, normal_of))
        normals, normal_of = normals[[first[k] for k in range(len(points))]], point_of
    return points, normals, point_of, normal_of


def tables(faces: list[Face], places: np.ndarray, wishes: Wishes, left_out: list[str]) -> Tables:
    """Returns the rows of the scene file."""
    used = [tuple(places[p].tolist()) for f in faces for p in f.points]
    turned = [n for f in faces for n in f.normals] if wishes.turns_normals else \
        [(0.0, 0.0, 1.0)] * len(used)  # unused
    stored = turned if wishes.baking else [np.rint(space.unit(n) * UNIT_14).astype(int).tolist() for n in turned]
    points, normals, point_of, normal_of = vertices(used, [(*n, 0) for n in stored])
    texels = [t for f in faces for t in f.texels] if wishes.mapping == "uv" else \
        [(0.0, 0.0)] * len(point_of)
    corners = [[point, normal, *map(fix, texel)]
               for point, normal, texel in zip(point_of, normal_of, texels)]
    rows, first = [], 0
    for face in faces:
        ring = places[face.points]
        fixed = np.rint(space.unit(newell(ring / ONE)) * UNIT_30).astype(np.int64).tolist()
        away = sum(n * int(p) for point in ring for n, p in zip(fixed, point))
        plane = [0, 0, 0, -1] if wishes.two_sided else \
            [*fixed, round(away / len(ring) / UNIT_30)]
        rows.append([*plane, first, len(ring)])
        first += len(ring)
    return Tables(points, normals, np.array(corners, np.int64), np.array(rows, np.int64),
                  [face.at for face in faces], left_out)


def build(shape: Shape, wishes: Wishes, where: str) -> Tables | None:
    """Returns the tables of a mesh; None if it has faces, but none of the wanted materials. The shape
    must have the coordinates that the wishes need; ``where`` begins messages."""
    limits = layout.load().constants
    scaled = shape.points * wishes.size
    used = sorted({point for face in shape.faces for point in face})
    if not (abs(scaled[used]) <= limits["MESH_REACH"]).all():  # also catches NaN
        fail(where, f"a point is more than {limits['MESH_REACH']} units from the mesh's origin")
    kept = np.nan_to_num(scaled).clip(-limits["MESH_REACH"], limits["MESH_REACH"])  # unused ones
    places = np.rint(kept * ONE).astype(np.int64)
    faces, left_out = faces_of(shape, places, where)
    if not faces:
        fail(where, "no face has an area")
    numbers = set(shape.drawn(wishes.names))
    drawn = [face for face in faces if face.number in numbers]
    if not drawn:
        return None
    check_counts(0, len(drawn), where)
    if wishes.turns_normals:
        set_normals(faces, drawn, places, wishes)
    made, most, all_places = [], limits["MESH_COUNT_MAX"], list(map(tuple, places.tolist()))
    for face in drawn:
        for part in parts_of(face, places, wishes):
            made += lit_parts(part, all_places, wishes, most)
        if len(made) > most:
            fail(where, f"more than {most} faces, those counted as triangles that are cut into them"
                        + " and as cells of the grid" * bool(wishes.grid))
    places = np.array(all_places, np.int64)
    found = tables(made, places, wishes, left_out)
    check_counts(len(found.points), len(found.faces), where)
    if len(found.normals) > most:
        fail(where, f"{len(found.normals)} different normals; {most} at most")
    return found
