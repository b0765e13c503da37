"""A turning face by the methods of the Italian note, and by every perspective.

Simone Aversa's note for the A1200 has three methods: gradients of the polygon with u = k + a / c,
two divides a scanline, and two divides a polygon, by its longest scanline. The last two show the
diagonal along which the face is cut into triangles. All draw the same triangles
(tests/scenes/face.toml) on the emulated machine. Errors are against the exact curve, over all
frames.
"""

import json
import zlib
from dataclasses import dataclass, replace
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from tmap.accuracy import scene_errors
from tmap.accuracy.errors import Errors
from tmap.base import markdown
from tmap.base.outputs import save_animation
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model.model import Settings
from tmap.run.run import render
from tmap.scene_file.scene_file import Scene

#: Captions, in the note's words and ours, and settings. Names of the note's methods begin with
#: their number.
#: Those with perspective have sub-pixel edges: with exact ones the face is drawn by columns, all alike.
METHODS = {"3: two divides a polygon": Settings("exact", "polygon"),
           "2: two divides a scanline": Settings("exact", "scanline"),
           "affine, from the plane": Settings("exact"),
           "every 16 pixels": Settings("subpixel", perspective="every16"),
           "every 8 pixels": Settings("subpixel", perspective="every8"),
           "1: each pixel": Settings("subpixel", perspective="pixel"),
           "each pixel, fine": Settings("subpixel", perspective="fine")}
SHOWN = 4  # number of the frame in the picture


def is_of_the_note(name: str) -> bool:
    """Returns True if a method is one of the note's: only their names begin with a number."""
    return name[0].isdigit()


@dataclass
class Method:
    """One method's frames, cycles and errors."""

    name: str
    frames: np.ndarray  # uint8 (frames, height, width, 3)
    cycles: float  # of a frame
    errors: Errors


def scene_of(settings: Settings) -> Scene:
    """Returns the scene of the face, drawn with other settings."""
    scene = compile_scene(SCENES / "face.toml")
    return replace(scene, materials=[replace(m, **vars(settings) | {"mapper": m.mapper})
                                     for m in scene.materials])


def measure(machine: str, on_step=None) -> list[Method]:
    """Draws all methods on a machine."""
    made = []
    for name, settings in METHODS.items():
        scene = scene_of(settings)
        drawn = render(scene, machine, "addx")
        spent = sum(figure["cycles"] for figure in drawn.figures) / scene.frames
        made.append(Method(name, scene.palette[np.stack(drawn.frames)], spent,
                           scene_errors.errors_of(scene, 1, True)))
        if on_step:
            on_step()
    return made


def table(methods: list[Method], machine: str) -> str:
    """Returns the figures in Markdown."""
    rows = []
    for m in methods:
        wrong = 100 * m.errors.wrong / max(m.errors.pixels, 1)
        rows.append([m.name, f"{m.cycles:,.0f}", f"{m.errors.worst:.3f}", f"{m.errors.rms:.4f}",
                     f"{wrong:.2f} %"])
    return markdown.table([f"method, {machine}", "cycles a frame", "largest error, texels", "rms",
                           "wrong texels"], rows)


def described(methods: list[Method]) -> dict[str, dict]:
    """Returns the figures in the picture's captions, and the CRC of the frame shown, by method."""
    return {m.name: {"cycles": m.cycles, "worst": round(m.errors.worst, 6),
                     "rms": round(m.errors.rms, 6),
                     "frame": zlib.crc32(m.frames[SHOWN].tobytes())} for m in methods}


def write_picture(methods: list[Method], path: Path) -> None:
    """Writes a frame of each method, captioned with its error and cycles."""
    columns = 4
    rows = -(-len(methods) // columns)
    figure, panels = plt.subplots(rows, columns, figsize=(12, 3.6 * rows), layout="constrained")
    for axes in panels.flat:
        axes.axis("off")
    for axes, m in zip(panels.flat, methods):
        axes.imshow(m.frames[SHOWN], interpolation="nearest")
        axes.set_title(f"{m.name}\n{m.cycles / 1000:,.0f} thousand cycles\n"
                       f"error {m.errors.worst:.3g} texels, rms {m.errors.rms:.2g}",
                       fontsize=10, y=-0.24)
    figure.savefig(path, dpi=100, bbox_inches="tight", pad_inches=0.05,
                   metadata={"Description": json.dumps(described(methods))})
    plt.close(figure)


def write_animation(methods: list[Method], path: Path) -> None:
    """Writes the note's three methods side by side, played forwards and backwards."""
    three = sorted((m for m in methods if is_of_the_note(m.name)), key=lambda m: m.name)
    strips = np.concatenate([m.frames for m in three], axis=2)
    pictures = [Image.fromarray(np.kron(strip, np.ones((2, 2, 1), np.uint8)))
                for strip in [*strips, *strips[-2:0:-1]]]
    save_animation(path, pictures, 80)


def write(folder: Path, machine: str, on_step=None) -> str:
    """Writes methods.png, methods.gif and methods.md; returns the table."""
    methods = measure(machine, on_step)
    write_picture(methods, folder / "methods.png")
    write_animation(methods, folder / "methods.gif")
    text = table(methods, machine)
    (folder / "methods.md").write_text(
        "# A turning face\n\n" + text + "\n\n![each method](methods.png)\n\n"
        "The note's methods 1, 2 and 3, from left to right:\n\n![animation](methods.gif)\n")
    return text
