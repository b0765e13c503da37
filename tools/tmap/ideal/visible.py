"""Which pixels of a frame show a face though another one, before it, covers them.

The integer model says which face each pixel shows. What covers a pixel, and which of two faces is nearer, is
computed from corners and planes of the scene file alone: in double precision, whose error (below 2^-30 of a
unit) is nothing beside the bounds of what the file and the 68020 round. A pixel is wrong if a face, not a
transparent picture, covers it and the shown face is behind it, by more than these bounds:

* Edges. The pixel is inside the covering face by ``margin`` at least, what its drawn edges may be off
  (tmap.ideal.mesh.off_screen, tmap.ideal.faces), times sqrt(2) for x and y together.
* Planes. The shown face's place on the pixel's ray is behind the covering face's plane by more than OFF of
  trees (tmap.trees.polygons: corners on a dividing plane), and what rounding moves either plane by
  (``rounding``); a plane's move is along the ray what it is across it, divided by the sine of the angle. A
  corner is off its face's plane by ON, 3 / 65536, and the moves of two views differ by sqrt(3) / 2 of 1 / 65536
  at most. A normal's half units, 2^-31 on three axes, are at most 3 * 2^-31 of the largest coordinate, those of
  a view's nine factors 3 sqrt(3) * 2^-31 of it: together less than 2^-27.
* z. If one of both is tested, 1/w differs by more than their planes may be off: by what tmap.model.depths derives, half
  a unit for each pixel of a line, and the gradients times the pixels that corners may be off, as edges. A plane goes
  through three corners, whose weights add up to 3 at most in size (c/drawing/fan.c).
"""

from dataclasses import dataclass

import numpy as np

from tmap.base.linear import product
from tmap.ideal import mesh as ideal_mesh
from tmap.model import depths, model
from tmap.model.mesh import Z, faces_of, steps_at
from tmap.scene_file.meshes import ONE, UNIT_30
from tmap.scene_file.scene_file import Scene
from tmap.setup.texturing import Settings
from tmap.trees.polygons import OFF, ON

NONE = -1


@dataclass
class Face:
    """A face before the camera: ``corners`` in units, y down; its plane is normal * place = height. The eye is in the
    origin, in front of the plane if ``height`` is below 0. ``off``: of its plane of q, 2.30; 0 if nothing is tested."""

    corners: np.ndarray
    normal: np.ndarray
    height: float
    rounding: float
    margin: float
    is_tested: bool
    is_keyed: bool
    off: int = 0


class Frame:
    """The faces of a frame, by what its polygons are drawn from, and its rays."""

    def __init__(self, scene: Scene, number: int) -> None:
        self.scene, self.number = scene, number
        self.faces: list[Face] = []
        self.numbers: dict[tuple, int] = {}  # {(material, vertices): in faces}
        for instance in scene.instances:
            age = number - instance.first_frame
            if 0 <= age < instance.views:
                self.add(instance, scene.views[instance.view + age])

    def add(self, instance, view) -> None:
        """Adds the faces of an instance that are drawn."""
        scene, mesh = self.scene, self.scene.meshes[instance.mesh]
        rows = view[:9].reshape(3, 3) / UNIT_30
        self.sizes = np.sqrt((rows * rows).sum(axis=1))
        points = scene.points[mesh.point:mesh.point + mesh.points] / ONE
        reach = float(abs(points).max())
        placed = ((points[:, None] * rows).sum(axis=2) + view[9:12] / ONE) / self.sizes
        for _, vertices, which in faces_of(scene, instance, self.number):
            if len(vertices) < 3:
                continue
            row = scene.faces[mesh.face + which].tolist()
            corners = placed[scene.corners[mesh.corner + row[4]:mesh.corner + row[4] + row[5], 0]]
            self.numbers[instance.material, tuple(vertices)] = len(self.faces)
            self.faces.append(self.face(instance, row, corners, rows, reach, vertices))

    def face(self, instance, row, corners, rows, reach: float, vertices) -> Face:
        """Returns a face; ``row``: of the scene's faces."""
        scene, material = self.scene, self.scene.materials[instance.material]
        normal = (np.array(row[:3]) / UNIT_30 * rows / self.sizes[:, None]).sum(axis=1)
        if not normal.any():  # seen from both sides
            normal = np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
            normal /= np.sqrt((normal * normal).sum())
            normal *= -np.sign((normal * corners[0]).sum())
        far = reach + float(abs(corners).max())
        cut = ideal_mesh.corner_error(reach, True)
        settings = Settings.of(material)
        nearest = max(float(corners[:, 2].min() * self.sizes[2]), scene.near_plane / ONE)
        off = ideal_mesh.off_screen(scene.guard, nearest, cut) + ideal_mesh.edge_error(settings.edges, scene.height)
        made = depths.found(scene, instance.material, vertices)
        steep = (abs(made[1].dx) + abs(made[1].dy)) / ONE if made else 0.0
        return Face(corners, normal, float((normal * corners).sum(axis=1).mean()),
                    rounding=far * 2.0 ** -27 + (ON + 1) / ONE, margin=off * np.sqrt(2), is_tested=instance.tree == Z,
                    is_keyed=material.mapper == "keyed",
                    off=made[1].off + scene.width // 2 + 1 + int(3 * steep * off) if made else 0)

    def rays(self) -> np.ndarray:
        """Returns the way to each pixel, (height, width, 3); one unit of w along each."""
        scene = self.scene
        y, x = np.mgrid[0:scene.height, 0:scene.width]
        ways = np.stack([x - scene.width / 2, y - scene.height / 2,
                         np.full(x.shape, 2.0 ** scene.guard)], -1) / 2.0 ** scene.guard
        return ways / self.sizes

    def shown(self) -> np.ndarray:
        """Returns the number of the face that each pixel shows, NONE where there is none."""
        scene, tested = self.scene, None
        shown = np.full((scene.height, scene.width), NONE)
        for what, faces, placed in steps_at(scene, self.number):
            if what == "begin":
                tested = depths.Depths(scene, faces)
                continue
            for face in faces:
                number = self.numbers[face[0], tuple(face[1])]
                if what.startswith("fill"):
                    tested.fill(*face, what == "fill_first")
                    continue
                made = depths.found(scene, *face)
                opaque = self.opaque(*face[:2]) if self.faces[number].is_keyed else None
                if what == "test":
                    lines = [(y, left, right, q) for y, left, right, q in tested.lines(*face)]
                else:
                    lines = [(y, line.left, line.right, None) for polygon in (made[0] if made else []) for y, line in enumerate(polygon.lines, polygon.top)
                             if line.left < line.right]
                for y, left, right, q in lines:
                    seen = np.ones(right - left, bool) if q is None else q >= tested.z[y, left:right]
                    if opaque is not None:
                        seen &= opaque[y, left:right]
                    shown[y, left:right][seen] = number
                    if q is not None:
                        tested.z[y, left:right][seen] = q[seen]
        return shown

    def opaque(self, which: int, vertices) -> np.ndarray:
        """Returns where a transparent picture has texels that are drawn."""
        frame = np.zeros((self.scene.height, self.scene.width), self.scene.pixel.dtype)
        model.draw_placed(self.scene, self.number, frame, [(which, vertices, 0)], {})
        return frame != 0

    def box(self, face: Face) -> tuple[slice, slice]:
        """Returns lines and columns that have all pixels of a face; the frame's if it reaches the eye."""
        scene, places = self.scene, face.corners * self.sizes
        if places[:, 2].min() < scene.near_plane / ONE:
            return slice(None), slice(None)
        found = []
        for k, size in ((1, scene.height), (0, scene.width)):
            at = size / 2 + 2.0 ** scene.guard * places[:, k] / places[:, 2]
            found.append(slice(*np.clip((at.min() - 1, at.max() + 2), 0, size).astype(int)))
        return tuple(found)

    def covered(self, face: Face, ways: np.ndarray) -> np.ndarray:
        """Returns which of the pixels with these rays a face covers, by its margin at least."""
        with np.errstate(divide="ignore", invalid="ignore"):
            inside = face.height / product(ways, face.normal) > self.scene.near_plane / ONE + 2.0 ** -12
        middle = face.corners.mean(axis=0)
        for a, b in zip(face.corners, np.roll(face.corners, -1, axis=0)):
            side = np.cross(a, b)
            side *= np.sign((side * middle).sum())
            step = side[:2] / self.sizes[:2] / 2.0 ** self.scene.guard  # the product's growth a pixel
            inside &= product(ways, side) > face.margin * np.sqrt((step * step).sum())
        return inside


def wrong(scene: Scene, number: int) -> np.ndarray:
    """Returns which pixels of a frame show another face than the nearest, or none though one is there."""
    frame = Frame(scene, number)
    ways, shown = frame.rays(), frame.shown()
    out = np.zeros(shown.shape, bool)
    normals = np.array([face.normal for face in frame.faces] + [np.zeros(3)])
    heights, roundings = (np.array([getattr(face, name) for face in frame.faces] + [0.0])
                          for name in ("height", "rounding"))
    offs = np.array([face.off for face in frame.faces] + [0])
    tested = np.array([face.is_tested for face in frame.faces] + [False])
    along = (ways * normals[shown]).sum(axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        far = heights[shown] / along  # of the shown face, in ways
        unsure = roundings[shown] / abs(along)
    for k, face in enumerate(frame.faces):
        if face.is_keyed or face.height > -face.rounding:
            continue
        part = frame.box(face)
        here, under = ways[part], shown[part]
        covered = frame.covered(face, here) & (under != k)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            slope = product(here, face.normal)
            is_behind = slope * far[part] - face.height < -(OFF / ONE + face.rounding + unsure[part] * abs(slope))
            q = (slope / face.height - 1 / far[part]) * (scene.near_plane >> 1) / ONE * 2.0 ** 30
            is_behind &= ~(face.is_tested | tested[under]) | (q > face.off + offs[under])
        out[part] |= covered & (is_behind | (under == NONE))
    return out
