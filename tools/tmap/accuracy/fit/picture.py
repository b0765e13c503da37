"""The picture of ``tmap fit``: error against frames a second."""

from pathlib import Path

import matplotlib.pyplot as plt

from tmap.accuracy.fit.search import Found
from tmap.compiler.space import SIZES

MARKS = dict(zip(SIZES, "osD^"))


def frontier(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Returns the points, frames a second and error, that no other beats."""
    made = []
    for rate, error in sorted(points, key=lambda point: (-point[0], point[1])):
        if not made or error < made[-1][1]:
            made.append((rate, error))
    return made


def plot(found: Found, name: str, fps: float, machine: str, path: Path) -> None:
    """Plots all trials; marks the goal, the scene as it is, and the choice."""
    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    at = {id(trial): (trial.rates[0], trial.off.rms) for trial in found.trials}
    for pixel, colour in zip(SIZES, plt.get_cmap("tab10").colors):
        some = [at[id(trial)] for trial in found.trials if trial.choice.pixel == pixel]
        if some:
            axes.scatter(*zip(*some), marker=MARKS[pixel], s=40, alpha=0.75, color=colour, label=f"pixels of {pixel}")
    axes.plot(*zip(*frontier(list(at.values()))), "k--", lw=1, label="frontier")
    axes.axvline(fps, color="grey", lw=1)
    axes.text(fps, 1.01, f"{fps:g}", transform=axes.get_xaxis_transform(), ha="center", fontsize=10)
    said = ((found.own, "as it is"), (found.best, "chosen" if found.holds else "nearest"))
    for k, (trial, text) in enumerate(said):
        if trial:
            axes.scatter(*at[id(trial)], s=190, facecolors="none", edgecolors="k", linewidths=1.5)
            axes.annotate(text, at[id(trial)], xytext=(12, 12 - 30 * k), textcoords="offset points", fontsize=11,
                          weight="bold")
    axes.set_xlabel(f"frames a second on the screen of {machine}, worst frame")
    axes.set_ylabel("error of colours, rms, of 255")
    axes.set_title(f"{name} at {fps:g} frames a second", pad=20)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=10)
    figure.savefig(path, dpi=110)
    plt.close(figure)
