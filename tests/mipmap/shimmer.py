"""How far a scene's frames are from exact ones, and how much they flicker, with mip maps and without.

The exact frames are those of a picture SCALE times as wide and high, without mip maps, each block's mean light.
`PYTHONPATH=tools .deps/venv/bin/python -m tests.mipmap.shimmer` draws tests/scenes/terrace.gif: without mip maps on the
left, with them on the right.
"""

import re
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image

from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.images.mipmap import from_light, to_light
from tmap.model import model

SCALE = 4
SOURCE = SCENES / "terrace.toml"


def pictures(width: int, height: int, frames: range, with_mipmaps: bool) -> list[np.ndarray]:
    """Returns the model's frames of the scene at a size, uint8 [height, width, 3]."""
    text = re.sub(r"width = \d+\nheight = \d+", f"width = {width}\nheight = {height}", SOURCE.read_text(), count=1)
    if not with_mipmaps:
        text = re.sub(r', mipmap = "polygon"(, levels = \d)?', "", text)
    with TemporaryDirectory() as folder:
        path = Path(folder) / SOURCE.name
        path.write_text(text)
        scene = compile_scene(path)
    return [scene.palette[model.render(scene, number)] for number in frames]


def means(picture: np.ndarray) -> np.ndarray:
    """Returns the mean light of each block around a pixel's centre."""
    height, width = (side // SCALE for side in picture.shape[:2])
    light = to_light(np.arange(256) / 255)[np.roll(picture, (SCALE // 2, SCALE // 2), (0, 1))]
    return from_light(light.reshape(height, SCALE, width, SCALE, 3).mean((1, 3)))


def rms(errors: list[np.ndarray]) -> float:
    """Returns the root mean square, without the frame's border, whose blocks are cut."""
    return float(np.sqrt(np.mean([error[1:-1, 1:-1]**2 for error in errors])))


def measured(width: int, height: int, frames: range, with_mipmaps: bool, exact: list[np.ndarray]) -> tuple[float, float]:
    """Returns the error, and the change of the error from frame to frame, of levels 0 to 255."""
    errors = [found.astype(float) - right for found, right in
              zip(pictures(width, height, frames, with_mipmaps), exact)]
    return rms(errors), rms([then - now for now, then in zip(errors, errors[1:])])


def exact_frames(width: int, height: int, frames: range) -> list[np.ndarray]:
    """Returns the exact frames."""
    return [means(each) for each in pictures(SCALE * width, SCALE * height, frames, False)]


def save(path: Path, width: int = 160, height: int = 128) -> None:
    """Draws the animation."""
    frames = range(0, 40, 2)
    both = [np.concatenate(pair, axis=1) for pair in zip(*(pictures(width, height, frames, each)
                                                           for each in (False, True)))]
    first, *rest = [Image.fromarray(each).quantize(64, dither=Image.Dither.NONE) for each in both]
    first.save(path, save_all=True, append_images=rest, duration=80, loop=0)


if __name__ == "__main__":
    save(SCENES / "terrace.gif")
    right = exact_frames(256, 160, range(8))
    for each in (False, True):
        print("with" if each else "without", "mip maps: error {:.1f}, flicker {:.1f}".format(
            *measured(256, 160, range(8), each, right)))
