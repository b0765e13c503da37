"""Several lights: the shades of meshes against a formula of their own, in floating point, within the
rounding that follows from the formats; and what is refused."""

import math

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler import lights
from tmap.compiler.scene import compile_scene
from tmap.model import mesh as model_mesh
from tmap.scene_file import scene_file

ONE = 65536
CHECKER = SCENES / "checker.png"
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


def corners_of(made, which: int = 0) -> list[tuple]:
    """Returns place, unit normal of its face and shade of each corner of a mesh, in the mesh's space."""
    instance = made.instances[which]
    mesh = made.meshes[instance.mesh]
    points, normals, corners, faces = (getattr(made, name)[first:first + count].tolist() for name, first, count in (
        ("points", mesh.point, mesh.points), ("normals", mesh.normal, mesh.normals),
        ("corners", mesh.corner, mesh.corners), ("faces", mesh.face, mesh.faces)))
    _, _, shades = model_mesh.looks_of(instance, normals, made.views[instance.view].tolist())
    return [([c / ONE for c in points[point]], [c / 2 ** 30 for c in face[:3]], shades[normal])
            for face in faces for point, normal, *_ in corners[face[4]:face[4] + face[5]]]


def rounding(instance) -> float:
    """Returns how far a baked shade may be from the exact one: the brightness is rounded to 2.14, bright -
    dark to 9.7, their product down to 1/65536, dark and bright to 1/65536; faces' normals are 2.30."""
    span = (instance.bright - instance.dark) / ONE
    return span * (2 ** -15 + 2 ** -26) + 2 ** -8 + 2 ** -16 + 2 * 2 ** -17


def turned(vector, degrees: float) -> tuple[float, float, float]:
    """Returns a vector turned about the y axis."""
    x, y, z = vector
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return x * c + z * s, y, z * c - x * s


def assert_shades(made, which: int, turn: float, move) -> list[float]:
    """Asserts that the shades of an instance's corners are those of the lights; returns the shares of
    full light."""
    instance, found = made.instances[which], []
    for place, normal, shade in corners_of(made, which):
        here = [a + b for a, b in zip(turned(place, turn), move)]
        right = min(sum(max(part, 0) for part in shares(SPEC, here, turned(normal, turn))), 1)
        exact = (instance.dark + (instance.bright - instance.dark) * right) / ONE
        assert abs(shade / ONE - exact) <= rounding(instance), (place, normal, shade / ONE, exact)
        found.append(right)
    return found


@pytest.mark.parametrize("grid", ["", "grid = 0.5\n"])
def test_what_stands_still_has_every_light_at_each_corner(tmp_path, grid: str) -> None:
    made = make(tmp_path, FACING + f"rotation = [0, 30, 0]\nposition = [0.5, 0.25, 1]\nsize = 1.5\n{grid}")
    found = assert_shades(made, 0, 30, (0.5, 0.25, 1))
    assert len(set(found)) > (20 if grid else 6) and max(found) - min(found) > 0.3
    assert (made.views == made.views[0]).all()


def test_smooth_normals_are_those_of_the_file(tmp_path) -> None:
    """Two corners have normals of their own, at either end of an edge."""
    (tmp_path / "mesh.obj").write_text("v -1 0 0\nv 1 0 0\nv 0 2 0\nvn 0 0 3\nvn 1 0 2\nvn 0 4 1\nf 1//1 2//2 3//3\n")
    made = make(tmp_path, START + ALL + '[[objects]]\nmaterial = "grey"\nmesh = "mesh.obj"\n')
    instance, normals = made.instances[0], ((0, 0, 3), (1, 0, 2), (0, 4, 1))
    for (place, _, shade), normal in zip(corners_of(made), normals, strict=True):
        right = min(sum(max(part, 0) for part in shares(SPEC, place, normal)), 1)
        exact = (instance.dark + (instance.bright - instance.dark) * right) / ONE
        assert abs(shade / ONE - exact) <= rounding(instance)


def test_still_parts_of_still_parents_are_baked_where_they_are(tmp_path) -> None:
    """The parent turns and moves its part, whose own rotation comes first."""
    parent = ROOF.replace("[[objects]]", '[[objects]]\nname = "base"') + 'normals = "faces"\nrotation = [0, 40, 0]\n' \
        "position = [1, 0, 0]\nsize = 0.5\n"
    part = ROOF + 'normals = "faces"\nparent = "base"\nrotation = [0, -10, 0]\nposition = [0, 2, 0]\n'
    made = make(tmp_path, START + ALL + parent + part)
    assert_shades(made, 0, 40, (1, 0, 0))
    assert_shades(made, 1, 30, (1, 1, 0))
    moving = make(tmp_path, START + ALL + parent.replace('name = "base"', 'name = "base"\nturns = 1') + part)
    assert all(len(np.unique(moving.views[each.view:each.view + 8, 21:], axis=0)) > 1 for each in moving.instances)


def test_trees_bake_each_mesh_where_it_is(tmp_path) -> None:
    """Both get the place in the middle of all of them; none is split."""
    one, other = (ROOF + f'normals = "faces"\norder = "bsp"\nrotation = [0, {turn}, 0]\nposition = {place}\n'
                  for turn, place in ((20, [-4, 0, 1]), (0, [3, 0.25, 0])))
    made = make(tmp_path, START + ALL + one + other)
    assert {each.tree for each in made.instances} == {0}
    eye = made.views[0, 12:15] / ONE
    for which in range(2):
        assert len(set(assert_shades(made, which, 0, (0 - eye[0], 0 - eye[1], 30 - eye[2])))) > 4


def test_lit_faces_have_the_mean_of_their_corners(tmp_path) -> None:
    """The mapper "lit" has one shade a face."""
    text = FACING.replace('grey.shades = ["#000000", "#ffffff"]', 'grey = { texture = "map", mapper = "lit" }') + \
        "uvs = [[[0, 0], [9, 0], [9, 9], [0, 9]]]\n" + f'[textures]\nmap.image = "{CHECKER}"\n'
    made = make(tmp_path, text)
    instance, found = made.instances[0], corners_of(made)
    assert made.meshes[0].faces == 2
    for face in (found[:4], found[4:]):
        rights = [min(sum(max(part, 0) for part in shares(SPEC, place, normal)), 1) for place, normal, _ in face]
        exact = (instance.dark + (instance.bright - instance.dark) * sum(rights) / 4) / ONE
        assert len({shade for *_, shade in face}) == 1
        assert abs(face[0][2] / ONE - exact) <= rounding(instance)


def test_a_mirror_takes_lights_as_one_direction_and_says_so(tmp_path, capsys) -> None:
    text = FACING.replace('grey.shades = ["#000000", "#ffffff"]',
                          'grey = { texture = "map", mapper = "lit_gouraud" }')
    text += f'mapping = "environment"\n[textures]\nmap.image = "{CHECKER}"\n'
    made = make(tmp_path, text)
    assert 'objects[0].mapping: "environment" needs the normals' in capsys.readouterr().err
    lengths = np.linalg.norm(made.normals[:, :3] / 2 ** 14, axis=1)
    assert abs(lengths - 1).max() < 2 ** -13


def test_a_lamp_on_the_surface_shines_straight_on_it(tmp_path) -> None:
    lamp = "[[lights]]\nposition = [-2, 0, 1]\nreach = 1\nbrightness = 0.5\n"
    made = make(tmp_path, START + "[light]\nambient = 0\n" + lamp + ROOF + 'normals = "faces"\n')
    instance = made.instances[0]
    assert [abs(shade / ONE - (instance.dark + instance.bright) / 2 / ONE) <= rounding(instance)
            for place, _, shade in corners_of(made)] == [place == [-2, 0, 1] for place, *_ in corners_of(made)]
