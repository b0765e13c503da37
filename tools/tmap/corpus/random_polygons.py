"""Random convex polygons by seed, for tests: ordinary, thin, tiny, huge, off screen, and
handwritten ones (tmap.corpus.written).

Everything is 16.16; one polygon per frame, so that none hides another.
"""

import math
import random

import numpy as np

from tmap.base.fixed import ONE, fix
from tmap.corpus import written
from tmap.model import model
from tmap.scene_file.materials import Material
from tmap.scene_file.scene_file import IDENTITY, Object, Scene
from tmap.scene_file.textures import Texture


def convex_polygon(rng: random.Random, width: int, height: int) -> list[tuple[int, int]]:
    """Corners on an ellipse of random place, size, thinness and rotation, either winding."""
    count = rng.choice((3, 3, 4, 4, 5, 6, 7, 8))
    size = rng.choice((2, 10, 40, 100, 300))
    major, minor = size * rng.uniform(0.3, 1), size * rng.uniform(0.3, 1)
    if rng.random() < 0.3:
        minor *= 10 ** rng.uniform(-4, -1)
    centre = rng.uniform(-0.2, 1.2) * width, rng.uniform(-0.2, 1.2) * height
    turn, start = rng.uniform(0, math.tau), rng.uniform(0, math.tau)
    angles = sorted(rng.uniform(0, math.tau) for _ in range(count))
    if rng.random() < 0.3:
        angles = [start + math.tau * k / count for k in range(count)]
    points = []
    for angle in angles:
        x, y = major * math.cos(angle), minor * math.sin(angle)
        points.append((fix(centre[0] + x * math.cos(turn) - y * math.sin(turn)),
                       fix(centre[1] + x * math.sin(turn) + y * math.cos(turn))))
    if rng.random() < 0.15:  # onto pixel centres or halfway between
        points = [(x + 0x4000 & ~0x7FFF, y + 0x4000 & ~0x7FFF) for x, y in points]
    if rng.random() < 0.5:
        points.reverse()
    shift = rng.randrange(count)
    return points[shift:] + points[:shift]


def texture_plane(rng: random.Random, points: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Returns s and t of the corners from one affine function of the screen."""
    scale = rng.choice((0, 1 / 16, 0.3, 1, 1, 1, 1.7, 4, 16))
    angle = rng.choice((0, math.pi / 2, math.pi, rng.uniform(0, math.tau), rng.uniform(0, math.tau)))
    squeeze = rng.choice((1, 1, -1, 0.2))
    c, s = scale * math.cos(angle), scale * math.sin(angle)
    base = rng.uniform(-300, 300), rng.uniform(-300, 300)
    mx, my = points[0][0] / ONE, points[0][1] / ONE
    return [(fix(base[0] + c * (x / ONE - mx) - s * (y / ONE - my)),
             fix(base[1] + squeeze * (s * (x / ONE - mx) + c * (y / ONE - my))))
            for x, y in points]


def is_convex(points: list[tuple[int, int]]) -> bool:
    """Returns true if all corners turn the same way: snapping can dent a thin polygon."""
    sides = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(points, points[1:] + points[:1]) if a != b]
    turns = [p[0] * q[1] - p[1] * q[0] for p, q in zip(sides, sides[1:] + sides[:1])]
    return all(t >= 0 for t in turns) or all(t <= 0 for t in turns)


def covering_polygon(rng: random.Random, width: int, height: int):
    """Returns corners and texture plane of a polygon; nine in ten cover a pixel of the frame."""
    if rng.random() < written.SHARE:
        points = written.outline(rng, width, height)
        return points, written.texels(rng, points, (256, 256))
    any_will_do = rng.random() < 0.1
    while True:
        points = convex_polygon(rng, width, height)
        if not is_convex(points):
            continue
        plane = texture_plane(rng, points)
        set_up = model.set_up([(*p, *q) for p, q in zip(points, plane)], width, height, True)
        if any_will_do or set_up and set_up.pixels:
            return points, plane


def scene(seed: int, count: int, width: int, height: int) -> Scene:
    """Returns a scene of ``count`` polygons, one per frame: number k depends only on seed and k."""
    noise = np.random.default_rng(seed)
    texture = Texture(noise.integers(0, 256, (256, 256), dtype=np.uint8))
    palette = noise.integers(0, 256, (256, 3), dtype=np.uint8)
    objects, vertices = [], []
    for k in range(count):
        rng = random.Random(f"{seed} {k}")
        points, plane = covering_polygon(rng, width, height)
        objects.append(Object(0 if rng.random() < 0.85 else 1, len(vertices), len(points), 0, 1, k))
        vertices += [(*p, *q, 0, ONE) for p, q in zip(points, plane)]
    return Scene(width, height, count, 7, palette, [texture],
                 [Material("affine", texture=0), Material(colour=200)], objects,
                 np.array(vertices), np.array([IDENTITY]))


def vertex_lines(vertices, raw=()) -> list[str]:
    """Formats vertices of 16.16; the fields in ``raw`` are printed as integers."""
    names = ("x", "y", "s", "t", "shade", "w")
    return ["  " + ", ".join(f"{name} {value}" if name in raw else f"{name} {value / ONE:.6f}"
                             for name, value in zip(names, vertex)) for vertex in vertices]
