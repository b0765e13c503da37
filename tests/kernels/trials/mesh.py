"""Trials of src68k/mesh against tools/tmap/model/mesh.py, which is held to exact numbers elsewhere."""

from types import SimpleNamespace

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import M32, Case
from tmap.model import mesh
from tmap.scene_file.scene_file import records

ONE, UNIT = 1 << 16, 1 << 30
REACH, AWAY = 2048 * ONE, 10240 * ONE - 1


def long(value: int) -> bytes:
    return (value & M32).to_bytes(4, "big")


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


def packed(struct: str, rows) -> bytes:
    """Rows of a table of the scene file."""
    return records(rows, layout.load().struct(struct))


def outside(point, near: int) -> int:
    found = mesh.depths(point.x, point.y, point.w, near)
    return sum(1 << k for k, depth in enumerate(found) if depth < 0)


def points_of(rng, count: int) -> list[tuple[int, ...]]:
    most = REACH if rng.integers(2) else 4 * ONE
    return [tuple(number(rng, most) for _ in range(3)) for _ in range(count)]


def mesh_transform_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 3, 40) * 12:
        about, row, points = scene(rng), view(rng), points_of(rng, count)
        memory, size = Memory(), layout.load().struct("mesh_point").size
        to = memory.room("mesh_point", count)
        view_at = memory.add(packed("scene_view", [row]), name="view")
        from_at = memory.add(packed("scene_point", points), name="points")
        plan = memory.struct("transform_plan", {"from": from_at, "view": view_at, "to": to},
                             count=count, near_plane=about.near_plane, guard=about.guard,
                             middle_x=about.width << 15, middle_y=about.height << 15)
        writes = []
        for k, p in enumerate(mesh.transform(about, points, row)):
            at = to + size * k
            writes.append(Write(at, b"".join(map(long, (p.x, p.y, p.w, *(p.screen or ()))))))
            writes.append(Write(at + 20, long(outside(p, about.near_plane))))
        trials.append(Trial(Case("mesh_transform", memory, pointers={"a0": plan}),
                            f"{count} points", writes=writes))
    return trials


def mesh_looks_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 33) * 12:
        most = 1 << 14
        normals = [(*(number(rng, most) for _ in range(3)), 0) for _ in range(count)]
        factors = [number(rng, 32767) for _ in range(3)]
        base, low = int(rng.integers(0, 256 * ONE)), int(rng.choice((-1 << 31, 0, 40 * ONE)))
        high = int(rng.choice((low, 200 * ONE, (1 << 31) - 1)))
        memory, size = Memory(), layout.load().struct("mesh_look").size
        to = memory.room("mesh_look", count)
        from_at = memory.add(packed("scene_normal", normals), name="normals")
        factors_at = memory.add(np.array(factors, ">i2").tobytes(), name="factors")
        plan = memory.struct("look_plan", {"from": from_at, "to": to + 4, "factors": factors_at},
                             count=count, base=base, low=low, high=high)
        made = mesh.looks(normals, factors, base, low, high)
        trials.append(Trial(Case("mesh_looks", memory, pointers={"a0": plan}), f"{count} normals",
                            writes=[Write(to + 4 + size * k, long(v)) for k, v in enumerate(made)]))
    return trials


def vertex(rng) -> list[int]:
    return [number(rng, (1 << 30) - 1) for _ in range(6)]


def mesh_cut_trials(rng) -> list[Trial]:
    trials = []
    for k in range(80):
        inside, beyond = vertex(rng), vertex(rng)
        whole = int(rng.integers(1, 1 << int(rng.integers(1, 33))))
        part = min(whole - 1, (1 << 31) - 1, int(rng.integers(0, whole)))
        part = (0, whole - 1, part, part)[k % 4]
        part = min(part, (1 << 31) - 1)
        if k % 5 == 0:
            beyond[:3] = inside[:3]
        memory = Memory()
        shape = layout.load().struct("vertex")
        ends = [memory.add(b"".join(map(long, v)), name=n)
                for v, n in ((inside, "inside"), (beyond, "outside"))]
        to = memory.add(memory.noise.bytes(shape.size), name="to", shape=shape)
        plan = memory.struct("cut_plan", {"to": to, "inside": ends[0], "outside": ends[1]},
                             part=part, whole=whole)
        way = [(abs(b - a) * part + (whole >> 1)) // whole for a, b in zip(inside, beyond)]
        made = [a + w if b > a else a - w for a, b, w in zip(inside, beyond, way)]
        trials.append(Trial(Case("mesh_cut", memory, pointers={"a0": plan}),
                            f"part {part} of {whole}", writes=[Write(to, b"".join(map(long, made)))]))
    return trials


def face(rng, first: int, corners: int) -> list[int]:
    """A face of any plane, or one seen from both sides."""
    if rng.integers(4) == 0:
        return [0, 0, 0, -1, first, corners]
    return [*(number(rng, UNIT) for _ in range(3)), number(rng, 12000 * ONE), first, corners]


def mesh_faces_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 30) * 10:
        about, row, points = scene(rng), view(rng), points_of(rng, 12)
        made = mesh.transform(about, points, row)
        sizes = rng.choice((3, 3, 4, 5, 32), count).tolist()
        corners = [(int(rng.integers(0, 12)), 0, 0, 0) for _ in range(sum(sizes))]
        firsts = (np.cumsum(sizes) - sizes).tolist()
        faces = [face(rng, first, size) for first, size in zip(firsts, sizes)]
        memory = Memory()
        shapes = {name: layout.load().struct(name) for name in ("mesh_face", "scene_face")}
        stored = [[p.x, p.y, p.w, 0, 0, outside(p, about.near_plane), 0, 0] for p in made]
        points_at = memory.add(b"".join(long(v) for p in stored for v in p), name="points")
        corners_at = memory.add(packed("scene_corner", corners), name="corners")
        faces_at = memory.add(packed("scene_face", faces), name="faces")
        view_at = memory.add(packed("scene_view", [row]), name="view")
        placed = memory.struct("mesh_placed", {"corners": corners_at, "points": points_at},
                               mesh=0, material=0, looks=0, flags=0)
        to = memory.room("mesh_face", count)
        plan = memory.struct("faces_plan", {"from": faces_at, "placed": placed, "view": view_at,
                                            "to": to}, count=count)
        seen = []
        for k, (first, size) in enumerate(zip(firsts, sizes)):
            used = [made[point] for point, *_ in corners[first:first + size]]
            common = np.bitwise_and.reduce([outside(p, about.near_plane) for p in used])
            if mesh.is_seen(faces[k], row) and not common:
                seen.append((~max(0, *(p.w for p in used)) & M32, faces_at + k
                             * shapes["scene_face"].size, placed))

        def also(result, seen=seen, to=to):
            found = np.frombuffer(result.memory, ">u4", 3 * len(seen), to).reshape(-1, 3).tolist()
            wanted = [[order, at + result.address & M32, placed + result.address & M32]
                      for order, at, placed in seen]
            wrong = [k for k, (a, b) in enumerate(zip(found, wanted)) if a != b]
            return f"face {wrong[0]} of {len(seen)} seen: expected order, face and placed " \
                   f"{wanted[wrong[0]]}, found {found[wrong[0]]}" if wrong else None

        size = len(seen) * shapes["mesh_face"].size
        writes = [Write(to, bytes(size), bytes(size))] if size else []
        trials.append(Trial(Case("mesh_faces", memory, pointers={"a0": plan}), f"{count} faces",
                            {"d0": len(seen)}, writes=writes, also=also))
    return trials


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    makers = mesh_transform_trials, mesh_looks_trials, mesh_cut_trials, mesh_faces_trials
    return [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng(seed + 50))]
