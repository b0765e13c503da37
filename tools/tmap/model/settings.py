"""Steps of accuracy for a scene's materials, as in c/scene/settings.h."""

from dataclasses import replace

import numpy as np

from tmap.scene_file.materials import SETTINGS, Material
from tmap.scene_file.pipes import COLUMNS
from tmap.scene_file.scene_file import Scene
from tmap.scene_file.textures import IN_DEPTH, ON_PLANE, UNITS

#: Edges, gradients and start of each step, from cheap to exact.
ACCURACY = (("integer", "polygon", "truncated"), ("subpixel", "polygon", "truncated"),
            ("subpixel", "polygon", "subtexel"), ("subpixel", "plane", "subtexel"),
            ("snapped", "plane", "subtexel"), ("exact", "plane", "subtexel"))
PERSPECTIVE = SETTINGS["perspective"]
EXACT = len(PERSPECTIVE)  # fine, and of materials that meshes alone have where they have none
#: Pixels between two divides of Glide's units, by steps of perspective.
SUBDIVISION = {"none": 16, "every16": 16, "every8": 8, "pixel": 0, "fine": 0}
#: Mappers whose gradients and start cannot be changed.
FIXED = (*ON_PLANE, *UNITS)


def materials_of_polygons(scene: Scene) -> set[int]:
    """Returns the materials that have a polygon or a face with more than three corners."""
    found = {obj.material for obj in scene.objects if obj.vertices > 3}
    for instance in scene.instances:
        mesh = scene.meshes[instance.mesh]
        faces = scene.faces[mesh.face:mesh.face + mesh.faces]
        if any(int(face[-1]) > 3 for face in faces):
            found.add(instance.material)
    return found


def set_material(own: Material, accuracy: int | None, perspective: int | None,
                 triangles: bool, only_cheaper: bool) -> Material:
    """Returns a material at a step of each axis, or, ``only_cheaper``, at that step at most; None keeps the
    scene's choice."""
    made = own
    if only_cheaper and perspective is not None and perspective >= PERSPECTIVE.index(own.perspective):
        perspective = None
    if only_cheaper and own.edges in ("integer", "snapped"):
        accuracy = None
    if perspective is not None and own.perspective != "none":
        name = PERSPECTIVE[perspective]
        made = replace(made, perspective=name,
                       tolerance=0 if name == "fine" else own.tolerance)
    if accuracy is None:
        return made
    edges, gradients, start = ACCURACY[accuracy]
    if own.mapper in UNITS and edges in ("integer", "snapped"):
        edges = "subpixel"
    made = replace(made, edges=edges)
    if own.mapper in FIXED or made.perspective != "none":
        return made
    return replace(made, start=start, gradients=gradients if triangles else own.gradients)


def materials_of_meshes(scene: Scene) -> set[int]:
    """Returns the materials without perspective that could have it and that meshes alone have, and their mip maps'."""
    alone = {instance.material for instance in scene.instances} - {obj.material for obj in scene.objects}
    found = set()
    for number in alone:
        material = scene.materials[number]
        if material.perspective == "none" and material.mapper in IN_DEPTH:
            found |= {number, *range(material.level, material.level + material.levels)}
    return found


def with_settings(scene: Scene, accuracy: int | None, perspective: int | None,
                  only_cheaper: bool = False) -> Scene:
    """Returns a scene whose materials are at these steps, each as far as it allows."""
    polygons = materials_of_polygons(scene)
    glide_units = scene.glide_units.copy()
    deep = materials_of_meshes(scene) if perspective == EXACT else set()
    if perspective is not None:
        perspective = min(perspective, PERSPECTIVE.index("fine"))
        own = glide_units[:, COLUMNS["glide_units"].index("subdivision")]
        asked = SUBDIVISION[PERSPECTIVE[perspective]]
        own[:] = np.where(only_cheaper & (own > asked), own, asked)
    made = [set_material(material, accuracy, perspective, number not in polygons, only_cheaper)
            for number, material in enumerate(scene.materials)]
    for number in deep:
        made[number] = replace(made[number], perspective="fine", gradients="plane", start="subtexel")
    return replace(scene, glide_units=glide_units, materials=made)
