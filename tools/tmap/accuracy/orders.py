"""What the order of meshes' faces costs and how right it is: scenes drawn in each order on the emulated
machine, and the pixels that show another face than the nearest (tmap.ideal.visible).
"""

from pathlib import Path

from tmap.base import markdown
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.ideal import visible
from tmap.run import run

#: Scenes, and, for each row, what takes the place of an order in the file.
ORDERS = {"rooms": {"depth": {"bsp": "depth"}, "bsp": {}},
          "movers": {"depth": {"bsp": "depth", "z": "depth"}, "bsp, movers by depth": {"z": "depth"},
                     "bsp, movers by z": {}},
          "keep": {"depth, movers by z": {"bsp": "depth"}, "bsp, movers by z": {}}}
ROWS = [name for name, orders in ORDERS.items() for _ in orders]  # one each
STEP = 4  # between the frames whose pixels are compared


def row(name: str, order: str, machine: str) -> list[str]:
    """Draws a scene in an order; returns its row of the table."""
    scene = compile_scene(SCENES / f"{name}.toml", order=ORDERS[name][order])
    wrong = [int(visible.wrong(scene, number).sum()) for number in range(0, scene.frames, STEP)]
    totals = run.total(run.render(scene, machine, "addx").figures)
    numbers = (len(scene.faces), len(scene.nodes), sum(wrong) / len(wrong), max(wrong),
               totals["polygons"] / scene.frames, totals["cycles"] / scene.frames)
    return [name, order, *(f"{number:,.0f}" for number in numbers)]


def write(folder: Path, machine: str, on_step=None, names=ORDERS) -> str:
    """Writes orders.md; returns its table."""
    rows = []
    for name in names:
        for order in ORDERS[name]:
            rows.append(row(name, order, machine))
            if on_step:
                on_step()
    text = markdown.table([f"scene, {machine}", "order", "faces", "nodes", "wrong pixels a frame", "at most",
                           "polygons a frame", "cycles a frame"], rows, "llrrrrrr")
    (folder / "orders.md").write_text(f"# The order of meshes' faces\n\n{text}\n")
    return text
