"""The integer model of c/depths and src68k/depths: which pixels of tested faces are seen.

q is (near / 2) / w, 2.30. A face is given by its material and whole corners on the screen,
(x, y, s, t, shade, w), 16.16.
"""

from dataclasses import dataclass, replace

import numpy as np

from tmap.base.fixed import M32, mul_div, signed
from tmap.build import layout
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


def found(scene, which: int, vertices) -> tuple[Polygon, Plane] | None:
    """Returns the lines of a face and its plane; None if it has no pixels."""
    settings = replace(Settings.of(scene.materials[which]), mapper="flat", perspective="none")
    vertices = [(*v[:2], 0, 0, v[4]) for v in adapt(vertices, settings, 256)]
    if any(not -FAR <= c < FAR for v in vertices for c in v[:2]):
        return None
    outline = outline_of(vertices, scene.width, scene.height, settings)
    if outline is None:
        return None
    return outline.polygon(scene.width, settings.has_exact_edges, False), \
        plane_of(vertices, outline, scene.near_plane)


class Depths:
    """A z buffer inside the boxes of the faces that are tested."""

    def __init__(self, scene, faces) -> None:
        self.scene = scene
        self.z = np.full((scene.height, scene.width), DEPTH_FAR, np.int64)
        self.bounds = [(scene.width, 0)] * scene.height
        for _, vertices in faces:
            left, top = (max((min(v[k] for v in vertices) >> 16) - 1, 0) for k in (0, 1))
            right, bottom = (min((max(v[k] for v in vertices) >> 16) + 2, size)
                             for k, size in enumerate((scene.width, scene.height)))
            for y in range(top, bottom if left < right else top):
                a, b = self.bounds[y]
                self.bounds[y] = min(a, left), max(b, right)

    def lines(self, which: int, vertices):
        """Yields line, first pixel, the pixel behind the last and their q of a face inside the bounds."""
        made = found(self.scene, which, vertices)
        if made is None:
            return
        polygon, plane = made
        for y, line in enumerate(polygon.lines, polygon.top):
            left, right = max(line.left, self.bounds[y][0]), min(line.right, self.bounds[y][1])
            if left < right:
                yield y, left, right, plane.line(left, right - left, y)

    def fill(self, which: int, vertices) -> None:
        """Puts a face into it that has been drawn over all before."""
        for y, left, right, q in self.lines(which, vertices):
            self.z[y, left:right] = q

    def copy(self, frame: np.ndarray, aside: np.ndarray, which: int, vertices) -> None:
        """Copies the pixels of a face drawn aside, where keyed ones are over 0, that are seen, and puts them into it."""
        for y, left, right, q in self.lines(which, vertices):
            seen = q >= self.z[y, left:right]
            if self.scene.materials[which].mapper == "keyed":
                seen &= aside[y, left:right] != 0
            self.z[y, left:right][seen] = q[seen]
            frame[y, left:right][seen] = aside[y, left:right][seen]
