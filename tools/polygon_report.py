"""All a person needs to find the cause of one wrong polygon."""

import re

import numpy as np
from PIL import Image

from . import model
from .diff import Frame, compare, panels
from .paths import BUILD


def number(value: int) -> str:
    """A 16.16 number in decimal and in hexadecimal."""
    return f"{value / 65536:.6f} ({value & model.M32:#010x})"


def lines_of(vertices, settings: model.Settings, size: tuple[int, int], width: int,
             height: int) -> list[str]:
    """Vertices, slopes and steps as the set-up has them."""
    lines = [f"  vertex {k}: " + ", ".join(
        f"{name} {number(c)}" for name, c in zip(("x", "y", "s", "t", "shade"), vertex))
        for k, vertex in enumerate(vertices)]
    polygon = model.set_up([v[:4] for v in model.adapt(vertices, settings, max(size))], width,
                           height, settings.mapper != "flat", settings, size)
    if not polygon:
        return [*lines, "  it covers nothing, or is refused"]
    for name, edges in (("left", polygon.left_edges), ("right", polygon.right_edges)):
        lines += [f"  {name} edge, lines {e.top} to {e.end - 1}: slope {number(e.slope)}"
                  for e in edges]
    if polygon.texturing:
        lines += [f"  {k}: {number(model.signed(v))}"
                  for k, v in vars(polygon.texturing).items() if k.startswith("d")]
    return lines


def explain(title: str, vertices, settings: model.Settings, size: tuple[int, int],
            expected: np.ndarray, found: np.ndarray | None, again: str,
            palette: np.ndarray | None = None) -> str:
    """``vertices``: (x, y, s, t, shade), 16.16; ``size``: of the map; ``found``: None where the
    guest drew nothing to compare. Writes a picture of expected, found and their difference."""
    text = [title, "  " + ", ".join(f"{k} {v}" for k, v in vars(settings).items())
            + f", map {size[0]}x{size[1]}, frame {expected.shape[1]}x{expected.shape[0]}"]
    text += lines_of(vertices, settings, size, *expected.shape[::-1])
    if found is not None:
        difference = compare(expected, found)
        text.insert(1, f"  expected and found: {difference}" if difference.count
                    else "  the guest's frame is the model's")
        picture = BUILD / "failed" / (re.sub(r"\W+", "_", title)[:60].strip("_") + ".png")
        picture.parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(panels(Frame(expected, palette), Frame(found, palette))).save(picture)
        text.append(f"  picture (expected, found, difference): {picture}")
    return "\n".join([*text, f"  again: {again}"])
