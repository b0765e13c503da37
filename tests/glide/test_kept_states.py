"""Many small triangles of one state of a texture unit, which are drawn by what was kept of the first: the
model's pictures."""

from dataclasses import replace

import numpy as np
import pytest

from tmap.base.fixed import ONE
from tmap.bench.modes import measure
from tmap.bench.modes.modes import Mode
from tmap.scene_file.scene_file import IDENTITY, Object, Scene
from tmap.guest import guest_frames
from tmap.guest.conditions import CONDITIONS
from tmap.model import model


MACHINE = "a1200-fast"
TRIANGLES, SHOWN = 40, 3  # of a frame; of a scene, in frames with other ones each
NAMES = ("glide_point", "glide_point_565", "glide_point_clamp", "glide_point_perspective", "glide_dithered",
         "glide_bilinear", "glide_bilinear_565", "glide_bilinear_clamp", "glide_bilinear_perspective",
         "glide_bilinear_every_8", "glide_mip_bilinear", "glide_trilinear", "glide_modulate",
         "glide_modulate_perspective", "glide_blend",
         "point", "point_16", "point_perspective", "point_shift", "threepoint", "threepoint_16",
         "threepoint_perspective", "wrap", "average", "modulate_shade", "trilinear", "trilinear_shade", "general",
         "any", "yuv_point", "yuv_filter")


def triangle(rng: np.random.Generator, mode: Mode, size: float) -> list[list[int]]:
    """Corners near a point of the frame or beside it, some of one depth or shade."""
    middle = rng.uniform((-8, -8), (measure.WIDTH + 8, measure.HEIGHT + 8))
    places = middle + rng.normal(0, size, (3, 2))
    texels = np.clip(rng.uniform(-60, 300, 2) + rng.normal(0, size * rng.choice([0.5, 4, 12]), (3, 2)), -400, 600)
    depths = rng.uniform(1, 6, 3) if rng.random() < 0.7 else np.full(3, rng.choice([1, 2.5]))
    shades = rng.uniform(0, 255, 3) if rng.random() < 0.7 else np.full(3, 99.5)
    if rng.random() < 0.2:  # at pixels' centres
        places = np.floor(places)
    rows = np.column_stack([places, texels, shades, depths])
    return np.rint(rows * ONE).astype(int).tolist()


def scene_of(mode: Mode) -> Scene:
    rng = np.random.default_rng(len(mode.name) * 1009 + sum(map(ord, mode.name)))
    plain, vertices, objects = measure.scene_of(mode), [], []
    for frame in range(SHOWN):
        for _ in range(TRIANGLES):
            objects.append(Object(0, len(vertices), 3, 0, 1, frame))
            vertices += triangle(rng, mode, float(rng.choice([2, 4, 4, 9, 25])))
    return replace(plain, vertices=np.array(vertices), objects=objects, poses=np.array([IDENTITY]))


@pytest.mark.parametrize("name", NAMES)
def test_kept_states_draw_the_models_frames(name: str) -> None:
    scene = scene_of(measure.EVERY[name])
    machine = CONDITIONS[MACHINE].machine
    frames = [model.render(scene, number) for number in range(SHOWN)]
    assert all(len(np.unique(frame)) > 4 for frame in frames)
    digests, = guest_frames.draw([(scene, "addx")], machine, timed=False)
    guest_frames.require_models(frames, digests, f"kept states: {name}", (scene, "addx", machine))
