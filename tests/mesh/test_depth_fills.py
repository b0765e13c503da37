"""What sets z for tested faces: the pixels of faces that are drawn, and no fewer faces than may hide them."""

import random

import numpy as np
import pytest

from tests.mesh.test_meshes import assert_models
from tests.mesh.test_once import BOX, SQUARE, make
from tests.mesh.test_orders import START
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.ideal import visible
from tmap.model import depths, model
from tmap.scene_file.scene_file import Scene
from tmap.setup import planarity

LOOKS = ['texture = "t", edges = "exact"', 'texture = "t", edges = "snapped"', 'texture = "t", gradients = "polygon"',
         *(f'texture = "t", perspective = "every16", edges = "{edges}"' for edges in ("exact", "snapped")),
         'colour = "#c08040", edges = "snapped"', 'shades = ["#201040", "#ffe0a0"]']


def header(looks: list[str], more: str = "") -> str:
    """A scene without objects; material ``m3`` looks as ``looks[3]``."""
    rest = START[START.index("[camera]"):]
    return f'width = 96\nheight = 64\nframes = 3\nbackground = "#203040"\n{more}[textures]\nt.image = ' \
           '"package:skimage/data/brick.png"\n[materials]\n' \
           + "".join(f"m{k} = {{ {look} }}\n" for k, look in enumerate(looks)) \
           + "[light]\ndirection = [1, -2, -1.5]\n" + rest


def bent(rng: random.Random, unit: int) -> list[tuple]:
    """A polygon of four or five corners of which one is within a unit of the line between its neighbours, on which
    there are pixels."""
    a = rng.randint(0, 30), rng.randint(0, 20)
    b = a[0] + rng.choice((0, rng.randint(1, 40))), a[1] + rng.randint(1, 40)
    c, d = ((p[0] + rng.randint(10, 40), p[1] - rng.randint(0, 20)) for p in (b, a))
    part = rng.random()
    middle = [(p << 16) + int((q - p << 16) * part) // unit * unit + rng.choice((-unit, 0, unit)) for p, q in zip(a, b)]
    corners = [*((x << 16, y << 16) for x, y in (d, c, b)), tuple(middle), (a[0] << 16, a[1] << 16)]
    if rng.random() < 0.5:
        corners.pop(0)
    first = rng.randrange(len(corners))
    return [(x, y, 2 * x + rng.choice((0, 1 << 18)), 2 * y, 50 << 16, (1 << 32) // (13000 + 3 * (x >> 10)))
            for x, y in corners[first:] + corners[:first]]


def pixels(polygons) -> set[tuple[int, int]]:
    return {(x, y) for polygon in polygons if polygon for y, line in enumerate(polygon.lines, polygon.top)
            for x in range(line.left, line.right)}


def drawn(scene: Scene, which: int, vertices) -> set[tuple[int, int]]:
    """The pixels that a face is drawn at, by its columns if so."""
    made: set[tuple[int, int]] = set()
    for piece in depths.pieces_of(scene, scene.materials[which], vertices, planarity.IN_SPACE):
        polygon = model.prepare_polygon(scene, which, piece)
        made |= {(y, x) for x, y in pixels([polygon.columns])} if polygon and polygon.columns else pixels([polygon])
    return made


def test_a_face_sets_z_where_it_is_drawn(tmp_path, monkeypatch) -> None:
    """At no pixel less, where a tested face behind would be seen through it, and at none more, where it would hide one.
    By the outline of a whole face that is a fan it would be so."""
    scene = make(tmp_path, header(LOOKS) + "".join(f'{BOX}material = "m{k}"\n{SQUARE * ("texture" in look)}\n'
                                                  for k, look in enumerate(LOOKS)))
    rng, lacking = random.Random("fills"), 0
    for _ in range(6000):
        which = rng.randrange(len(LOOKS))
        vertices = bent(rng, 4096 if scene.materials[which].edges == "snapped" else 1)
        at, made = drawn(scene, which, vertices), depths.found(scene, which, vertices)
        assert at == pixels(made[0] if made else []), (LOOKS[which], vertices)
        with monkeypatch.context() as patch:
            patch.setattr(depths, "pieces_of", lambda _scene, _material, face, _vouched: [face])
            made = depths.found(scene, which, vertices)
            lacking += bool(at ^ pixels(made[0] if made else []))
    assert lacking > 300


def bent_face(rng: random.Random) -> str:
    """A wall with five corners, one near the line between its neighbours."""
    z, x, y = rng.uniform(-4, 1), rng.uniform(-3, 3), rng.uniform(-2, 2)
    ring = [[-1, -1], [1, -1], [1, 1], [round(rng.uniform(-0.9, 0.9), 2), 1], [-1, 1]]
    points = [[round(x + 2 * p, 3), round(y + 1.5 * q, 3), round(z, 3)] for p, q in ring]
    return f"[[objects]]\npoints = {points}\nfaces = [[0, 1, 2, 3, 4]]\ntwo_sided = true\n" \
           "uvs = [[[0, 0], [256, 0], [256, 256], [99, 256], [0, 256]]]\n"


def random_scene(rng: random.Random, once: bool) -> str:
    """Still boxes and walls in a tree, and boxes that turn through them, tested; ``once``: each pixel once."""
    looks = [look for look in LOOKS if not once or "snapped" not in look]
    text = header(looks, 'visible = "once"\n' * once)
    for k in range(10):
        which = rng.randrange(len(looks))
        place = [round(rng.uniform(-4, 4), 2), round(rng.uniform(-2, 2), 2), round(rng.uniform(-4, 2), 2)]
        if k in (3, 4):
            which = rng.randrange(3 - once)
            text += f'{bent_face(rng)}material = "m{which}"\norder = "bsp"\n'
            continue
        text += f'{BOX}material = "m{which}"\nposition = {place}\n{SQUARE * ("texture" in looks[which])}\n'
        text += f"rotation = {[rng.randint(0, 359) for _ in range(3)]}\nsize = {rng.choice((0.4, 0.8, 1.5))}\n"
        text += 'order = "bsp"\n' if k < 6 else f'order = "z"\naxis = [1, 1, 0]\nturns = {rng.random():.2f}\n'
    return text


@pytest.fixture(scope="module")
def scenes(tmp_path_factory) -> dict[str, Scene]:
    rng, folder = random.Random("z"), tmp_path_factory.mktemp("scenes")
    return {f"number {k}": make(folder, random_scene(rng, bool(k % 2))) for k in range(16)}


def test_random_scenes_are_the_models(scenes) -> None:
    assert_models(scenes)


def test_random_scenes_show_the_nearest_faces(scenes) -> None:
    for name, scene in scenes.items():
        for number in range(scene.frames):
            wrong = np.argwhere(visible.wrong(scene, number))
            assert not len(wrong), f"{name}, frame {number}: (y, x) {wrong[:8].tolist()}, {len(wrong)} in all"


def close_scene(rng: random.Random) -> str:
    """A wall across the view, steep or not, and tested walls beside it and through it, by as little as a few units of
    z. The renderer draws none of whose box z is nearer by more than q may be off (depths_hide)."""
    turn = [rng.randint(-75, 75), rng.randint(-75, 75), 0]
    text = header(LOOKS)
    for k in range(12):
        which, size = rng.randrange(len(LOOKS)), 9 if k == 0 else rng.choice((0.2, 0.5, 1.5))
        away = 0 if k == 0 else rng.choice((-1, 1)) * 2.0 ** rng.uniform(-12, -2)
        own = [round(c + (rng.choice((0, 0, 0.05, 2)) if k else 0), 2) for c in turn]
        place = [0, 0, 0] if k == 0 else [round(rng.uniform(-1, 1), 2), round(rng.uniform(-1, 1), 2), 0]
        points = [[x * size + p, y * size + q, away] for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
                  for p, q in [place[:2]]]
        text += f'[[objects]]\npoints = {points}\nfaces = [[0, 1, 2, 3]]\ntwo_sided = true\nmaterial = "m{which}"\n' \
                f'rotation = {own}\norder = "{"z" if k else "bsp"}"\n'
        text += "uvs = [[[0, 0], [256, 0], [256, 256], [0, 256]]]\n" * ("texture" in LOOKS[which])
    return text


def test_faces_close_to_a_wall_are_the_models(tmp_path) -> None:
    rng = random.Random("close")
    assert_models({f"number {k}": make(tmp_path, close_scene(rng)) for k in range(24)})


@pytest.mark.parametrize("name", ("keep", "movers", "random"))
def test_what_is_left_out_would_change_nothing(scenes, monkeypatch, name: str) -> None:
    """The picture is that of z filled by all faces that meet a tested one's part of the frame."""
    some = [*scenes.values()][:8] if name == "random" else [compile_scene(SCENES / f"{name}.toml")]
    fill = depths.Depths.fill
    for scene in some:
        numbers = range(0, scene.frames, max(1, scene.frames // 6))
        right = [model.render(scene, number) for number in numbers]
        with monkeypatch.context() as patch:
            patch.setattr(depths.Depths, "fill", lambda *face_of: fill(*face_of[:4], False))
            assert all((model.render(scene, number) == frame).all() for number, frame in zip(numbers, right))
