"""Trials of src68k/mesh against tools/tmap/model/mesh.py, which is held to exact numbers elsewhere."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench.mesh import (attributes_trial, cut_trial, faces_trial, faces_wide_trial, orders_trial, outside,
                             project_trial, snap_trial, spread_trial, transform_trial, values_trial, wide_trial)
from tmap.bench.mesh_batches import Gathered, gather_trial
from tmap.bench.trial import Trial
from tmap.compiler import views16
from tmap.model import mesh, mesh16
from tmap.scene_file.meshes import ENVIRONMENT, LIT

ONE, UNIT = 1 << 16, 1 << 30
REACH, AWAY = 2048 * ONE, 10240 * ONE - 1


def number(rng, most: int) -> int:
    """Of any size and sign, the borders now and then."""
    if rng.integers(8) == 0:
        return int(rng.choice((most, -most, 0)))
    value = int(rng.integers(0, 1 << int(rng.integers(1, most.bit_length() + 1))))
    return min(value, most) * int(rng.choice((-1, 1)))


def rotation(rng) -> list[int]:
    """Nine factors of a rotation, as a view has them."""
    q = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return np.rint(q * UNIT).astype(int).ravel().tolist()


def view(rng) -> list[int]:
    """A row of the views: any factors, or a rotation that looks at points near the origin."""
    if rng.integers(2):
        factors, move = [number(rng, UNIT) for _ in range(9)], [number(rng, AWAY) for _ in range(3)]
    else:
        factors, move = rotation(rng), [0, 0, int(rng.integers(ONE, 20 * ONE))]
    eye = [number(rng, 12000 * ONE) for _ in range(3)]
    return [*factors, *move, *eye, *([0] * 10)]


def scene(rng) -> SimpleNamespace:
    return SimpleNamespace(near_plane=int(rng.choice((256, ONE, 12345, 100 * ONE))),
                           guard=int(rng.integers(6, 14)), width=320, height=256)


def points_of(rng, count: int) -> list[tuple[int, ...]]:
    most = REACH if rng.integers(2) else 4 * ONE
    return [tuple(number(rng, most) for _ in range(3)) for _ in range(count)]


def marks_of(number: int, count: int) -> np.ndarray:
    """All, a half or a third of the points, by a trial's number."""
    return np.random.default_rng(number).integers(1 + number % 3, size=count) == 0


def mesh_transform_trials(rng) -> list[Trial]:
    """Any factors, which mostly leave the screen, and those of views in which most points are on it."""
    trials, shown, total = [], 0, 0
    for count in (1, 2, 3, 40) * 30:
        total += count
        frame = [4 * int(n) for n in rng.integers(1, 100, 2)]
        if rng.integers(6) == 0:
            row = row16_of(rng)
            points = np.array([[number(rng, 16383) for _ in range(3)] for _ in range(count)])
        else:
            about = SimpleNamespace(guard=int(rng.integers(6, 10)), width=frame[0], height=frame[1])
            most = int(rng.integers(2, 2 * ONE))
            whole = rng.integers(-most, most + 1, (count, 3))
            row = views16.row_of(about, [*rotation(rng), *(int(n) for n in rng.integers(-ONE, ONE, 2)),
                                         int(rng.integers(2 * ONE, 40 * ONE)), *([0] * 13)],
                                 mesh16.reach(whole))
            points = mesh16.points_of(whole)
        places = mesh16.transform(points, row, frame)
        if places is not None and count > 3:  # a point on the last column or line
            axis = len(trials) // 4 % 2
            values = (places.x, places.y)[axis]
            if (on := places.shown & (values > 0) & (values % 16 == 0)).any():
                frame[axis] = int(values[on][0]) // 16
                places = mesh16.transform(points, row, frame)
        shown += places is not None and int(places.shown.sum())
        marked = marks_of(len(trials), count)
        trials.append(transform_trial(Memory(), frame, points, marked, row, f"{count} points, {marked.sum()} marked"))
    assert total / 4 < shown < 3 * total / 4
    return trials


def row16_of(rng) -> list[int]:
    """A row of the views16 with any numbers that the file may hold."""
    row = [number(rng, 16384) for _ in range(18)]
    for at in (mesh16.W, mesh16.X, mesh16.Y):
        row[at] = number(rng, (1 << 31) - 1)
        row[at + 4] = int(rng.integers(0, 32))
    return [*row, 1]


def mesh_transform_wide_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 3, 40) * 12:
        about, row, points = scene(rng), view(rng), points_of(rng, count)
        trials.append(wide_trial(Memory(), about, points, row, f"{count} points"))
    return trials


def mesh_attributes_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 33) * 12:
        most = 1 << 14
        normals = [(*(number(rng, most) for _ in range(3)), 0) for _ in range(count)]
        factors = [number(rng, 32767) for _ in range(3)]
        base, low = int(rng.integers(0, 256 * ONE)), int(rng.choice((-1 << 31, 0, 40 * ONE)))
        high = int(rng.choice((low, 200 * ONE, (1 << 31) - 1)))
        trials.append(attributes_trial(Memory(), normals, factors, base, low, high,
                                       f"{count} normals", 4))
    return trials


def values_trials(kernel: str, rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 33) * 12:
        most = 1 << 14
        normals = [(*(number(rng, most) for _ in range(3)), 0) for _ in range(count)]
        low = int(rng.integers(0, 256 * ONE))
        marked = marks_of(len(trials), count)
        trials.append(values_trial(Memory(), kernel, normals, marked, [number(rng, 32767) for _ in range(6)], low,
                                   int(rng.integers(low, 256 * ONE)), f"{count} normals, {marked.sum()} marked",
                                   len(trials) // 3 % 6))
    return trials


def mesh_mirror_trials(rng) -> list[Trial]:
    return values_trials("mesh_mirror", rng)


def mesh_shade_trials(rng) -> list[Trial]:
    return values_trials("mesh_shade", rng)


def vertex(rng) -> list[int]:
    return [number(rng, (1 << 30) - 1) for _ in range(6)]


def mesh_cut_trials(rng) -> list[Trial]:
    trials = []
    for k in range(80):
        inside, beyond = vertex(rng), vertex(rng)
        whole = int(rng.integers(1, 1 << int(rng.integers(1, 33))))
        part = min(whole - 1, (1 << 31) - 1, int(rng.integers(0, whole)))
        part = min((0, whole - 1, part, part)[k % 4], (1 << 31) - 1)
        if k % 5 == 0:
            beyond[:3] = inside[:3]
        trials.append(cut_trial(Memory(), inside, beyond, part, whole, f"part {part} of {whole}"))
    return trials


def mesh_project_trials(rng) -> list[Trial]:
    """Vertices inside all borders, some on them."""
    return [project_trial(Memory(), [[number(rng, w), number(rng, w), *vertex(rng)[:3], w]
                                     for w in rng.integers(1, 1 << int(rng.integers(8, 31)), count).tolist()],
                          [4 * int(n) for n in rng.integers(1, 100, 2)], int(rng.integers(6, 10)), f"{count} vertices")
            for count in (1, 2, 3, 9) * 12]


def face(rng, first: int, corners: int) -> list[int]:
    """A face of any plane, or one seen from both sides."""
    if rng.integers(4) == 0:
        return [0, 0, 0, -1, first, corners]
    return [*(number(rng, UNIT) for _ in range(3)), number(rng, 12000 * ONE), first, corners]


def mesh_faces_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 30) * 10:
        row = row16_of(rng)
        row[mesh16.EYE:mesh16.EYE + 3] = [number(rng, 32767) for _ in range(3)]
        sizes = rng.choice((3, 3, 4, 5, 32), count).tolist()
        corners = [int(rng.integers(0, 12)) for _ in range(sum(sizes))]
        firsts = (np.cumsum(sizes) - sizes).tolist()
        faces = [face(rng, first, size) for first, size in zip(firsts, sizes)]
        trials.append(faces_trial(Memory(), corners, faces, row, f"{count} faces"))
    return trials


def mesh_orders_trials(rng) -> list[Trial]:
    """Places anywhere, some beside the limit of lines and some out of range."""
    trials = []
    for count in (1, 2, 30) * 10:
        bottom = int(rng.choice((2000, 4096, 8000)))
        places = [(None if rng.integers(20) == 0 else
                   (int(rng.integers(0, 5121)), int(rng.choice((0, 1, bottom - 1, bottom, rng.integers(bottom))))),
                   number(rng, (1 << 30) - 1)) for _ in range(12)]
        faces = [rng.integers(0, 12, int(rng.choice((3, 3, 4, 5, 32)))).tolist() for _ in range(count)]
        trials.append(orders_trial(Memory(), places, faces, int(rng.integers(0, 9)), f"{count} faces"))
    return trials


def mesh_faces_wide_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 30) * 10:
        about, row, points = scene(rng), view(rng), points_of(rng, 12)
        points = [(p.x, p.y, p.w, outside(p, about.near_plane))
                  for p in mesh.transform(about, points, row)]
        sizes = rng.choice((3, 3, 4, 5, 32), count).tolist()
        corners = [int(rng.integers(0, 12)) for _ in range(sum(sizes))]
        firsts = (np.cumsum(sizes) - sizes).tolist()
        faces = [face(rng, first, size) for first, size in zip(firsts, sizes)]
        trials.append(faces_wide_trial(Memory(), points, corners, faces, row, f"{count} faces"))
    return trials


def mesh_snap_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 30) * 10:
        right, bottom = (16 * int(n) for n in rng.integers(1, 330, 2))
        points = [(*(number(rng, 400 * ONE) if rng.integers(3) else int(rng.integers(0, right << 12))
                     for _ in range(2)), int(rng.choice((0, 0, 0, 5)))) for _ in range(count)]
        trials.append(snap_trial(Memory(), points, right, bottom, f"{count} points"))
    return trials


def gathered(rng, mapper: str) -> Gathered:
    """Faces that are mostly in range: each is high up or far down, where another's height would be too much."""
    def rarely(*values):
        return values[0] if rng.integers(40) else values[int(rng.integers(1, len(values)))]

    points = [rarely((int(rng.integers(0, 5120)), int(rng.integers(0, 1900)) + 5000 * (k // 10)), None,
                     (3, 4000)) for k in range(20)]
    looks = [(*(int(n) for n in rng.integers(0, 256 * ONE + 1, 2)), int(rng.integers(0, 255 * ONE)))
             for _ in range(9)]
    most = 300 * ONE if rng.integers(3) else 700 * ONE
    flags = {"gouraud": LIT, "affine": int(rng.choice((0, ENVIRONMENT))),
             "lit": LIT | int(rng.choice((0, ENVIRONMENT)))}.get(mapper, 0)
    faces = []
    for _ in range(int(rng.integers(1, 40))):
        count, half = int(rng.choice((3, 4))), 10 * int(rng.integers(2))
        faces.append((int(rarely(0, 1, 2)), [
            (half + int(rng.integers(10)), int(rng.integers(9)), number(rng, most), number(rng, most))
            for _ in range(rarely(count, 5))]))
    return Gathered(mapper, points, looks, faces, flags, int(rng.choice((0, 0, ONE // 2, 12345, 2 * ONE))),
                    int(rng.integers(4, 50)), (2,))


def mesh_gather_trials(rng) -> list[Trial]:
    trials = []
    for k in range(90):
        mapper = ("flat", "gouraud", "affine", "lit")[k % 4]
        trials.append(gather_trial(Memory(), gathered(rng, mapper), f"{mapper}, number {k}"))
    return trials


def mesh_link_trials(rng) -> list[Trial]:
    trials = []
    for k in range(60):
        these = replace(gathered(rng, ("flat", "gouraud", "affine")[k % 3]), is_linked=True)
        trials.append(gather_trial(Memory(), these, f"number {k}"))
    return trials


def mesh_spread_trials(rng) -> list[Trial]:
    """Many of one order, orders of any size, and crowds beside one that is far away."""
    trials = []
    for k, count in enumerate((1, 2, 3, 40, 200) * 8):
        most = int(rng.choice((1, 30, 256, 257, 1 << 20, (1 << 32) - 1)))
        least = int(rng.integers(0, (1 << 32) - most))
        trials.append(spread_trial(Memory(), rng.integers(least, least + most + 1, count).tolist(),
                                   f"{count} orders, number {k}"))
    falling = [1 << 30, *range(120, 0, -1)]
    trials.append(spread_trial(Memory(), falling[:1] + falling[:0:-1], "few steps"))
    trials.append(spread_trial(Memory(), falling, "crowded", True))
    return trials


def trials() -> list[Trial]:
    makers = (mesh_snap_trials, mesh_gather_trials, mesh_transform_wide_trials, mesh_attributes_trials,
              mesh_cut_trials, mesh_project_trials, mesh_faces_wide_trials, mesh_transform_trials, mesh_faces_trials,
              mesh_mirror_trials, mesh_shade_trials,
              mesh_link_trials, mesh_spread_trials, mesh_orders_trials)
    return [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng(seed + 50))]
