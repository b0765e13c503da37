"""Pictures of the accuracy report: error against cycles, swimming, every mapper."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from tmap.base.outputs import save_animation
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.guest.emulator import MEASURED
from tmap.model.model import Settings
from tmap.run.run import picture_of, render
from tmap.scene_file.scene_file import Material, Object, Scene, Texture
from tmap.setup.shading import LIT

LEAST = 1e-6  # texels: smaller errors, 0 among them, are drawn as this on a logarithmic axis
MARKS = {"affine": "o", "arbitrary": "s", "tiled": "D", "columns": "^", "generated": "v",
         "lit": "p", "lit_gouraud": "h", "dithered": "*", "keyed": "d", "every16": "<", "every8": ">", "pixel": "P",
         "fine": "X"}


def drawn_by(row: dict) -> str:
    """Returns a row's perspective, or its mapper if it has no perspective or is lit."""
    return row["mapper"] if row["perspective"] == "none" or row["mapper"] in LIT else row["perspective"]


def plot(rows: list[dict], path: Path) -> None:
    """Plots error against cycles of the texture mappers: a panel a set, with the frontier."""
    machine = rows[-1]["machine"]
    names = list(dict.fromkeys(r["name"] for r in rows))
    columns = min(len(names), 4)
    lines = -(-len(names) // columns)
    figure, panels = plt.subplots(lines, columns, figsize=(4 * columns + 0.5, 3.8 * lines + 0.7),
                                  sharey=True, layout="constrained", squeeze=False)
    colours, marks = plt.get_cmap("tab20").colors, {}
    colours = colours[::2] + colours[1::2]
    for axes, name in zip(panels.flat, names):
        chosen = [r for r in rows if r["name"] == name and r["machine"] == machine
                  and drawn_by(r) in MARKS]
        for k, way in enumerate(MARKS):
            some = [r for r in chosen if drawn_by(r) == way]
            if some:
                marks[way] = axes.scatter([r["cycles_per_polygon"] / 1000 for r in some],
                                          [max(r["texel_error_rms"], LEAST) for r in some],
                                          marker=MARKS[way], s=28, alpha=0.75, color=colours[k])
        best = sorted((r for r in chosen if r["frontier"]), key=lambda r: r["cycles_per_polygon"])
        marks["frontier"], = axes.plot([r["cycles_per_polygon"] / 1000 for r in best],
                                       [max(r["texel_error_rms"], LEAST) for r in best], "k--", lw=1)
        axes.set_yscale("log")
        axes.set_title(f"{name}")
        axes.set_xlabel("thousand cycles a polygon")
        axes.grid(alpha=0.3)
    for axes in panels.flat[len(names):]:
        axes.axis("off")
    for axes in panels[:, 0]:
        axes.set_ylabel(f"rms error, texels ({machine})")
    order = [way for way in (*MARKS, "frontier") if way in marks]
    figure.legend([marks[way] for way in order], order, loc="outside lower center", ncols=2 * columns,
                  fontsize=9)
    figure.savefig(path, dpi=110)
    plt.close(figure)


#: Settings of the swimming picture's panels.
SWIMMERS = (Settings("integer", "polygon", "truncated", mapper="affine"),
            Settings("subpixel", "plane", "truncated", mapper="affine"),
            Settings("exact", "plane", "subtexel", mapper="affine"))
SWIM_FRAMES, SWIM_FRAME_MS = 24, 120
SWIM_SIDE = 64  # pixels of a panel


def swimming_scene() -> Scene:
    """Returns a small triangle that moves an eighth of a pixel a frame, under three settings."""
    texture = np.indices((256, 256)).sum(0) // 8 % 2 * 255  # stripes of 8 texels
    objects, materials, poses = [], [], []
    corners = [(6, 4, 0, 0, 0, 1), (52, 22, 92, 36, 0, 1), (17, 56, 22, 104, 0, 1)]
    vertices = [tuple(c << 16 for c in corner) for corner in corners]
    for number, s in enumerate(SWIMMERS):
        materials.append(Material(**vars(s), texture=0))
        objects.append(Object(number, 0, 3, len(poses), SWIM_FRAMES, 0))
        poses += [(65536, 0, 0, 65536, (number * SWIM_SIDE << 16) + k * 8192, k * 4096)
                  for k in range(SWIM_FRAMES)]
    grey = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, 1)
    return Scene(3 * SWIM_SIDE, SWIM_SIDE, SWIM_FRAMES, 96, grey,
                 [Texture(texture.astype(np.uint8), "page")], materials, objects,
                 np.array(vertices), np.array(poses))


def write_swimming(out: Path) -> None:
    """Writes swimming.gif and swimming.png, drawn on the emulated machine, five times as large."""
    scene = swimming_scene()
    frames = render(scene, MEASURED[-1], "addx").frames
    pictures = []
    for frame in frames:
        big = np.kron(frame, np.ones((5, 5), np.uint8))
        big[:, 5 * SWIM_SIDE::5 * SWIM_SIDE] = 255
        pictures.append(Image.fromarray(big))
    save_animation(out / "swimming.gif", pictures, SWIM_FRAME_MS)
    strip = np.concatenate([np.asarray(p) for p in pictures[::SWIM_FRAMES // 3][:3]])
    Image.fromarray(strip).save(out / "swimming.png")


def write_mappers(out: Path) -> None:
    """Writes mappers.png: a polygon of each mapper, rendered on the emulated machine."""
    scene = compile_scene(SCENES / "mappers.toml")
    (frame,) = render(scene, MEASURED[-1], "addx").frames
    picture_of(frame, scene).save(out / "mappers.png")
