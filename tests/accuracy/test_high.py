"""Polygons in perspective of hundreds of lines: what is made for their lines must not reach what these are made from."""

import random
from dataclasses import replace

from tmap.base.fixed import ONE
from tmap.fuzz.depths import in_depth
from tmap.fuzz.polygons import Fuzzed, scene, textures
from tmap.guest import guest_frames
from tmap.guest.emulator import SECOND
from tmap.model import model
from tmap.scene_file.scene_file import Scene
from tmap.setup.texturing import Settings

WIDTH, HEIGHT, COUNT = 160, 1000, 24


def high_scene(seed: int = 1) -> Scene:
    """Triangles from the frame's first lines to its last, one a frame, whose depths differ up to four times."""
    rng = random.Random(f"{seed} high")
    settings = Settings(mapper="affine", gradients="plane", start="subtexel")
    page, some = next(k for k, each in enumerate(textures(1, 0)) if each.layout == "page"), []
    for number in range(COUNT):
        beyond = 60 * (number % 3 == 2)  # some reach over the right border
        points = [(rng.randint(2, WIDTH - 3 + beyond) * ONE + rng.randrange(ONE), y * ONE + rng.randrange(ONE))
                  for y in (rng.randint(1, 60), rng.randint(200, 800), HEIGHT - rng.randint(3, 60))]
        vertices = [(x, y, rng.randint(0, 255 * ONE), rng.randint(0, 255 * ONE), 0, ONE) for x, y in points]
        some.append(Fuzzed(in_depth(rng, "4", vertices, (WIDTH, HEIGHT)),
                           replace(settings, edges=rng.choice(("exact", "subpixel")),
                                   perspective=("every16", "every8")[number % 2]), page))
    return replace(scene(1, 0, some), width=WIDTH, height=HEIGHT)


def test_frames_are_the_models() -> None:
    made = high_scene()
    digests, = guest_frames.draw([(made, "addx")], SECOND, timed=False)
    guest_frames.require_models([model.render(made, number) for number in range(COUNT)], digests, "high polygons",
                                (made, "addx", SECOND))
