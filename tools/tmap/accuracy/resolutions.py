"""What a scene's pixels of 2x1, 1x2 and 2x2 save and what they cost: drawn on the emulated machine, and compared with
its picture in pixels of 1x1.

A larger pixel has the colour of its upper left one, so two kinds of errors add up: the pixels that are left out, and
the material's own errors, whose pieces are now of larger pixels.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.base import markdown
from tmap.base.paths import SCENES
from tmap.bench.scenes import some_frames
from tmap.compiler.scene import compile_scene
from tmap.compiler.space import SIZES
from tmap.guest.emulator import CLOCK_HZ
from tmap.run import conversion, run

NAMES = ("corridor", "floor", "cube", "keep")
ROWS = [(name, pixel) for name in NAMES for pixel in SIZES]
STEP = 8  # between the frames that are drawn: of 96, every 8th
SHOWN = 1  # of these, in the picture


def colours(scene, frame: np.ndarray) -> np.ndarray:
    """Returns a frame's colours on the screen, [row][x][3]."""
    return np.asarray(run.picture_of(frame, scene).convert("RGB"))


@dataclass(frozen=True)
class Difference:
    """How far pictures are from exact ones."""

    pixels: int = 0
    other: int = 0  # pixels of another colour
    squares: int = 0  # of all channels' differences

    @property
    def percent(self) -> float:
        """Pixels of another colour, of 100."""
        return 100 * self.other / self.pixels

    @property
    def rms(self) -> float:
        """The root of the channels' mean square, of 255."""
        return math.sqrt(self.squares / (3 * self.pixels))


def difference(made: Iterable[np.ndarray], exact: Iterable[np.ndarray]) -> Difference:
    """Compares frames' colours with exact ones."""
    pixels = other = squares = 0
    for one, best in zip(made, exact, strict=True):
        off = one.astype(int) - best
        pixels += off[..., 0].size
        other += int(off.any(axis=-1).sum())
        squares += int((off * off).sum())
    return Difference(pixels, other, squares)


def row(name: str, pixel: str, machine: str, exact: list[np.ndarray]) -> tuple[list[str], list[np.ndarray]]:
    """Draws a scene in pixels of a size; returns its row of the table and its frames' colours. ``exact``: those in
    pixels of 1x1; empty for these themselves."""
    whole = compile_scene(SCENES / f"{name}.toml", keys={"pixel": pixel})
    scene = some_frames(whole, list(range(0, whole.frames, STEP)))
    drawn = run.render(scene, machine, "addx")
    made = [colours(scene, frame) for frame in drawn.frames]
    drawing = run.total(drawn.figures)["cycles"] / scene.frames
    showing = conversion.cycles(scene, machine, drawing)
    off = difference(made, exact or made)
    figures = [f"{drawing:,.0f}", f"{showing:,.0f}", f"{CLOCK_HZ / (drawing + showing):.1f}",
               f"{off.percent:.1f}", f"{off.rms:.1f}"]
    return [name, pixel, *figures], made


def picture(shown: list[np.ndarray]) -> Image.Image:
    """Returns a frame in pixels of each size, two side by side."""
    made = [np.hstack(shown[k:k + 2]) for k in range(0, len(shown), 2)]
    return Image.fromarray(np.vstack(made))


def write(folder: Path, machine: str, on_step=None, names=NAMES) -> str:
    """Writes resolutions.md and a picture of each scene; returns the table."""
    rows, pictures = [], ""
    for name in names:
        exact, shown = [], []
        for pixel in SIZES:
            figures, made = row(name, pixel, machine, exact)
            exact = exact or made
            rows.append(figures)
            shown.append(made[min(SHOWN, len(made) - 1)])
            if on_step:
                on_step()
        picture(shown).save(folder / f"{name}_resolutions.png")
        pictures += f"\n## {name}: {', '.join(SIZES)}\n\n![{name}]({name}_resolutions.png)\n"
    text = markdown.table([f"scene, {machine}", "pixels", "cycles to draw", "to convert, shown", "frames a second",
                           "other colours, %", "rms, of 255"], rows, "llrrrrr")
    (folder / "resolutions.md").write_text(f"# Larger pixels\n\n{text}\n{pictures}")
    return text
