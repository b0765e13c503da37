"""Pictures that show their orientation and size: letters, digits, a different colour at each
border. Every maker returns levels of 0 to 255, height x width x 3, not yet rounded."""

import colorsys

import numpy as np

from tmap.base.elementary import cos, each

INK = (255, 250, 235)
ABOVE, LEFT, RIGHT, BELOW = (70, 130, 255), (235, 60, 50), (60, 190, 80), (250, 205, 60)

# Colours of the checker: ground, squares of each quarter, letter.
CHECKER = ((232, 224, 200), (208, 72, 56), (56, 120, 184), (240, 184, 64), (72, 144, 96),
           (28, 28, 44))

GLYPHS = {"1": (".#.", "##.", ".#.", ".#.", "###"), "2": ("###", "..#", "###", "#..", "###"),
          "3": ("###", "..#", ".##", "..#", "###"), "4": ("#.#", "#.#", "###", "..#", "..#"),
          "5": ("###", "#..", "###", "..#", "###"), "6": ("###", "#..", "###", "#.#", "###"),
          "8": ("###", "#.#", "###", "#.#", "###"), ":": (".", "#", ".", "#", ".")}


def flat(height: int, width: int, colour: tuple[float, float, float]) -> np.ndarray:
    """Returns a picture of one colour."""
    return np.full((height, width, 3), colour, float)


def checker() -> np.ndarray:
    """Squares of 32 texels in a different colour for each quarter, a dark edge, and an F."""
    cream, *quarters, dark = CHECKER
    picture = flat(256, 256, cream)
    for y in range(8):
        for x in range(y % 2, 8, 2):
            picture[32 * y:32 * y + 32, 32 * x:32 * x + 32] = quarters[y // 4 * 2 + x // 4]
    picture[:3] = picture[-3:] = picture[:, :3] = picture[:, -3:] = dark
    strokes = (48, 208, 80, 104), (48, 72, 80, 184), (112, 136, 80, 160)
    for around, colour in ((4, cream), (0, dark)):
        for top, bottom, left, right in strokes:
            picture[top - around:bottom + around, left - around:right + around] = colour
    return picture


def letter() -> np.ndarray:
    """An F, with a bright line at the top and on the left."""
    picture = flat(16, 16, (28, 44, 92))
    picture[0] = picture[:, 0] = (120, 160, 220)
    picture[2:14, 3:6] = picture[2:5, 3:13] = (245, 205, 70)
    picture[7:9, 3:10] = (230, 120, 60)
    return picture


def medallion() -> np.ndarray:
    """A disc of rings and petals in sixteen greys."""
    y, x = np.mgrid[:32, :32] - 15.5
    radius = np.hypot(x, y)
    xx, yy = x * x, y * y
    square = xx + yy
    petals = (xx - yy) * (xx * xx - 14 * xx * yy + yy * yy) / (square * square * square)  # cos(6 way)
    level = 7.5 + 4 * each(cos, 0.85 * radius) + 3.5 * radius / 15 * petals
    return np.repeat(np.where(radius < 15.6, 17 * np.rint(level), 0)[..., None], 3, 2)


def palettes() -> np.ndarray:
    """Sixteen palettes of sixteen colours, one a row: greys, then fifteen hues from dark to bright.
    The first colour of each hue is the ground around the medallion."""
    picture = flat(16, 16, (24, 24, 32))
    picture[0] = 17 * np.arange(16)[:, None]
    for row in range(1, 16):
        for k in range(1, 16):
            hue = (row - 1) / 15 + 0.008 * (k - 7.5)
            picture[row, k] = 255 * np.array(colorsys.hls_to_rgb(hue, 0.08 + 0.8 * k / 15, 0.85))
    return picture


def bordered(height: int, width: int, tint: tuple, border: int = 1) -> np.ndarray:
    """Returns a colour that gets darker downwards, with a different colour at each border."""
    light = 1.12 - 0.30 * np.arange(height) / height
    picture = flat(height, width, tint) * light[:, None, None]
    picture[:border], picture[-border:] = ABOVE, BELOW
    picture[:, :border], picture[:, -border:] = LEFT, RIGHT
    picture[:border, :border], picture[-border:, -border:] = 255, 0
    return picture


def width_of(text: str) -> int:
    """Returns a text's width in dots, with one dot between characters."""
    return sum(len(GLYPHS[each][0]) + 1 for each in text) - 1


def write(picture: np.ndarray, text: str, x: int, y: int, dot: int = 1) -> None:
    """Draws a line of text with dots of ``dot`` x ``dot`` texels."""
    for each in text:
        glyph = np.array([list(row) for row in GLYPHS[each]]) == "#"
        height, width = dot * glyph.shape[0], dot * glyph.shape[1]
        picture[y:y + height, x:x + width][np.kron(glyph, np.ones((dot, dot), bool))] = INK
        x += width + dot


def write_down(picture: np.ndarray, text: str, x: int, y: int) -> None:
    """Draws text downwards; a colon is two dots next to each other."""
    for each in text:
        if each == ":":
            picture[y, [x, x + 2]] = INK
            y += 2
        else:
            write(picture, each, x, y)
            y += 6


def aspect(width: int, height: int, tint: tuple[int, int, int]) -> np.ndarray:
    """The aspect ratio in digits, and arrows along the longer side."""
    picture = bordered(height, width, tint)
    arrow = np.array(tint) * 1.5 + 30
    text = f"{max(width // height, 1)}:{max(height // width, 1)}"
    if width > height:
        write(picture, text, (width - width_of(text)) // 2, (height - 4) // 2)
        for x in (5, 23) if width == 32 else (8, 14, 46, 52):
            for k in range(3):
                picture[height // 2 - 2 + k:height // 2 + 3 - k, x + k] = arrow
    elif width < height:
        if width == 16:
            write(picture, text, 3, 13)
        else:
            write_down(picture, text, 3, (height - 13) // 2)
        middle = 8 if width == 16 else 4
        for y in (4, 25) if height == 32 else (6, 12, 49, 55):
            for k in range(3):
                picture[y + k, middle - 2 + k:middle + 3 - k] = arrow
    else:
        write(picture, text, 7, 11, 2)
        for k in range(4):
            picture[[5 + k, 23 + k], 12 + k:20 - k] = arrow
    return picture


def size(side: int, tint: tuple[int, int, int]) -> np.ndarray:
    """A square map's side in the largest digits that fit."""
    border, text = max(1, side // 16), str(side)
    picture = bordered(side, side, tint, border)
    dot = max(1, int(0.86 * (side - 2 * border)) // max(width_of(text), 5))
    write(picture, text, (side - width_of(text) * dot + 1) // 2, (side - 5 * dot + 1) // 2, dot)
    return picture


def smallest(side: int) -> np.ndarray:
    """Maps without room for digits: 4, 2 and 1 texels wide."""
    if side == 1:
        return flat(1, 1, (235, 130, 50))
    picture = bordered(side, side, (0, 0, 0))
    if side == 4:
        picture[1:3, 1:3] = (130, 110, 60), (110, 130, 60)
    else:
        picture[0, 1] = ABOVE
    return picture


ASPECTS = {(64, 8): (96, 64, 140), (32, 8): (64, 80, 150), (32, 16): (50, 110, 140),
           (32, 32): (50, 120, 90), (16, 32): (110, 120, 50), (8, 32): (150, 95, 45),
           (8, 64): (150, 60, 70)}
SIZES = {256: (120, 60, 110), 128: (90, 70, 140), 64: (60, 90, 150), 32: (45, 115, 130),
         16: (50, 125, 85), 8: (110, 120, 50)}
