"""The integer model of c/depths and src68k/depths: which pixels of tested faces are seen.

q is (near / 2) / w, 2.30. A face is given by its material and whole corners on the screen,
(x, y, s, t, shade, w), 16.16.
"""

from dataclasses import dataclass, field, replace
from itertools import product

import numpy as np

from tmap.base.fixed import M32, mul_div, signed
from tmap.build import layout
from tmap.setup import planarity
from tmap.setup.perspective import Q_ONE, steepness
from tmap.setup.polygon import FAR, Outline, Polygon, adapt, outline_of
from tmap.setup.texturing import Settings, gradients

TOO_STEEP = 1 << 16  # 2^16 units a pixel
DEPTH_FAR = -1 << 31


def error_part(steep: int, pixels: int) -> int:
    """Returns the units that a plane may be off after some pixels; ``steep``: the upper half of its gradient."""
    return (steep * pixels >> 15) + (pixels >> 14)


@dataclass
class Plane:
    """q over the screen, 48.16: at pixel (i, j), and its growth a pixel and a line. ``off``: the units by which
    q of a line's first pixel may be off; each further pixel adds half a unit."""

    i: int
    j: int
    at: int
    dx: int
    dy: int
    off: int

    def line(self, left: int, count: int, y: int) -> np.ndarray:
        """Returns q of the pixels of a line."""
        first = self.at + (left - self.i) * self.dx + (y - self.j) * self.dy >> 16
        step = self.dx + (1 << 15) >> 16
        found = (first + step * np.arange(count)) & M32
        return np.where(found >> 31, found - (1 << 32), found)


def plane_of(vertices, outline: Outline, near: int) -> Plane:
    """Returns the plane of q of a polygon, or the middle of its corners' q where a plane would be off by more."""
    three = [(*vertices[k][:2], mul_div(near >> 1, Q_ONE, vertices[k][-1])) for k in outline.corners]
    qs = [corner[2] for corner in three]
    left, top, right, bottom = outline.box
    x, y = signed((left << 16) - three[0][0]), signed((top << 16) - three[0][1])
    gx, gy = gradients(three, 2)
    steep = steepness(gx), steepness(gy)
    reach = max(qs) - min(qs)
    off = layout.load().constants["DEPTH_OFF_LEAST"] + error_part(steep[0], (abs(x) >> 16) + right - left + 1) \
        + error_part(steep[1], (abs(y) >> 16) + bottom - top + 1)
    if max(steep) >= TOO_STEEP or off > reach:
        return Plane(left, top, min(qs) + (reach >> 1) << 16, 0, 0, reach)
    return Plane(left, top, (three[0][2] << 16) + (gx * x >> 16) + (gy * y >> 16), gx, gy, off)


def found(scene, which: int, vertices, vouched: int = planarity.IN_SPACE) -> tuple[list[Polygon], Plane] | None:
    """Returns the lines of a face, of the outlines of the polygons that draw it, and its plane; None if it has no
    pixels. ``vouched``: the kinds of its values that are planar without a test."""
    material = scene.materials[which]
    settings = replace(Settings.of(material), mapper="flat", perspective="none")

    def outline(corners) -> Outline | None:
        corners = [(*v[:2], 0, 0, v[4]) for v in adapt(corners, settings, 256)]
        if any(not -FAR <= c < FAR for v in corners for c in v[:2]):
            return None
        return outline_of(corners, scene.width, scene.height, settings)

    whole = outline(vertices)
    if whole is None:
        return None
    outlines = [outline(piece) for piece in pieces_of(scene, material, vertices, vouched)]
    return [each.polygon(scene.width, settings.has_exact_edges, False) for each in outlines if each], \
        plane_of([(*v[:2], 0, 0, v[4]) for v in adapt(vertices, settings, 256)], whole, scene.near_plane)


def pieces_of(scene, material, vertices, vouched: int) -> list:
    """Returns a face, or the triangles that it is drawn as."""
    if material.gradients == "polygon" and material.mapper != "flat":
        return planarity.fan(vertices)
    longer = max(scene.textures[material.texture].texels.shape) if material.texture >= 0 else 256
    return planarity.parts(vertices, material, scene.frame_shape, longer, vouched)


@dataclass
class Part:
    """A part of the frame with tested faces: columns and lines, and their least and greatest w."""

    left: int
    top: int
    right: int
    bottom: int
    near: int
    far: int
    lacks: bool = False  # not all corners are kept, or one is far from the frame
    corners: list[tuple[int, int, int]] = field(default_factory=list)  # whole pixels, and q

    @classmethod
    def of(cls, scene, vertices) -> "Part | None":
        """Returns that of a face; None if none of the frame is in it."""
        left, top = (max((min(v[k] for v in vertices) >> 16) - 1, 0) for k in (0, 1))
        right, bottom = (min((max(v[k] for v in vertices) >> 16) + 2, size)
                         for k, size in enumerate((scene.width, scene.height)))
        depths = [v[5] for v in vertices]
        return cls(left, top, right, bottom, min(depths), max(depths)) if left < right and top < bottom else None

    def meets(self, other: "Part") -> bool:
        """Returns true if both have a pixel in common."""
        return self.left < other.right and other.left < self.right and self.top < other.bottom and other.top < self.bottom

    def join(self, other: "Part") -> None:
        """Takes another one in."""
        for name, choose in (("left", min), ("top", min), ("right", max), ("bottom", max), ("near", min), ("far", max)):
            setattr(self, name, choose(getattr(self, name), getattr(other, name)))

    def is_before(self, plane: "Plane", width: int, height: int) -> bool:
        """Returns true if all faces in the part are before a plane of q: depths_are_before."""
        dx, dy = plane.dx >> 16, plane.dy >> 16
        steep = (abs(dx) >> 5) * width + (abs(dy) >> 5) * height
        if not plane.dx and not plane.dy or self.lacks or max(abs(dx), abs(dy)) >> 20 or steep >> 24:
            return False
        bias = layout.load().constants["EDGE_BIAS"]
        at = (plane.at - (plane.i + bias) * plane.dx - plane.j * plane.dy >> 16) + bias * dx \
            + bias + 2 * (width + height) + 2 + (dx + 1) * (dx >= 0) + (dy + 1) * (dy >= 0)
        return all(signed(at + dx * x + dy * y) < q for x, y, q in self.corners)


class Depths:
    """A z buffer in parts of the frame, around the faces that are tested."""

    def __init__(self, scene, faces) -> None:
        self.scene, constants = scene, layout.load().constants
        self.nearest = constants["DEPTH_NEAREST"]
        self.z = np.full((scene.height, scene.width), DEPTH_FAR, np.int64)
        self.parts: list[Part] = []
        room = constants["DEPTH_CORNERS"]
        for _, vertices, _ in faces:
            part = Part.of(scene, vertices)
            if not part:
                continue
            met = [each for each in self.parts if each.meets(part)]
            if not met and len(self.parts) < constants["DEPTH_PARTS"]:
                self.parts.append(part)
            else:
                part, other = (met or self.parts[-1:])[0], part
                part.join(other)
            if len(vertices) > room:
                part.lacks = True
                continue
            room -= len(vertices)
            for v in vertices:
                x, y = v[0] >> 16, v[1] >> 16
                part.corners.append((x, y, mul_div(scene.near_plane >> 1, Q_ONE, v[5])))
                part.lacks |= not (-scene.width <= x < 2 * scene.width and -scene.height <= y < 2 * scene.height)

    def lines(self, which: int, vertices, vouched: int = planarity.IN_SPACE):
        """Yields line, first pixel, the pixel behind the last and their q of a face."""
        made = found(self.scene, which, vertices, vouched)
        if made is None:
            return
        polygons, plane = made
        for polygon in polygons:
            for y, line in enumerate(polygon.lines, polygon.top):
                if line.left < line.right:
                    yield y, line.left, line.right, plane.line(line.left, line.right - line.left, y)

    def fill(self, which: int, vertices, vouched: int, is_ordered: bool) -> None:
        """Puts a face into it that has been drawn over all before, in the parts whose faces it may hide.
        ``is_ordered``: only faces of its tree were put in before."""
        own = Part.of(self.scene, vertices)
        met = [part for part in self.parts if own and part.meets(own)]
        parts = [part for part in met if not is_ordered or part.far >= own.near]
        made = found(self.scene, which, vertices, vouched) if parts else None
        if made is None:
            return
        is_before = all(part.near > own.far for part in met)
        if is_ordered and not is_before:
            parts = [part for part in parts if not part.is_before(made[1], self.scene.width, self.scene.height)]
        for polygon, part in product(made[0], parts):
            for y, line in enumerate(polygon.lines, polygon.top):
                left, right = max(line.left, part.left), min(line.right, part.right)
                if part.top <= y < part.bottom and left < right:
                    self.z[y, left:right] = self.nearest if is_before else made[1].line(left, right - left, y)

    def copy(self, frame: np.ndarray, aside: np.ndarray, which: int, vertices, vouched: int) -> None:
        """Copies the pixels of a face drawn aside, where keyed ones are over 0, that are seen, and puts them into it."""
        for y, left, right, q in self.lines(which, vertices, vouched):
            seen = q >= self.z[y, left:right]
            if self.scene.materials[which].mapper == "keyed":
                seen &= aside[y, left:right] != 0
            self.z[y, left:right][seen] = q[seen]
            frame[y, left:right][seen] = aside[y, left:right][seen]
