"""The demo in the window, at the machine's own speed, over the console that started it."""

import numpy as np

from tests.screen.pictures import played
from tests.screen.test_show import chunky_picture
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.model import model
from tmap.run import demo

FRAMES = 25  # of each part: a second
#: Parts that show a scene alone, in larger pixels, and how many of its first frames may be seen.
SEEN = {"hall": 16, "mirror": 16, "rotator": 40}


def test_parts_show_their_frames(tmp_path) -> None:
    """Pictures that the blitter ended are the model's, dot for dot; and each part's line is printed to a console, which
    draws, before the next part begins."""
    pictures = {}
    for name, count in SEEN.items():
        scene = compile_scene(demo.SOURCE / f"{name}.toml")
        pictures[name] = [chunky_picture(scene, model.render(scene, number).repeat(2, 0).repeat(2, 1))
                          for number in range(count)]
    with played(f"FRAMES {FRAMES}", tmp_path / "run") as (on, end):
        for name, frames in pictures.items():
            on.wait(f"a frame of {name}", lambda shot: any(
                np.array_equal(shot[:len(frame)], frame) for frame in frames), still=False)
        on.wait("the demo's end", lambda _: end.exists() and emulator.read(end).strip() == "0", still=False)
