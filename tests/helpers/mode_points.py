"""Point samples of texture units' modes, which may be wrong only where rounding of the planes
explains it; and the table that ``tmap accuracy`` writes of modes."""

from dataclasses import replace

import numpy as np

from tmap.accuracy import accuracy, engines
from tmap.bench.modes.measure import HEIGHT, WIDTH
from tmap.ideal import ideal
from tmap.model import model


def raised(corners, x: int, y: int, key: int) -> float:
    """Returns by how much s (``key`` 2) or t (3) of a triangle may exceed its exact value at a
    pixel, in texels."""
    made = model.set_up([c[:4] for c in corners], WIDTH, HEIGHT, True, model.Settings("exact"))
    three = [corners[k] for k in ideal.corners(corners)]
    plane = ideal.Plane([c[:2] for c in three], [c[key] for c in three])
    return plane.bound(x, y, made.texturing, made.texturing.cuts[key - 2])


def check(mode, errors, kind: str, surface) -> None:
    """Asserts that every pixel shows the intended texel. A pixel may show the next one if s or t is
    closer to it than its plane may be raised there. ``errors``: the engine's module; ``surface``:
    the exact s and t."""
    on = errors.pixels_of(mode, kind)
    drawn, meant = errors.colours_of(mode, kind)
    s_and_t = surface(on).at(on.x, on.y)
    for k in np.flatnonzero((drawn[:, :3] != meant[:, :3]).any(-1)):
        x, y = int(on.x[k]), int(on.y[k])
        below = [1 - c.fraction[k] for c in s_and_t]
        may = [raised(mode.vertices[:3], x, y, key) for key in (2, 3)]
        assert below[0] <= may[0] or below[1] <= may[1], (
            f"mode {mode.name}, {kind}, pixel ({x}, {y}): expected {meant[k]}, found {drawn[k]}; s and t "
            f"are {below} texels below the next ones and raised by {may}")


def check_table(folder, capsys, monkeypatch, engine: str, modes: list) -> None:
    """ENGINE.md has one line for each mode, with its errors, as drawn by the machine; only for
    these modes: the bench draws all."""
    monkeypatch.setitem(engines.ENGINES, engine, replace(
        engines.ENGINES[engine], every={mode.name: mode for mode in modes}))
    assert accuracy.command(folder, [engine], "a1200-fast", False) == 0
    text = (folder / f"{engine}.md").read_text()
    lines = [line for line in text.splitlines() if line.startswith("| ")]
    assert len(lines) == 1 + len(modes) and lines[1] in capsys.readouterr().out
    for mode, line in zip(modes, lines[1:]):
        assert line.startswith(f"| {mode.title} | ") and line.count("|") == 7
