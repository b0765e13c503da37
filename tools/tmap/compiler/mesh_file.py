"""Reads meshes as scenes name them: Wavefront OBJ files, or lists of points and faces."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import tinyobjloader

from tmap.base.fields import fail
from tmap.build import layout
from tmap.images import images

NUMBER = rb"[ \t]+[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
#: Lines of points, normals and texture coordinates. They are checked here because the parser reads
#: a word that is not a number as 0.
NUMBERS = re.compile(rb"[ \t]*(?:vt(?:%b){2,}|vn?(?:%b){3,})[ \t]*(?:#.*)?\r?" % (NUMBER, NUMBER))
BYTES_MAX = 16 << 20  # of an OBJ file; a larger one is a mistake or an attack


@dataclass
class Shape:
    """A mesh before scaling. Faces run counterclockwise, seen from outside."""

    points: np.ndarray  # (n, 3)
    faces: list[list[int]]  # a face's points
    texels: list[list[tuple[float, float]]] | None = None  # s, t of each corner
    normals: list[list[tuple[float, float, float]]] | None = None  # of each corner


def check_counts(points: int, faces: int, where: str) -> None:
    """Refuses more points or faces than a mesh may have."""
    most = layout.load().constants["MESH_COUNT_MAX"]
    for noun, count in (("points", points), ("faces", faces)):
        if count > most:
            fail(where, f"{count} {noun}; {most} at most")


def parse(data: bytes, where: str):
    """Parses an OBJ file's bytes; returns attributes and shapes."""
    for number, line in enumerate(data.split(b"\n"), 1):
        if line.split(None, 1)[:1] in ([b"v"], [b"vt"], [b"vn"]) and not NUMBERS.fullmatch(line):
            fail(where, f"line {number}: its numbers cannot be read")
    config = tinyobjloader.ObjReaderConfig()
    config.triangulate = False
    reader = tinyobjloader.ObjReader()
    if not reader.ParseFromString(data.decode("latin-1"), "", config):
        reason = " ".join(reader.Error().split()) or "not a Wavefront OBJ file"
        fail(where, f"cannot be read: {reason}")
    return reader.GetAttrib(), reader.GetShapes()


def pick(table, width: int, indices: list[list[int]], noun: str, where: str):
    """Returns rows of a table by index, face by face; None if a corner has no index."""
    if any(index < 0 for face in indices for index in face):
        return None
    rows = np.array(table, float).reshape(-1, width)
    if max((index for face in indices for index in face), default=-1) >= len(rows):
        fail(where, f"a face names a {noun} that is not there")
    return [[tuple(rows[index].tolist()) for index in face] for face in indices]


def load(reference: str, folder: Path, where: str, extent: tuple[float, float]) -> Shape:
    """Returns the mesh of an OBJ file: all its objects and groups together, with polygons uncut.

    Materials are not read. ``extent``: s and t at the far ends of the map; v runs upwards in the
    file, t downwards.
    """
    path = images.locate(reference, folder, where)
    where = f"{where}: {reference}"
    try:
        if path.stat().st_size > BYTES_MAX:
            fail(where, f"more than {BYTES_MAX} bytes")
        data = path.read_bytes()
    except OSError as error:
        fail(where, error.strerror)
    attributes, shapes = parse(data, where)
    counts = [int(n) for shape in shapes for n in shape.mesh.num_face_vertices]
    if not counts:
        fail(where, "has no faces")
    points = np.array(attributes.vertices, float).reshape(-1, 3)
    check_counts(0, len(counts), where)
    corners = [c for shape in shapes for c in shape.mesh.indices]
    ends = np.cumsum(counts).tolist()
    rings = [corners[end - count:end] for end, count in zip(ends, counts)]
    if not all(0 <= c.vertex_index < len(points) for c in corners):
        fail(where, "a face names a point that is not there")
    texels = pick(attributes.texcoords, 2, [[c.texcoord_index for c in r] for r in rings],
                  "texture coordinate", where)
    normals = pick(attributes.normals, 3, [[c.normal_index for c in r] for r in rings],
                   "normal", where)
    if texels:
        texels = [[(u * extent[0], (1 - v) * extent[1]) for u, v in face] for face in texels]
    return Shape(points, [[c.vertex_index for c in ring] for ring in rings], texels, normals)


def listed(spec: dict, where: str, uvs: str = "uvs") -> Shape:
    """Returns the mesh of an object with points and faces. ``where``: the object, for messages;
    ``uvs``: the field with the texture coordinates."""
    points, faces, texels = spec["points"], spec["faces"], spec[uvs]
    for i, face in enumerate(faces):
        for k, point in enumerate(face):
            if point >= len(points):
                fail(f"{where}.faces[{i}][{k}]", f"there is no point {point}")
    if texels is not None:
        if len(texels) == 1:  # the same on every face
            texels = texels * len(faces)
        if len(texels) != len(faces):
            fail(f"{where}.{uvs}", f"must have {len(faces)} entries, one a face, or one for all; "
                                 f"not {len(texels)}")
        for i, (face, corners) in enumerate(zip(faces, texels)):
            if len(face) != len(corners):
                fail(f"{where}.{uvs}[{min(i, len(spec[uvs]) - 1)}]",
                     f"must have {len(face)} entries, one a corner of face {i}; "
                     f"not {len(corners)}")
        texels = [[tuple(corner) for corner in face] for face in texels]
    return Shape(np.array(points, float), faces, texels)
