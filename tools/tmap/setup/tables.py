"""Which tables draw the lines of a polygon with perspective."""

from types import ModuleType

from tmap.setup import far, logarithm, reciprocal
from tmap.setup.perspective import PIECES, Perspective
from tmap.setup.texturing import Line, Settings


def model_of(constants) -> ModuleType:
    """Returns the module that models lines drawn with such constants."""
    return far if isinstance(constants, far.Constants) else logarithm


def constants(deep: Perspective, lines: list[Line], box, setting: str, settings: Settings):
    """Returns the constants of lines drawn by tables; None if no line is."""
    if setting in PIECES:
        every = "tolerance" if setting == "every8" != settings.perspective else setting
        return far.find(deep, every, box, settings.has_exact_edges)
    first = next((k for k, line in enumerate(lines) if line.right > line.left), None)
    if setting == "fine" or first is None:
        return None
    return reciprocal.find(deep, lines[first].left - box[0], first)
