"""Polygons a second: every filler is timed only if it draws the model's pixels, and is as fast as
promised."""

import numpy as np
import pytest

from tmap.accuracy import polys
from tmap.base.errors import UserError


@pytest.fixture(scope="module")
def rows() -> dict[str, dict]:
    """The rows in fast RAM, by name, with fewer triangles than the baseline."""
    return {row["name"]: row for row in polys.measure("a1200-fast", count=200)}


def test_every_filler_is_counted(rows) -> None:
    """All five fillers. Seconds and cycles agree, except for rounding: thousands of cycles to
    hundredths, polygons to tenths."""
    assert list(rows) == ["flat", "gouraud", "texture", "arbitrary", "tiled"]
    for name, row in rows.items():
        cycles = 1000 * row["kilocycles_per_polygon"]
        least, most = (polys.CLOCK_HZ / (cycles + off) for off in (5, -5))
        assert least - 0.05 <= row["polygons_per_second"] <= most + 0.05, (name, row)


def test_a_wrong_picture_is_no_figure(monkeypatch) -> None:
    right = polys.frames

    def wrong(row: str, count: int) -> list[np.ndarray]:
        empty, full = right(row, count)
        full = full.copy()
        full[-1, -1] ^= 1
        return [empty, full]

    monkeypatch.setattr(polys, "frames", wrong)
    with pytest.raises(UserError, match="polys: flat on a1200-fast: frame 1: 1 pixels are not the model's; pixel"):
        polys.measure("a1200-fast", count=2)


@pytest.mark.parametrize("name", ["flat", "gouraud"])
def test_fewer_cycles_than_the_pentium(rows, name: str) -> None:
    assert rows[name]["kilocycles_per_polygon"] < rows[name]["pentium_kilocycles"]


def test_table_has_a_line_a_filler(rows) -> None:
    """Two columns a machine, and the Pentium's."""
    _, _, *lines = polys.table(list(rows.values())).splitlines()
    for line, (name, row) in zip(lines, rows.items(), strict=True):
        assert line == (f"| {name} | {row['polygons_per_second']:.0f} | "
                        f"{row['kilocycles_per_polygon']:.1f} | {row['pentium_kilocycles']} |")
