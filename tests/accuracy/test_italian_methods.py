"""The turning face by the note's three methods: their errors, drawn on the machine, and their
picture."""

import json

import numpy as np
import pytest
from PIL import Image

from tmap.accuracy import italian_methods
from tmap.ideal import bounds
from tmap.model import model
from tmap.model.mesh import polygons_at
from tmap.report import readme


@pytest.fixture(scope="module")
def found() -> dict[str, italian_methods.Method]:
    return {m.name: m for m in italian_methods.measure("a1200-fast")}


@pytest.mark.parametrize("name", italian_methods.METHODS)
def test_frames_and_errors(found, name: str) -> None:
    """The frames are the model's. Errors are within the derived bounds."""
    settings = italian_methods.METHODS[name]
    scene, total = italian_methods.scene_of(settings), bounds.Verdict()
    expected = scene.palette[np.stack([model.render(scene, k) for k in range(scene.frames)])]
    assert np.array_equal(found[name].frames, expected)
    if settings.perspective == "none":
        return
    for number in range(scene.frames):
        for which, vertices in polygons_at(scene, number):
            polygon = model.prepare_polygon(scene, which, vertices)
            total.merge(bounds.check_set_up(model.adapt(vertices, settings, 256), polygon, settings,
                                            scene.width, scene.height, (256, 256)))
    assert not total.complaint and found[name].errors.worst <= total.texel_error + 2**-24


def test_each_method_is_as_exact_as_it_says(found) -> None:
    """Affine methods are off by tens of texels, pieces by their chord errors, division at each
    pixel by 1/32 and 1/128 texel at most; what is more exact takes longer."""
    errors = {name: m.errors.worst for name, m in found.items()}
    assert min(errors[n] for n in errors if n.startswith(("2", "3", "affine"))) > 20
    assert errors["every 16 pixels"] > errors["every 8 pixels"] > 2 * errors["1: each pixel"]
    assert errors["1: each pixel"] < 1 / 32 and errors["each pixel, fine"] < 1 / 128
    for ladder in (("every 16 pixels", "every 8 pixels"), ("1: each pixel", "each pixel, fine")):
        cycles = [found[n].cycles for n in ("affine, from the plane", *ladder)]
        assert cycles == sorted(cycles)


def test_pictures(found, tmp_path) -> None:
    """The page's picture shows the current frames; so do the cycles and errors in it as text."""
    made = list(found.values())
    italian_methods.write_picture(made, tmp_path / "methods.png")
    italian_methods.write_animation(made, tmp_path / "methods.gif")
    assert len(italian_methods.table(made, "a1200").splitlines()) == 2 + len(found)
    with Image.open(tmp_path / "methods.gif") as moving:
        assert (moving.size, moving.n_frames) == ((960, 288), 2 * len(made[0].frames) - 2)
    with Image.open(readme.METHODS) as picture:
        shown = json.loads(picture.text["Description"])
    again = "the README's picture of methods is not today's: scripts/tmap readme"
    for name, figures in italian_methods.described(made).items():
        assert shown[name].pop("cycles") == pytest.approx(figures.pop("cycles"), rel=0.001), again
        assert shown.pop(name) == figures, again
    assert not shown
