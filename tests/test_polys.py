"""Polygons a second: every filler draws the model's pixels, at the speed promised."""

import pytest

from tools import polys


@pytest.fixture(scope="module")
def rows() -> dict[str, dict]:
    """The rows in fast RAM, by name, of fewer triangles than the baseline has."""
    return {row["name"]: row for row in polys.measure("a1200-fast", count=200)}


def test_every_filler_is_counted(rows) -> None:
    """All five, and seconds and cycles agree."""
    assert list(rows) == ["flat", "gouraud", "texture", "arbitrary", "tiled"]
    for row in rows.values():
        cycles = 1000 * row["kilocycles_per_polygon"]
        assert row["polygons_per_second"] == pytest.approx(polys.CLOCK_HZ / cycles, rel=0.002)


@pytest.mark.parametrize("name", ["flat", "gouraud"])
def test_fewer_cycles_than_the_pentium(rows, name: str) -> None:
    """Clock for clock."""
    assert rows[name]["kilocycles_per_polygon"] < rows[name]["pentium_kilocycles"]


def test_table_has_a_line_a_filler(rows) -> None:
    """Two columns a machine, and the Pentium's."""
    lines = polys.table(list(rows.values())).splitlines()
    assert len(lines) == 7 and all(line.count("|") == 5 for line in lines)
