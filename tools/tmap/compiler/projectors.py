"""Faces in space whose second unit has separate s and t: listed with the faces, or cast on them by
a projector, which works like a reversed camera.

A mesh has one s and t a corner, so such faces are compiled to polygons of the scene for each frame.
Their corners are computed as the 68020 computes those of meshes (tmap.model.mesh), so that edges
meet. Let the camera see a point at depth w, and the projector see it at depth Q and at S, T in its
picture. Linear on the screen are 1 / w, s / w and t / w of the first unit, and S Q / w, T Q / w and
Q / w of the second. So the second unit's s and t are S and T, and its w is w / Q, which is below 0
behind the projector. s and t grow without limit next to the projector's plane Q = 0. A face with a
corner there is cut, and the part CONE or more from the picture is treated as if behind the
projector.
"""

import math
from types import SimpleNamespace

import numpy as np

from tmap.base.elementary import tan
from tmap.base.fields import fail, table
from tmap.base.fixed import ONE, fix, fix_all
from tmap.base.linear import product
from tmap.compiler import hierarchy, space
from tmap.compiler.glide import LEAST_W, has_own
from tmap.compiler.map_range import extent_of
from tmap.glide.state import REACH, W_MAX
from tmap.model import mesh

#: Columns of a corner before projection: x, y, s, t, shade and w as in tmap.model.mesh, 16.16, then
#: S Q, T Q and Q of the second unit, with FINE fraction bits.
X, Y, S, W, SQ, TQ, Q = 0, 1, 2, 5, 6, 7, 8
FINE = 24
ROUNDED = 1 / 256  # more than rounding adds to s and t
CONE = 4000  # limit of s and t at which a face is cut if one of its corners is beyond REACH


def schema(limits: dict[str, int]):
    """Returns the check of a projector: a camera's fields without the near plane."""
    return table(space.camera_fields(limits, None))


def check_object(obj: dict, material: dict, projectors: dict, where: str) -> None:
    """Refuses an object with a mesh unless it has exactly the coordinates that its material's
    second unit needs. ``where``: the object, for messages."""
    given = [name for name in ("uvs1", "projector") if obj.get(name) is not None]
    if not has_own(material):
        for field in given:
            fail(f"{where}.{field}", f"material {obj['material']!r} has no second unit with "
                                     "coordinates of its own")
    elif len(given) != 1:
        fail(where, f"material {obj['material']!r} has a unit with coordinates of its own: needs "
                    f"exactly one of {'uvs1, ' * ('uvs1' in obj)}projector")
    elif obj["mapping"] not in (None, "uv"):
        fail(f"{where}.mapping", f"material {obj['material']!r} has a unit with coordinates of its "
                                 'own, which go with "uv" alone')
    if obj["projector"] is not None and obj["projector"] not in projectors:
        fail(f"{where}.projector", f"there is no projector {obj['projector']!r}")


def fits(corners: np.ndarray) -> bool:
    """Returns True if the second unit can draw its coordinates of a polygon."""
    if (corners[:, Q] == 0).any():
        return False
    st, w = own_of(corners)
    return max(abs(st).max(), np.ptp(st, axis=0).max()) < REACH - ROUNDED \
        and LEAST_W <= abs(w).min() and abs(w).max() <= W_MAX


def own_of(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns s and t, and w, of the second unit."""
    return corners[:, SQ:Q] / corners[:, Q:], corners[:, W] / ONE / (corners[:, Q] / 2 ** FINE)


def cut(corners: np.ndarray, heights: np.ndarray) -> np.ndarray:
    """Returns the part of a convex polygon, a row a corner, with heights over a border of 0 or
    more."""
    kept = []
    for k, (corner, height) in enumerate(zip(corners, heights)):
        last, before = corners[k - 1], heights[k - 1]
        if (height < 0) != (before < 0):
            kept.append(last + (corner - last) * (before / (before - height)))
        if height >= 0:
            kept.append(corner)
    return np.array(kept).reshape(-1, corners.shape[1])


class Faces:
    """An object in space, as polygons of the screen."""

    def __init__(self, obj: dict, material: dict, made, where: str) -> None:
        """``made``: an objects.Space."""
        self.obj, self.space, self.where = obj, made, where
        camera = made.spec["camera"]
        self.scene = SimpleNamespace(width=made.spec["width"], height=made.spec["height"],
                                     guard=made.guard, near_plane=fix(camera["near"]))
        self.projector = made.spec["projectors"].get(obj["projector"])
        unit = material["glide"]["units"][1]
        self.most = made.limits["POLYGON_VERTICES_MAX"] // 2
        self.clamp_w = unit["clamp_w"]
        self.extent = extent_of((unit["width"], unit["height"]))
        self.first = made.tables_of(obj, material, where)
        self.second = self.first
        if self.first is not None and not self.projector:
            self.second = made.tables_of(obj, material, where, "uvs1")
            if not np.array_equal(self.first.faces, self.second.faces):  # one of them is not planar
                obj = obj | {"triangles": True}
                self.first, self.second = (made.tables_of(obj, material, where, name)
                                           for name in ("uvs", "uvs1"))

    def thrown(self, frame: int) -> np.ndarray:
        """Returns S Q, T Q and Q of all points."""
        name, spec = self.obj["projector"], self.space.spec
        turn, position = hierarchy.placed_at(self.obj, frame, spec["frames"])
        axes, eye, fov = space.camera_at(self.projector, frame, f"{self.space.where}projectors.{name}")
        places = product(self.first.points[:, :3] / ONE, turn.T) + position
        x, y, depth = product(axes, (places - eye).T)
        wide, high = self.extent
        scale = wide / 2 / tan(math.radians(fov) / 2)
        return np.column_stack([wide / 2 * depth + scale * x, high / 2 * depth + scale * y, depth])

    def corners(self, points: list[mesh.Point], frame: int) -> list[tuple]:
        """Returns all corners of all faces."""
        table_ = self.first.corners.tolist()
        if self.projector:
            own = self.thrown(frame)[self.first.corners[:, 0]]
        else:
            own = np.column_stack([self.second.corners[:, 2:4] / ONE, np.ones(len(table_))])
        own = np.rint(own * 2 ** FINE).astype(np.int64).tolist()
        return [(points[k].x, points[k].y, s, t, 0, points[k].w, *other)
                for (k, _, s, t), other in zip(table_, own)]

    def shown(self, face: np.ndarray, number_: int, frame: int) -> list[np.ndarray]:
        """Returns a face, or the parts of it whose coordinates the units can draw."""
        if len(face) > self.most:
            fail(self.first.sources[number_], f"has {len(face)} corners on the screen in frame {frame}; "
                                              f"with coordinates of their own {self.most} at most")
        if fits(face):
            return [face]
        if not self.clamp_w:
            fail(self.first.sources[number_], "a corner is too near the plane "
                 f"that {self.obj['projector']!r} stands on, in frame {frame}: its s or t reaches "
                 f"{REACH}; clamp_w of the second unit would let it be cut there")
        parts = []
        for axis in (SQ, TQ):
            for sign in (1, -1):
                inside = CONE * face[:, Q] - sign * face[:, axis]
                behind = cut(face, -inside)
                behind[:, SQ:] = 0, 0, -(2 ** FINE)
                parts.append(behind)
                face = cut(face, inside)
                if len(face) < 3:
                    break
        return [part for part in [*parts, face] if len(part) >= 3 and fits(part)]

    def on_screen(self, face: np.ndarray) -> np.ndarray:
        """Returns a face's corners as the file stores them, int64 [n, 6], followed by those of the
        second unit."""
        first = np.rint(face[:, :SQ]).astype(np.int64)
        first[:, :S] = [mesh.project(self.scene, x, y, w)
                        for x, y, w in first[:, [X, Y, W]].tolist()]
        second = first.copy()
        st, w = own_of(face)
        second[:, S:] = fix_all(np.column_stack([st, np.zeros(len(face)), w]))
        return np.concatenate([first, second])

    def polygons(self, frame: int) -> list[np.ndarray]:
        """Returns a frame's polygons, the farthest first, by each face's greatest depth. Faces seen
        from the back are left out unless the object shows both sides."""
        if self.first is None:
            return []
        view = self.space.view(self.obj, frame, 0.0, self.where)
        points = mesh.transform(self.scene, self.first.points[:, :3].tolist(), view)
        corners, found = self.corners(points, frame), []
        for number_, row in enumerate(self.first.faces.tolist()):
            face = corners[row[4]:row[4] + row[5]]
            if not mesh.is_seen(row, view):
                continue
            seen = np.array(mesh.clip(face, self.scene.near_plane), float)
            if len(seen) >= 3:
                found += [(max(corner[W] for corner in face), self.on_screen(part))
                          for part in self.shown(seen, number_, frame)]
        found.sort(key=lambda each: -each[0])
        return [made for _, made in found]
