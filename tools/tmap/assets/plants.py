"""Trees and bushes: pictures with transparent pixels, whose background is colourless. Every maker returns levels of 0
to 255 and alpha, height x width x 4, not yet rounded."""

import numpy as np

from tmap.assets.noise import grain, noise, tinted

TRUNK = (92, 66, 44)


def cut(picture: np.ndarray, opaque: np.ndarray) -> np.ndarray:
    """Returns a picture of which only these texels are opaque."""
    return np.where(opaque[..., None], np.concatenate([picture, np.full((*opaque.shape, 1), 255.0)], 2), 0)


def pine() -> np.ndarray:
    """A pine, 64x128: five skirts of branches, lit from the left, over a trunk."""
    y, x = np.mgrid[:128, :64] + 0.5
    away = abs(x - 32)
    rough = noise(128, 64, 0.6, 71)
    picture = tinted(TRUNK, 0.6 + 0.5 * grain(128, 64, 1, 72).mean(0) + 0 * y)
    opaque = (away < 3.5) & (y > 96) & (y < 127)
    light = 0.55 + 0.35 * grain(128, 64, 0.8, 73) + 0.012 * (32 - x)
    for top, bottom, half in ((74, 116, 30), (54, 96, 26), (36, 76, 21), (19, 56, 15), (3, 36, 9)):
        part = (y - top) / (bottom - top)
        skirt = (part > 0) & (part < 1) & (away < half * part + 1.6 * rough - 0.5)
        picture[skirt] = tinted((46, 104, 62), light * (1.15 - 0.5 * part))[skirt]
        opaque |= skirt
    return cut(picture, opaque)


def bush() -> np.ndarray:
    """A bush, 64x64: leaves with holes between them."""
    y, x = np.mgrid[:64, :64] + 0.5
    round_ = np.hypot((x - 32) / 30, (y - 36) / 27) + 0.09 * noise(64, 64, 0.9, 81)
    holes = noise(64, 64, 0.7, 82) + 1.2 * (1 - round_) < -0.75
    light = 0.5 + 0.5 * grain(64, 64, 0.7, 83) - 0.006 * (y - 32) - 0.004 * (x - 32)
    return cut(tinted((96, 136, 50), light), (round_ < 1) & ~holes & (y < 63))
