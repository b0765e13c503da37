"""Small scene files of texture engines, and checks of their errors."""

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from tests.helpers.refusals import without_line
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.scene_file.scene_file import Scene

HEAD = """\
width = 64
height = 48
frames = {frames}
format = "{pixels}"
background = "#102030"
"""


def save_noise(folder, seed: int, **sizes: tuple[int, int]) -> None:
    """Saves pictures of random colours; ``sizes`` has (height, width) by name."""
    rng = np.random.default_rng(seed)
    for name, size in sizes.items():
        pixels = rng.integers(0, 256, (*size, 3), np.uint8)
        Image.fromarray(pixels).save(folder / f"{name}.png")


@pytest.fixture
def folder(tmp_path):
    """A directory with pictures of noise: noise 32x32, odd 24x20, long 64x4, wide 1030x4, palettes
    16x16, half 16x5."""
    save_noise(tmp_path, 3, noise=(32, 32), odd=(20, 24), long=(4, 64), wide=(4, 1030),
               palettes=(16, 16), half=(5, 16))
    return tmp_path


def scene_text(material: str, obj: str, pixels: str = "rgba8888", frames: int = 1) -> str:
    """Returns a scene of one material, "it", and one object."""
    return (HEAD.format(frames=frames, pixels=pixels) + f"[materials]\nit = {{ {material} }}\n"
            + f'[[objects]]\nmaterial = "it"\n{obj}\n')


def batch_text(width: int, height: int, pixels: str, engines) -> str:
    """Returns a scene of one frame with texture engines as its materials m0, m1, ... and no object
    yet."""
    return (f'width = {width}\nheight = {height}\nframes = 1\nformat = "{pixels}"\n'
            'background = "#102030"\n[materials]\n'
            + "".join(f"m{n} = {{ n64 = {{ {engine} }} }}\n" for n, engine in enumerate(engines)))


def compiled(folder, text: str) -> Scene:
    (folder / "scene.toml").write_text(text)
    return compile_scene(folder / "scene.toml")


def check_refused(folder, text: str, message: str) -> None:
    """Asserts that the scene is refused with one line that begins with the file and ``message``."""
    with pytest.raises(UserError) as caught:
        compiled(folder, text)
    said = without_line(str(caught.value), folder / "scene.toml")
    assert said.startswith(f"{folder / 'scene.toml'}: {message}"), said


def shown(name: str, off: str | None) -> Scene:
    """A scene's first frame; without rules, which is slow, only its middle."""
    whole = compile_scene(SCENES / f"{name}.toml", 1)
    if not off:
        return whole
    width, height = whole.width // 8 * 4, whole.height // 2
    poses = whole.poses.copy()  # meshes are centred on the frame anyway
    poses[:, 4:] -= np.array([whole.width - width, whole.height - height]) << 15
    return replace(whole, width=width, height=height, poses=poses)
