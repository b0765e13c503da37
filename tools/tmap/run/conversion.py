"""What a scene's frames cost on the screen beside their drawing: the conversion to bitplanes, by the bench's committed
figures, while the picture is shown. With fast RAM the blitter does a part of it, which takes the processor no time."""

import json
from functools import cache

from tmap.base.paths import BASELINE
from tmap.guest.emulator import has_fast_memory
from tmap.scene_file.scene_file import Scene

#: The bench's rows of the processor's part of a conversion that the blitter merges once, and twice, and their length, by a
#: pixel's width.
WITH_BLITTER = {1: ("c2p_8_blit_low", "c2p_8_blits_low", 320), 2: ("c2p_8_2x1_blit_low", "c2p_8_2x1_blits_low", 160)}
#: The bench's row of a conversion without it, by format too.
ROWS = {("chunky", 1): ("c2p_8_low", 320), ("chunky", 2): ("c2p_8_2x1_low", 160),
        **{(form, width): (f"c2p_ham8_{name}_{dots}", 160)
           for form, name in (("rgb565", "16"), ("rgba5551", "5551"), ("rgba8888", "32"))
           for width, dots in ((1, "super"), (2, "high"))}}
SCREEN = 320, 256  # pixels of low resolution
FIELD = 4 * 312 * 227  # cycles
MERGED_BYTES = 38900  # in a field, by the blitter (c/screen/screen.c)


@cache
def figures() -> dict[tuple, float]:
    """Returns the committed cycles a pixel of kernels."""
    rows = json.loads(BASELINE.read_text())["rows"]
    return {(row["name"], row["machine"], row["length"]): row["cycles_per_pixel"] for row in rows}


def is_merged_twice(scene: Scene, spent: float) -> bool:
    """Returns True if the blitter merges twice where a frame takes so many cycles: once and a rest, as c/screen/screen.c
    has it."""
    merged = scene.width * scene.height  # bytes of planes or half planes
    return spent / FIELD >= merged / MERGED_BYTES + 2 + merged // MERGED_BYTES


def cycles(scene: Scene, machine: str, drawing: float = 0) -> float | None:
    """Returns the cycles in which a machine converts a whole frame while one is shown, drawn in so many cycles; None if
    the screen cannot show it."""
    sides = scene.width * scene.pixel_width, scene.height * scene.pixel_height
    if scene.width % 8 or any(side > most for side, most in zip(sides, SCREEN)):
        return None
    width = scene.pixel_width
    if scene.pixel.colours and max(width, scene.pixel_height) == 1 and all(
            2 * side <= most for side, most in zip(sides, SCREEN)):
        width = 2  # it is shown twice as large
    is_fast = has_fast_memory(machine)
    pixels = scene.width * scene.height
    if not is_fast or scene.pixel.colours:
        name, length = ROWS[scene.format, width]
        return figures()[name, "a1200-mixed" if is_fast else "a1200", length] * pixels
    # Planes are in chip RAM, where "a1200-fast" has none of its data.
    *names, length = WITH_BLITTER[width]
    once, twice = (figures()[name, "a1200-mixed", length] * pixels for name in names)
    return twice if is_merged_twice(scene, drawing + once) else once
