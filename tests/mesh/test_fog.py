"""Fog: the shades of corners against exact fractions, pictures against the model on both machines, pixels against
fog that is computed for each of them, and what is refused."""

import math
import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.helpers import guest_runs, refusals
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.build import layout
from tmap.compiler.scene import compile_scene
from tmap.model import mesh, model
from tmap.product import scene_program
from tmap.scene_file import scene_file
from tmap.scene_file.meshes import FOG, LIT

ONE = 65536
START = """\
width = 96
height = 64
frames = 3
background = "#8090a0"
[fog]
colour = "#8090a0"
near = 3
far = 12
[textures]
brick.image = "package:skimage/data/brick.png"
[camera]
eye = [0, 1, 9]
target = [0.5, 0.6, 0]
fov = 80
near = 0.25
[materials]
"""
#: Every kind of material that fades.
LOOKS = [f'texture = "brick", mapper = "{mapper}"{way}' for mapper in ("lit", "lit_gouraud")
         for way in ("", *(f', perspective = "{each}"' for each in ("every16", "every8", "pixel", "fine")))]
LOOKS += ['texture = "brick", mapper = "lit_gouraud", mipmap = "polygon", levels = 2, perspective = "every16"',
          'texture = "brick", mapper = "lit_gouraud", perspective = "pixel", tolerance = 0.5',
          'colour = "#c04020"', 'colour = "#40c020", gradients = "polygon"', 'colour = "#4020c0", gradients = "scanline"']
BOX = """\
[[objects]]
points = [[-1, -1, -1], [1, -1, -1], [-1, 1, -1], [1, 1, -1], [-1, -1, 1], [1, -1, 1], [-1, 1, 1], [1, 1, 1]]
faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3]]
"""
UVS = "uvs = [[[0, 0], [200, 0], [200, 200], [0, 200]]]\n"
FLOOR = """\
[[objects]]
material = "floor"
points = [[-9, 0, 12], [9, 0, 12], [9, 0, -18], [-9, 0, -18]]
faces = [[0, 1, 2, 3]]
uvs = [[[0, 2048], [512, 2048], [512, 0], [0, 0]]]
"""


def make(folder, text: str):
    (folder / "scene.toml").write_text(text)
    made = compile_scene(folder / "scene.toml")
    scene_file.write(made)  # write checks the whole scene
    return made


def boxes(rng: random.Random, looks: list[str], order: str, start: str = START) -> str:
    """Boxes before, in and behind the fog, some of them beyond the near plane and the borders."""
    text = start + "".join(f"m{k} = {{ {look}, fog = true }}\n" for k, look in enumerate(looks))
    for k in range(8):
        look = rng.randrange(len(looks))
        place = [round(rng.uniform(-4, 4), 3), round(rng.uniform(-2, 2), 3), round(rng.uniform(-5, 9), 3)]
        text += f'{BOX}material = "m{look}"\nposition = {place}\nrotation = [0, {rng.randint(0, 359)}, 0]\n' \
                f"size = {rng.choice((0.5, 1, 2))}\n" + UVS * ("texture" in looks[look])
        text += "turns = 0.2\n" if order == "depth" else f'order = "{order}"\n'
    return text


def assert_models(scenes: list, machine: str) -> list:
    """Asserts that the guest draws the model's pictures; returns what it drew."""
    asked = [guest_runs.Asked(scene) for scene in scenes]
    drawn = guest_runs.draw(asked, machine)
    for number, each in enumerate(zip(asked, drawn)):
        guest_runs.check(f"scene {number}", *each)
    return drawn


@pytest.mark.parametrize("machine", ["a1200-fast", "a1200"])
def test_frames_are_the_models(tmp_path, machine: str) -> None:
    """In any order, each pixel once or drawn over, with snapped vertices too; all rules that fog leads to apply."""
    rng = random.Random("fog")
    scenes = [make(tmp_path, boxes(rng, [look], "depth")) for look in LOOKS]
    scenes += [make(tmp_path, boxes(rng, rng.sample(LOOKS[:-2], 3), order)) for order in ("bsp", "z", "depth")]
    scenes += [replace(each, once=1) for each in scenes
               if all(material.edges == "exact" for material in each.materials)][:8]
    assert any(material.edges == "snapped" for scene in scenes for material in scene.materials)
    assert any(scene.once for scene in scenes)
    for scene in scenes:
        assert all(each.flags == FOG for each in scene.instances)
    drawn = assert_models(scenes, machine)
    rules = set().union(*(each.rules for each in drawn))
    assert {"equal_levels", "equal_shades", "no_light", "full_light"} <= rules


def test_a_mirror_in_fog_is_the_models(tmp_path) -> None:
    text = START + 'm = { texture = "brick", mapper = "lit_gouraud", fog = true }\n'
    text += '[[objects]]\nmaterial = "m"\nmesh = "knot.obj"\nmapping = "environment"\nturns = 1\n'
    (tmp_path / "knot.obj").write_bytes((SCENES / "knot.obj").read_bytes())
    assert_models([make(tmp_path, text)], "a1200-fast")


def test_the_scene_is_the_models_on_both_machines() -> None:
    scene = compile_scene(SCENES / "mist.toml")
    kept = [0, 21, 42, 63]
    for machine in ("a1200-fast", "a1200"):
        digests = guest_runs.draw([guest_runs.Asked(scene, counted=False)], machine)[0].digests
        for number in kept:
            assert guest_runs.guest_frames.is_models(model.render(scene, number), digests[number]), (machine, number)


def test_shades_are_within_half_a_unit_of_exact_ones(tmp_path) -> None:
    """At every corner that is drawn, those made by cutting too; before, in and behind the fog."""
    seen = {"none": 0, "some": 0, "all": 0}
    for seed in range(6):
        made = make(tmp_path, boxes(random.Random(seed), ['texture = "brick", mapper = "lit_gouraud"'], "depth"))
        for instance in made.instances:
            near, far, span = 3, 12, Fraction(instance.bright - instance.dark)
            for _, vertices, _ in (face for number in range(3) for face in mesh.faces_of(made, instance, number)):
                for vertex in vertices:
                    w = Fraction(vertex[5], ONE)
                    part = min(max((w - near) / (far - near), 0), 1)
                    assert abs(vertex[4] - (instance.bright - span * part)) <= Fraction(1, 2)
                    seen["none" if w <= near else "all" if w >= far else "some"] += 1
    assert min(seen.values()) > 100


def light_bound(low: float, high: float, near: float, far: float) -> float:
    """Returns how far fog that is even between corners may be from that of each pixel, as a part of all fog. 1/w is
    even on the screen, so a pixel's depth is the harmonic mean of those of the corners, a to b, with its shares in
    them; the fog of the corners is mixed by the same shares. Where all is between near and far that is too much fog
    by at most the arithmetic less the harmonic mean, (sqrt b - sqrt a)^2. A limit inside makes it worse, by b / (b -
    a) at most: for a near one at n the error is at most (n - a) (b - n) b / (n (b - a)), which is greatest at n =
    sqrt(a b); a far one is the difference of two such functions, of which neither is below 0."""
    if low >= far or high <= near or low == high:
        return 0.0
    even = (math.sqrt(high) - math.sqrt(low)) ** 2
    return even * (1 if near <= low and high <= far else high / (high - low)) / (far - near)


def numbered(made):
    """Returns a scene whose light table has the numbers of its rows: a frame then has the level of each pixel."""
    levels = layout.load().constants["LIGHT_LEVELS"]
    rows = np.repeat(np.arange(levels, dtype=np.uint8)[:, None], 256, 1)
    return replace(made, background=255, textures=[replace(each, texels=rows) if each.layout == "light" else each
                                                   for each in made.textures])


@pytest.mark.parametrize("grid, most", [(None, 0.48), (6, 0.17), (3, 0.06), (1.5, 0.022)])
def test_pixels_are_as_near_to_their_own_fog_as_is_derived(tmp_path, grid: float | None, most: float) -> None:
    """A floor, looked at from above it: the depth of each pixel follows from the camera. ``most``: how far one of
    its pixels is off at most, as a part of all fog; the grid makes that less."""
    text = START.replace("0.6, 0]", "0.4, 0]") + 'floor = { texture = "brick", mapper = "lit_gouraud", perspective = ' \
        '"every16", fog = true }\n' + FLOOR + (f"grid = {grid}\n" if grid else "")
    made = numbered(make(tmp_path, text))
    near, far, worst, checked = 3.0, 12.0, 0.0, 0
    frame, view = model.render(made, 0), made.views[0].tolist()
    # the plane y = 0 of the mesh before the camera: a ray (x / w, y / w, 1) times `normal` is height / w
    normal = [view[3 * k + 1] / 2 ** 30 for k in range(3)]
    lens = [sum((view[3 * k + a] / 2 ** 30) ** 2 for a in range(3)) for k in range(3)]
    height = view[13] / ONE
    allowed = np.zeros(frame.shape)
    for _, vertices in mesh.polygons_at(made, 0):
        ws = [v[5] / ONE for v in vertices]
        polygon = model.prepare_polygon(made, 0, vertices)
        for y, line in enumerate(polygon.lines, polygon.top) if polygon else ():
            allowed[y, line.left:max(line.left, line.right)] = light_bound(min(ws), max(ws), near, far)
    for y, x in np.argwhere(frame < 64).tolist():
        ray = ((x - made.width / 2) / 2 ** made.guard, (y - made.height / 2) / 2 ** made.guard, 1)
        w = -height / sum(r * n / size for r, n, size in zip(ray, normal, lens))
        exact = 1 - min(max((w - near) / (far - near), 0), 1)
        # Shades go from 1/2 to 255 1/2, a level has 4. A face's plane may be a shade off at a corner. Its level
        # is rounded down; half a pixel's edge beyond the face and a plane's roundings are below 1/8 of one.
        level = (0.5 + 255 * exact) / 4
        off = max(int(frame[y, x]) - level, level - 1 - int(frame[y, x]), 0)
        assert off <= allowed[y, x] * 255 / 4 + 1 / 4 + 1 / 8, (x, y, frame[y, x], level, allowed[y, x])
        worst, checked = max(worst, off / 64), checked + 1
    assert checked > 1500 and 0.9 * most < worst <= most


def test_the_table_leads_to_the_fogs_colour(tmp_path) -> None:
    """Always the palette's nearest colour; materials in the light have a table of their own."""
    text = START + 'm = { texture = "brick", mapper = "lit_gouraud", fog = true }\n' \
        'lit = { texture = "brick", mapper = "lit_gouraud" }\n' + f'{BOX}material = "m"\n{UVS}{BOX}material = "lit"\n{UVS}'
    made = make(tmp_path, text)
    assert [each.flags for each in made.instances] == [FOG, LIT]
    tables = [made.textures[each.light].texels for each in made.materials]
    colours = made.palette.astype(float)
    for table, dark in zip(tables, ((0x80, 0x90, 0xA0), (0, 0, 0)), strict=True):
        assert (table[63] == np.arange(256)).all() and len(np.unique(table[0])) == 1
        for level in (0, 1, 20, 45, 62):
            wanted = np.rint(dark + (colours - dark) * level / 63)
            away = ((wanted[:, None] - colours[None]) ** 2).sum(axis=2)
            assert (away[np.arange(256), table[level]] == away.min(axis=1)).all()
    assert (colours[tables[0][0, 0]] == (0x80, 0x90, 0xA0)).all()  # it is the background's too


def test_a_flat_colour_becomes_a_ramp_from_the_fog(tmp_path) -> None:
    made = make(tmp_path, START + f'm = {{ colour = "#c04020", fog = true }}\n{BOX}material = "m"\n')
    material, instance = made.materials[0], made.instances[0]
    assert material.mapper == "gouraud"
    ends = [made.palette[instance.dark >> 16].tolist(), made.palette[instance.bright >> 16].tolist()]
    assert ends == [[0x80, 0x90, 0xA0], [0xC0, 0x40, 0x20]] and (instance.bright >> 16) - (instance.dark >> 16) == 31


FADING = 'm = { texture = "brick", mapper = "lit_gouraud", fog = true }\n'
ONE_BOX = f'{BOX}material = "m"\n{UVS}'


@pytest.mark.parametrize("text, message", [
    (START.replace("far = 12", "far = 3") + FADING + ONE_BOX, "fog.far: must be above near, 3"),
    (START.replace("far = 12", "far = 3.000001") + FADING + ONE_BOX, "fog.far: must be above near, 3"),
    (START.replace("near = 3", "near = -1") + FADING + ONE_BOX, "fog.near: must be from 0 to 16384"),
    (START.replace("far = 12", "far = 20000") + FADING + ONE_BOX, "fog.far: must be from 0 to 16384"),
    (START.replace("far = 12\n", "") + FADING + ONE_BOX, "fog.far: is missing"),
    (START.replace("far = 12", "far = 12\ndensity = 1") + FADING + ONE_BOX, "fog.density: unknown field"),
    (START.replace('[fog]\ncolour = "#8090a0"', '[fog]\ncolour = "grey"') + FADING + ONE_BOX, "fog.colour: must be"),
    (START.replace('[fog]\ncolour = "#8090a0"\nnear = 3\nfar = 12\n', "") + FADING + ONE_BOX,
     "materials.m.fog: the scene has no [fog]"),
    (START + FADING.replace(", fog = true", "") + ONE_BOX, "fog: no material has `fog = true`"),
    (START + FADING.replace("lit_gouraud", "affine") + ONE_BOX,
     'materials.m.fog: is for a colour or a texture with the mapper "lit" or "lit_gouraud"; this material has the mapper '
     '"affine"'),
    (START + FADING.replace("lit_gouraud", "keyed") + ONE_BOX, 'this material has the mapper "keyed"'),
    (START + 'm = { shades = ["#000000", "#ffffff"], fog = true }\n' + f'{BOX}material = "m"\n',
     "materials.m.fog: is for a colour or a texture with the mapper"),
    ('format = "rgb565"\n' + START + 'm = { colour = "#ffffff", fog = true }\n' + f'{BOX}material = "m"\n',
     'materials.m.fog: needs pixels of one byte, but format is "rgb565"'),
    ('format = "rgb565"\n' + START + 'm = { glide = { units = [{ image = "x.png", format = "p8" }] }, fog = true }\n'
     + ONE_BOX, 'materials.m.fog: needs pixels of one byte, but format is "rgb565"'),
    (START + FADING + '[[objects]]\nmaterial = "m"\nsides = 3\nradius = 9\n' + ONE_BOX,
     "objects[0].material: material 'm' has fog, which is for objects in space"),
    (START + FADING + ONE_BOX + 'normals = "faces"\n', "objects[0].normals: material 'm' has no use for them"),
    (START + FADING.replace("true", "1") + ONE_BOX, "materials.m.fog: must be true or false"),
])
def test_refused(tmp_path, text: str, message: str) -> None:
    """Each in one line, which names the file's line."""
    with pytest.raises(UserError) as caught:
        make(tmp_path, text)
    said = str(caught.value)
    assert message in refusals.without_line(said, tmp_path / "scene.toml")


@pytest.mark.parametrize("changes, said", [
    ({"flags": FOG | LIT}, "flags: fog is for a light table, or Gouraud's, alone"),
    ({"material": 1}, "flags: fog is for a light table, or Gouraud's, alone"),
    ({"fog_near": -1}, "fog_near: -1"), ({"fog_far": 3 * ONE}, "fog_far: 196608"),
    ({"fog_far": (1 << 30) + 1}, "fog_far: 1073741825"), ({"dark": -1}, "dark: -1"), ({"bright": 1 << 24}, "bright: ")])
def test_wrong_files_are_refused(tmp_path, changes: dict, said: str) -> None:
    made = make(tmp_path, START + FADING + 'red.colour = "#ff0000"\n' + ONE_BOX)
    made.instances[0] = replace(made.instances[0], **changes)
    with pytest.raises(UserError) as caught:
        scene_file.write(made)
    assert f"instances[0].{said}" in str(caught.value)


def test_nothing_is_executed_without_fog(tmp_path) -> None:
    """The routine that fades corners, in a traced run of every instruction."""
    found = {}
    for fog in (True, False):
        text = START + FADING + ONE_BOX + "frames = 1\n"
        text = text.replace("frames = 3\n", "", 1).replace("frames = 1\n", "")
        text = "frames = 1\n" + text
        if not fog:
            text = text.replace(", fog = true", "").replace('[fog]\ncolour = "#8090a0"\nnear = 3\nfar = 12\n', "")
        sections = scene_program.load_sections(make(tmp_path, text))
        trace = scene_program.measure(sections, tmp_path / f"trace{fog}")
        found[fog] = sum(len(offsets) for section, (offsets, _) in trace.items() if "_mesh_fade" in section.symbols)
    assert found[True] > 0 and found[False] == 0
