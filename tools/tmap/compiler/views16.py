"""Factors with which the Amiga transforms a mesh's points with 16-bit operands: struct scene_view16.

Points P are whole numbers up to MESH_UNIT16, c = P reach / MESH_UNIT16 their coordinates. With the
view's rows f_x, f_y, f_z and moves, G the guard's pixels and M the middle of the frame, a place is

    16 x_screen = (16 G x + 16 M_x w) / w,

so its two sums of products have the factors 16 G f_x + 16 M_x f_z; half of w is added, which makes
the quotient's floor the nearest. Factors have reach / MESH_UNIT16 in them, and the largest power of
two that keeps them within MESH_FACTOR16 and sums below 2^31. The divisor is the depth shifted to the
right until the factors of x and y fit.

Errors. Each P is off by half a unit, and so is each factor F. So a sum is off by at most half of the
sum of its |F| and of the point's |P|, and half a unit for its move: e_x; the depth v by the same
shifted, and half a unit for rounding: e_v. The place before its floor is then off by
(e_x + place e_v) / v sixteenths of a pixel. For a mesh of radius r pixels at d times its radius that
is about (r + 160 / d) / 5500 pixels. It grows where a mesh is near to the eye, so it is not assumed:
a frame has factors only if no point is before the near plane, all that come out on the screen are
within 1/32 pixel of their exact places, and every face that would be taken wrongly for one seen or not
seen from the front is thinner than that on the screen. Points off the screen are transformed with
32-bit operands. Otherwise the frame is drawn with 32-bit operands.
The depth by which faces are sorted has e_v too.

Only materials with snapped edges and without perspective take them, and no tree, whose order holds where
faces are taken for seen by their exact planes: rounding a vertex to 1/16 pixel
is another 1/32.
"""

from dataclasses import replace

import numpy as np

from tmap.model import mesh, mesh16
from tmap.base.fixed import signed
from tmap.build import layout

LIMITS = layout.load().constants
UNIT16, FACTOR16 = LIMITS["MESH_UNIT16"], LIMITS["MESH_FACTOR16"]
#: How far a point may be from its exact place, and how thin a face is that may be taken wrongly,
#: 1/16 pixel.
OFF = 0.5
#: The least part of a mesh's points on the screen with which 16-bit operands pay: the others, and the
#: corners of faces that a border cuts, are transformed with 32-bit ones too.
SHOWN = 0.75


def nearest(n: int, d: int) -> int:
    """Returns n / d rounded to the nearest, d > 0."""
    return (2 * n + d) // (2 * d)


def row_of(scene, view: list[int], reach: int) -> list[int] | None:
    """Returns a row of the views16 for a mesh of this reach; None if the eye is too far away."""
    rows = [(*view[3 * k:3 * k + 3], view[9 + k]) for k in range(3)]
    depth, lens = rows[2], 5 + scene.guard
    # Twice 16 G x + (16 M + 1/2) w, factors 2.30 and moves 16.16.
    sides = [[(n << lens) + (16 * size + 1) * w for n, w in zip(row, depth)]
             for row, size in zip(rows, (scene.width, scene.height))]
    farthest = abs(depth[3]) + 3 * reach

    def factors(row, up: int, down: int) -> list[int]:
        return [nearest((n * reach) << up, UNIT16 << down) for n in row[:3]]

    def fit(row, up: int, down: int) -> bool:
        return max(map(abs, factors(row, up, down))) <= FACTOR16

    finer = max(s for s in range(31) if fit(depth, s, 30) and farthest << s < 1 << 31)
    coarser = next(r for r in range(31) if all(fit(row, 0, 31 + r) for row in sides)
                   and (16 * max(scene.width, scene.height) + 1) * (farthest >> r) < 1 << 31)
    eye = max(map(abs, view[12:15]))
    cut = next(k for k in range(32) if nearest(eye, 1 << k) < 1 << 15)
    if cut > 14:
        return None
    made, shift = [], finer + coarser
    for row, up, down, move in ((depth, finer, 30, (depth[3] << finer) + (1 << shift >> 1)),
                                *((row, 0, 31 + coarser, nearest(row[3], 2 << coarser)) for row in sides)):
        a, b, c = factors(row, up, down)
        made.append([signed(move - a * b), a, b, c])
    return [*made[0], shift, *made[1], coarser, *made[2], 14 - cut,
            *(nearest(e, 1 << cut) for e in view[12:15]), 1]


def exact_places(scene, points: np.ndarray, view: list[int]) -> tuple[np.ndarray, ...]:
    """Returns x and y in 1/16 pixel and the depth, 16.16, float64, of whole sums."""
    x, y, w = (((points * view[3 * k:3 * k + 3]).sum(axis=1) + (view[9 + k] << 30)).astype(float)
               for k in range(3))
    with np.errstate(all="ignore"):
        return (x / w * 2.0 ** (4 + scene.guard) + 8 * scene.width,
                y / w * 2.0 ** (4 + scene.guard) + 8 * scene.height, w / (1 << 30))


def thickness(x: np.ndarray, y: np.ndarray) -> float:
    """Returns a polygon's area by its longest extent."""
    area = abs(float((x * np.roll(y, -1) - y * np.roll(x, -1)).sum())) / 2
    return area / max(float(np.ptp(x)), float(np.ptp(y)), 2.0 ** -16)


def is_good(scene, instance, view: list[int], row: list[int]) -> bool:
    """Returns true if the frame's points and faces are as near as this file's text says."""
    which = scene.meshes[instance.mesh]
    points = scene.points[which.point:which.point + which.points]
    x, y, w = exact_places(scene, points, view)
    short = mesh16.points_of(points)
    places = mesh16.transform(short, row, (scene.width, scene.height))
    if w.min() < scene.near_plane or places is None or places.shown.mean() < SHOWN:
        return False
    for at, right in ((mesh16.X, x), (mesh16.Y, y)):
        if abs(mesh16.sums(short, row, at) / places.depth - 0.5 - right)[places.shown].max() > OFF:
            return False
    for face in scene.faces[which.face:which.face + which.faces].tolist():
        if mesh.is_seen(face, view) != mesh16.is_seen(face, row):
            first = which.corner + face[4]
            used = scene.corners[first:first + face[5], 0]
            if thickness(x[used], y[used]) > OFF:
                return False
    return True


def rows_of(scene, instance) -> list[list[int]]:
    """Returns as many rows of the views16 as an instance has views; unused ones are zeros."""
    which, made = scene.meshes[instance.mesh], []
    reach = mesh16.reach(scene.points[which.point:which.point + which.points])
    for view in scene.views[instance.view:instance.view + instance.views].tolist():
        row = row_of(scene, view, reach)
        made.append(row if row and is_good(scene, instance, view, row) else [0] * 19)
    return made


def add(scene):
    """Returns the scene with views16 for those instances whose material takes them."""
    instances, rows = [], []
    for instance in scene.instances:
        material = scene.materials[instance.material]
        made = rows_of(scene, instance) \
            if material.edges == "snapped" and material.perspective == "none" and instance.tree == LIMITS["NO_TREE"] else []
        if any(row[mesh16.IS_USED] for row in made):
            instance = replace(instance, view16=len(rows))
            rows += made
        instances.append(instance)
    return replace(scene, instances=instances, views16=np.array(rows, np.int64).reshape(-1, 19))
