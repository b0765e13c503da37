"""The picture of ``tmap fit``: error against frames a second."""

from pathlib import Path

import matplotlib.pyplot as plt

from tmap.accuracy.fit.search import Found
from tmap.compiler.space import SIZES
from tmap.guest.emulator import CLOCK_HZ

COLOURS = dict(zip(SIZES, plt.get_cmap("tab10").colors))
MARKS = dict(zip(SIZES, "osD^"))


def frontier(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Returns the points, frames a second and error, that no other beats."""
    made = []
    for rate, error in sorted(points, key=lambda point: (-point[0], point[1])):
        if not made or error < made[-1][1]:
            made.append((rate, error))
    return made


def plot(found: Found, name: str, fps: float, machine: str, path: Path) -> None:
    """Plots all trials, by the frames that all of them have, and what was predicted of other choices; marks the goal,
    the scene as it is, and the choice."""
    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    trials = {trial.choice: trial.of(found.numbers) for trial in found.trials if {*found.numbers} <= {*trial.numbers}}
    at = {choice: (trial.rates[0], trial.off.rms) for choice, trial in trials.items()}
    guessed = [(CLOCK_HZ / each.worst, each.rms, each.choice.pixel) for each in found.predicted
               if each.choice not in at]
    for pixel in SIZES:
        axes.scatter(*zip(*[each[:2] for each in guessed if each[2] == pixel] or [((), ())]), marker=".", s=12,
                     alpha=0.3, color=COLOURS[pixel], linewidths=0)
        some = [point for choice, point in at.items() if choice.pixel == pixel]
        if some:
            axes.scatter(*zip(*some), marker=MARKS[pixel], s=40, alpha=0.8, color=COLOURS[pixel],
                         label=f"pixels of {pixel}")
    axes.step(*zip(*frontier([*at.values(), *(each[:2] for each in guessed)])), "k--", lw=1, where="post",
              label="frontier")
    axes.axvline(fps, color="grey", lw=1)
    axes.text(fps, 1.01, f"{fps:g}", transform=axes.get_xaxis_transform(), ha="center", fontsize=10)
    said = ((found.own, "as it is", (12, 10)), (found.best, "chosen" if found.holds else "nearest", (12, -18)))
    for trial, text, place in said:
        if trial:
            axes.scatter(*at[trial.choice], s=190, facecolors="none", edgecolors="k", linewidths=1.5)
            axes.annotate(text, at[trial.choice], xytext=place, textcoords="offset points", fontsize=11, weight="bold")
    axes.margins(x=0.12, y=0.1)
    frames = ", ".join(map(str, found.numbers))
    axes.set_xlabel(f"frames a second on the screen of {machine}, the worst of frames {frames}")
    axes.set_ylabel("error of colours, rms, of 255")
    axes.set_title(f"{name} at {fps:g} frames a second: measured, and predicted (small)", pad=20)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=10)
    figure.savefig(path, dpi=110)
    plt.close(figure)
