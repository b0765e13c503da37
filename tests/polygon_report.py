"""What a person needs to find the cause of a polygon that is not the model's."""

import numpy as np
from PIL import Image

from tools import model, scene_file
from tools.diff import Frame, panels
from tools.paths import BUILD


def numbers(name: str, value: int) -> str:
    """A 16.16 number in decimal and in hex."""
    return f"{name} {value / 65536:.6f} ({value & model.M32:#010x})"


def explain(scene: scene_file.Scene, number: int, found: np.ndarray, what: str, again: str) -> str:
    """All about one wrong frame with one polygon: ``what`` it is, the first wrong pixel,
    vertices, slopes, gradients, a picture's file, and the command to run it ``again``."""
    right, obj = model.render(scene, number), scene.objects[number]
    y, x = np.argwhere(right != found)[0]
    picture = BUILD / "failed" / f"{what.split(':')[0].replace(' ', '_')}_{number}.png"
    picture.parent.mkdir(parents=True, exist_ok=True)
    both = Frame(right, scene.palette), Frame(found, scene.palette)
    Image.fromarray(panels(*both)).save(picture)
    lines = [f"{what}: {np.count_nonzero(right != found)} pixels differ, the first at "
             f"(x {x}, y {y}): expected {right[y, x]}, found {found[y, x]}",
             f"  {scene.materials[obj.material]}"]
    for k, vertex in enumerate(scene_file.vertices_at(scene, obj, number)):
        each = map(numbers, ("x", "y", "s", "t", "shade"), vertex)
        lines.append(f"  vertex {k}: " + ", ".join(each))
    polygon = model.prepare(scene, obj, number)
    for name in ("left", "right") if polygon else ():
        lines += [f"  {name} edge, lines {e.top} to {e.end - 1}: {numbers('slope', e.slope)}"
                  for e in getattr(polygon, f"{name}_edges")]
    if polygon and polygon.texturing:
        lines += ["  " + numbers(k, model.signed(v))
                  for k, v in vars(polygon.texturing).items() if k.startswith("d")]
    return "\n".join([*lines, f"  picture (expected, found, difference): {picture}",
                      f"  again: {again}"])
