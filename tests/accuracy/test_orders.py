"""The report on the order of meshes' faces."""

from tmap.accuracy import orders
from tmap.compiler.scene import compile_scene


def test_report_shows_each_order(tmp_path, monkeypatch) -> None:
    """By depth pixels are wrong, by the tree none is, for more faces and cycles."""
    monkeypatch.setattr(orders, "compile_scene", lambda path, order: compile_scene(path, 5, order))
    text = orders.write(tmp_path, "a1200-fast", names=("rooms",))
    depth, tree = ([cell.strip() for cell in line.split("|")[2:-1]] for line in text.splitlines()[2:])
    assert (depth[0], tree[0]) == tuple(orders.ORDERS["rooms"])
    faces, nodes, mean, most, polygons, cycles = zip(*(
        [int(cell.replace(",", "")) for cell in row[1:]] for row in (depth, tree)))
    assert (nodes[0], mean[1], most[1]) == (0, 0, 0) and nodes[1] > 10 and most[0] >= mean[0] > 100
    assert faces[0] < faces[1] and polygons[0] < polygons[1] and 1_000_000 < cycles[0] < cycles[1]
    assert text in (tmp_path / "orders.md").read_text()


def test_movers_are_right_by_z_alone(tmp_path, monkeypatch) -> None:
    """Where movers cross each other and walls, the tree alone leaves pixels wrong; by z none is, for more cycles."""
    monkeypatch.setattr(orders, "compile_scene", lambda path, order: compile_scene(path, 9, order))
    text = orders.write(tmp_path, "a1200-fast", names=("movers",))
    rows = [[cell.strip() for cell in line.split("|")[2:-1]] for line in text.splitlines()[2:]]
    assert [row[0] for row in rows] == [*orders.ORDERS["movers"]]
    wrong, cycles = ([int(row[k].replace(",", "")) for row in rows] for k in (4, 6))
    assert wrong[0] > wrong[1] > 100 and wrong[2] == 0, wrong
    assert cycles[0] < cycles[1] < cycles[2]
