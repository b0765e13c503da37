"""Trials of the walks through trees, src68k/mesh/mesh_walk.s and mesh_near*.s, against tools/tmap/model/trees.py and
mesh.py; of mesh_vertices."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.mesh import ONE, UNIT, number, points_of, scene, view
from tmap.bench.mesh import outside, walk_trial
from tmap.bench.mesh_batches import vertices_trial
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial
from tmap.bench.visible import Faces, Near, box_of, near_face_trial, near_trial, place_of
from tmap.model import mesh

OFF = (1024, 0xFFFF, 1)  # units that edges may be beyond points


def tree(rng, count: int) -> list[list[int]]:
    """The nodes of a tree of any form and planes. Some planes go through the origin."""
    sizes, nodes, slot = [count], [], 0
    while sizes:
        left = sizes.pop() - 1
        front = int(rng.choice((0, left, rng.integers(0, left + 1))))
        slots = int(rng.integers(0, 4))
        distance = int(rng.choice((0, number(rng, 12000 * ONE))))
        nodes.append([*(number(rng, UNIT) for _ in range(3)), distance, front, left - front, slot, slots])
        sizes += [part for part in (left - front, front) if part]
        slot += slots
    return nodes


def eye(rng) -> list[int]:
    """Anywhere, every fourth time in the origin."""
    return [0, 0, 0] if rng.integers(4) == 0 else [number(rng, (1 << 31) - 1) for _ in range(3)]


def walk_trials(rng) -> list[Trial]:
    """Some slots are empty."""
    made = []
    for k, count in enumerate((1, 2, 3, 4, 9, 60) * 12):
        nodes = tree(rng, count)
        slots = nodes[-1][6] + nodes[-1][7]
        seen = [int(face) if rng.integers(2) else None for face in rng.permutation(slots)]
        made.append(walk_trial(Memory(), nodes, seen, eye(rng), f"{count} nodes, number {k}"))
    return made


def near_trials(rng) -> list[Trial]:
    """Calls of whole walks, until there is no node left; some boxes are outside a border."""
    made = []
    for k, count in enumerate((1, 2, 3, 7, 20) * 3):
        boxes = np.sort(rng.integers(-1 << 15, 1 << 15, (count, 2, 3)), axis=1).reshape(count, 6).tolist()
        borders = [(tuple(int(axis + 3 * rng.integers(2)) for axis in range(3)),
                    tuple(rng.integers(-1 << 14, (1 << 14) + 1, 3).tolist()),
                    int(rng.choice((-1 << 30, -1 << 29, 0 if k % 2 else -3 << 29)))) for _ in range(5)]
        walk = Near(tree(rng, count), boxes, borders, eye(rng))
        calls, is_left = 0, True
        while is_left:
            made.append(near_trial(Memory(), walk, f"{count} nodes, number {k}, call {calls}"))
            calls, is_left = calls + 1, walk.node is not None or bool(walk.steps)
        made.append(near_trial(Memory(), walk, f"{count} nodes, number {k}, after the end"))
    return made


def near_face_trials(rng) -> list[Trial]:
    """Faces some of whose points are transformed before; the same point at two corners too; slots without a face, faces
    seen from the back and normals of two zeros; lines without gaps and with some."""
    made = []
    for k, count in enumerate((1, 2, 5, 12) * 20):
        about, row = scene(rng), view(rng)
        faces = []
        for _ in range(count):
            normal = [number(rng, UNIT) * int(rng.integers(3) > 0) for _ in range(3)]
            distance = -1 if not any(normal) else number(rng, (1 << 30 + k % 2) - 1)
            corners = rng.integers(0, 12, int(rng.choice((3, 4, 5, 32)))).tolist()
            faces.append(None if rng.integers(6) == 0 else
                         ([0, 0, 0, -1] if rng.integers(3) == 0 else [*normal, distance], corners))
        stamped = (rng.integers(3, size=12) < k % 4).tolist()
        gaps = [gaps_of(rng, about.width) if k // 4 % 3 else [] for _ in range(about.height)]
        made.append(near_face_trial(Memory(), about, Faces(faces, points_of(rng, 12), stamped, row, gaps,
                                                           OFF[k % 3]), f"{count} slots, number {k}"))
    return made


def grazing_trials(rng) -> list[Trial]:
    """Faces that the eye's plane just misses or not, by a unit; lines and columns that are gaps just beside their
    boxes, the last that count or the first that do not."""
    made = []
    while len(made) < 64:
        about, row, corners = scene(rng), view(rng), rng.permutation(24)[:3].tolist()
        points = points_of(rng, 24)
        placed = mesh.transform(about, points, row)
        outsides = [outside(point, about.near_plane) for point in placed]
        inside, beside = ([k for k, border in enumerate(outsides) if is_wanted(border)]
                          for is_wanted in (lambda border: not border, lambda border: border and not border & 1))
        if len(inside) > 2 and beside:
            corners = inside[:2] + (inside[2:] if len(made) % 3 else beside)[:1]
        borders = [outsides[k] for k in corners]
        some = borders[0] | borders[1] | borders[2]
        if some & 1 or borders[0] & borders[1] & borders[2]:
            continue
        normal = [number(rng, UNIT) for _ in range(3)]
        product = sum(n * e for n, e in zip(normal, row[12:15])) >> 30
        if not -1 << 31 < product < 1 << 31:
            continue
        places = [place_of(point, about, border) for point, border in zip((placed[k] for k in corners), borders)]
        off, beyond = OFF[len(made) % 3], int(rng.integers(2))
        left, right, top, bottom = box_of(places, off, 2 * bool(some) + beyond)
        everywhere, gaps = [(BIAS, BIAS + about.width - 1)], [[] for _ in range(about.height)]
        side = int(rng.integers(4))
        if side < 2 and 0 <= (line := (top, bottom)[side]) < about.height:
            gaps[line] = everywhere
        elif side >= 2 and 0 <= (column := (left, right)[side - 2]) < about.width:
            gaps = [[(BIAS + column, BIAS + column)] for _ in gaps]
        else:
            continue
        distance = product - 1 if len(made) % 8 else product - int(rng.integers(2))
        made.append(near_face_trial(Memory(), about, Faces([([*normal, distance], corners)], points, [False] * 24, row, gaps,
                                                       off),
                                    f"side {side}, {beyond} beyond it, distance {distance}"))
    return made


def gaps_of(rng, width: int) -> list[tuple[int, int]]:
    """Up to three gaps of a line."""
    ends = np.sort(rng.choice(width, 2 * int(rng.integers(0, 4)), replace=False)) + BIAS
    return [(int(first), int(last)) for first, last in zip(ends[::2], ends[1::2])]


def vertices_trials(rng) -> list[Trial]:
    """All flags; all points inside every second time."""
    made = []
    for k, count in enumerate((3, 4, 5, 32) * 8):
        points = [(*(number(rng, 1 << 30) for _ in range(5)), int(rng.integers(32)) * (k // 4 % 2)) for _ in range(9)]
        values = [[number(rng, 1 << 24) for _ in range(3)] for _ in range(9)]
        corners = [(*rng.integers(0, 9, 2).tolist(), number(rng, 1 << 28), number(rng, 1 << 28)) for _ in range(count)]
        made.append(vertices_trial(Memory(), points, values, corners, k % 4 if k < 16 else k // 8, f"number {k}"))
    return made


def trials() -> list[Trial]:
    return [trial for seed, make in enumerate((walk_trials, near_trials, near_face_trials, vertices_trials, grazing_trials))
            for trial in make(np.random.default_rng(81 + seed))]
