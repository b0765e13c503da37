"""The combinations of settings and mapper that are measured."""

from tmap.scene_file.scene_file import SETTINGS
from tmap.scene_file.textures import MAPPERS, ON_PLANE
from tmap.setup.shading import LIT
from tmap.setup.texturing import Settings

#: Combinations for all mappers except affine: cheap, usual, exact.
USUAL = (("integer", "plane", "truncated"), ("subpixel", "plane", "subtexel"),
         ("exact", "plane", "subtexel"))


def usual(mapper: str) -> list[Settings]:
    """Returns those of USUAL that the mapper has."""
    return [Settings(*each, mapper=mapper) for each in USUAL
            if mapper not in ON_PLANE or each[1:] == ("plane", "subtexel")]


def combinations() -> list[Settings]:
    """Returns every sensible combination of settings and mapper."""
    made = [Settings(e, g, s, mapper="affine") for e in ("integer", "subpixel", "exact")
            for g in ("scanline", "polygon", "plane") for s in ("truncated", "subtexel")]
    made += [Settings(e, "plane", "subtexel", mapper="flat")
             for e in ("integer", "subpixel", "snapped", "exact")]
    made += [Settings("snapped", mapper=mapper) for mapper in ("gouraud", "affine", "lit", "lit_gouraud")]
    return made + [settings for mapper in MAPPERS[1] if mapper not in ("flat", "affine")
                   for settings in usual(mapper)]


def size_combinations() -> list[Settings]:
    """Returns the settings for triangles of a mesh: one for each step of accuracy."""
    return [Settings(edges, "polygon", "truncated") for edges in ("integer", "subpixel")] \
        + [Settings(edges) for edges in ("subpixel", "snapped", "exact")] \
        + [Settings(edges, mapper=mapper) for mapper in ("gouraud", "flat")
           for edges in ("integer", "subpixel", "snapped", "exact")] \
        + [Settings(edges, mapper=mapper) for mapper in ("lit", "lit_gouraud")
           for edges in ("snapped", "exact")]


def depth_combinations() -> list[Settings]:
    """Returns the settings for a set with depth: affine and every other perspective, which lit mappers
    draw too."""
    return [Settings(edges, perspective=p) for edges in ("subpixel", "exact")
            for p in SETTINGS["perspective"]] \
        + [Settings("exact", perspective=p, mapper=mapper) for mapper in LIT
           for p in SETTINGS["perspective"][1:]]
