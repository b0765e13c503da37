"""Reads Wavefront OBJ files: statements with their lines, then points, texture coordinates, normals
and faces. tinyobjloader resolves indices; it knows no lines, and reads a word that is not a number as
0, so each statement is checked here first.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import tinyobjloader

from tmap.base.fields import fail

NUMBER = rb"[ \t]+[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
#: Statements with points, normals and texture coordinates.
NUMBERS = re.compile(rb"[ \t]*(?:vt(?:%b){2,}|vn?(?:%b){3,})[ \t]*(?:#.*)?" % (NUMBER, NUMBER))
INDEX = rb"[-+]?0*[1-9]\d{0,8}"
#: A face's corner: point, texture coordinate, normal. Some programs write the slashes alone.
CORNER = re.compile(rb"(%b)(?:/(%b)?(?:/(%b)?)?)?" % (INDEX, INDEX, INDEX))


@dataclass
class ObjFile:
    """An OBJ file's content; a list's entries belong to its faces, in order."""

    libraries: list[str]  # what the mtllib statements name
    points: np.ndarray  # [n, 3]
    lines: list[int]  # where the face's statement begins, from 1
    materials: list[str]  # by usemtl; "" before the first
    faces: list[list[int]]  # points; fewer than 3 corners are possible
    texels: list[list[tuple[float, float]] | None]  # u, v; None if a corner has none
    normals: list[list[tuple[float, float, float]] | None]  # the same


def statements(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Yields the statements of a file, each with its first line's number. A backslash at the end of
    a line continues the statement, except in comments, where it may end a folder's name."""
    parts: list[bytes] = []
    for number, line in enumerate(data.splitlines(), 1):
        parts.append(line.rstrip())
        if parts[-1].endswith(b"\\") and not parts[0].lstrip().startswith(b"#"):
            parts[-1] = parts[-1][:-1]
            continue
        yield number - len(parts) + 1, b" ".join(parts)
        parts = []
    if parts:
        yield number - len(parts) + 1, b" ".join(parts)


def corners_of(statement: bytes, where: str) -> list[bytes]:
    """Returns a face's corners as words without spare slashes."""
    words = statement.split(b"#")[0].split()[1:]
    found = [CORNER.fullmatch(word) for word in words]
    if not all(found):
        fail(where, "its corners cannot be read; they are point, point/texture, point//normal or "
                    "point/texture/normal, counted from 1, or from -1 backwards")
    return [b"/".join(index or b"" for index in each.groups()).rstrip(b"/") for each in found]


def text_of(statement: bytes, where: str) -> str:
    """Returns the words behind a statement's first, as text with single spaces: names may have them."""
    rest = b" ".join(statement.split()[1:])
    try:
        found = rest.decode()
    except UnicodeDecodeError:
        found = rest.decode("latin-1")
    if not found.isprintable():
        fail(where, "must be text")
    return found


def pick(table, width: int, index: list[int], noun: str, where: str):
    """Returns the rows of a table for a face's corners; None if a corner has no index."""
    if min(index, default=-1) < 0:
        return None
    if max(index) >= len(table) // width:
        fail(where, f"the face names a {noun} that is not there")
    return [tuple(map(float, table[width * k:width * k + width])) for k in index]


def read(data: bytes, where: str) -> ObjFile:
    """Returns the content of an OBJ file. ``where``: the file, for messages."""
    lines, counts, used, name, libraries = [], [], [], "", []
    plain: list[bytes] = []  # what the parser reads, in the file's own lines
    for number, statement in statements(data):
        word, at = statement.split(None, 1)[:1], f"{where}: line {number}"
        if word in ([b"v"], [b"vt"], [b"vn"]):
            if not NUMBERS.fullmatch(statement):
                fail(at, "its numbers cannot be read")
        elif word == [b"f"]:
            corners = corners_of(statement, at)
            lines.append(number)
            counts.append(len(corners))
            used.append(name)
            statement = b"f " + b" ".join(corners)
        elif word == [b"usemtl"]:
            name = text_of(statement, at)
            continue
        elif word == [b"mtllib"]:
            libraries.append(text_of(statement, at))
            continue
        else:
            continue
        plain += [b""] * (number - 1 - len(plain)) + [statement]
    config = tinyobjloader.ObjReaderConfig()
    config.triangulate = False
    reader = tinyobjloader.ObjReader()
    if not reader.ParseFromString(b"\n".join([*plain, b""]).decode("latin-1"), "", config):
        reason = " ".join(reader.Error().split()) or "not a Wavefront OBJ file"
        line = re.search(r"Line (\d+)", reason)
        if line:
            fail(f"{where}: line {line[1]}", "a corner counts back beyond the first point, texture "
                                             "coordinate or normal")
        fail(where, f"cannot be read: {reason}")
    attributes = reader.GetAttrib()
    corners = iter([c for shape in reader.GetShapes() for c in shape.mesh.indices])
    made = ObjFile(libraries, np.array(attributes.vertices, float).reshape(-1, 3), lines, used,
                   [], [], [])
    texels, normals = list(attributes.texcoords), list(attributes.normals)
    for line, count in zip(lines, counts):
        # The parser leaves out faces of fewer than three corners.
        face, at = [next(corners) for _ in range(count * (count >= 3))], f"{where}: line {line}"
        if not all(0 <= c.vertex_index < len(made.points) for c in face):
            fail(at, "the face names a point that is not there")
        made.faces.append([c.vertex_index for c in face])
        made.texels.append(pick(texels, 2, [c.texcoord_index for c in face], "texture coordinate", at))
        made.normals.append(pick(normals, 3, [c.normal_index for c in face], "normal", at))
    return made
