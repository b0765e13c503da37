"""The named corpus of hard polygons: all families of makers, and cases that fuzzers found.

``cases`` are 16.16 and the same in every run. A case that a fuzzer found is kept in
``FOUND``, a JSON list of objects with the fields of ``Case``, sorted by name.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, replace

import numpy as np

from tmap.base.errors import UserError
from tmap.base.paths import ROOT
from tmap.corpus import hard_depths, hard_outlines, hard_planes, hard_textures, random_maps
from tmap.corpus.hard_case import HEIGHT, WIDTH, Case
from tmap.corpus.settings_grid import usual
from tmap.model.model import Settings
from tmap.scene_file.scene_file import (IDENTITY, MAPPER_LAYOUT, SETTINGS, Material, Object, Scene,
                                        Texture, size_fault)
from tmap.setup import planarity
from tmap.setup.clip import clip, frame_window
from tmap.setup.shading import LIT

FAMILIES = (*hard_outlines.FAMILIES, *hard_textures.FAMILIES, *hard_planes.FAMILIES,
            *hard_depths.FAMILIES)
FOUND = ROOT / "tests" / "hard_cases.json"
Drawing = tuple[Case, Settings]  # the settings include the mapper


def found_cases() -> list[Case]:
    """Returns the cases in ``FOUND``; none if the file does not exist."""
    if not FOUND.exists():
        return []
    return [Case(entry["name"], entry["sentence"], tuple(map(tuple, entry["vertices"])),
                 tuple(entry["mappers"]), tuple(entry["map_size"]), entry["depth"])
            for entry in json.loads(FOUND.read_text())]


def cases() -> list[Case]:
    """The corpus, family by family; found ones last."""
    return [case for family in FAMILIES for case in family()] + found_cases()


def keep(case: Case) -> None:
    """Adds a case to ``FOUND``; refuses a name that the corpus already has."""
    if case.name in {known.name for known in cases()}:
        raise UserError(f"{FOUND}: there is a case called {case.name} already")
    kept = sorted([*found_cases(), case], key=lambda known: known.name)
    rows = ",\n ".join(json.dumps(asdict(known)) for known in kept)
    FOUND.write_text(f"[\n {rows}\n]\n")


def map_size(case: Case, mapper: str) -> tuple[int, int]:
    """Returns width and height of a mapper's map: the case's if the layout can have that size."""
    return (256, 256) if size_fault(MAPPER_LAYOUT[mapper], *case.map_size) else case.map_size


def combinations(case: Case) -> Iterator[Settings]:
    """Yields the settings with which a case is drawn: all different ones if the mapper is affine or
    flat, the usual ones and clipped vertices for other mappers; if it has depth, each perspective, for lit
    mappers with exact edges."""
    vertices = [v[:2] for v in case.vertices]
    is_clipped = clip(vertices, frame_window(WIDTH, HEIGHT)) != vertices
    clips = SETTINGS["clip"] if is_clipped else ("scissor",)
    for mapper in case.mappers:
        if case.depth:
            made = [Settings(e, perspective=p) for e in ("subpixel", "exact")
                    for p in SETTINGS["perspective"]] if mapper == "affine" else \
                [Settings("exact", perspective=p) for p in SETTINGS["perspective"][1:]]
        elif mapper == "affine":
            made = [Settings(e, g, s) for e in SETTINGS["edges"] for g in SETTINGS["gradients"]
                    for s in SETTINGS["start"] if g != "polygon" or len(case.vertices) == 3]
        elif mapper == "flat":
            made = [Settings(e) for e in SETTINGS["edges"]]
        else:
            made = usual(mapper)
        for settings in made:
            for way in clips if mapper in ("affine", "flat") or settings == made[-1] else clips[:1]:
                yield replace(settings, clip=way, mapper=mapper)


def scene(drawings: list[Drawing]) -> Scene:
    """Returns a scene with one drawing in each frame."""
    textures, materials, objects, vertices = {}, {}, [], []
    for number, (case, s) in enumerate(drawings):
        layout, texture = MAPPER_LAYOUT[s.mapper], -1
        if layout:
            texture = textures.setdefault((layout, map_size(case, s.mapper)), len(textures))
        light = textures.setdefault(("light", (256, 64)), len(textures)) if s.mapper in LIT else -1
        material = Material(**vars(s), texture=texture, colour=200, light=light)
        objects.append(Object(materials.setdefault(material, len(materials)), len(vertices),
                              len(case.vertices), 0, 1, number,
                              planarity.vouched(case.vertices, s.mapper, False, 1)))
        vertices += case.vertices
    return Scene(WIDTH, HEIGHT, len(drawings), 7, random_maps.palette(),
                 [Texture(random_maps.of_size(*size), layout) for layout, size in textures], list(materials),
                 objects, np.array(vertices), np.array([IDENTITY]))
