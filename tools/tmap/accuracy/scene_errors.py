"""The scenes of effects and depth, drawn on the emulated machine: animations, cycles, errors.

Errors are against the exact curve if a material has a perspective, and else against the exact
plane, over every ERROR_STEP-th frame. Texture engines are left out; the errors of their modes are
in tmap.accuracy.engines.
"""

from pathlib import Path

import numpy as np

from tmap.accuracy.errors import Errors
from tmap.base import markdown
from tmap.base.errors import UserError
from tmap.base.outputs import save_animation
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.ideal import ideal
from tmap.ideal.bounds import has_ideal
from tmap.ideal.perspective import Picture
from tmap.model import model
from tmap.model.mesh import polygons_at
from tmap.model.model import Settings
from tmap.run import run
from tmap.scene_file.scene_file import Scene
from tmap.scene_file.textures import UNITS

NAMES = ("cube", "floor", "corridor", "environment", "rotator", "lit", "torch", "shaded")
ERROR_STEP = 8


#: A scene's name, its figures as tmap.run.run.total gives them, its frames, its errors.
Shown = tuple[str, dict, int, Errors]


def errors_of(scene: Scene, step: int = ERROR_STEP, always_curve: bool = False) -> Errors:
    """Returns the errors of u and v in every ``step``-th frame. Polygons without texture or ideal
    are left out. ``always_curve``: against the exact curve, whatever the perspective."""
    total, size = Errors(), (scene.width, scene.height)
    for number in range(0, scene.frames, step):
        for which, vertices in polygons_at(scene, number):
            m = scene.materials[which]
            settings = Settings.of(m)
            texels = scene.textures[m.texture].texels.shape if m.texture >= 0 else (256, 256)
            adapted = model.adapt(vertices, settings, max(texels))
            if m.mapper in ("flat", *UNITS) or not has_ideal(adapted, settings):
                continue
            polygon = model.set_up(adapted, *size, True, settings, texels[::-1])
            if always_curve or polygon and polygon.perspective:
                total.add(polygon, Picture(adapted, *size), settings)
            elif ideal.plane_of(adapted, 2).d:  # it has an area
                total.add(polygon, ideal.Picture(adapted, *size), settings)
    return total


def show(name: str, machine: str, folder: Path) -> Shown:
    """Draws a scene and writes its animation to ``folder``/NAME.gif."""
    scene = compile_scene(SCENES / f"{name}.toml")
    drawn = run.render(scene, machine, "addx")
    if any(len(np.unique(frame)) == 1 for frame in drawn.frames):
        raise UserError(f"{name}: a frame of one colour")
    pictures = [run.picture_of(frame, scene) for frame in drawn.frames]
    save_animation(folder / f"{name}.gif", pictures, run.gif_times(drawn.figures))
    return name, run.total(drawn.figures), scene.frames, errors_of(scene)


def table(shown: list[Shown], machine: str) -> str:
    """Returns the figures as a Markdown table."""
    rows = []
    for name, t, frames, e in shown:
        errors = [f"{e.worst:.4f}", f"{e.rms:.4f}"] if e.pixels else ["", ""]
        rows.append([name, str(frames), f"{t['polygons'] / frames:,.0f}",
                     f"{t['cycles'] / frames:,.0f}", f"{t['cycles_per_pixel'] or 0:.1f}", *errors,
                     ", ".join(t["spans"])])
    return markdown.table([f"scene, {machine}", "frames", "polygons a frame", "cycles a frame",
                           "cycles a pixel", "largest error, texels", "rms", "spans"], rows,
                          "lrrrrrrl")


def write(folder: Path, machine: str, on_step=None, names=NAMES) -> str:
    """Writes scenes.md and an animation of each scene; returns the table."""
    shown = []
    for name in names:
        shown.append(show(name, machine, folder))
        if on_step:
            on_step()
    text = table(shown, machine)
    pictures = "\n".join(f"## {name}\n\n![{name}]({name}.gif)\n" for name in names)
    (folder / "scenes.md").write_text(f"# Scenes\n\n{text}\n\n{pictures}")
    return text
