"""Checks the table that ``tmap accuracy`` writes of an engine's modes."""

from dataclasses import replace

from tmap.accuracy import accuracy, engines


def check(folder, capsys, monkeypatch, engine: str, modes: list) -> None:
    """ENGINE.md has one line for each mode, with its errors, as drawn by the machine; only for these
    modes: the bench draws all."""
    monkeypatch.setitem(engines.ENGINES, engine, replace(
        engines.ENGINES[engine], every={mode.name: mode for mode in modes}))
    assert accuracy.command(folder, [engine], "a1200-fast", False) == 0
    text = (folder / f"{engine}.md").read_text()
    lines = [line for line in text.splitlines() if line.startswith("| ")]
    assert len(lines) == 1 + len(modes) and lines[1] in capsys.readouterr().out
    for mode, line in zip(modes, lines[1:]):
        assert line.startswith(f"| {mode.title} | ") and line.count("|") == 7
