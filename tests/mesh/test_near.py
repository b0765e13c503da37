"""Trees that are drawn each pixel once, from their nearest nodes on: the model's picture, whatever is left out."""

import random
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.mesh.test_once import BOX, LOOKS, SQUARE, boxes, hidden, make, posts
from tmap.run import memory
from tmap.scene_file.scene_file import Scene

TESTED = ['colour = "#40c0e0"', 'texture = "brick"']


def head(rng: random.Random, looks: list[str], camera: str) -> str:
    """A scene without objects."""
    text = boxes(rng, looks)
    return text[:text.index("[camera]")] + f"[camera]\n{camera}\n"


def inside_out(faces: str) -> str:
    """A box whose faces are seen from inside."""
    rows = [row.strip(" []").split(",") for row in faces.splitlines()[2].split("=")[1].split("],")]
    turned = ", ".join(f"[{', '.join(n.strip() for n in reversed(row))}]" for row in rows)
    return faces.replace(faces.splitlines()[2], f"faces = [{turned}]")


def room(look: str, place: list, size: float) -> str:
    return f'{inside_out(BOX)}material = "{look}"\nposition = {place}\nsize = {size}\norder = "bsp"\n'


def things(rng: random.Random, count: int, looks: list[str], spread: float, order: str = "bsp") -> str:
    """Boxes of a tree."""
    text = ""
    for _ in range(count):
        look = rng.randrange(len(looks))
        place = [round(rng.uniform(-spread, spread), 3) for _ in range(3)]
        turn = [rng.choice((0, 0, rng.randint(0, 359))) for _ in range(3)]
        text += f'{BOX}material = "m{look}"\nposition = {place}\nrotation = {turn}\norder = "{order}"\n' \
                f"size = {rng.choice((0.2, 0.4, 1))}\n" + (SQUARE + "\n") * ("texture" in looks[look])
    return text


def flight(rng: random.Random, reach: float) -> str:
    """A camera at random places that looks at random ones; its frames are 0 to 2."""
    keys = []
    for frame in range(3):
        eye, target = ([round(rng.uniform(-reach, reach), 2) for _ in range(3)] for _ in range(2))
        keys.append(f"{{ frame = {frame}, eye = {eye}, target = {target} }}")
    return f"fov = {rng.choice((40, 70, 110))}\nkeys = [{', '.join(keys)}]"


def tree(rng: random.Random, is_room: bool, reach: float, tested: bool = False) -> str:
    """A tree; looks: all of LOOKS by and by. With ``tested`` some boxes by z among it."""
    looks = rng.sample(LOOKS, 3) + TESTED
    text = head(rng, looks, flight(rng, reach))
    text += room("m3", [0, 0, 0], 4.5) if is_room else ""
    text += things(rng, rng.randint(5, 10), looks[:3], 3)
    return text + (things(rng, 3, TESTED, 2, "z").replace('"m0"', '"m3"').replace('"m1"', '"m4"') if tested else "")


def assert_model(scenes: list[Scene], machine: str = "a1200-fast") -> list[guest_runs.Drawn]:
    """Asserts that scenes, drawn once, have the model's picture."""
    asked = [guest_runs.Asked(scene) for scene in scenes]
    drawn = guest_runs.draw(asked, machine)
    for number, each in enumerate(zip(asked, drawn)):
        guest_runs.check(f"scene {number}", *each, machine)
    return drawn


@pytest.mark.parametrize("seed", range(2))
def test_random_trees(tmp_path, seed: int) -> None:
    """Cameras inside a room, whose walls fill the frame, and outside of all, which look anywhere; boxes by z among
    both."""
    rng = random.Random(f"near {seed}")
    scenes = [make(tmp_path, tree(rng, k % 2 == 0, (3, 12)[k // 2 % 2], k % 3 == 0)) for k in range(12)]
    assert all(scene.once and len(scene.nodes) for scene in scenes)
    assert sum(map(hidden, assert_model(scenes))) > 1000


def test_nothing_is_in_view(tmp_path) -> None:
    """A camera that looks away from the whole tree, and one that is in front of its near plane."""
    rng = random.Random("away")
    scenes = [make(tmp_path, head(rng, LOOKS[:2], f"eye = [0, 0, {eye}]\ntarget = [0, 0, {eye + way}]") + things(
        rng, 5, LOOKS[:2], 3)) for eye, way in ((40, 1), (40, -1), (3.02, 0.5))]
    drawn = assert_model(scenes)
    assert len(set(drawn[0].digests["hash"].tolist())) == 1
    assert set(drawn[0].digests["hash"].tolist()) != set(drawn[1].digests["hash"].tolist())


def test_too_many_gaps_of_a_tree(tmp_path) -> None:
    """Then all of the tree is drawn back to front, what had not been reached too; z of all of it counts."""
    text = posts(13).replace("height = 96", "height = 6").replace("turns = 0.2\naxis = [1, 0, 0]\n", "")
    text = text.replace("size = 12\n", 'size = 12\norder = "bsp"\n').replace("two_sided = true", 'order = "bsp"\ntwo_sided = true')
    tested = f'{BOX}material = "m1"\nposition = [0.5, 0, -1]\nsize = 0.5\norder = "z"\n'
    assert_model([make(tmp_path, text), make(tmp_path, text + tested)])


def test_instances_that_lack_or_differ(tmp_path) -> None:
    """A file's tree whose instances are not all in each frame, and one whose instances have other views."""
    rng = random.Random("lacks")
    scene = make(tmp_path, tree(rng, True, 3))
    lacking = [replace(each, first_frame=k % 3, views=min(each.views, 3 - k % 3))
               for k, each in enumerate(scene.instances)]
    moved = scene.views.copy()
    moved[:, 9] += 1 << 15
    differing = [replace(each, view=each.view + len(moved) * (k == 1)) for k, each in enumerate(scene.instances)]
    assert_model([replace(scene, instances=lacking),
                  replace(scene, instances=differing, views=np.concatenate([scene.views, moved]))])


def test_memory_is_taken_where_pixels_are_drawn_once(tmp_path) -> None:
    scene = make(tmp_path, tree(random.Random(3), False, 5))
    once, painter = (memory.tree_bytes(replace(scene, once=each)) for each in (1, 0))
    assert once[:2] == painter and len(once) == 7
