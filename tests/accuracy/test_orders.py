"""The report on the order of meshes' faces."""

import numpy as np

from tmap.accuracy import orders
from tmap.compiler.scene import compile_scene


def test_report_shows_each_order(tmp_path, monkeypatch) -> None:
    """By depth pixels are wrong, by the tree none is, for more faces and cycles."""
    monkeypatch.setattr(orders, "compile_scene", lambda path, order: compile_scene(path, 5, order))
    text = orders.write(tmp_path, "a1200-fast", names=orders.NAMES)
    depth, tree = ([cell.strip() for cell in line.split("|")[2:-1]] for line in text.splitlines()[2:])
    assert (depth[0], tree[0]) == orders.ORDERS
    faces, nodes, mean, most, polygons, cycles = zip(*(
        [int(cell.replace(",", "")) for cell in row[1:]] for row in (depth, tree)))
    assert (nodes[0], mean[1], most[1]) == (0, 0, 0) and nodes[1] > 10 and most[0] >= mean[0] > 100
    assert faces[0] < faces[1] and polygons[0] < polygons[1] and 1_000_000 < cycles[0] < cycles[1]
    assert text in (tmp_path / "orders.md").read_text()


def test_wrong_pixels_are_those_of_a_drawing_by_hand() -> None:
    """Two squares before the eye, the near one half as wide: drawn first, all of its pixels are wrong."""
    near, far = (np.array([[-s, -s, d], [s, -s, d], [s, s, d], [-s, s, d]], float) for s, d in ((1, 4), (4, 8)))
    ways = np.stack([*np.meshgrid(np.linspace(-0.5, 0.5, 11), np.linspace(-0.5, 0.5, 11)), np.ones((11, 11))], -1)
    met = [orders.depths(corners, np.zeros(3), ways.reshape(-1, 3)) for corners in (near, far)]
    assert [int(np.isfinite(each).sum()) for each in met] == [25, 121]
    assert set(met[0]) == {4.0, np.inf} and set(met[1]) == {8.0}


def test_movers_are_right_by_z_alone(tmp_path, monkeypatch) -> None:
    """Where movers cross each other and walls, the tree alone leaves pixels wrong; by z none is, for more cycles."""
    monkeypatch.setattr(orders, "compile_scene", lambda path, order: compile_scene(path, 9, order))
    text = orders.write(tmp_path, "a1200-fast", names=("movers",))
    rows = [[cell.strip() for cell in line.split("|")[2:-1]] for line in text.splitlines()[2:]]
    assert [row[0] for row in rows] == [*orders.MOVERS["movers"]]
    wrong, cycles = ([int(row[k].replace(",", "")) for row in rows] for k in (4, 6))
    assert wrong[0] > wrong[1] > 100 and wrong[2] == 0, wrong
    assert cycles[0] < cycles[1] < cycles[2]
