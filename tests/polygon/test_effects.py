"""The rotator and the lit scene have the features they are meant to show. That the guest draws them
as the model does: tests/accuracy/test_scene_errors.py."""

import numpy as np

from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import model


def test_rotator() -> None:
    """The rotator covers the screen at every angle, and the texels' steps turn: along rows first,
    along columns after a quarter."""
    scene = compile_scene(SCENES / "rotator.toml", 24)
    for number in range(scene.frames):
        made = [model.prepare(scene, obj, number) for obj in scene.objects]
        assert sum(polygon.pixels for polygon in made) == 320 * 256, number
        steps = [(polygon.texturing.dudx, polygon.texturing.dvdx) for polygon in made]
        assert {(u != 0, v != 0) for u, v in steps} == {{0: (True, False), 16: (False, True)}.get(
            number, (True, True))}, number


def test_lit_scene() -> None:
    """Eight panels along the top have one level each, ever brighter, then ever darker; the disc's
    levels change within its spans."""
    scene = compile_scene(SCENES / "lit.toml", 1)
    assert {material.mapper for material in scene.materials} == {"lit", "lit_gouraud"}
    shown = scene.palette[model.render(scene, 0)].astype(int).sum(axis=2)
    panels = [shown[:16, 40 * k:40 * k + 40].mean() for k in range(8)]
    assert panels[:4] == sorted(panels[:4]) and panels[4:] == sorted(panels[4:], reverse=True)
    light = scene.textures[scene.materials[0].light].texels
    assert (light[63] == np.arange(256)).all()
