"""Draws hard meshes, checks them against their exact faces, and makes their pictures for the page
of hard cases."""

from dataclasses import replace
from fractions import Fraction
from itertools import groupby

import numpy as np

from tmap.base.errors import UserError
from tmap.compiler import mesh_build, space
from tmap.compiler.objects import FACTOR_BITS, RADIUS, rounded
from tmap.corpus import random_maps
from tmap.corpus.hard_case import HEIGHT, WIDTH, called
from tmap.corpus.hard_meshes import MeshCase
from tmap.guest import guest_frames
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.ideal import faces as ideal_faces
from tmap.ideal.faces import Camera, Verdict
from tmap.model import model
from tmap.run.diff import compare
from tmap.scene_file.meshes import ENVIRONMENT, LIT, Instance, Mesh
from tmap.scene_file.scene_file import (IDENTITY, MAPPER_LAYOUT, ONE, SETTINGS, Material, Scene,
                                        Texture)
from tmap.setup.texturing import Settings
from tmap.shapes.mesh_file import Shape

DARK, BRIGHT = 20, 220  # darkest and brightest shade of the light
LIGHT = (Fraction(2, 3), -Fraction(1, 3), -Fraction(2, 3))  # direction towards the light
BACKGROUND, COLOUR = 7, 200
FLAGS = {"environment": ENVIRONMENT, "shade": LIT}
Drawing = tuple[MeshCase, Settings]


def combinations(case: MeshCase) -> list[Settings]:
    """Returns a case's settings: flat and every perspective; if its look comes from normals, the
    settings for environment mapping or shades alone."""
    if case.look == "environment":
        return [Settings("exact", perspective=p) for p in ("none", "every8", "pixel")]
    if case.look == "shade":
        return [Settings(edges, mapper="gouraud") for edges in ("exact", "subpixel")]
    return [Settings("exact", mapper="flat"),
            *(Settings("exact", perspective=p) for p in SETTINGS["perspective"]),
            Settings("subpixel", perspective="pixel"),
            Settings("subpixel", clip="vertices", perspective="every16")]


def camera(case: MeshCase) -> Camera:
    """Returns the exact camera."""
    guard = space.guard_bits(WIDTH, HEIGHT, case.focal)
    lens = Fraction(case.focal, 1 << guard)
    factors = [[c * part for c in row] for row, part in zip(case.turn, (lens, lens, 1))]
    move = [-sum(f * e for f, e in zip(row, case.eye)) for row in factors]
    lengths = int(RADIUS), int(RADIUS), BRIGHT - DARK
    looks = [[length * c for c in row] for row, length in zip((*case.turn[:2], LIGHT), lengths)]
    return Camera(factors, move, case.eye, looks, guard, WIDTH, HEIGHT, case.near)


def view(exact: Camera) -> list[int]:
    """Returns the camera's row as the scene file stores it."""
    parts = (exact.factors, 30), ([exact.move], 16), ([exact.eye], 16), (exact.looks, FACTOR_BITS)
    return [n for rows, bits in parts for n in rounded([list(map(float, row)) for row in rows], bits)] + [0]


def scene(case: MeshCase, settings: list[Settings], texels: np.ndarray) -> Scene:
    """Returns a scene with one frame for each of a case's settings; ``texels``: the map."""
    shape = Shape(np.array([[float(c) for c in point] for point in case.points]),
                  [list(face) for face in case.faces],
                  [[(float(s), float(t)) for s, t in face] for face in case.texels])
    tables = mesh_build.build(shape, mesh_build.Wishes(
        normals=None if case.look == "uv" else "smooth", mapping=case.look, light=case.look == "shade",
        planes=True, two_sided=case.two_sided), case.name)
    rows = tables.points, tables.normals, tables.corners, tables.faces
    mesh = Mesh(*(n for table in rows for n in (0, len(table))))
    materials = [Material(**vars(s), texture=0 if MAPPER_LAYOUT[s.mapper] else -1, colour=COLOUR)
                 for s in settings]
    flags = FLAGS.get(case.look, 0)
    ends = (DARK << 16, BRIGHT << 16) if flags == LIT else (0, 0)
    instances = [Instance(0, k, 0, 0, 1, k, flags, *ends) for k in range(len(settings))]
    exact = camera(case)
    return Scene(WIDTH, HEIGHT, len(settings), BACKGROUND, random_maps.palette(), [Texture(texels)],
                 materials, [], np.zeros((0, 6), int), np.array([IDENTITY]),
                 near_plane=round(case.near * ONE),
                 guard=exact.guard, points=tables.points, normals=tables.normals,
                 corners=tables.corners, faces=tables.faces,
                 meshes=[mesh], instances=instances, views=np.array([view(exact)]))


def grouped(drawings: list[Drawing]) -> dict[MeshCase, list[Settings]]:
    """Returns the settings of each case, whose drawings come together."""
    return {case: [settings for _, settings in some]
            for case, some in groupby(drawings, lambda drawing: drawing[0])}


def joined(scenes: list[Scene]) -> Scene:
    """Joins the frames of scenes with the same lens, and adds an empty one. Loading and setting up
    a scene takes as long as many frames, so there should be few scenes."""
    tables = {name: [getattr(each, name) for each in scenes]
              for name in ("points", "normals", "corners", "faces")}
    made = replace(scenes[0], frames=1, materials=[], meshes=[], instances=[],
                   views=np.concatenate([each.views for each in scenes]),
                   **{name: np.concatenate(rows) for name, rows in tables.items()})
    firsts = [0] * len(tables)
    for k, each in enumerate(scenes):
        counts = [len(rows[k]) for rows in tables.values()]
        made.meshes.append(Mesh(*(n for both in zip(firsts, counts) for n in both)))
        made.instances += [replace(i, mesh=k, material=i.material + len(made.materials), view=k,
                                   first_frame=i.first_frame + made.frames - 1)
                           for i in each.instances]
        made.materials += each.materials
        made.frames += each.frames
        firsts = [first + count for first, count in zip(firsts, counts)]
    return made


def drawn(scenes: list[Scene], machine: str) -> list[tuple[np.ndarray, np.void]]:
    """Returns the digests of each scene's frames and that of an empty frame. All run in one boot,
    and scenes with the same lens share a file."""
    lenses: dict[tuple[int, int], list[int]] = {}
    for k, each in enumerate(scenes):
        lenses.setdefault((each.near_plane, each.guard), []).append(k)
    whole = [joined([scenes[k] for k in part]) for part in lenses.values()]
    found = {}
    for part, digests in zip(lenses.values(),
                             guest_frames.draw([(each, "addx") for each in whole], machine)):
        ends = np.cumsum([scenes[k].frames for k in part])
        for k, some in zip(part, np.split(digests[:-1], ends[:-1]), strict=True):
            found[k] = some, digests[-1]
    return [found[k] for k in range(len(scenes))]


def check(each: Scene, digests: np.ndarray, names: list[str], machine: str) -> None:
    """Refuses frames that differ from the model's. ``names``: of the scene's drawings."""
    for number, (digest, name) in enumerate(zip(digests, names, strict=True)):
        right = model.render(each, number)
        if not guest_frames.is_models(right, digest):
            alone = replace(each, frames=1, instances=[replace(each.instances[number], first_frame=0)])
            raise UserError(f"{name} is not the model's; expected / found: "
                            f"{compare(right, guest_frames.frame_of(alone, 'addx', machine))}")


def cycles(drawings: list[Drawing], machine: str) -> list[int]:
    """Cycles of each drawing, a case's together. Refuses a frame that is not the model's."""
    groups = grouped(drawings)
    scenes = [scene(case, settings, random_maps.of_size(256, 256)) for case, settings in groups.items()]
    spent = []
    for each, (case, settings), (digests, empty) in zip(scenes, groups.items(), drawn(scenes, machine)):
        check(each, digests, [called(case, s) for s in settings], machine)
        if not guest_frames.is_models(np.full((HEIGHT, WIDTH), BACKGROUND, np.uint8), empty):
            raise UserError(f"{case.name}: a frame without meshes is not empty")
        ticks = digests["ticks"].astype(int) - int(empty["ticks"])
        spent += (ticks * CYCLES_PER_TICK).tolist()
    return spent


def judge(case: MeshCase, settings: list[Settings]) -> list[Verdict]:
    """Returns the verdict on each setting of a case against its exact faces."""
    made = scene(case, settings, random_maps.of_size(256, 256))
    faces = ideal_faces.exact_faces(made, made.instances[0], camera(case))
    found = [ideal_faces.judge(made, k, instance, faces) for k, instance in enumerate(made.instances)]
    for k, verdict in enumerate(found):
        if case.around and (model.render(made, k) == BACKGROUND).any() and settings[k].mapper == "flat":
            verdict.complain("leaves pixels out, though it is on all sides of the eye")
    return found


def both(case: MeshCase, texels: np.ndarray) -> tuple[np.ndarray | None, np.ndarray]:
    """Returns the exact picture and ours, int16 (HEIGHT, WIDTH), -1 outside the mesh. Shades have
    no exact picture (None)."""
    settings = combinations(case)
    best = next((s for s in settings if s.perspective == "fine"), settings[-1])
    if case.look == "shade":
        best = settings[0]
    made = scene(case, [best], texels)
    made.background = 0
    alone = replace(made, textures=[Texture(np.full_like(texels, 255))])
    ours = model.render(made, 0).astype(np.int16)
    ours[model.render(alone, 0) == 0] = -1
    if case.look == "shade":
        return None, ours
    faces = ideal_faces.exact_faces(made, made.instances[0], camera(case))
    shown = ideal_faces.picture(camera(case), faces, lambda u, v: texels[v % 256, u % 256])
    return shown, ours
