"""Pictures of the scene ``keep``: for each of its eight rooms three walls, a floor and a ceiling, 64x64. Makers return
levels of 0 to 255, not yet rounded."""

from collections.abc import Callable
from functools import partial

import numpy as np

from tmap.assets.noise import grain, noise, smeared, tinted

SIDE = 64
Tint = tuple[float, float, float]
Maker = Callable[[], np.ndarray]


def worn(picture: np.ndarray, seed: int, much: float = 0.07) -> np.ndarray:
    """Returns a picture with stains of all sizes, which repeat at the borders."""
    return picture * (1 + much * noise(SIDE, SIDE, 1.4, seed) + 0.5 * much * noise(SIDE, SIDE, 0.5, seed + 1))[..., None]


def relief(light: np.ndarray, block: tuple[slice, slice], joint: float) -> None:
    """Lights the upper left borders of a block and darkens the lower right ones; its last row and column are the
    joint."""
    part = light[block]
    part[0] *= 1.2
    part[:, 0] *= 1.12
    part[-2] *= 0.84
    part[:, -2] *= 0.88
    part[-1] = part[:, -1] = joint


def masonry(tint: Tint, seed: int, courses: int = 4, stones: int = 3) -> np.ndarray:
    """Courses of stones of random widths, every other course shifted."""
    random, light = np.random.default_rng(seed), np.ones((SIDE, SIDE))
    high = SIDE // courses
    for course in range(courses):
        ends = np.rint(np.linspace(0, SIDE, stones + 1) + np.append(0, random.normal(0, 2, stones)))
        ends[-1] = SIDE
        row = np.ones((high, SIDE))
        for left, right in zip(ends[:-1].astype(int), ends[1:].astype(int)):
            row[:, left:right] *= 0.82 + 0.3 * random.random()
            relief(row, (slice(0, high), slice(left, right)), 0.4)
        light[course * high:(course + 1) * high] = np.roll(row, (course % 2) * SIDE // stones // 2, 1)
    return worn(tinted(tint, light), seed + 100)


def slabs(first: Tint, second: Tint, seed: int, side: int = 32) -> np.ndarray:
    """Slabs in two tints that alternate."""
    random, light = np.random.default_rng(seed), np.ones((SIDE, SIDE))
    y, x = np.mgrid[:SIDE, :SIDE] // side
    for top in range(0, SIDE, side):
        for left in range(0, SIDE, side):
            block = slice(top, top + side), slice(left, left + side)
            light[block] *= 0.88 + 0.2 * random.random()
            relief(light, block, 0.45)
    return worn(np.where(((y + x) % 2)[..., None], tinted(first, light), tinted(second, light)), seed + 100)


def planks(tint: Tint, seed: int, wide: int = 16) -> np.ndarray:
    """Planks from top to bottom, each cut once."""
    random, light = np.random.default_rng(seed), np.ones((SIDE, SIDE))
    for left in range(0, SIDE, wide):
        light[:, left:left + wide] *= 0.8 + 0.3 * random.random()
        light[random.integers(SIDE), left:left + wide] *= 0.5
        light[:, left] *= 1.15
        light[:, left + wide - 1] *= 0.5
    return worn(tinted(tint, light * (1 + 0.07 * smeared(noise(SIDE, SIDE, 0.3, seed + 50)))), seed + 100, 0.04)


def plates(tint: Tint, seed: int, side: int = 32) -> np.ndarray:
    """Plates of metal with a rivet in each corner."""
    light = np.ones((SIDE, SIDE))
    for top in range(0, SIDE, side):
        for left in range(0, SIDE, side):
            relief(light, (slice(top, top + side), slice(left, left + side)), 0.35)
            for y in (top + 4, top + side - 6):
                for x in (left + 4, left + side - 6):
                    light[y, x:x + 2], light[y + 1, x:x + 2] = 1.45, 0.6
    return worn(tinted(tint, light), seed, 0.05)


def plaster(tint: Tint, seed: int, board: Tint | None = None) -> np.ndarray:
    """Plaster, above a board if it has one."""
    picture = tinted(tint, 0.86 + 0.26 * grain(SIDE, SIDE, 1.2, seed))
    if board:
        picture[44:] = tinted(board, 0.9 + 0.1 * smeared(noise(SIDE, SIDE, 0.3, seed + 1)))[44:]
        picture[44], picture[45], picture[46] = picture[44] * 1.3, picture[45] * 1.1, picture[46] * 0.5
        picture[60:] *= 0.6
    return picture


def beams(tint: Tint, ground: Tint, seed: int) -> np.ndarray:
    """Two beams across a ceiling."""
    picture = tinted(ground, 0.7 + 0.2 * grain(SIDE, SIDE, 1.2, seed))
    wood = tinted(tint, 0.95 + 0.07 * smeared(noise(SIDE, SIDE, 0.3, seed + 1)).T)
    for top in (8, 40):
        picture[top:top + 14] = wood[top:top + 14]
        picture[top] *= 1.25
        picture[top + 13] *= 0.6
        picture[top + 14:top + 17] *= 0.55
    return picture


GREY, SAND, RED, BROWN, BLUE, GREEN, VIOLET, DARK = (
    (150, 148, 142), (196, 170, 124), (164, 84, 62), (140, 96, 58), (96, 116, 150), (100, 128, 92), (128, 100, 140),
    (92, 88, 84))
#: By room: walls 0 to 2, floor, ceiling.
ROOMS: dict[str, tuple[Maker, ...]] = {
    "a": (partial(masonry, GREY, 1), partial(masonry, GREY, 2, 4, 2), partial(masonry, DARK, 3, 8, 4),
          partial(slabs, GREY, DARK, 4), partial(beams, BROWN, DARK, 5)),
    "b": (partial(masonry, RED, 11, 8, 4), partial(masonry, RED, 12, 8, 3), partial(plaster, SAND, 13, BROWN),
          partial(planks, BROWN, 14), partial(beams, BROWN, SAND, 15)),
    "c": (partial(masonry, SAND, 21), partial(masonry, SAND, 22, 4, 2), partial(plaster, SAND, 23),
          partial(slabs, SAND, RED, 24, 16), partial(plaster, SAND, 25)),
    "d": (partial(planks, BROWN, 31), partial(planks, BROWN, 32, 8), partial(plaster, GREY, 33, BROWN),
          partial(planks, RED, 34, 8), partial(planks, DARK, 35)),
    "e": (partial(plates, BLUE, 41), partial(plates, BLUE, 42, 16), partial(plates, DARK, 43),
          partial(plates, GREY, 44, 64), partial(plates, DARK, 45, 64)),
    "f": (partial(masonry, GREEN, 51), partial(masonry, GREEN, 52, 8, 4), partial(plaster, GREEN, 53, DARK),
          partial(slabs, GREEN, DARK, 54), partial(plaster, DARK, 55)),
    "g": (partial(masonry, BLUE, 61, 4, 2), partial(masonry, BLUE, 62), partial(plaster, BLUE, 63, GREY),
          partial(slabs, BLUE, GREY, 64, 16), partial(beams, GREY, BLUE, 65)),
    "h": (partial(masonry, VIOLET, 71), partial(masonry, VIOLET, 72, 4, 2), partial(plaster, VIOLET, 73, DARK),
          partial(slabs, VIOLET, SAND, 74), partial(beams, DARK, VIOLET, 75))}
SURFACES = ("wall0", "wall1", "wall2", "floor", "roof")
PICTURES = {f"{room}_{name}": make for room, makers in ROOMS.items() for name, make in zip(SURFACES, makers)}
