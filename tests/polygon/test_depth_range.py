"""The range of depths, 1/256 to 16,384: every kind of scene accepts its ends, and refuses depths
beyond with one line. That both ends in one polygon are drawn right is in the hard cases."""

import math

import pytest

from tests.helpers.engine_scenes import check_refused, compiled, folder, scene_text  # noqa: F401
from tmap.scene_file import scene_file

LEAST, MOST, ONE = 1 / 256, 16384.0, 65536
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


@pytest.mark.parametrize("w", [LEAST, MOST])
@pytest.mark.parametrize("kind", KINDS)
def test_the_ends_are_taken(folder, kind: str, w: float) -> None:
    """The compiler and the check before a file is written accept both ends, unchanged."""
    scene = compiled(folder, text_of(kind, w))
    assert int(w * ONE) in scene.vertices[:, 5].tolist()
    assert kind != "affine" or scene.materials[0].perspective == "pixel"
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
