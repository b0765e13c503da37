"""How lines of a polygon with perspective are drawn from their far ends."""

from types import ModuleType

from tmap.setup import cubic, far, tolerance
from tmap.setup.perspective import CURVES, EXACT, PIECES, Perspective, steepness
from tmap.setup.texturing import Settings

TILT_LEAST = 48  # pixels of the widest polygon whose straight lines with a tilt are short


def model_of(constants) -> ModuleType:
    """Returns the module that models lines drawn with such constants."""
    return far if isinstance(constants, far.Constants) else cubic


def constants(deep: Perspective, box, setting: str, settings: Settings):
    """Returns the constants of lines drawn from their far ends; None if they are not."""
    if setting in PIECES:
        every = "tolerance" if setting == "every8" != settings.perspective else setting
        return far.find(deep, every, box, settings.has_exact_edges)
    return cubic.find(deep, setting, box, settings.has_exact_edges)


def takes_short(deep: Perspective, width: int, found) -> bool:
    """Returns true, and takes their tilt away, if a polygon's straight lines with a tilt are so short that they cost
    less from their far ends, by the constants ``found``."""
    if not deep.tilt or width > TILT_LEAST or found is None or found.less:  # straight ones are more accurate then
        return False
    deep.tilt = 0
    return True


def exact_setting(deep: Perspective, setting: str, settings: Settings) -> str:
    """Returns a setting, or a name of EXACT, whose pieces draw lines exactly: where q grows slowly, longer ones keep
    the error of the setting's name, a pixel or half of one, or do for curves."""
    if setting in CURVES:
        return tolerance.straight(deep, setting) or setting
    if setting not in PIECES or setting != settings.perspective:
        return setting
    pixels, longest = PIECES[setting], max(EXACT.values())
    parts = 2 if setting == "every8" else 1  # of a pixel
    while pixels < longest and steepness(deep.q.dx) + 1 <= deep.least // (pixels * pixels * parts + 1):
        pixels *= 2
    return f"every{pixels}"
