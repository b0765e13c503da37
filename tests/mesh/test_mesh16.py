"""Points and faces with 16-bit operands compared with exact numbers: within the derived bounds whatever the
view, and within 1/32 pixel where the tools use them."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.helpers import mesh_cases
from tests.mesh.test_mesh_ideal import about, row_of, turned
from tmap.base.paths import SCENES
from tmap.compiler import views16
from tmap.compiler.scene import compile_scene
from tmap.ideal import mesh as ideal
from tmap.model import mesh, mesh16

ONE = 65536


def sixteenths(scene, view, point) -> tuple[Fraction, ...]:
    """A point's exact x and y in 1/16 pixel and its depth, from the file's numbers."""
    factors = [[Fraction(n, 1 << 30) for n in view[3 * k:3 * k + 3]] for k in range(3)]
    x, y, w = ideal.camera(factors, [Fraction(n, ONE) for n in view[9:12]], point)
    return tuple(16 * c for c in ideal.screen(scene.guard, scene.width, scene.height, x, y, w)) + (w,)


@pytest.mark.parametrize("reach, away", [(1, 3), (2.5, 8), (40, 60), (2048, 5000), (0.01, 0.1), (0.2, 500)])
def test_places_are_within_their_bound(reach, away):
    """Meshes small and large, near and far: x, y and depth, before they are rounded to sixteenths."""
    random, worst, seen = np.random.default_rng(round(1000 * away)), 0.0, 0
    for _ in range(30):
        scene = about(int(random.integers(6, 11)))
        factors = np.array([random.uniform(0.5, 1)] * 2 + [1.0])[:, None] * turned(random)
        view = [*row_of(factors, [*random.uniform(-0.1, 0.1, 2) * away, away]),
                *(int(n) for n in random.integers(-away * ONE, away * ONE + 1, 3)), *[0] * 10]
        points = np.rint(random.uniform(-reach, reach, (30, 3)) * ONE).astype(int)
        row, short = views16.row_of(scene, view, mesh16.reach(points)), mesh16.points_of(points)
        places = mesh16.transform(short, row, (scene.width, scene.height))
        sums = [mesh16.sums(short, row, at).tolist() for at in (mesh16.X, mesh16.Y)]
        for k, point in enumerate(points.tolist() if places else ()):
            *exact, w = sixteenths(scene, view, point)
            v, unit = int(places.depth[k]), 2 ** row[mesh16.DEPTH_SHIFT]
            deep = ideal.sum_error16(row[1:4], short[k].tolist()) / 2 ** row[mesh16.DIVISOR_SHIFT] + Fraction(1, 2)
            assert abs(v * unit - w * ONE) <= deep * unit
            for at, total, right in zip((mesh16.X, mesh16.Y), sums, exact) if places.shown[k] else ():
                bound = (ideal.sum_error16(row[at + 1:at + 4], short[k].tolist()) + right * deep) / v
                off = abs(Fraction(total[k], v) - Fraction(1, 2) - right)
                assert off <= bound
                worst, seen = max(worst, float(off / bound)), seen + 1
    assert seen > 300 and worst > 0.3  # the bound is not too wide to test anything


def scenes():
    yield from (compile_scene(SCENES / f"{name}.toml", 9) for name in ("environment", "shaded"))
    yield from (mesh_cases.before(seed) for seed in range(12))


def test_what_the_tools_use_is_within_a_thirty_second():
    """All points on the screen, from exact numbers; faces that are seen wrongly are thin."""
    used = left = 0
    for scene in scenes():
        for instance in scene.instances:
            which = scene.meshes[instance.mesh]
            points = scene.points[which.point:which.point + which.points]
            for age in range(instance.views if instance.view16 >= 0 else 0):
                row, view = scene.views16[instance.view16 + age].tolist(), scene.views[instance.view + age].tolist()
                if not row[mesh16.IS_USED]:
                    left += 1
                    continue
                used += 1
                places = mesh.transform16(scene, instance, which, row)
                for x, y, shown, point in zip(places.x, places.y, places.shown, points.tolist()):
                    exact = sixteenths(scene, view, point)
                    assert exact[2] >= Fraction(scene.near_plane, ONE)
                    if shown:  # 1/32 pixel, and as much for rounding
                        assert max(abs(int(x) - exact[0]), abs(int(y) - exact[1])) <= 1
    assert used > 40 and left > 5


def test_only_snapped_edges_without_perspective_take_them():
    """The others keep 32-bit operands."""
    scene = compile_scene(SCENES / "environment.toml", 3)
    assert scene.instances[0].view16 == 0
    for change in ({"edges": "exact"}, {"edges": "subpixel"}, {"perspective": "every16"}):
        made = views16.add(replace(scene, instances=[replace(scene.instances[0], view16=-1)],
                                   materials=[replace(scene.materials[0], **change)]))
        assert made.instances[0].view16 == -1 and not len(made.views16)


def test_a_mesh_near_the_eye_keeps_32_bits():
    """Its points would be off by more."""
    scene = compile_scene(SCENES / "environment.toml", 1)
    scene.views[0, 11], scene.near_plane = 2.4 * ONE, 256
    found = views16.add(replace(scene, instances=[replace(scene.instances[0], view16=-1)]))
    assert found.instances[0].view16 == -1
