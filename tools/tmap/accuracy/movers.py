"""Wrong pixels of scenes whose meshes move through each other, in any order: the integer model says which face
each pixel shows, and 1/w of all faces that cover it, in floating point from their corners, which is the nearest.
"""

import numpy as np

from tmap.model.depths import Depths, found
from tmap.model.mesh import steps_at
from tmap.scene_file.scene_file import ONE, Scene

SAME = 1e-3  # units of depth: faces that differ by less are equally near


def nearness(vertices) -> tuple[np.ndarray, float, float]:
    """Returns the plane of 1/w over the screen (growth a pixel and a line, value at 0, 0), its least and its
    greatest value at the corners."""
    places = np.array([(v[0] / ONE, v[1] / ONE, 1) for v in vertices])
    values = np.array([ONE / v[5] for v in vertices])
    middle = places.mean(axis=0) - (0, 0, 1)
    plane = np.linalg.lstsq(places - middle, values, rcond=None)[0]
    plane[2] -= plane[0] * middle[0] + plane[1] * middle[1]
    return plane, values.min(), values.max()


class Pictures:
    """1/w of the face that each pixel shows, and of the nearest that covers it; 0: none does."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.shown, self.nearest = (np.zeros((scene.height, scene.width)) for _ in range(2))

    def add(self, face, depths: Depths | None) -> None:
        """Draws a face over all before, or tests it."""
        made = found(self.scene, *face)
        if made is None:
            return
        plane, low, high = nearness(face[1])
        tested = {y: (left, q) for y, left, _, q in depths.lines(*face)} if depths else {}
        for y, line in enumerate(made[0].lines, made[0].top):
            x = np.arange(line.left, line.right)
            part, near = (y, slice(line.left, max(line.left, line.right))), x
            near = np.clip(plane[0] * x + plane[1] * y + plane[2], low, high)
            self.nearest[part] = np.maximum(self.nearest[part], near)
            if not depths:
                self.shown[part] = near
            elif y in tested:
                left, q = tested[y]
                here = (y, slice(left, left + len(q)))
                is_seen = q >= depths.z[here]
                self.shown[here] = np.where(is_seen, near[left - line.left:][:len(q)], self.shown[here])
                depths.z[here] = np.where(is_seen, q, depths.z[here])


def wrong_pixels(scene: Scene, number: int) -> int:
    """Returns how many pixels of a frame show another face than the nearest."""
    pictures, depths = Pictures(scene), None
    for what, faces, _ in steps_at(scene, number):
        if what == "begin":
            depths = Depths(scene, faces)
        for face in faces if what != "begin" else []:
            if what == "fill":
                depths.fill(*face)
            else:
                pictures.add(face, depths if what == "test" else None)
    covered = pictures.shown > 0
    far, near = 1 / pictures.shown[covered], 1 / pictures.nearest[covered]
    return int((far > near + SAME).sum())
