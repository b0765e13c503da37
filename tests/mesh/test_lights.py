"""Several lights: the shades of meshes against a formula of their own, in floating point, within the
rounding that follows from the formats; and what is refused."""

import math

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.compiler import lights
from tmap.compiler.scene import compile_scene
from tmap.model import mesh as model_mesh
from tmap.scene_file import scene_file

ONE = 65536
START = """\
width = 64
height = 48
frames = 8
background = "#000000"
[materials]
grey.shades = ["#000000", "#ffffff"]
red.colour = "#ff0000"
[camera]
eye = [0, 0, 30]
"""
LAMP = "[[lights]]\nposition = [1, 3, 4]\nreach = 9\nbrightness = 0.75\n"
SIDE = "[[lights]]\nposition = [-4, 1, 2]\nreach = 7\nbrightness = 0.5\n"
MOON = "[[lights]]\ndirection = [1, -2, -1]\nbrightness = 0.25\n"
ALL = "[light]\nambient = 0.1\n" + LAMP + SIDE + MOON
#: A roof of two slopes: the sun shines on one, lamps on both.
ROOF = """\
[[objects]]
material = "grey"
points = [[-2, 0, 1], [2, 0, 1], [2, 1, 0], [-2, 1, 0], [2, 0, -1], [-2, 0, -1]]
faces = [[0, 1, 2, 3], [3, 2, 4, 5]]
"""
FACING = START + ALL + ROOF + 'normals = "faces"\n'


def make(folder, text: str):
    (folder / "scene.toml").write_text(text)
    made = compile_scene(folder / "scene.toml")
    scene_file.write(made)  # write checks the whole scene
    return made


def shares(spec: list[dict], place, normal) -> list[float]:
    """Returns what each light adds at a place to the brightness of a surface, below 0 if it shines on
    its back: the law as the page on scene files states it."""
    made = []
    for light in spec:
        way = [-c for c in light["direction"]] if "direction" in light else \
            [a - b for a, b in zip(light["position"], place)]
        size = math.dist(way, (0, 0, 0))
        part = 0.0 if "direction" in light else min(size / light["reach"], 1.0)
        cosine = sum(a * b for a, b in zip(way, normal)) / size / math.dist(normal, (0, 0, 0))
        made.append(light.get("brightness", 1.0) * (1 - part ** 2) ** 2 * cosine)
    return made


SPEC = [{"position": (1, 3, 4), "reach": 9, "brightness": 0.75},
        {"position": (-4, 1, 2), "reach": 7, "brightness": 0.5},
        {"direction": (1, -2, -1), "brightness": 0.25}]


def test_one_light_is_the_same_alone_or_in_a_list(tmp_path) -> None:
    turning = ROOF + "turns = 1\n"
    old = make(tmp_path, START + "[light]\ndirection = [1, -2, -1]\nambient = 0.1\n" + turning)
    new = make(tmp_path, START + "[light]\nambient = 0.1\n[[lights]]\ndirection = [1, -2, -1]\n" + turning)
    assert scene_file.write(old) == scene_file.write(new)


def test_no_light_is_the_usual_one(tmp_path) -> None:
    said = f"[light]\ndirection = {lights.USUAL}\nambient = {lights.AMBIENT}\n"
    assert scene_file.write(make(tmp_path, START + ROOF)) == scene_file.write(make(tmp_path, START + said + ROOF))


def test_what_moves_takes_all_lights_as_one_direction(tmp_path) -> None:
    """The sum of the lights at its origin: exact for faces on whose front all of them shine, else too
    dark by at most half of what all add."""
    made = make(tmp_path, START + ALL + ROOF + 'normals = "faces"\nturns = 1\nposition = [0.5, 0.25, 1]\n')
    instance, seen = made.instances[0], {True: 0, False: 0}
    for frame in range(made.frames):
        turn = 2 * math.pi * frame / 8
        _, _, shades = model_mesh.looks_of(instance, made.normals.tolist(), made.views[instance.view + frame].tolist())
        for (x, y, z, _), shade in zip(made.normals.tolist(), shades, strict=True):
            normal = (x * math.cos(turn) + z * math.sin(turn), y, z * math.cos(turn) - x * math.sin(turn))
            each = shares(SPEC, (0.5, 0.25, 1), normal)
            ours = (shade - instance.dark) / (instance.bright - instance.dark)
            right = sum(max(part, 0) for part in each)
            # Three factors of 9.7, a normal of 2.14 and the product's floor.
            error = 3 / (instance.bright - instance.dark) * 2 ** 8 + 2 ** -13
            seen[min(each) >= 0] += 1
            assert abs(ours - max(sum(each), 0)) <= error, (frame, normal)
            assert -error <= right - ours <= sum(SPEC[k]["brightness"] for k in range(3)) / 2 + error
    assert min(seen.values()) > 0


@pytest.mark.parametrize("text, message", [
    (START + "[light]\nambient = 0.5\n" + ROOF, "light.direction: is missing"),
    (START + "[light]\ndirection = [0, -1, 0]\n" + MOON + ROOF, "light.direction: there are lights too"),
    (START + "[[lights]]\ndirection = [0, 0, 0]\n" + ROOF, "lights[0].direction: must have a length"),
    (START + MOON + "[[lights]]\nbrightness = 1\n" + ROOF, "lights[1]: needs exactly one of direction, position"),
    (START + "[[lights]]\nposition = [0, 0, 0]\n" + ROOF, "lights[0].reach: is missing"),
    (START + "[[lights]]\nposition = [0, 0, 0]\nreach = 0\n" + ROOF, "lights[0].reach: must be from 0.001 to"),
    (START + "[[lights]]\nposition = [0, 0]\nreach = 1\n" + ROOF, "lights[0].position: must have 3 entries"),
    (START + MOON.replace("0.25", "-1") + ROOF, "lights[0].brightness: must be from 0 to 16"),
    (START + MOON + "keys = []\n" + ROOF, "lights[0].keys: unknown field; known are direction, brightness"),
    (START + MOON.replace("[1, -2", '["1", -2') + ROOF, "lights[0].direction[0]: must be a number, not text"),
    ("lights = []\n" + START + ROOF, "lights: must have 1 to 64 entries"),
])
def test_refused(tmp_path, text: str, message: str) -> None:
    with pytest.raises(UserError) as caught:
        make(tmp_path, text)
    assert message in str(caught.value) and str(caught.value).count("\n") == 0
