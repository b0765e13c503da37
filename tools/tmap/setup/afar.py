"""How lines of a polygon with perspective are drawn from their far ends."""

from types import ModuleType

from tmap.setup import cubic, far
from tmap.setup.perspective import PIECES, Perspective, steepness
from tmap.setup.texturing import Settings


def model_of(constants) -> ModuleType:
    """Returns the module that models lines drawn with such constants."""
    return far if isinstance(constants, far.Constants) else cubic


def constants(deep: Perspective, box, setting: str, settings: Settings):
    """Returns the constants of lines drawn from their far ends; None if they are not."""
    if setting in PIECES:
        every = "tolerance" if setting == "every8" != settings.perspective else setting
        return far.find(deep, every, box, settings.has_exact_edges)
    return cubic.find(deep, setting, box, settings.has_exact_edges)


def exact_setting(deep: Perspective, setting: str, settings: Settings) -> str:
    """Returns whose pieces draw lines exactly: every8's half a pixel allows 16 pixels where q grows slowly."""
    slow = steepness(deep.q.dx) + 1 <= deep.least // (16 * 16 // 2 + 1)
    return "every16" if slow and setting == "every8" == settings.perspective else setting
