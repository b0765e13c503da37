"""Repeating pictures of walls, floors and ground. Every maker returns levels of 0 to 255, height x
width x 3, not yet rounded."""

import math

import numpy as np

from tmap.assets.noise import grain, noise, smeared, tinted
from tmap.base.elementary import each, power, sin


def grey(levels: np.ndarray) -> np.ndarray:
    """Returns levels as R, G and B."""
    return np.repeat(levels[..., None], 3, 2)


def bricks() -> np.ndarray:
    """Four courses of bricks whose top edges are lit."""
    rough = grain(32, 32, 1, 1)
    picture = tinted((188, 180, 168), 0.8 + 0.3 * rough)
    for course, tones in enumerate(((0.8, 1), (0.85, 0.95, 0.9), (0.9, 1.05), (0.9, 1, 0.85))):
        for k, tone in enumerate(tones):
            left = 16 * k - 8 * (course % 2)
            brick = slice(8 * course, 8 * course + 7), slice(max(left, 0), left + 15)
            picture[brick] = tinted((176, 82, 60), tone * (0.8 + 0.35 * rough[brick]))
            picture[8 * course, brick[1]] *= 1.15
    return picture


def planks() -> np.ndarray:
    """Four planks with the grain of wood, each with another tint and cut at another place."""
    light = 0.7 + 0.25 * grain(32, 32, 1.2, 2).mean(0) + 0.25 * grain(32, 32, 1.6, 3)
    picture = np.empty((32, 32, 3))
    for left, tint, cut in ((0, (150, 98, 50), 0), (8, (166, 112, 60), 21),
                            (16, (140, 90, 44), 10), (24, (158, 104, 58), 31)):
        plank = slice(left, left + 8)
        picture[:, plank] = tinted(tint, light[:, plank])
        picture[cut, plank] *= 0.5
        picture[:, left] *= 0.45
    return picture


def panels() -> np.ndarray:
    """Grey plaster in four panels."""
    levels = 170 + 60 * grain(32, 32, 1.1, 4)
    y, x = np.mgrid[:32, :32] % 16
    levels[(y == 0) | (x == 0)] *= 0.6
    return grey(levels)


def pavement() -> np.ndarray:
    """Slabs in two alternating tints, with a diamond on each."""
    y, x = np.mgrid[:64, :64]
    bright = ((y // 32 + x // 32) % 2 == 1)[..., None]
    light = 0.75 + 0.4 * grain(64, 64, 1.2, 5)
    picture = np.where(bright, tinted((206, 196, 176), light), tinted((72, 92, 112), light))
    outwards = abs(y % 32 - 16) + abs(x % 32 - 16)
    diamond = ((outwards == 9) | (outwards == 10))[..., None]
    picture = np.where(diamond, np.where(bright, (150, 60, 40), (200, 170, 90)), picture)
    picture[(y % 32 == 0) | (x % 32 == 0)] = (36, 34, 32)
    return picture


def speckles() -> np.ndarray:
    """Grey noise for a detail texture."""
    made = grain(16, 16, 0.3, 6)
    return grey(128 + 190 * (made - made.mean()))


def waves() -> np.ndarray:
    """Ripples on water: bright where six waves cancel."""
    y, x = np.mgrid[:32, :32] * math.tau / 32
    field = abs(sum(height * each(sin, kx * x + ky * y + phase) for kx, ky, height, phase in (
        (1, 2, 1, 0), (2, -1, 1, 1), (3, 1, 0.6, 2.3), (-1, 3, 0.6, 4), (2, 3, 0.4, 0.7),
        (4, -1, 0.35, 3))))
    return grey(30 + 225 * each(power, 1 - field / field.max(), 2.2))


def stones() -> np.ndarray:
    """Ashlar in four courses, three stones a course, lit from above and the left."""
    picture, random = np.zeros((64, 64, 3)), np.random.default_rng(5)
    for top in range(0, 64, 16):
        lefts = (12, 30, 52) if top % 32 else (0, 26, 44)
        for left, right in zip(lefts, (*lefts[1:], lefts[0] + 64)):
            tint = np.array((172, 150, 122)) * (0.86 + 0.26 * random.random())
            tint += random.normal(0, 5, 3)
            light = np.ones((16, right - left))
            light[0] *= 1.16
            light[:, 0] *= 1.10
            light[-2:] *= 0.86
            light[:, -2:] *= 0.88
            light[-1] = light[:, -1] = 0.42
            picture[top:top + 16, np.arange(left, right) % 64] = tinted(tint, light)
    return picture * (1 + 0.07 * noise(64, 64, 1.6, 1) + 0.05 * noise(64, 64, 0.6, 2))[..., None]


def rough() -> np.ndarray:
    """Stone seen closely, for a detail texture: pits lit from above, mean level 150."""
    height = noise(64, 64, 0.55, 7, 2) + 0.5 * noise(64, 64, 1.1, 9, 3)
    pits = np.minimum(noise(64, 64, 0.9, 8, 4) + 1.1, 0)
    levels = 150 + 34 * height / height.std() * 0.9 + 70 * pits
    levels = np.clip(levels - 0.5 * (np.roll(levels, 1, 0) - levels), 30, 245)
    return tinted((1.14, 1, 0.82), levels + 150 - levels.mean())


def grass() -> np.ndarray:
    """Grass seen from far away."""
    fine, coarse = noise(32, 32, 0.8, 21), noise(32, 32, 1.6, 22)
    return np.stack([98 + 13 * fine + 9 * coarse, 124 + 17 * fine + 9 * coarse, 60 + 9 * fine], -1)


def boards() -> np.ndarray:
    """Boards along t, two lengths each."""
    picture, random = np.zeros((64, 64, 3)), np.random.default_rng(8)
    for k, cut in enumerate((10, 40, 24, 56)):
        board = slice(16 * k, 16 * k + 16)
        for end in (cut, cut + 32):
            tone = 0.86 + 0.24 * random.random()
            picture[np.arange(end, end + 32) % 64, board] = np.array((196, 140, 86)) * tone
        picture[[cut, (cut + 32) % 64], board] *= 0.5
    picture *= (1 + 0.06 * smeared(noise(64, 64, 0.3, 33))
                + 0.05 * noise(64, 64, 1.2, 34))[..., None]
    picture[:, ::16] *= 0.45
    picture[:, 1::16] *= 1.08
    return picture


def wainscot() -> np.ndarray:
    """A plastered wall above panels of wood."""
    top = 48
    picture = tinted((232, 222, 202),
                     1 + 0.05 * noise(64, 64, 1.3, 31) + 0.02 * noise(64, 64, 0.4, 32))
    wood = tinted((176, 120, 78), 1 + 0.06 * smeared(noise(64, 64, 0.3, 41)))
    picture[top:] = wood[top:]
    picture[top] = (214, 160, 108)
    picture[top + 1] *= 1.1
    picture[top + 2] *= 0.55
    for left in range(2, 64, 16):
        panel = slice(left, left + 12)
        picture[top + 5:61, left] *= 0.6
        picture[top + 5, panel] *= 0.6
        picture[top + 5:61, left + 11] *= 1.18
        picture[60, panel] *= 1.18
    picture[61:] = wood[61:] * 0.62
    return picture
