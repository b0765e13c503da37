"""The range of depths, 1/256 to 16,384: every kind of scene accepts its ends and draws them right,
and refuses depths beyond with one line."""

import math

import numpy as np
import pytest

from tests.helpers.engine_scenes import check_refused, compiled, save_noise, scene_text
from tmap.corpus import hard_cases
from tmap.guest import guest_frames
from tmap.ideal import bounds
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import IDENTITY, SETTINGS, Material, Object, Scene, Texture

LEAST, MOST, ONE = 1 / 256, 16384.0, 65536
WAYS = SETTINGS["perspective"][1:]
PLACE = "objects[0].vertices"
OWN = "st1 = [[0, 0], [8, 0], [0, 8]]\nw1 = [1, W, 1]"
#: The material, the triangle with W as its depth, the scene's pixel format.
TRIANGLE = "vertices = [[0, 0, 0, 0, 1], [32, 0, 32, 0, W], [0, 32, 0, 32, 1]]"
UNIT = 'image = "noise.png", format = "rgb565"'
KINDS = {
    "affine": ('texture = "noise", perspective = "pixel"', TRIANGLE, "chunky", PLACE + "[1][4]"),
    "N64": ("n64 = { perspective = true, tiles = [{ image = 'noise.png', format = 'rgba16' }] }",
            TRIANGLE, "rgba8888", PLACE + "[1][4]"),
    "Glide": (f"glide = {{ perspective = true, units = [{{ {UNIT} }}] }}", TRIANGLE, "rgb565",
              PLACE + "[1][4]"),
    "Glide's second unit": (f"glide = {{ perspective = true, units = [{{ {UNIT} }}, {{ {UNIT}, own = true }}] }}",
                            TRIANGLE.replace("W", "1") + "\n" + OWN, "rgb565", "objects[0].w1[1]")}


def text_of(kind: str, w: float) -> str:
    material, triangle, pixels, _ = KINDS[kind]
    head = 'textures.noise.image = "noise.png"\n' if kind == "affine" else ""
    return head + scene_text(material, triangle.replace("W", repr(w)), pixels)


@pytest.fixture
def folder(tmp_path):
    save_noise(tmp_path, 3, noise=(32, 32))
    return tmp_path


@pytest.mark.parametrize("w", [LEAST, MOST])
@pytest.mark.parametrize("kind", KINDS)
def test_the_ends_are_taken(folder, kind: str, w: float) -> None:
    """The compiler and the check before a file is written accept both ends, unchanged."""
    scene = compiled(folder, text_of(kind, w))
    assert int(w * ONE) in scene.vertices[:, 5].tolist()
    scene_file.write(scene)


@pytest.mark.parametrize("w", [math.nextafter(LEAST, 0), math.nextafter(MOST, math.inf), math.nan,
                               math.inf, -1.0, 1e300])
@pytest.mark.parametrize("kind", list(KINDS)[:3])
def test_what_lies_beyond_is_refused(folder, kind: str, w: float) -> None:
    """The next floating-point number beyond an end is refused."""
    check_refused(folder, text_of(kind, w), f"{KINDS[kind][3]}: must be from 0.00390625 to 16384")


@pytest.mark.parametrize("w, said", [
    (math.nextafter(MOST, math.inf), "from -16384 to 16384"), (math.nan, "from -16384 to 16384"),
    (-math.nextafter(MOST, math.inf), "from -16384 to 16384"),
    (0.0, "1/65536 or more away from 0"), (1e-9, "1/65536 or more away from 0")])
def test_a_second_units_depths_may_be_negative(folder, w: float, said: str) -> None:
    """Negative depths are behind a projector; only numbers near 0 have no meaning."""
    kind = "Glide's second unit"
    check_refused(folder, text_of(kind, w), f"{KINDS[kind][3]}: must be {said}")
    assert -(1 << 30) in compiled(folder, text_of(kind, -MOST)).vertices[:, 5].tolist()


@pytest.mark.parametrize("vertex, place", [("[16384, 0, 32, 0, 1]", "[1][0]"), ("[32, -16384, 32, 0, 1]", "[1][1]"),
                                           ("[32, 0, 16384, 0, 1]", "[1][2]"), ("[32, 0, 32, nan, 1]", "[1][3]")])
def test_places_end_before(folder, vertex: str, place: str) -> None:
    """Each number of a vertex has its own range."""
    text = text_of("affine", MOST).replace("[32, 0, 32, 0, 16384.0]", vertex)
    check_refused(folder, text, f"{PLACE}{place}: must be from -16383 to 16383")


def polygons() -> list[list[tuple[int, ...]]]:
    """Triangles as large as a frame, and squares flat in space, with both ends of the range."""
    near, far, made = int(LEAST * ONE), int(MOST * ONE), []
    corners = [(3 * ONE, 5 * ONE), (90 * ONE + 77, 11 * ONE), (40 * ONE, 60 * ONE + 4321)]
    for k in range(3):
        for depths in ((near, far, far), (near, near, far), (far, 5 * ONE, near)):
            made.append([(*corners[(i + k) % 3], *((0, 0), (256 * ONE, 0), (0, 256 * ONE))[i], 0, w)
                         for i, w in enumerate(depths)])
    for a, b in ((near, far), (far, near)):
        for turned in (False, True):
            sides = [(0, 0, a), (80, 0, b), (80, 60, b), (0, 60, a)]
            made.append([((y if turned else x) * ONE, (x if turned else y) * ONE, (x > 0) * 256 * ONE,
                          (y > 0) * 256 * w // far * ONE, 0, w) for x, y, w in sides])
    return made


def test_both_ends_in_one_polygon_are_drawn_right() -> None:
    """With each perspective setting the emulated machine draws the model's pixels, and the model is
    within its bounds."""
    kinds = [Material("affine", "exact", perspective=way, texture=0) for way in WAYS]
    noise = np.random.default_rng(3).integers(0, 256, (256, 256), dtype=np.uint8)
    objects, vertices = [], []
    for corners in polygons():
        for k in range(len(kinds)):
            objects.append(Object(k, len(vertices), len(corners), 0, 1, len(objects)))
        vertices += corners
    scene = Scene(hard_cases.WIDTH, hard_cases.HEIGHT, len(objects), 7, np.zeros((256, 3), np.uint8),
                  [Texture(noise)], kinds, objects, np.array(vertices), np.array([IDENTITY]))
    digests, = guest_frames.draw([(scene, "addx")], "a1200-fast")
    sure = 0
    for number, digest in enumerate(digests):
        corners, way = polygons()[number // len(kinds)], WAYS[number % len(kinds)]
        assert guest_frames.is_models(model.render(scene, number), digest), (way, corners)
        verdict = bounds.judge(corners, model.Settings("exact", perspective=way), scene.width, scene.height)
        assert not verdict.complaint, (way, corners, verdict.complaint)
        sure += not verdict.unsure
    assert sure > len(digests) / 2, f"{sure} of {len(digests)} are drawn with perspective"
