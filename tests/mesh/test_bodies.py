"""Bodies that are tested by z beside a tree: hidden ones are left out, and the picture is the model's all the same."""

import random
from dataclasses import replace

from tests.helpers import guest_runs
from tests.mesh.test_near import TESTED, assert_model, head, room, things
from tests.mesh.test_once import BOX, LOOKS, SQUARE, make

BOARD = "points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]\nfaces = [[0, 1, 2, 3]]\ntwo_sided = true\n"


def walls(rng: random.Random, count: int) -> str:
    """Boards of a tree, most of them large and across the view."""
    text = ""
    for _ in range(count):
        place = [round(rng.uniform(-3, 3), 2) for _ in range(3)]
        turn = [rng.choice((0, 0, rng.randint(0, 359))), rng.choice((0, 90, rng.randint(0, 359))), 0]
        text += f'[[objects]]\n{BOARD}material = "m0"\nposition = {place}\nrotation = {turn}\n' \
                f'size = {rng.choice((1, 2, 4))}\norder = "bsp"\n{SQUARE}\n'
    return text


def scene(rng: random.Random, bodies: int) -> str:
    """Bodies among walls, and in them; some turn, some are at their places."""
    looks = [rng.choice([look for look in LOOKS if "texture" in look]), "colour = \"#806040\"", *TESTED]
    eye, target = ([round(rng.uniform(-4, 4), 2) for _ in range(3)] for _ in range(2))
    text = head(rng, looks, f"fov = {rng.choice((40, 75, 100, 150))}\neye = {eye}\ntarget = {target}")
    text += room("m1", [0, 0, 0], 4.5) + walls(rng, rng.randint(3, 8))
    made = things(rng, bodies, TESTED, 4, "z").replace('"m1"', '"m3"').replace('"m0"', '"m2"')
    return text + made.replace('order = "z"', 'order = "z"\nturns = 0.4\naxis = [1, 1, 0]', bodies // 3)


def test_random_bodies(tmp_path) -> None:
    rng = random.Random("bodies")
    assert_model([make(tmp_path, scene(rng, 10)) for _ in range(16)])


def test_hidden_bodies_are_left_out(tmp_path) -> None:
    """Behind a wall that fills the frame they cost less than a fifth of what they cost where they are seen."""
    text = head(random.Random(0), [LOOKS[0], *TESTED], "eye = [0, 0, 9]\ntarget = [0, 0, 0]\nfov = 70")
    wall = f'{BOX}material = "m0"\nposition = [0, 0, AT]\nsize = 30\norder = "bsp"\n'
    body = "".join(f'{BOX}material = "m1"\nposition = [{k % 5 - 2}, {k // 5 - 1}, {-k % 3}]\nsize = 0.3\norder = "z"\n'
                   for k in range(15))
    scenes = [make(tmp_path, text + wall.replace("AT", at) + more) for at, more in (
        ("-27", ""), ("-27", body), ("-35", body))]
    drawn = guest_runs.draw([guest_runs.Asked(each, counted=False) for each in scenes], timed=True)
    empty, hidden, seen = (int(each.digests["ticks"].min()) for each in drawn)
    assert (drawn[0].digests["hash"] == drawn[1].digests["hash"]).all()
    assert hidden - empty < (seen - empty) / 5, (empty, hidden, seen)


def test_other_frames_lack_them(tmp_path) -> None:
    """Bodies that are not in all frames; their numbers count from the first one."""
    rng = random.Random("lack")
    made = make(tmp_path, scene(rng, 8))
    some = [replace(each, first_frame=k % 3, views=min(each.views, 3 - k % 3)) if each.tree < 0 else each
            for k, each in enumerate(made.instances)]
    assert_model([replace(made, instances=some)])
