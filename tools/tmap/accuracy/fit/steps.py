"""The settings that ``tmap fit`` chooses from: steps of each group of a scene's materials, edges, and a pixel's size.

Steps of perspective are those that no other beats in the committed figures of ``tmap accuracy``, which ``tmap choose``
reads too, and one with a tolerance. What changes more than accuracy stays: mappers, mip maps, filters.
"""

from collections import Counter
from copy import deepcopy
from dataclasses import dataclass, replace
from itertools import product

from tmap.accuracy import choose
from tmap.accuracy.choose import LARGEST, POLYGON, Wish
from tmap.accuracy.rows import beats
from tmap.base.paths import ACCURACY_BASELINE
from tmap.compiler import materials, objects
from tmap.glide.state import SUBDIVISIONS
from tmap.scene_file.textures import UNITS

MOST_GROUPS = 4  # materials of equal settings are one group where there are more
TOLERANCE = 0.5  # texels
TOLERANT = "pixel"  # the perspective with which lines that are that exact without it save most
ASKED = ("edges", "gradients", "start", "perspective", "tolerance")
EDGES = "exact", "snapped"
OWN = {}  # the step that leaves a material as it is


@dataclass(frozen=True)
class Group:
    """Materials whose settings change together, and their steps: keys of each, the most exact first."""

    names: tuple[str, ...]
    steps: tuple[dict, ...]


@dataclass(frozen=True)
class Choice:
    """Settings of a scene; ``steps``: a number for each group. Without any the scene is as it is."""

    pixel: str
    edges: str | None = None
    steps: tuple[int, ...] = ()


@dataclass(frozen=True)
class Space:
    """All that can be chosen for a scene."""

    raw: dict  # the file's content
    spec: dict  # the same, checked
    groups: tuple[Group, ...]
    edges: tuple[str, ...]

    def exact(self, pixel: str) -> Choice:
        """Returns the most exact settings."""
        return Choice(pixel, self.edges[0], (0,) * len(self.groups))

    def cheap(self, pixel: str) -> Choice:
        """Returns the cheapest settings."""
        return Choice(pixel, self.edges[-1], tuple(len(group.steps) - 1 for group in self.groups))

    def base(self, pixel: str) -> Choice:
        """Returns the cheapest settings with exact edges."""
        return replace(self.cheap(pixel), edges=self.edges[0])

    def bent(self, pixel: str) -> Choice:
        """Returns the cheapest settings with a perspective: polygons that bend little may take less with one."""
        base = self.base(pixel)
        return replace(base, steps=tuple(map(self.before, range(len(self.groups)), base.steps)))

    def before(self, group: int, step: int) -> int:
        """Returns the step before one, of those that are not the scene's own."""
        return next((k for k in reversed(range(step)) if self.groups[group].steps[k] != OWN), step)

    def single(self, base: Choice, group: int, step: int) -> Choice:
        """Returns the base with one group at another step."""
        return replace(base, steps=(*base.steps[:group], step, *base.steps[group + 1:]))

    def parts(self, choice: Choice) -> Counter:
        """Returns the choices whose figures make a choice's, with their factors: the base, and what changing one group
        alone adds. Other edges may add less to a group that is changed; one of its steps says by how much."""
        base = self.base(choice.pixel)
        other = replace(base, edges=choice.edges)
        made = Counter([other])
        for group, (step, first) in enumerate(zip(choice.steps, base.steps)):
            if step == first:
                continue
            made[self.single(base, group, step)] += 1
            made[base] -= 1
            if other != base:
                one = self.before(group, first)
                for each, factor in ((other, 1), (base, -1)):
                    made[self.single(each, group, one)] += factor
                    made[each] -= factor
        return made

    def singles(self, pixel: str) -> list[Choice]:
        """Returns all choices that are parts of others."""
        return list(dict.fromkeys(part for choice in self.every(pixel) for part in self.parts(choice)))

    def every(self, pixel: str) -> list[Choice]:
        """Returns all choices in pixels of a size."""
        return [Choice(pixel, edges, steps) for edges in self.edges
                for steps in product(*(range(len(group.steps)) for group in self.groups))]


def perspectives(rows: list[dict], machine: str, mapper: str) -> list[str]:
    """Returns the perspectives of a mapper that no other beats, the most exact first."""
    found = [row for row in choose.candidates(rows, Wish(0, machine, depth=True, mapper=mapper))
             if (row["edges"], row["gradients"], row["start"]) == ("exact", "plane", "subtexel")]
    kept = [row for row in found if not any(beats(other, row, (POLYGON, LARGEST)) for other in found)]
    return [row["perspective"] for row in sorted(kept, key=lambda row: row[LARGEST])]


def is_in_space(spec: dict, name: str) -> bool:
    """Returns True if all objects of a material have depths of their own: they may be drawn with a perspective and
    without."""
    return all(objects.is_mesh(obj) and obj.get("mapping") != "environment"
               for obj in spec["objects"] if obj["material"] == name)


def steps_of(spec: dict, name: str, rows: list[dict], machine: str) -> list[dict]:
    """Returns a material's steps, the most exact first."""
    material = spec["materials"][name]
    mapper, deep = materials.mapper_of(material), is_in_space(spec, name)
    if mapper == "glide" and material["glide"]["perspective"]:
        return [{"subdivision": each} for each in SUBDIVISIONS]
    if mapper in UNITS or "texture" not in material:
        return [OWN]
    plane = {"gradients": "plane", "start": "subtexel"}
    known = perspectives(rows, machine, mapper) if deep or material["perspective"] != "none" else []
    if not deep:
        known = [each for each in known if each != "none"]
    if not known:
        return [plane | {"perspective": material["perspective"], "tolerance": 0}]
    return [plane | {"perspective": each, "tolerance": tolerance} for each in known
            for tolerance in ((0, TOLERANCE) if each == TOLERANT else (0,))]


def with_own(material: dict, steps: list[dict]) -> tuple[dict, ...]:
    """Adds a material's own settings to its steps, before the cheapest, unless they are one of them."""
    if steps == [OWN] or "subdivision" in steps[0] or any(
            all(material[key] == value for key, value in step.items()) for step in steps):
        return tuple(steps)
    return (*steps[:max(1, len(steps) - 1)], OWN, *steps[max(1, len(steps) - 1):])


def grouped(spec: dict, names: list[str], steps: dict[str, tuple]) -> list[Group]:
    """Returns groups of materials with the same steps and settings; with the same steps only, if there are many."""
    def of(key) -> list[Group]:
        found: dict[str, list[str]] = {}
        for name in names:
            found.setdefault(key(name), []).append(name)
        return [Group(tuple(some), steps[some[0]]) for some in found.values()]

    ways = (lambda name: name,
            lambda name: repr((materials.mapper_of(spec["materials"][name]), steps[name],
                               [spec["materials"][name][key] for key in ASKED])),
            lambda name: repr(steps[name]))
    return next((made for made in map(of, ways) if len(made) <= MOST_GROUPS), of(ways[-1]))


def space_of(raw: dict, spec: dict, machine: str) -> Space:
    """Returns what can be chosen for a scene: its content as in the file, and checked."""
    rows = choose.load(ACCURACY_BASELINE)["rows"]
    used = {obj["material"] for obj in spec["objects"]}
    names = [name for name in raw.get("materials", {}) if name in used]
    steps = {name: with_own(spec["materials"][name], steps_of(spec, name, rows, machine)) for name in names}
    is_once = spec["visible"] == "once"
    could = any(spec["materials"][name]["perspective"] == "none" or {"perspective": "none"}.items() <= step.items()
                for name in names for step in steps[name])
    units = any(materials.mapper_of(spec["materials"][name]) in UNITS for name in spec["materials"])
    return Space(raw, spec, tuple(grouped(spec, [name for name in names if len(steps[name]) > 1], steps)),
                 EDGES if could and not is_once and not units and names else EDGES[:1])


def set_keys(raw: dict, own: dict, step: dict) -> None:
    """Sets a step's keys in a material as its file has it; ``own``: the same, checked. Keys that say what holds without
    them are left out."""
    if "subdivision" in step:
        for unit in raw["glide"]["units"]:
            if unit.get("subdivision", 0) != step["subdivision"]:
                unit["subdivision"] = step["subdivision"]
        return
    defaults = {"gradients": "plane", "start": "subtexel", "perspective": "none", "tolerance": 0}
    for key, value in step.items():
        if own[key] == value:
            continue
        raw.pop(key, None)
        if value != defaults[key]:
            raw[key] = value


def keys_of(space: Space, choice: Choice) -> dict:
    """Returns the keys of a scene's table that a choice sets: the size of pixels, and materials."""
    if choice.edges is None:
        return {"pixel": choice.pixel}
    made = deepcopy(space.raw.get("materials", {}))
    for group, step in zip(space.groups, choice.steps):
        for name in group.names:
            set_keys(made[name], space.spec["materials"][name], group.steps[step])
    for name, material in made.items():
        if materials.mapper_of(space.spec["materials"][name]) not in UNITS:
            material["edges"] = choice.edges
    return {"pixel": choice.pixel, "materials": made}


def words(step: dict) -> str:
    """Returns a step in words."""
    if step == OWN:
        return "as it is"
    if "subdivision" in step:
        return f"every {step['subdivision']}" if step["subdivision"] else "each pixel"
    tolerance = f" ±{step['tolerance']:g}" if step["tolerance"] else ""
    return step["perspective"] + tolerance


def in_words(space: Space, choice: Choice) -> str:
    """Returns a choice in words: the perspective of each group, and the edges."""
    if choice.edges is None or not space.groups and len(space.edges) == 1:
        return "as the scene has them"
    said = [(group.names[0] + (f" and {len(group.names) - 1} more" if len(group.names) > 1 else "")) + " "
            + words(group.steps[step]) for group, step in zip(space.groups, choice.steps)]
    return "; ".join(said + ([f"edges {choice.edges}"] if len(space.edges) > 1 else []))
