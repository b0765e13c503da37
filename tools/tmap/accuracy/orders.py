"""What the order of meshes' faces costs and how right it is: scenes drawn in each order on the emulated
machine, and the pixels where the face drawn last is not the nearest.

Rays and faces are in floating point. Faces whose places on a ray differ by less than SAME count as equally
near, and at pixels less than SAME beside a drawn face's edge either is right: more than rounded corners of
trees are off (tools/tmap/trees/polygons.py), and, as they are on an edge side by side, the edges between them.
Scenes with movers are compared by tmap.accuracy.movers.
"""

from pathlib import Path

import numpy as np

from tmap.accuracy import movers
from tmap.base import markdown
from tmap.base.linear import product
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import mesh, trees
from tmap.run import run
from tmap.scene_file.meshes import UNIT_30
from tmap.scene_file.scene_file import ONE, Scene

NAMES = ("rooms",)  # scenes whose meshes are all in one space
ORDERS = ("depth", "bsp")
#: Scenes with movers, and, for each row, what takes the place of an order in the file.
MOVERS = {"movers": {"depth": {"bsp": "depth", "z": "depth"}, "bsp, movers by depth": {"z": "depth"},
                     "bsp, movers by z": {}}}
ROWS = [name for name in (*NAMES, *MOVERS) for _ in MOVERS.get(name, ORDERS)]  # one each
STEP = 4  # between the frames whose pixels are compared
SAME = 1e-3  # of a unit along the ray


def in_order(scene: Scene, number: int) -> list[np.ndarray]:
    """Returns the corners, in the meshes' space, of the faces that are drawn in a frame, in drawing order.
    All instances are seen from one space, and drawn together."""
    drawn = []
    for instance in scene.instances:
        of = scene.meshes[instance.mesh]
        for depth, _, which in mesh.faces_of(scene, instance, number):
            row = scene.faces[of.face + which]
            points = scene.corners[of.corner + row[4]:of.corner + row[4] + row[5], 0]
            key = -depth if instance.tree < 0 else int(scene.slots[instance.slot + which, 0])
            drawn.append((key, scene.points[of.point + points] / ONE))
    if scene.instances[0].tree >= 0:
        eye = scene.views[scene.instances[0].view + number].tolist()[12:15]
        rank = {slot: k for k, slot in enumerate(trees.walk(scene.nodes.tolist(), 0, eye))}
        drawn = [(rank[slot], corners) for slot, corners in drawn]
    return [corners for _, corners in sorted(drawn, key=lambda pair: pair[0])]


def rays(scene: Scene, number: int, step: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns the eye and, for every ``step``-th pixel each way, the way from it, both in the meshes' space."""
    view = scene.views[scene.instances[0].view + number]
    y, x = np.mgrid[0:scene.height:step, 0:scene.width:step]
    across = [(c + 0.5 - side / 2) / 2.0 ** scene.guard for c, side in ((x, scene.width), (y, scene.height))]
    rows = view[:9].reshape(3, 3) / UNIT_30  # at right angles
    ways = product(np.stack([*across, np.ones(x.shape)], -1).reshape(-1, 3), rows / (rows * rows).sum(axis=1)[:, None])
    return view[12:15] / ONE, ways


def depths(corners: np.ndarray, eye: np.ndarray, ways: np.ndarray, beside: float = 0.0) -> np.ndarray:
    """Returns how far along each ray a face is met, or what is not more than ``beside`` from its edges;
    infinity where it is not."""
    normal = np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        far = product(corners.mean(axis=0) - eye, normal) / product(ways, normal)
        places = eye + far[:, None] * ways
        inside = far > 0
        for a, b in zip(corners, np.roll(corners, -1, axis=0)):
            across = np.cross(normal, b - a)
            inside &= product(places - a, across) >= -beside * np.sqrt((across * across).sum())
    return np.where(inside, far, np.inf)


def wrong_pixels(scene: Scene, whole: Scene, number: int, step: int = 1) -> int:
    """Returns how many of the pixels show another face than the nearest. ``whole``: the same meshes without
    splits."""
    eye, ways = rays(scene, number, step)
    nearest = np.full(len(ways), np.inf)
    for corners in in_order(whole, number):
        nearest = np.minimum(nearest, depths(corners, eye, ways))
    size = np.sqrt((ways * ways).sum(axis=1))
    wrong = np.isfinite(nearest)
    for beside in (0.0, SAME):
        shown = np.full(len(ways), np.inf)
        for corners in in_order(scene, number):
            met = depths(corners, eye, ways, beside)
            shown = np.where(np.isfinite(met), met, shown)
        with np.errstate(invalid="ignore"):
            wrong &= shown * size > nearest * size + SAME
    return int(wrong.sum())


def row(name: str, order: str, machine: str) -> list[str]:
    """Draws a scene in an order; returns its row of the table."""
    if name in MOVERS:
        scene = compile_scene(SCENES / f"{name}.toml", order=MOVERS[name][order])
        wrong = [movers.wrong_pixels(scene, number) for number in range(0, scene.frames, STEP)]
    else:
        scene, whole = (compile_scene(SCENES / f"{name}.toml", order=each) for each in (order, "depth"))
        wrong = [wrong_pixels(scene, whole, number) for number in range(0, scene.frames, STEP)]
    totals = run.total(run.render(scene, machine, "addx").figures)
    numbers = (len(scene.faces), len(scene.nodes), sum(wrong) / len(wrong), max(wrong),
               totals["polygons"] / scene.frames, totals["cycles"] / scene.frames)
    return [name, order, *(f"{number:,.0f}" for number in numbers)]


def write(folder: Path, machine: str, on_step=None, names=(*NAMES, *MOVERS)) -> str:
    """Writes orders.md; returns its table."""
    rows = []
    for name in names:
        for order in MOVERS.get(name, ORDERS):
            rows.append(row(name, order, machine))
            if on_step:
                on_step()
    text = markdown.table([f"scene, {machine}", "order", "faces", "nodes", "wrong pixels a frame", "at most",
                           "polygons a frame", "cycles a frame"], rows, "llrrrrrr")
    (folder / "orders.md").write_text(f"# The order of meshes' faces\n\n{text}\n")
    return text
