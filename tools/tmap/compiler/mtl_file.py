"""Materials of a scene from the material libraries (MTL) that an OBJ file names: flat colours from Kd,
textures from map_Kd, all of whose picture is on the texture coordinates 0 to 1. All else in a library is about
light, which flat and textured materials lack.
"""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from tmap.base.fields import fail
from tmap.compiler import materials
from tmap.images import images
from tmap.shapes import mesh_file, obj_file

FILE = "file"  # materials = "file"
COLOUR = "#cccccc"  # of a material that states none
#: Options of map_Kd, with the most words that follow each. Those of PLACING move the picture.
OPTIONS = {"-blendu": 1, "-blendv": 1, "-boost": 1, "-bm": 1, "-cc": 1, "-clamp": 1, "-imfchan": 1,
           "-mm": 2, "-o": 3, "-s": 3, "-t": 3, "-texres": 1, "-type": 1}
PLACING = {"-o": 0.0, "-s": 1.0, "-t": 0.0}
REAL = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


@dataclass
class Look:
    """What a library says of a material."""

    at: str  # its picture's or its own place, for messages
    colour: str = COLOUR  # "#rrggbb"
    picture: str | None = None  # as the scene names it


def beside(reference: str, name: str) -> str:
    """Returns the name, as the scene has to write it, of a file that a file names. Of a path on some
    other machine only the last part counts."""
    name = name.replace("\\", "/")
    if re.match(r"/|[A-Za-z]:", name):
        name = re.split("[/:]", name)[-1]
    folder, slash, _ = reference.rpartition("/")
    return folder + slash + name


def colour_of(words: list[str], at: str) -> str:
    """Returns the colour of Kd; parts are from 0 to 1, the second and third may be left out."""
    if len(words) not in (1, 3) or not all(map(REAL.fullmatch, words)):
        fail(at, "Kd must be one number or three")
    parts = [min(max(float(word), 0.0), 1.0) for word in (words * 3)[:3]]
    return "#" + "".join(f"{round(255 * part):02x}" for part in parts)


def picture_of(text: str, at: str) -> str:
    """Returns the picture's name in map_Kd, whose options come first. The name may have spaces."""
    words = text.split()
    while words and words[0] in OPTIONS:
        option, count = words[0], OPTIONS[words[0]]
        if option in PLACING:
            count = next((k for k in range(3) if not REAL.fullmatch("".join(words[k + 1:k + 2]))), 3)
            if any(float(word) != PLACING[option] for word in words[1:count + 1]):
                fail(at, f"map_Kd's option {option} is not read; change the texture coordinates in its place")
        del words[:count + 1]
    if not words:
        fail(at, "map_Kd names no picture")
    return " ".join(words)


def looks(reference: str, folder: Path, where: str) -> dict[str, Look]:
    """Returns the materials of a library by name. ``where``: the file that names it."""
    data, where = mesh_file.data_of(reference, folder, where), f"{where}: {reference}"
    found: dict[str, Look] = {}
    look = None
    for number, statement in obj_file.statements(data):
        word, at = b"".join(statement.split(None, 1)[:1]).decode("latin-1"), f"{where}: line {number}"
        if word == "newmtl":
            look = found[obj_file.text_of(statement, at)] = Look(at)
        elif look and word == "Kd":
            look.colour = colour_of(obj_file.text_of(statement, at).split(), at)
        elif look and word == "map_Kd":
            look.at, look.picture = at, beside(reference, picture_of(obj_file.text_of(statement, at), at))
    return found


def libraries(names: list[str], reference: str, folder: Path) -> list[str]:
    """Returns the references of libraries. A statement names several, or one whose name has spaces."""
    made = []
    for name in names:
        whole = beside(reference, name)
        is_one = whole.startswith(images.PACKAGE) or os.path.isfile(folder / whole)
        made += [whole] if is_one else [beside(reference, word) for word in name.split()]
    return list(dict.fromkeys(made))


def add(spec: dict, folder: Path, where: str) -> None:
    """Gives a scene the materials and textures of the files whose objects have materials "file", and
    these objects the table that names them."""
    new_material, new_texture = materials.material_schema(), materials.texture_schema()
    for i, obj in enumerate(spec["objects"]):
        if obj.get("materials") != FILE:
            continue
        at, reference = f"{where}objects[{i}].materials", obj["mesh"]
        mesh_at = f"{where}objects[{i}].mesh"
        mesh_file.check_format(reference, mesh_at)
        found = obj_file.read(mesh_file.data_of(reference, folder, mesh_at), f"{mesh_at}: {reference}")
        known: dict[str, Look] = {}
        for library in libraries(found.libraries, reference, folder):
            known |= looks(library, folder, at)
        obj["materials"] = {}
        for name, line in zip(found.materials, found.lines):
            if name in obj["materials"]:
                continue
            if name not in known:
                fail(f"{at}: {reference}: line {line}",
                     f"a face of material {name!r}, which is in no library that the file names" if name
                     else "a face before the first usemtl; it has no material")
            look, made = known[name], f"{reference} {name}"
            obj["materials"][name] = made
            if look.picture is None:
                spec["materials"][made] = new_material({"colour": look.colour}, look.at)
                continue
            images.locate(look.picture, folder, look.at)
            spec["textures"][made] = new_texture({"image": look.picture, "fit": "whole"}, look.at) | {"at": look.at}
            spec["materials"][made] = new_material({"texture": made}, look.at)
