"""Directions in scenes: their length does not matter, however small or large. A vector without a
direction, or with an invalid number, is refused in one line."""

import warnings

import pytest
from tests.helpers.refusals import without_line
from tests.mesh.test_space import OBJ, changed, folder, make, on_file, placed  # noqa: F401

from tmap.base.errors import UserError

#: The least positive number, one whose square is 0, ordinary ones, the largest coordinate.
LENGTHS = (5e-324, 1e-200, 1e-9, 1.0, 3.0, 1e5)


def tables(folder, text: str) -> list[list]:
    """Returns all tables that a scene's directions may change; warnings are errors."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made = make(folder, text)
    return [made.views.tolist(), made.normals.tolist()]


def light(vector: str) -> str:
    """GOOD with a lit mesh and this direction of the light."""
    return on_file("glow", "turns = 1") + f"[light]\ndirection = {vector}\n"


def axis(vector: str) -> str:
    """GOOD with a mesh that turns about this axis."""
    return placed(f"turns = 0.3\naxis = {vector}")


def up(vector: str) -> str:
    """GOOD with a camera with this up vector."""
    return changed("eye = [0, 0, 10]", f"eye = [0, 0, 10]\nup = {vector}")


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("text, most", [(light, 1e5), (up, 1e5), (axis, 1.0)])
def test_length_does_not_matter(folder, text, most: float, length: float) -> None:
    """Along an axis, and along a diagonal with equal components: a unit vector and one of that
    length give the same tables."""
    for sign in ([1, 0, 0], [0, -1, 0], [-1, 1, 0]):
        long = [min(length, most) * part for part in sign]
        assert tables(folder, text(str(long))) == tables(folder, text(str([float(c) for c in sign]))), sign


@pytest.mark.parametrize("text, field", [(light, "light.direction"), (up, "camera.up"),
                                         (axis, "objects[1].axis")])
@pytest.mark.parametrize("number, said", [
    ("0.0", ": must have a length"), ("nan", "[1]: must be from "), ("inf", "[1]: must be from "),
    ("-inf", "[1]: must be from "), ("1e200", "[1]: must be from "), ("-1e300", "[1]: must be from ")])
def test_no_direction_is_refused(folder, text, field: str, number: str, said: str) -> None:
    with pytest.raises(UserError) as caught:
        tables(folder, text(f"[0, {number}, 0]"))
    line = without_line(str(caught.value), folder / "scene.toml")
    assert line.startswith(f"{folder / 'scene.toml'}: {field}{said}"), line


@pytest.mark.parametrize("length", ["1e-300", "1e-20", "2", "1e20", "1e300"])
def test_normals_of_a_file_may_have_any_length(folder, length: str) -> None:
    """From the least to the largest numbers."""
    (folder / "mesh.obj").write_text(OBJ.replace("vn 0 0 2", f"vn 0 {length} {length}"))
    assert tables(folder, on_file("glow"))[1][-1] == [0, 11585, 11585, 0]  # 2^14 / sqrt(2)


@pytest.mark.parametrize("normal", ["0 0 0", "1e-999 0 0", "0 1e999 0"])
def test_normals_without_direction_are_refused(folder, normal: str) -> None:
    """Numbers beyond the range of floating point are read as 0 or infinity."""
    (folder / "mesh.obj").write_text(OBJ.replace("vn 0 0 2", f"vn {normal}"))
    with pytest.raises(UserError, match=r"objects\[1\].mesh: mesh.obj: line 11: has a normal without"):
        tables(folder, on_file("glow"))
