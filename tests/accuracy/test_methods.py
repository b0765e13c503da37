"""The turning face by the note's three methods: their errors, drawn on the machine."""

from dataclasses import replace

import numpy as np
from PIL import Image

from tmap.accuracy import methods
from tmap.ideal import bounds
from tmap.model import model
from tmap.model.mesh import polygons_at


def test_each_method_is_as_exact_as_it_says(monkeypatch, tmp_path) -> None:
    """The frames are the model's. Affine methods are off by tens of texels, pieces by their chord
    errors and the derived bounds, division at each pixel by 1/16 texel (lines by tables are raised
    by the 1/32 that they may fall short by) and 1/128 at most."""
    whole = methods.scene_of

    def short(settings):
        scene = whole(settings)
        return replace(scene, frames=methods.SHOWN + 1)

    monkeypatch.setattr(methods, "scene_of", short)
    found = {m.name: m for m in methods.measure("a1200-fast")}
    for name, settings in methods.METHODS.items():
        scene = short(settings)
        expected = scene.palette[np.stack([model.render(scene, k) for k in range(scene.frames)])]
        assert np.array_equal(found[name].frames, expected), name
    errors = {name: m.errors.worst for name, m in found.items()}
    assert min(errors[n] for n in errors if n.startswith(("2", "3", "affine"))) > 20
    assert errors["every 16 pixels"] > 2 * errors["every 8 pixels"] > 4 * errors["1: each pixel"]
    assert errors["1: each pixel"] < 1 / 16 and errors["each pixel, fine"] < 1 / 128
    for name, settings in methods.METHODS.items():
        scene, total = short(settings), bounds.Verdict()
        for number in range(scene.frames if settings.perspective != "none" else 0):
            for which, vertices in polygons_at(scene, number):
                polygon = model.prepare_polygon(scene, which, vertices)
                total.merge(bounds.judge_set_up(model.adapt(vertices, settings, 256), polygon, settings,
                                                scene.width, scene.height, (256, 256)))
        assert not total.complaint, name
        assert settings.perspective == "none" or errors[name] <= total.texel_error + 2**-24, name
    for ladder in (("every 16 pixels", "every 8 pixels"), ("1: each pixel", "each pixel, fine")):
        cycles = [found[n].cycles for n in ("affine, from the plane", *ladder)]
        assert cycles == sorted(cycles)
    methods.write_picture(list(found.values()), tmp_path / "methods.png")
    methods.write_animation(list(found.values()), tmp_path / "methods.gif")
    assert len(methods.table(list(found.values()), "a1200").splitlines()) == 2 + len(found)
    with Image.open(tmp_path / "methods.gif") as moving:
        assert (moving.size, moving.n_frames) == ((960, 288), 2 * (methods.SHOWN + 1) - 2)
