"""Pictures of views. They do not repeat, except the landscape from left to right. Every maker
returns levels of 0 to 255, height x width x 3, not yet rounded."""

import math

import numpy as np

from tmap.assets.noise import grain, tinted
from tmap.assets.signs import flat
from tmap.base.elementary import each, exp, log2, power, sin


def averaged(picture: np.ndarray, times: int) -> np.ndarray:
    """Returns a picture of the means of times x times dots."""
    height, width, _ = picture.shape
    return picture.reshape(height // times, times, width // times, times, 3).mean((1, 3))


def gradient(places: np.ndarray, start: tuple, end: tuple) -> np.ndarray:
    """Returns a gradient from one colour, at 0, to another, at 1."""
    return np.array(start) + places[..., None] * np.subtract(end, start)


def sunset() -> np.ndarray:
    """The picture in the demo's chrome: a low sun, clouds, hills, a tiled plain."""
    y, x = np.mgrid[:128, :128] / 127
    sky = np.stack([20 + 200 * each(power, 2 * y, 2.2), 50 + 185 * each(power, 2 * y, 1.6),
                    120 + 260 * y], -1)
    depth = 2 * y - 1
    near = np.clip(depth, 0, 1)
    ground = np.stack([70 + 150 * each(power, near, 0.7), 30 + 95 * depth, 12 + 30 * depth], -1)
    picture = np.where((y < 0.5)[..., None], sky, ground)
    hills = 0.5 - 0.035 * abs(each(sin, 9 * x)) - 0.03 * abs(each(sin, 23 * x + 1))
    picture[(y > hills) & (y < 0.52)] = (36, 20, 40)
    from_sun = np.hypot(x - 0.68, y - 0.22)
    picture += 255 * np.clip(1.25 - from_sun / 0.09, 0, 1)[..., None]
    picture += tinted((1, 0.9, 0.6), 120 * each(exp, -np.square(from_sun / 0.16)))
    for k in range(3):
        cloud = each(exp, -np.square((y - 0.13 - 0.09 * k) / 0.02)) * (each(sin, 7 * x + 2 * k) > 0.1)
        picture += 90 * cloud[..., None]
    plain = y > 0.54
    across = abs((x - 0.5) / (0.25 + depth) % 0.25 - 0.125) < 0.012
    rows = (3 * log2(np.clip(depth, 0.02, 1))).astype(int) % 2 == 1
    picture[plain & across] *= 0.45
    picture[plain & rows] *= 0.8
    return picture


def landscape() -> np.ndarray:
    """Sky with clouds and a sun, three chains of hills that get darker downwards, a house."""
    y, x = np.mgrid[:32, :64].astype(float)
    picture = gradient(y / 31, (63, 110, 210), (250, 180, 90))
    clouds = 150 * np.maximum(grain(32, 64, 1.5, 9) - 0.55, 0)
    picture[:19] += clouds[:19, :, None]
    from_sun = np.hypot(x - 44, y - 14)
    picture = np.where((from_sun < 8)[..., None], 0.6 * picture + 0.4 * np.array((255, 220, 140)),
                       picture)
    picture[from_sun < 5] = (255, 240, 170)
    for line, height, step, phase, tint in ((17, 3, 0.13, 0, (110, 70, 110)),
                                            (21, 2.5, 0.2, 2, (60, 60, 90)),
                                            (26, 2, 0.3, 1, (36, 70, 48))):
        below = y - (line + height * each(sin, step * x + phase) + each(sin, 0.7 * x + phase))
        picture = np.where((below > 0)[..., None], tinted(tint, 1 - 0.025 * below), picture)
    for k in range(4):
        picture[18 + k, 12 - k:14 + k] = (90, 30, 30)
    picture[22:26, 10:16] = (190, 40, 34)
    picture[24:26, 12] = (250, 220, 120)
    return picture


def painting() -> np.ndarray:
    """Two hills before an evening sky, framed."""
    y, x = np.mgrid[:32, :32] / 31
    picture = gradient(y, (70, 110, 200), (240, 180, 140))
    picture[np.hypot(x - 0.65, y - 0.42) < 0.13] = (255, 232, 140)
    far = y > 0.62 + 0.09 * each(sin, 7 * x)
    picture[far] = gradient(x, (40, 90, 50), (70, 120, 60))[far]
    picture[y > 0.80 + 0.06 * each(sin, 9 * x + 2)] = (30, 62, 40)
    framed = flat(32, 32, (190, 150, 60))
    framed[2:-2, 2:-2] = (90, 62, 20)
    framed[3:-3, 3:-3] = picture[3:-3, 3:-3]
    return framed


def window() -> np.ndarray:
    """Light through two pointed windows and a rose of stained glass; the wall is dim."""
    dim, times = (84, 86, 108), 4
    y, x = np.mgrid[:64 * times, :64 * times] / times
    picture = flat(64 * times, 64 * times, dim)
    for left, glass in ((8, ((255, 190, 90), (245, 110, 70), (255, 240, 180))),
                        (35, ((110, 150, 255), (140, 220, 245), (255, 240, 180)))):
        light = pointed(x - left, y - 18, 21, 43)
        panes = (np.floor((y - 1) / 8.5) + np.floor((x - left) / 7)).astype(int) % 3
        lead = ((y - 1) % 8.5 < 1.2) | (((x - left) % 7 < 1.2) & (x > left + 2))
        picture[light] = np.array(glass)[panes][light]
        picture[light & lead] = dim
    radius, (low, high) = np.hypot(x - 32, y - 13), np.sort(abs(np.stack([x - 32, y - 13])), 0)
    petals = (low >= (math.sqrt(2) - 1) * high).astype(int)  # of eight: the four on the diagonals
    rose = radius < 9.2
    picture[rose] = np.array(((245, 110, 70), (255, 240, 180)))[petals][rose]
    picture[rose & (abs(radius - 3.6) < 0.8)] = dim
    picture[radius < 2.8] = (110, 150, 255)
    return averaged(picture, times)


def pointed(x: np.ndarray, y: np.ndarray, width: float, height: float) -> np.ndarray:
    """Returns the inside of a pointed arch whose top left is 0, 0. The sides are upright below;
    above, each is a circle about the foot of the other."""
    spring = 0.87 * width
    upright = (x > 0) & (x < width) & (y >= spring) & (y < height)
    circles = (np.hypot(x, y - spring) < width) & (np.hypot(x - width, y - spring) < width)
    return upright | ((y < spring) & circles)


def pane() -> np.ndarray:
    """A window of four panes and the sky behind it."""
    y = np.mgrid[:16, :16][0]
    picture = np.stack([214 - 5 * y, 232 - 2.5 * y, 255 + 0 * y], -1)
    picture[[0, -1]] = picture[:, [0, -1]] = (52, 44, 40)
    picture[7:9] = picture[:, 7:9] = (64, 54, 48)
    return picture
