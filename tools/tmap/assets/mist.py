"""The colonnade of tests/scenes/mist.toml: a column, and the pictures of its stone and of the paving."""

import math

import numpy as np

from tmap.assets.noise import grain, tinted
from tmap.base.elementary import cos, each, sin

SIDES = 8
BASE, CAPITAL = (0.0, 0.5), (3.5, 4.0)  # heights of the square parts; the shaft is between them
HALF, RADIUS = 0.6, 0.42  # of the square parts' sides, and of the shaft


def column() -> bytes:
    """Returns a column of eight sides on a square base, under a square capital, as an OBJ file. The picture is round
    the shaft once; the square parts have its upper part."""
    points, texels, faces = [], [], []

    def face(corners, places) -> None:
        first = len(points) + 1
        points.extend(corners)
        texels.extend(places)
        faces.append([first + k for k in range(len(corners))])

    def round_at(k: int, y: float) -> tuple[float, float, float]:
        angle = math.tau * (k + 0.5) / SIDES
        return RADIUS * cos(angle), y, RADIUS * sin(angle)

    low, high = BASE[1], CAPITAL[0]
    for k in range(SIDES):
        a, b = k / SIDES, (k + 1) / SIDES
        face([round_at(k + 1, low), round_at(k, low), round_at(k, high), round_at(k + 1, high)],
             [(b, 0), (a, 0), (a, 1), (b, 1)])
    square = [(HALF, HALF), (-HALF, HALF), (-HALF, -HALF), (HALF, -HALF)]
    for bottom, top in (BASE, CAPITAL):
        for k, (x, z) in enumerate(square):
            to_x, to_z = square[(k + 1) % 4]
            a, b = k / 4, (k + 1) / 4
            face([(to_x, bottom, to_z), (x, bottom, z), (x, top, z), (to_x, top, to_z)],
                 [(b, 0.8), (a, 0.8), (a, 1), (b, 1)])
    face([(x, BASE[1], z) for x, z in reversed(square)], [(0.4, 0.4), (0.5, 0.4), (0.5, 0.6), (0.4, 0.6)])
    face([(x, CAPITAL[0], z) for x, z in square], [(0.05, 0.4), (0.2, 0.4), (0.2, 0.6), (0.05, 0.6)])
    lines = [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in points]
    lines += [f"vt {u:.4f} {v:.4f}" for u, v in texels]
    lines += ["f " + " ".join(f"{n}/{n}" for n in each_face) for each_face in faces]
    return ("\n".join(lines) + "\n").encode()


def stone() -> np.ndarray:
    """Fluted stone round a column, lit from one side, with joints between its drums and moss at its foot."""
    y, x = np.mgrid[:64, :128]
    around = each(cos, math.tau * (x / 128 - 0.62))
    flutes = each(cos, math.tau * x / 8)
    light = 0.62 + 0.3 * around + 0.09 * flutes + 0.3 * (grain(64, 128, 0.9, 51) - 0.5)
    light = np.where((y % 21 == 20), 0.55 * light, light)
    moss = np.clip(grain(64, 128, 1.3, 52) - 0.75 + y / 90, 0, 0.6)[..., None]
    return tinted((214, 202, 178), light) * (1 - moss) + tinted((92, 120, 62), light) * moss


def paving() -> np.ndarray:
    """Worn slabs with grass between them."""
    y, x = np.mgrid[:64, :64]
    shifted = x + 16 * (y // 16 % 2)
    tone = np.random.default_rng(53).uniform(0.8, 1.08, (4, 4))[y // 16, shifted % 64 // 16]
    light = tone * (0.72 + 0.36 * grain(64, 64, 1.0, 54))
    picture = tinted((158, 150, 138), light)
    joint = (y % 16 < 2) | (shifted % 16 < 2)
    worn = grain(64, 64, 1.2, 55) > 0.62
    picture = np.where((joint | worn & (y % 16 < 4))[..., None], tinted((84, 108, 52), 0.5 + 0.7 * light), picture)
    return picture


def turf() -> np.ndarray:
    """Grass with bare ground here and there."""
    light = 0.45 + 0.75 * grain(64, 64, 0.7, 56)
    bare = np.clip(3 * (grain(64, 64, 1.4, 57) - 0.6), 0, 1)[..., None]
    return tinted((96, 126, 58), light) * (1 - bare) + tinted((128, 108, 76), light) * bare


FILES = {"mist/column.obj": column}
PICTURES = {"mist/stone.png": stone, "mist/paving.png": paving, "mist/turf.png": turf}
