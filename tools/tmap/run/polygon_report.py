"""A report that helps to find the cause of one wrong polygon."""

import re
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.base.fixed import M32, ONE, signed
from tmap.base.paths import BUILD
from tmap.model import model
from tmap.run.diff import Frame, compare, differing, panels
from tmap.scene_file.scene_file import Scene, vertices_at


def numbers(name: str, value: int) -> str:
    """Returns a 16.16 number in decimal and in hexadecimal."""
    return f"{name} {value / ONE:.6f} ({value & M32:#010x})"


def save_picture(scene: Scene, right: np.ndarray, found: np.ndarray, what: str) -> Path:
    """Saves both frames and their difference; returns the file, named after ``what`` is wrong."""
    picture = BUILD / "failed" / (re.sub(r"\W+", "_", what)[:60].strip("_") + ".png")
    picture.parent.mkdir(parents=True, exist_ok=True)
    both = Frame(right, scene.palette, scene.pixel), Frame(found, scene.palette, scene.pixel)
    Image.fromarray(panels(*both, differing(right, found))).save(picture)
    return picture


def explain(scene: Scene, number: int, found: np.ndarray | None, what: str, again: str) -> str:
    """Returns a report on the frame ``number`` with one polygon: ``what`` is wrong, the first wrong
    pixel, vertices, slopes, gradients, a picture's file, and the command to run it ``again``.
    ``found``: None if the guest has drawn nothing."""
    obj = scene.objects[number]
    lines = [what]
    if found is not None:
        right = model.render(scene, number)
        difference = compare(right, found)
        lines.append(f"  expected / found: {difference}" if difference.count
                     else "  the guest's frame is the model's")
    lines.append(f"  {scene.materials[obj.material]}, frame {scene.width}x{scene.height}")
    for k, vertex in enumerate(vertices_at(scene, obj, number)):
        each = map(numbers, ("x", "y", "s", "t", "shade", "w"), vertex)
        lines.append(f"  vertex {k}: " + ", ".join(each))
    polygon = model.prepare(scene, obj, number)
    for name in ("left", "right") if polygon else ():
        lines += [f"  {name} edge, lines {e.top} to {e.end - 1}: {numbers('slope', e.slope)}"
                  for e in getattr(polygon, f"{name}_edges")]
    if polygon and polygon.texturing:
        lines += ["  " + numbers(k, signed(v))
                  for k, v in vars(polygon.texturing).items() if k.startswith("d")]
    if found is not None:
        lines.append(f"  picture (expected, found, difference): {save_picture(scene, right, found, what)}")
    return "\n".join([*lines, f"  again: {again}"])
