"""Every mapper with every setting, from a scene file to the frame: bit for bit the model."""

import itertools

import numpy as np
import pytest
from PIL import Image

from tests.helpers import guest_runs
from tests.helpers.engine_scenes import compiled
from tests.helpers.guest_runs import Asked
from tmap.scene_file.scene_file import ON_PLANE, SETTINGS

HEAD = """\
width = 96
height = 64
background = "#102030"
[textures]
full = {image = "noise.png"}
odd = {image = "noise.png", width = 100, height = 37}
high = {image = "noise.png", width = 64, height = 512}
small = {image = "noise.png", width = 64, height = 128}
holed = {image = "holes.png", width = 64, height = 128}
[materials]
"""
#: mapper: (further fields of the material, radius on the map)
LOOKS = {"gouraud": ('shades = ["#000000", "#ffff00"], steps = 40', 0),
         "arbitrary": ('texture = "odd"', 128), "tiled": ('texture = "full"', 300),
         "columns": ('texture = "high"', 300), "generated": ('texture = "full"', 300),
         "lit": ('texture = "full"', 40), "lit_gouraud": ('texture = "full"', 300),
         "affine": ('texture = "small"', 700), "dithered": ('texture = "small"', 300),
         "keyed": ('texture = "holed"', 700)}
#: Format: its mappers (tests/compiler/test_run.py tests the affine one of chunky frames), machine.
DRAWN = {"chunky": ([mapper for mapper in LOOKS if mapper != "affine"], "a1200-fast"),
         "rgb565": (["columns", "affine", "dithered"], "a1200"),
         "rgba5551": (["columns", "affine", "dithered"], "a1200-fast"),
         "rgba8888": (["affine", "dithered"], "a1200")}
#: Generated code draws polygons within a row of the map: every other polygon is this many times
#: narrower.
NARROW = {"generated": 3}
SPANS = {"chunky": {*DRAWN["chunky"][0], "lit_wrap", "gouraud_short", "dithered_wrap", "keyed_wrap",
                    "affine_short", "affine_addx", "affine_addx_wrap", "affine_scanline"} - {"dithered"},
         "rgb565": {"columns_16", "affine_16", "affine_16_wrap", "dithered_16_wrap"},
         "rgba8888": {"affine_32", "affine_32_wrap", "dithered_32_wrap"}}
SPANS["rgba5551"] = SPANS["rgb565"]


def scene(pixels: str) -> str:
    """One frame for each mapper and combination of settings; polygons of 3 to 7 corners, some
    larger than the frame."""
    choices = {kind: names for kind, names in SETTINGS.items()
               if kind not in ("mapper", "perspective")}
    materials = objects = ""
    mappers = DRAWN[pixels][0]
    wanted = [(mapper, *names) for mapper, *names in itertools.product(mappers, *choices.values())
              if mapper not in ON_PLANE or {"plane", "subtexel"} <= set(names)]
    for n, (mapper, *names) in enumerate(wanted):
        look, map_radius = LOOKS[mapper]
        settings = dict(zip(choices, names)) | ({"mapper": mapper} if map_radius else {})
        materials += f"m{n} = {{{look}" + "".join(f', {k} = "{v}"' for k, v in settings.items())
        materials += "}\n"
        sides = 3 if settings["gradients"] == "polygon" else 3 + n % 5
        map_radius //= NARROW.get(mapper, 1) if n % 2 else 1
        objects += (f'[[objects]]\nmaterial = "m{n}"\nsides = {sides}\nangle = {7 * n}\n'
                    f"radius = {47.3 if n % 3 else 11.7}\nmap_radius = {map_radius}\n"
                    f"centre = [53.4, 25.7]\nfirst = {n}\nlast = {n}\n"
                    + "shades = [130]\n" * (mapper == "lit"))
    return f"frames = {n + 1}\nformat = \"{pixels}\"\n" + HEAD + materials + objects


@pytest.mark.parametrize("machine", ["a1200", "a1200-fast"])
def test_every_mapper_is_the_models(tmp_path, machine):
    noise = np.random.default_rng(1).integers(0, 256, (64, 64, 3)).astype(np.uint8)
    Image.fromarray(noise).resize((512, 512)).save(tmp_path / "noise.png")
    holes = np.dstack([noise, np.where(noise[:, :, 0] < 100, 0, 255).astype(np.uint8)])
    Image.fromarray(holes).save(tmp_path / "holes.png")
    asked = {pixels: Asked(compiled(tmp_path, scene(pixels))) for pixels in DRAWN
             if DRAWN[pixels][1] == machine}
    for pixels, drawn in guest_runs.check_all(asked, machine).items():
        assert asked[pixels].scene.format == pixels
        assert drawn.spans == SPANS[pixels]
        assert all(frame["pixels"] > 100 for frame in drawn.figures)
