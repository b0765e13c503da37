"""Reads meshes as scenes name them: Wavefront OBJ files, or lists of points and faces."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tmap.base.fields import fail
from tmap.build import layout
from tmap.images import images
from tmap.shapes import obj_file

BYTES_MAX = 16 << 20  # of an OBJ file; a larger one is a mistake or an attack
#: Names of other formats for meshes, by the ends of their files' names.
OTHERS = {"glb": "glTF", "gltf": "glTF", "stl": "STL", "ply": "PLY", "3ds": "3D Studio", "max": "3ds Max",
          "fbx": "FBX", "dae": "Collada", "blend": "Blender", "lwo": "LightWave", "lw": "LightWave",
          "dxf": "DXF", "off": "OFF", "x3d": "X3D", "wrl": "VRML", "usd": "USD", "usda": "USD",
          "usdc": "USD", "usdz": "USD", "c4d": "Cinema 4D", "ma": "Maya", "mb": "Maya", "md2": "Quake II",
          "md3": "Quake III", "mtl": "a material library", "step": "STEP", "stp": "STEP", "iob": "Imagine",
          "3mf": "3MF"}


@dataclass
class Shape:
    """A mesh before scaling. Faces run counterclockwise, seen from outside."""

    points: np.ndarray  # (n, 3)
    faces: list[list[int]]  # a face's points
    texels: list[list[tuple[float, float]] | None] | None = None  # s, t of each corner
    normals: list[list[tuple[float, float, float]] | None] | None = None  # of each corner
    lines: list[int] | None = None  # of the faces in their file, from 1
    materials: list[str] | None = None  # of the faces in their file; "": before the first usemtl

    def at(self, face: int, where: str) -> str:
        """Returns the place of a face for messages. ``where``: the file, or the list of faces."""
        return f"{where}[{face}]" if self.lines is None else f"{where}: line {self.lines[face]}"

    def drawn(self, names: tuple[str, ...] | None) -> list[int]:
        """Returns the numbers of the faces whose materials in the file are these; None: of all."""
        return [k for k in range(len(self.faces)) if names is None or self.materials[k] in names]


def check_counts(points: int, faces: int, where: str) -> None:
    """Refuses more points or faces than a mesh may have."""
    most = layout.load().constants["MESH_COUNT_MAX"]
    for noun, count in (("points", points), ("faces", faces)):
        if count > most:
            fail(where, f"{count} {noun}; {most} at most")


def data_of(reference: str, folder: Path, where: str) -> bytes:
    """Returns the bytes of a file; refuses one that is larger than any mesh."""
    path = images.locate(reference, folder, where)
    try:
        if path.stat().st_size > BYTES_MAX:
            fail(f"{where}: {reference}", f"more than {BYTES_MAX} bytes")
        return path.read_bytes()
    except OSError as error:
        fail(f"{where}: {reference}", error.strerror)


def check_format(reference: str, where: str) -> None:
    """Refuses a mesh's file whose name is that of another format."""
    kind = OTHERS.get(reference.rpartition(".")[2].lower())
    if kind:
        fail(where, f"{reference}: is {kind}; meshes are read from Wavefront OBJ files (.obj)")


def load(reference: str, folder: Path, where: str, extent: tuple[float, float]) -> Shape:
    """Returns the mesh of an OBJ file: all its objects and groups together, with polygons uncut.

    ``extent``: s and t at the far ends of the map; v runs upwards in the file, t downwards.
    """
    check_format(reference, where)
    data, where = data_of(reference, folder, where), f"{where}: {reference}"
    found = obj_file.read(data, where)
    if not found.faces:
        fail(where, "has no faces")
    most = layout.load().constants["SCENE_COUNT_MAX"]
    if len(found.faces) > most:
        fail(where, f"{len(found.faces)} faces; {most} at most in a file")
    texels = [face and [(u * extent[0], (1 - v) * extent[1]) for u, v in face] for face in found.texels]
    return Shape(found.points, found.faces, texels, found.normals, found.lines, found.materials)


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
