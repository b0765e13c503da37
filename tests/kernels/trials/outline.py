"""Trials of src68k/polygon: three vertices, whole outlines with their planes, the longest scanline,
Gouraud's vertices; against the model."""

from dataclasses import replace

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.polygon import (FAR, HEIGHT, WIDTH, box_block, described, edges_make_trial,
                                          exact_fields, rounded_fields, seen_polygons, sides_block,
                                          sides_find_trials, sides_numbers, sides_pointers,
                                          vertex_at, vertex_block, wanted_sides)
from tests.kernels.trials.texturing import texturing_plane_trial
from tmap.base.fixed import M32, ONE, signed
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial, Write, anything, fields, values
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.model import model
from tmap.setup import edges as model_edges, texturing

GENTLE = (("CHAIN_NONE", model.Settings(mapper="generated")),
          ("CHAIN_NONE", model.Settings(mapper="columns")),
          ("CHAIN_ANYWHERE", model.Settings(start="truncated")),
          ("CHAIN_PLANE", model.Settings()))
CHEAP = model.Settings("integer", "polygon", "truncated")
INSET = ONE // 16


def triangles(rng, count: int) -> list[list[tuple]]:
    """Triangles in the frame and around it, with gentle gradients and with others."""
    made = []
    for k in range(count):
        size = float(rng.choice((3, 20, 100, 400, 1500)))
        places = rng.uniform(0, 256, 2) + rng.uniform(-size, size, (3, 2))
        steps = rng.uniform(-1, 1, (2, 2)) * float(rng.choice((0.2, 1, 6, 30)))
        texels = places @ steps + rng.uniform(-100, 400, 2)
        if k % 4 == 0:
            places = np.floor(places)
        made.append([tuple(min(max(round(c * ONE), -FAR), FAR - 1) for c in (*p, *t))
                     for p, t in zip(places, texels)])
    return made


def sides_three_trials(rng) -> list[Trial]:
    found = [trial for trial in sides_find_trials(rng) if trial.case.registers["d0"] == 3]
    for trial in found:
        trial.case = replace(trial.case, kernel="sides_three", registers={})
    return found


def edges_three_trials(rng) -> list[Trial]:
    found = [edges_make_trial(p, exact) for p in seen_polygons(rng) + triangles(rng, 60)
             if len(p) == 3 for exact in (False, True)]
    found = [trial for trial in found if trial]
    for trial in found:
        places = trial.case.pointers
        trial.case = replace(trial.case, kernel="edges_three", registers={"d0": trial.case.registers["d1"]},
                             pointers={"a1": places["a1"], "a2": places["a0"], "a4": places["d0"]})
    return found


def gentle_trials(rng) -> list[Trial]:
    """As those of texturing_plane, for all gradients."""
    made = seen_polygons(rng) + triangles(rng, 120)
    return [trial for p in made for each in GENTLE
            if (trial := texturing_plane_trial(p, *each, kernel="texturing_gentle"))]


def embed(memory: Memory, at: int, outer: str, field: str, struct: str, pointers: dict[str, int],
          **numbers: int) -> int:
    """Writes a struct that is a field of another one at ``at``; returns its place."""
    shape = layout.load().struct(struct)
    place = at + layout.load().struct(outer).fields[field]["offset"]
    memory.data[place:place + shape.size] = shape.pack(**numbers, **pointers)
    memory.pointers += [place + shape.fields[name]["offset"] for name in pointers]
    return place


def setup_block(memory: Memory, vertices, at: int) -> tuple[int, int]:
    """struct setup as polygon_find takes it, and its scratch memory as far as the right edges."""
    sizes = {name: layout.load().struct("scratch").fields[name]["offset"] for name in ("left", "right")}
    edge = layout.load().struct("edge").size
    scratch = memory.blank(sizes["right"] + len(vertices) * edge, "scratch")
    frame = memory.struct("frame", {}, pixels=0, width=WIDTH, height=HEIGHT, pitch=WIDTH, pixel_bytes=1)
    setup = memory.room("setup")
    shape = layout.load().struct("setup").fields
    for name, value, points in (("scratch", scratch, True), ("frame", frame, True),
                                ("vertices", at, True), ("count", len(vertices), False)):
        place = setup + shape[name]["offset"]
        memory.data[place:place + 4] = value.to_bytes(4, "big")
        if points:
            memory.pointers.append(place)
    embed(memory, setup, "setup", "texturing", "texturing", {},
          **dict.fromkeys(layout.load().struct("texturing").fields, 0))
    return setup, scratch


def plane_writes(setup: int, t: model.Texturing) -> list[Write]:
    """What the texturing of a setup becomes."""
    at = setup + layout.load().struct("setup").fields["texturing"]["offset"]
    names = ("dudx", "dvdx", "wraps", "u_cut", "wrap_bit", "dudy", "dvdy", "u", "v", "i", "j")
    return fields(at, "texturing", {name: int(getattr(t, name)) for name in names})


def start_writes(place: int, edge: model.Edge, t: model.Texturing) -> list[Write]:
    """What u, v and their steps of a left edge on the plane become."""
    u, v = texturing.on_plane(t, edge.column(edge.top), edge.top)
    return fields(place, "edge", {"u": u, "v": v, "du": t.dudy + edge.whole * t.dudx,
                                  "dv": t.dvdy + edge.whole * t.dvdx})


def polygon_find_trial(vertices, exact: bool, has_plane: bool) -> Trial:
    wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
    memory = Memory()
    at = vertex_block(memory, vertices)
    setup, scratch = setup_block(memory, vertices, at)
    shape, edge_size = layout.load().struct("setup").fields, layout.load().struct("edge").size
    constants = layout.load().constants
    chain = constants["CHAIN_PLANE"] if has_plane else -1
    title = f"exact {exact}, plane {has_plane}: {described(vertices)}"
    case = Case("polygon_find", memory, {"d0": int(exact), "d1": chain & M32}, {"a0": setup})
    if sides is None:
        return Trial(case, title, {"d0": constants["POLYGON_EMPTY"]}, writes=[
            anything(setup + shape[name]["offset"], size) for name, size in
            (("sides", layout.load().struct("sides").size), ("outline_sides", 4))])
    sides_at, plan = (setup + shape[name]["offset"] for name in ("sides", "edges"))
    area = sides_at + layout.load().struct("sides").fields["area"]["offset"]
    writes = fields(setup, "setup", {}, {"outline_sides": sides_at})
    writes += fields(sides_at, "sides", sides_numbers(vertices, wanted), sides_pointers(at, vertices, wanted))
    writes.append(Write(area, wanted[4].to_bytes(8, "big")))
    writes += fields(setup + shape["box"]["offset"], "rectangle",
                     dict(zip(("left", "top", "right", "bottom"), sides.box)))
    t = texturing.plane(vertices, sides.corners, sides.box, model.Settings(), True)
    room = {side: scratch + layout.load().struct("scratch").fields[side]["offset"]
            for side in ("left", "right")}
    numbers = {}
    for side, way in (("left", 1), ("right", -1)):
        edges = model_edges.side(vertices, wanted[0], way * sides.direction, sides.box[1],
                                 sides.box[3], exact)
        numbers[f"{side}s"] = len(edges)
        for k, edge in enumerate(edges):
            found = (exact_fields if exact else rounded_fields)(edge)
            place = room[side] + k * edge_size
            writes += fields(place, "edge", found | {"lines": edge.end - edge.top, "top": edge.top},
                             {"upper": vertex_at(at, vertices.index(edge.upper)),
                              "lower": vertex_at(at, vertices.index(edge.lower))})
            if has_plane and side == "left":
                writes += start_writes(place, edge, t)
    writes += fields(plan, "edge_plan", numbers, {"lines": scratch, **room})
    if has_plane:
        writes += plane_writes(setup, t)
    return Trial(case, title, {"d0": constants["POLYGON_DRAWN"]}, writes=writes)


def polygon_find_trials(rng) -> list[Trial]:
    made = [*seen_polygons(rng)[::4], *triangles(rng, 40)]
    return [polygon_find_trial(p, bool(k & 1), bool(k & 2)) for k, p in enumerate(made)]


def plane_find_trials(rng) -> list[Trial]:
    found = []
    for vertices in triangles(rng, 40):
        wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
        if sides is None:
            continue
        memory = Memory()
        at = vertex_block(memory, vertices)
        setup, scratch = setup_block(memory, vertices, at)
        embed(memory, setup, "setup", "sides", "sides", sides_pointers(at, vertices, wanted),
              **sides_numbers(vertices, wanted), spare=[0] * 3, area=list(wanted[4].to_bytes(8, "big")))
        embed(memory, setup, "setup", "box", "rectangle", {},
              **dict(zip(("left", "top", "right", "bottom"), sides.box)))
        edge, = model_edges.side(vertices, wanted[0], sides.direction, *sides.box[1::2], True)[:1]
        place = memory.struct("edge", {}, **dict.fromkeys(layout.load().struct("edge").fields, 0) | {
            "x": edge.column(edge.top) + BIAS, "top": edge.top, "whole": edge.whole})
        embed(memory, setup, "setup", "edges", "edge_plan", {"left": place}, right=0, lines=0,
              lefts=1, rights=0, dudx=0, dvdx=0)
        t = texturing.plane(vertices, sides.corners, sides.box, model.Settings(), True)
        found.append(Trial(
            Case("plane_find", memory, {"d0": layout.load().constants["CHAIN_PLANE"]}, {"a0": setup}),
            described(vertices), writes=plane_writes(setup, t) + start_writes(place, edge, t)))
    return found


def longest_trials(rng) -> list[Trial]:
    found = []
    for vertices in triangles(rng, 80):
        wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
        for mapper in ("affine", "tiled", "columns") if sides else ():
            settings = replace(CHEAP, mapper=mapper)
            t = texturing.longest(vertices, sides.corners, sides.box, settings)
            memory = Memory()
            at = vertex_block(memory, vertices)
            sides_at, box = sides_block(memory, at, vertices, wanted), box_block(memory, sides.box)
            cuts = dict(zip(("u_cut", "v_cut"), texturing.CUT.get(mapper, (0, 0))))
            out = memory.struct("texturing", {}, **dict.fromkeys(
                layout.load().struct("texturing").fields, 7) | cuts)
            numbers = {name: int(getattr(t, name)) for name in ("dudx", "dvdx", "wraps", "u_cut", "wrap_bit")}
            chain = "CHAIN_ANYWHERE" if mapper == "affine" else "CHAIN_NONE"
            found.append(Trial(
                Case("texturing_longest", memory, {"d1": layout.load().constants[chain]},
                     {"a0": out, "a1": sides_at, "d0": box}),
                f"{mapper}: {described(vertices)}", writes=fields(out, "texturing", numbers)))
    return found


def edge_block(memory: Memory, at: int, vertices, edge: model.Edge) -> int:
    numbers = dict.fromkeys(layout.load().struct("edge").fields, 0) | {
        "lines": edge.end - edge.top, "top": edge.top}
    pointers = {name: vertex_at(at, vertices.index(getattr(edge, name))) for name in ("upper", "lower")}
    return memory.struct("edge", pointers, **{k: n for k, n in numbers.items() if k not in pointers})


def along_trials(rng) -> list[Trial]:
    """texturing_along, and texturing_edges for one edge."""
    found = []
    for vertices in triangles(rng, 80):
        sides = model_edges.measure(vertices, WIDTH, HEIGHT)
        for edge in model_edges.side(vertices, sides.corners[0], sides.direction, *sides.box[1::2],
                                     False) if sides else ():
            points = texturing.along(edge)
            steps = [b - a for a, b in zip(points[0], points[min(1, len(points) - 1)])]
            memory = Memory()
            at = vertex_block(memory, vertices)
            place = edge_block(memory, at, vertices, edge)
            wanted = dict(zip(("u", "v", "du", "dv"), (*points[0][1:], *steps[1:])))
            title = f"lines {edge.top} to {edge.end}: {described(vertices)}"
            found.append(Trial(Case("texturing_along", memory, {}, {"a0": place}), title,
                               writes=fields(place, "edge", wanted)))
            for mapper in ("affine", "columns"):
                settings = replace(CHEAP, mapper=mapper)
                t = texturing.longest(vertices, sides.corners, sides.box, settings)
                starts = texturing.edge_starts(t, edge, settings)
                later = starts[min(1, len(starts) - 1)]
                memory = Memory()
                at = vertex_block(memory, vertices)
                place = edge_block(memory, at, vertices, edge)
                plane = memory.struct("texturing", {}, **{
                    name: signed(int(getattr(t, name)))
                    for name in layout.load().struct("texturing").fields if name not in ("u", "v")}, u=0, v=0)
                wanted = {"u": starts[0][0], "v": starts[0][1],
                          "du": later[0] - starts[0][0], "dv": later[1] - starts[0][1]}
                found.append(Trial(
                    Case("texturing_edges", memory, {"d0": 1, "d1": sides.box[2] - sides.box[0]},
                         {"a0": plane, "a1": place}), f"{mapper}, {title}",
                    writes=fields(place, "edge", wanted)))
    return found


def shade_trials(rng) -> list[Trial]:
    found = []
    for count in (1, 3, 3, 3, 4, 7, 64):
        for mask in (M32, 0xFFFF0000):
            vertices = rng.integers(-16384 * ONE, 16384 * ONE, (count, 4)).tolist()
            shades = [int(n) for n in rng.integers(0, rng.choice((2, 255 * ONE)), count)]
            memory, shape = Memory(), layout.load().struct("vertex")
            at = memory.add(b"".join(shape.pack(**dict(zip("xyst", v)), shade=shade, w=7)
                                     for v, shade in zip(vertices, shades)), name="vertices", shape=shape)
            out = memory.room("vertex", count)
            low, high = (min(shades) & ~0xFFFF) + INSET, (max(shades) | 0xFFFF) - INSET
            writes = [write for k, (v, shade) in enumerate(zip(vertices, shades)) for write in fields(
                vertex_at(out, k), "vertex",
                {"x": v[0] & mask, "y": v[1] & mask, "s": min(max(shade, low), high), "t": 0})]
            found.append(Trial(Case("shade_vertices", memory, {"d0": count, "d1": mask},
                                    {"a0": out, "a1": at}), values(count=count, mask=mask), writes=writes))
    return found


def trials() -> list[Trial]:
    makers = (sides_three_trials, edges_three_trials, gentle_trials, polygon_find_trials,
              plane_find_trials, longest_trials, along_trials, shade_trials)
    return [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng([9, seed]))]
