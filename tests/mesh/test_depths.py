"""Scenes with ``order = "z"``: what is refused, which pixels are drawn, and the error of q, by exact fractions."""

from dataclasses import replace
from fractions import Fraction

import pytest

from tests.mesh.test_meshes import assert_models
from tests.mesh.test_orders import CROSS, START, beam, make
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import depths, model
from tmap.model.mesh import steps_at
from tmap.run import memory
from tmap.scene_file import scene_file
from tmap.setup.polygon import adapt, outline_of
from tmap.setup.texturing import Settings

TESTED = beam("red", order="z") + beam("green", "turns = 1", "rotation = [0, 0, 90]", order="z") \
    + beam("blue", "rotation = [0, 90, 0]", order="depth")


def test_tested_ones_come_first_and_part_no_tree(tmp_path) -> None:
    made = make(tmp_path, beam("red") + beam("green", "turns = 1", order="z") + beam("blue"))
    assert [each.tree for each in made.instances] == [-2, 0, 0]


def test_still_beams_are_those_of_the_tree(tmp_path) -> None:
    """By z and by the tree: the same picture but for pixels on the lines where beams meet."""
    tree, tested = make(tmp_path, CROSS), make(tmp_path, CROSS.replace("bsp", "z"))
    for k in range(6):
        wrong = (model.render(tree, k) != model.render(tested, k)).sum()
        assert wrong <= 12, wrong


def test_machine_draws_the_models_pixels(tmp_path) -> None:
    """Also cut by the near plane, with light, maps and perspective, with any order beside it, on a frame that the
    background shows through."""
    lit = '[textures]\nt.image = "checker.png"\n'
    (tmp_path / "checker.png").write_bytes((SCENES / "checker.png").read_bytes())
    near = TESTED.replace('order = "z"', 'order = "z"\nsize = 3', 1)
    uvs = "uvs = [[[0, 0], [256, 0], [256, 256], [0, 256]]]"
    scenes = {"flat": make(tmp_path, TESTED), "near": make(tmp_path, near)}
    start = START.replace("[materials]", lit + '[materials]\nmap = { texture = "t", perspective = "every16" }\n'
                                               'affine.texture = "t"\nexact = { colour = "#ffff00", edges = "exact" }')
    text = start + "".join(beam(name, *more, uvs, f"rotation = [{31 * k}, {47 * k}, 10]", order=order)
                           for k, (name, order, *more) in enumerate(
                               (("map", "z", "turns = 1"), ("affine", "bsp"), ("affine", "z", "size = 2.5"),
                                ("map", "bsp"), ("exact", "depth"))))
    (tmp_path / "scene.toml").write_text(text.replace(f'{uvs}\nrotation = [124, 188, 10]', "rotation = [9, 9, 9]"))
    scenes["maps"] = compile_scene(tmp_path / "scene.toml")
    scene_file.write(scenes["maps"])
    assert_models(scenes)


def exact_q(three, x: int, y: int) -> Fraction:
    """The value at a pixel of the plane through three corners (x, y, q), 16.16."""
    (ax, ay, a), (bx, by, b), (cx, cy, c) = three
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    px, py = (x << 16) - ax, (y << 16) - ay
    return a + ((b - a) * (px * (cy - ay) - (cx - ax) * py) + (c - a) * ((bx - ax) * py - px * (by - ay))) / area


@pytest.mark.parametrize("number", (0, 17, 40))
def test_q_is_within_its_bound(number: int) -> None:
    """At every pixel of tested faces and of each eighth line of others."""
    scene, checked = compile_scene(SCENES / "movers.toml"), 0
    faces = [(what, face) for what, some, _ in steps_at(scene, number) if what.startswith(("fill", "test")) for face in some]
    for what, (which, vertices, _) in faces:
        made = depths.found(scene, which, vertices)
        if made is None or made[1].dx == made[1].dy == 0:
            continue
        settings = replace(Settings.of(scene.materials[which]), mapper="flat")
        places = [(*v[:2], w) for v, w in zip(adapt(vertices, settings, 256), [v[5] for v in vertices])]
        outline = outline_of([(*p[:2], 0, 0) for p in places], scene.width, scene.height, settings)
        three = [(*places[k][:2], Fraction((scene.near_plane >> 1) << 30, places[k][2])) for k in outline.corners]
        (polygon,), plane = made
        for y, line in enumerate(polygon.lines, polygon.top):
            if line.right <= line.left or what != "test" and y % 8:
                continue
            q = plane.line(line.left, line.right - line.left, y)
            for n in {0, len(q) // 2, len(q) - 1}:
                off = abs(int(q[n]) - exact_q(three, line.left + n, y))
                assert off <= plane.off + Fraction(n, 2), (which, vertices, line.left + n, y, float(off))
                checked += 1
    assert checked > 400


@pytest.mark.parametrize("material, more, said", [
    ('{ colour = "#ff0000", edges = "subpixel" }', "", 'needs edges "snapped" or "exact", but material "red" has '
                                                       '"subpixel"'),
    ('{ colour = "#ff0000" }', 'format = "rgb565"\n', 'needs pixels of one byte, but format is "rgb565"')])
def test_what_cannot_be_tested_is_refused(tmp_path, material: str, more: str, said: str) -> None:
    text = more + START.replace('red.colour = "#ff0000"', f"red = {material}") + beam("red", order="z")
    (tmp_path / "scene.toml").write_text(text)
    with pytest.raises(UserError) as error:
        compile_scene(tmp_path / "scene.toml")
    assert said.replace('material "red"', "material 'red'") in str(error.value) and ".order" in str(error.value)


def test_memory_is_taken_where_it_is_used(tmp_path) -> None:
    """4 bytes of z and one aside for each pixel, a line's bounds, parts and corners; nothing without z."""
    plain, tested = (sum(memory.mesh_bytes(make(tmp_path, TESTED.replace('"z"', f'"{order}"'))))
                     for order in ("depth", "z"))
    assert 5 * 96 * 64 < tested - plain < 5 * 96 * 64 + 64 * 12 + 1400
