"""Scenes of random meshes: such as the compiler writes, and such as only a hostile file holds."""

from dataclasses import replace

import numpy as np

from tmap.compiler import views16
from tmap.model import mesh16
from tmap.scene_file.meshes import COLUMNS, ENVIRONMENT, LIT, Instance, Mesh
from tmap.scene_file.scene_file import IDENTITY, SETTINGS, Material, Object, Scene, Texture

ONE, UNIT = 1 << 16, 1 << 30
MATERIALS = [Material(colour=200), Material("affine", texture=0),
             Material("affine", "exact", "scanline", texture=0),
             Material("affine", "subpixel", "polygon", texture=0),
             Material("gouraud", "exact"), Material("affine", clip="vertices", texture=0),
             Material(edges="snapped", colour=100), Material("affine", "snapped", texture=0),
             Material("gouraud", "snapped")]


def box(half: int, corners: int = 4) -> tuple[list, list, list, list]:
    """Points, normals, corners and faces of a cube; each side is two triangles if ``corners`` is
    3."""
    points = [[x * half, y * half, z * half] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    normals, rows, faces = [], [], []
    texels = ((0, 0), (256 * ONE, 0), (256 * ONE, 256 * ONE), (0, 256 * ONE))
    for number, side in enumerate(sides):
        middle = np.sign(np.array(points)[list(side)].sum(axis=0))
        normals.append([*(middle * 16384).tolist(), 0])
        for part in ([(0, 1, 2, 3)] if corners == 4 else [(0, 1, 2), (0, 2, 3)]):
            faces.append([*(middle * UNIT).tolist(), half, len(rows), len(part)])
            rows += [[side[k], number, *texels[k]] for k in part]
    return points, normals, rows, faces


def turned(random) -> np.ndarray:
    q = np.linalg.qr(random.normal(size=(3, 3)))[0]
    return q * np.sign(np.linalg.det(q))


def view(random, away: float) -> list[int]:
    """A view of a mesh whose origin is about ``away`` from the eye, roughly in the middle of the
    frame."""
    turn = turned(random)
    move = np.array([*random.uniform(-1, 1, 2) * away, away])
    looks = [np.rint(turn[k] * 127 * 128) for k in (0, 1)] + [np.rint(turn[2] * 100 * 128)]
    return [*np.rint(turn * UNIT).astype(int).ravel().tolist(),
            *np.rint(move * ONE).astype(int).tolist(),
            *np.rint(-turn.T @ move * ONE).astype(int).tolist(),
            *np.array(looks).astype(int).ravel().tolist(), 0]


def base(random, side: int = 64) -> Scene:
    """A scene with materials and one map but no objects."""
    settings = SETTINGS["perspective"]
    materials = [replace(m, perspective=settings[random.integers(len(settings))])
                 if (m.mapper, m.gradients) == ("affine", "plane") and m.edges != "snapped" else m
                 for m in MATERIALS]
    return Scene(width=side, height=side // 4 * 3, frames=1, background=7,
                 palette=random.integers(0, 256, (256, 3)).astype(np.uint8),
                 textures=[Texture(random.integers(0, 256, (256, 256)).astype(np.uint8))],
                 materials=materials, objects=[], vertices=np.zeros((0, 6), np.int64),
                 poses=np.array([IDENTITY]), near_plane=int(random.choice((256, 9000, ONE))),
                 guard=int(random.integers(6, 11)))


def boxes(seed: int, frames: int = 4) -> Scene:
    """Cubes of all materials, some crossing the near plane and the guard band, some at the same
    depth, and two flat polygons among them."""
    random = np.random.default_rng(seed)
    scene = base(random)
    scene.frames = frames
    tables = {name: [] for name in ("points", "normals", "corners", "faces")}
    for corners in (4, 3):
        made = box(ONE, corners)
        firsts = [(len(stored), len(rows)) for stored, rows in zip(tables.values(), made)]
        scene.meshes.append(Mesh(*(n for pair in firsts for n in pair)))
        for stored, rows in zip(tables.values(), made):
            stored += rows
    for name, rows in tables.items():
        setattr(scene, name, np.array(rows))
    triangle = [[0, 0, 0, 0, 0, ONE], [30 * ONE, 0, 0, 0, 0, ONE], [0, 30 * ONE, 0, 0, 0, ONE]]
    scene.vertices = np.array(triangle)
    scene.poses = np.array([IDENTITY] * frames)
    scene.objects = [Object(0, 0, 3, 0, frames, 0)] * 2
    views = []
    for number in range(9):
        material = number % len(MATERIALS)
        flags = LIT if MATERIALS[material].mapper == "gouraud" else ENVIRONMENT * int(random.integers(2))
        mesh = 1 if material == 3 else int(random.integers(2))
        scene.instances.append(Instance(mesh, material, min(number // 3, 2), len(views), frames,
                                        0, flags, 20 * ONE, 220 * ONE))
        away = float(random.choice((0.3, 1.5, 4, 40)))
        row = view(random, away)
        views += [view(random, away) if number % 2 else row for _ in range(frames)]
    scene.views = np.array(views)
    return scene


def before(seed: int, frames: int = 4) -> Scene:
    """The same with the snapped cubes in the middle of the frame, some larger than it: with 16-bit operands
    where the tools use them."""
    random, scene = np.random.default_rng(seed + 100), boxes(seed, frames)
    for instance in scene.instances[6:]:
        for number in range(instance.view, instance.view + frames):
            away = 2.0 ** scene.guard * 1.8 / random.uniform(8, 40)
            move = np.array([*random.uniform(-0.1, 0.1, 2), 1]) * away
            turn = scene.views[number, :9].reshape(3, 3) / UNIT
            scene.views[number, 9:15] = np.rint([*move * ONE, *-turn.T @ move * ONE])
    scene.near_plane = ONE
    return views16.add(scene)


def trees(seed: int, frames: int = 4) -> Scene:
    """Boxes of which the first two are in one tree and the third is another. The planes are any, so that
    both orders of a node's parts come up; some nodes have no faces."""
    random, scene = np.random.default_rng(seed + 200), boxes(seed, frames)
    first = scene.instances[0]
    scene.instances[:3] = [replace(first, mesh=0, before=0, tree=0, slot=0),
                           replace(first, mesh=0, before=0, material=1, tree=0, slot=6),
                           replace(scene.instances[2], mesh=0, before=0, tree=5, slot=12)]
    counts = ((2, 2), (1, 0), (0, 0), (0, 1), (0, 0)), ((0, 0),)
    nodes = []
    for tree, faces in zip(counts, (12, 6)):
        ends = [0, *sorted(random.integers(0, faces + 1, len(tree) - 1).tolist()), faces]
        for (front, back), slot, end in zip(tree, ends, ends[1:]):
            nodes.append([*random.integers(-UNIT // 2, UNIT // 2, 3).tolist(), int(random.integers(-ONE, ONE)),
                          front, back, slot, end - slot])
    scene.nodes = np.array(nodes)
    scene.slots = np.concatenate([random.permutation(12), random.permutation(6)])[:, None]
    return scene


def hostile(seed: int) -> Scene:
    """Meshes that no compiler writes: random numbers wherever the file may hold them."""
    random = np.random.default_rng(seed)
    scene = base(random, 48)
    scene.materials = [m for m in scene.materials if m.gradients != "polygon"]
    sizes = random.choice((3, 4, 5, 31, 32), 40)
    count, points = int(sizes.sum()), 50

    def rows(table: str, most: dict, many: int) -> np.ndarray:
        return np.column_stack([random.integers(-most.get(c, 0), most.get(c, 0) + 1, many)
                                for c in COLUMNS[table]])

    near = int(random.choice((4 * ONE, 2048 * ONE)))
    scene.points = rows("points", dict.fromkeys("xyz", near), points)
    scene.normals = rows("normals", dict.fromkeys("xyz", 16384), 20)
    scene.corners = np.column_stack([random.integers(0, points, count), random.integers(0, 20, count),
                                     *random.integers(-2**31, 2**31, (2, count))])
    firsts = sizes.cumsum() - sizes
    planes = random.integers(-UNIT, UNIT + 1, (40, 3)) * random.integers(0, 2, (40, 1))
    distances = random.choice((-1, -2**31, 0, 2**31 - 1), 40)
    scene.faces = np.column_stack([planes, distances, firsts, sizes])
    scene.meshes = [Mesh(0, points, 0, 20, 0, count, 0, 40)]
    most = dict.fromkeys(COLUMNS["views"][:9], UNIT) | dict.fromkeys(("x0", "y0"), 2 * near) \
        | dict.fromkeys(COLUMNS["views"][12:15], 2**31 - 1) \
        | dict.fromkeys(COLUMNS["views"][15:24], 32767)
    count = len(scene.materials)
    scene.views = rows("views", most, count)
    scene.views[:, 11] = random.integers(0, 2 * near, count)
    flags = (0, ENVIRONMENT, LIT, ENVIRONMENT | LIT)
    scene.instances = [Instance(0, k, 0, k, 1, 0, LIT if scene.materials[k].mapper == "gouraud"
                                else flags[k % 4], 0, 255 * ONE, k) for k in range(count)]
    scene.views16 = rows16(random, count)
    return scene


def rows16(random, count: int) -> np.ndarray:
    """Views for 16-bit operands, of any numbers."""
    rows = np.column_stack([random.integers(-32768, 32768, count) for _ in COLUMNS["views16"]])
    for at in (mesh16.W, mesh16.X, mesh16.Y):
        rows[:, at] = random.integers(-2**31, 2**31, count)
        rows[:, at + 1:at + 4] >>= 1
        rows[:, at + 4] = random.integers(0, 32, count)
    rows[:, mesh16.W] = abs(rows[:, mesh16.W])
    rows[:, mesh16.DIVISOR_SHIFT] = random.integers(0, 12, count)
    return rows


def crowd(seed: int) -> Scene:
    """Triangles whose depths are almost or quite the same, and one far behind them."""
    random = np.random.default_rng(seed)
    scene, count = base(random), 200
    spread = int(random.choice((1, 40, 4000)))
    middles = np.column_stack([random.integers(-2 * ONE, 2 * ONE, (count, 2)),
                               random.integers(0, spread, count)])
    middles[0, 2] = 2000 * ONE
    ways = ((0, 0), (ONE, 0), (0, ONE))
    scene.points = np.array([[x + dx, y + dy, z] for x, y, z in middles for dx, dy in ways])
    scene.normals = np.array([[0, 0, 16384, 0]])
    scene.corners = np.column_stack([np.arange(3 * count), np.zeros((3 * count), int),
                                     *random.integers(0, 256 * ONE, (2, 3 * count))])
    scene.faces = np.array([[0, 0, 0, -1, 3 * k, 3] for k in range(count)])
    scene.meshes = [Mesh(0, 3 * count, 0, 1, 0, 3 * count, 0, count)]
    scene.views = np.array([[*(UNIT * np.eye(3, dtype=int)).ravel(), 0, 0, 8 * ONE, *[0] * 13]])
    scene.instances = [Instance(0, 7, 0, 0, 1, 0, 0, 0, 0)]
    return scene
