"""Trials of src68k/polygon: whole outlines with their planes, gentle ones too, the longest scanline,
Gouraud's vertices; against the model and exact fractions."""

from dataclasses import replace

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.edge import called_as
from tests.kernels.trials.polygon import (FAR, HEIGHT, WIDTH, box_block, described, exact_fields,
                                          polygons, rounded_fields, seen_polygons, sides_block,
                                          sides_numbers, sides_pointers, vertex_at, vertex_block,
                                          wanted_sides)
from tests.kernels.trials.texturing import plane_writes, steps_check
from tmap.base.fixed import M32, ONE, signed
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial, Write, anything, fields, values
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.model import model
from tmap.setup import edges as model_edges, texturing

#: Chains, and how the model knows each: by a mapper.
GENTLE = (("CHAIN_NONE", model.Settings(mapper="generated")),
          ("CHAIN_NONE", model.Settings(mapper="columns")),
          ("CHAIN_ANYWHERE", model.Settings(start="truncated")),
          ("CHAIN_PLANE", model.Settings()),
          ("CHAIN_WHOLE", model.Settings(mapper="generated")),
          ("CHAIN_SHADES", model.Settings(mapper="gouraud")))
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


def embed(memory: Memory, at: int, outer: str, field: str, struct: str, pointers: dict[str, int],
          **numbers: int) -> int:
    """Writes a struct that is a field of another one at ``at``; returns its place."""
    shape = layout.load().struct(struct)
    place = at + layout.load().struct(outer).fields[field]["offset"]
    memory.data[place:place + shape.size] = shape.pack(**numbers, **pointers)
    memory.pointers += [place + shape.fields[name]["offset"] for name in pointers]
    return place


def at_of(struct: str, field: str) -> int:
    return layout.load().struct(struct).fields[field]["offset"]


def setup_block(memory: Memory, vertices, at: int) -> tuple[int, dict[str, int]]:
    """struct setup as polygon_find takes it, and where its left and right edges are made."""
    room = {side: memory.room("edge", len(vertices), f"{side} edges") for side in ("left", "right")}
    frame = memory.struct("frame", {}, pixels=0, width=WIDTH, height=HEIGHT, pitch=WIDTH, pixel_bytes=1)
    setup = memory.room("setup")
    for name, value, points in (("frame", frame, True), ("vertices", at, True),
                                ("count", len(vertices), False)):
        place = setup + at_of("setup", name)
        memory.data[place:place + 4] = value.to_bytes(4, "big")
        if points:
            memory.pointers.append(place)
    embed(memory, setup, "setup", "edges", "edge_plan", room, lines=0, lefts=0, rights=0, dudx=0, dvdx=0)
    embed(memory, setup, "setup", "texturing", "texturing", {},
          **dict.fromkeys(layout.load().struct("texturing").fields, 0))
    return setup, room


def plane_of(vertices, sides: model_edges.Sides, edges: list[model.Edge], chain: str,
             settings: model.Settings) -> model.Texturing:
    """The model's plane, from the first pixel of the left edges."""
    first = edges[0].column(edges[0].top), edges[0].top
    t = texturing.plane(vertices, sides.corners, sides.box, settings, first)
    if chain == "CHAIN_SHADES":
        return replace(t, dvdx=0, dvdy=0, v=0)
    if chain == "CHAIN_WHOLE":
        inside = texturing.inside_vertices(vertices) if t.gentle else \
            texturing.inside_period(t.dvdx, t.dvdy, t.v, sides.box)
        return replace(t, wraps=not inside)
    return t


def start_writes(places: int, edges: list[model.Edge], t: model.Texturing) -> list[Write]:
    """What u, v and their steps of left edges on the plane become."""
    found = []
    for k, edge in enumerate(edges):
        u, v = texturing.on_plane(t, edge.column(edge.top), edge.top)
        found += fields(places + k * layout.load().struct("edge").size, "edge", {
            "u": u, "v": v, "du": t.dudy + edge.whole * t.dudx, "dv": t.dvdy + edge.whole * t.dvdx})
    return found


def left_edges(vertices, sides: model_edges.Sides, exact: bool) -> list[model.Edge]:
    return model_edges.side(vertices, sides.corners[0], sides.direction, *sides.box[1::2], exact)


def gentle_trial(vertices, chain: str, settings: model.Settings, exact: bool,
                 kernel: str = "texturing_gentle") -> Trial | None:
    """A polygon's plane and the starts of all its left edges; None where nothing of it is in the frame."""
    if chain == "CHAIN_SHADES":
        vertices = [(*v[:3], 0) for v in vertices]
    wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
    if sides is None:
        return None
    edges = left_edges(vertices, sides, exact)
    t = plane_of(vertices, sides, edges, chain, settings)
    memory = Memory()
    at = vertex_block(memory, vertices)
    setup, room = setup_block(memory, vertices, at)
    embed(memory, setup, "setup", "sides", "sides", sides_pointers(at, vertices, wanted),
          **sides_numbers(vertices, wanted), spare=[0] * 3, area=list(wanted[4].to_bytes(8, "big")))
    embed(memory, setup, "setup", "box", "rectangle", {},
          **dict(zip(("left", "top", "right", "bottom"), sides.box)))
    cuts = dict(zip(("u_cut", "v_cut"), texturing.CUT.get(settings.mapper, (0, 0))))
    out = embed(memory, setup, "setup", "texturing", "texturing", {},
                **dict.fromkeys(layout.load().struct("texturing").fields, 7) | cuts)
    place = setup + at_of("setup", "edges") + at_of("edge_plan", "lefts")
    memory.data[place:place + 4] = len(edges).to_bytes(4, "big")
    shape = layout.load().struct("edge")
    for k, edge in enumerate(edges):
        place = room["left"] + k * shape.size
        memory.data[place:place + shape.size] = shape.pack(**dict.fromkeys(shape.fields, 0) | {
            "x": edge.column(edge.top) + BIAS, "top": edge.top, "whole": edge.whole})
    number = layout.load().constants[chain]
    case = Case(kernel, memory, {"d1": number}, {"a6": setup}) if kernel == "texturing_gentle" \
        else Case(kernel, memory, {"d0": number}, {"a0": setup})
    trial = Trial(case, f"{chain}, {settings.mapper}, box {sides.box}: {described(vertices)}",
                  writes=plane_writes(out, t) + start_writes(room["left"], edges, t),
                  also=steps_check(out, t, [vertices[k] for k in sides.corners],
                                   "u" if chain == "CHAIN_SHADES" else "uv"))
    if kernel == "texturing_gentle":
        trial.outputs["d0"] = layout.load().constants["POLYGON_DRAWN"]
    return trial


def gentle_trials(rng) -> list[Trial]:
    """As those of texturing_plane, for all gradients."""
    made = seen_polygons(rng) + triangles(rng, 120)
    return [trial for k, p in enumerate(made) for each in GENTLE
            if (trial := gentle_trial(p, *each, bool(k & 1)))]


def plane_find_trials(rng) -> list[Trial]:
    return [trial for p in triangles(rng, 40)
            if (trial := gentle_trial(p, "CHAIN_PLANE", model.Settings(), True, "plane_find"))]


def outline_trial(kernel: str, vertices, exact: bool, has_plane: bool) -> Trial:
    """polygon_find, or its body."""
    wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
    memory = Memory()
    at = vertex_block(memory, vertices)
    setup, room = setup_block(memory, vertices, at)
    edge_size = layout.load().struct("edge").size
    constants = layout.load().constants
    chain = constants["CHAIN_PLANE"] if has_plane else -1
    case = Case(kernel, memory, {"d0": int(exact), "d1": chain & M32},
                {"a0" if kernel == "polygon_find" else "a6": setup})
    trial = Trial(case, f"exact {exact}, plane {has_plane}: {described(vertices)}")
    sides_at, plan = (setup + at_of("setup", name) for name in ("sides", "edges"))
    trial.writes += fields(setup, "setup", {}, {"outline_sides": sides_at})
    outside = any(not -FAR <= n < FAR for v in vertices for n in v)
    if outside or sides is None:
        trial.outputs["d0"] = constants["POLYGON_OUTSIDE_RANGE" if outside else "POLYGON_EMPTY"]
        trial.writes.append(anything(sides_at, layout.load().struct("sides").size))
        return trial
    trial.outputs["d0"] = constants["POLYGON_DRAWN"]
    numbers = sides_numbers(vertices, wanted)
    pointers = sides_pointers(at, vertices, wanted)
    if len(vertices) == 3:  # triangle_outline leaves these out
        del numbers["left_step"], pointers["first"], pointers["last"]
    trial.writes += fields(sides_at, "sides", numbers, pointers)
    trial.writes.append(Write(sides_at + at_of("sides", "area"), wanted[4].to_bytes(8, "big")))
    trial.writes += fields(setup + at_of("setup", "box"), "rectangle",
                           dict(zip(("left", "top", "right", "bottom"), sides.box)))
    counts = {}
    for side, way in (("left", 1), ("right", -1)):
        edges = model_edges.side(vertices, wanted[0], way * sides.direction, sides.box[1],
                                 sides.box[3], exact)
        counts[f"{side}s"] = len(edges)
        for k, edge in enumerate(edges):
            found = (exact_fields if exact else rounded_fields)(edge)
            trial.writes += fields(room[side] + k * edge_size, "edge",
                                   found | {"lines": edge.end - edge.top, "top": edge.top},
                                   {"upper": vertex_at(at, vertices.index(edge.upper)),
                                    "lower": vertex_at(at, vertices.index(edge.lower))})
    trial.writes += fields(plan, "edge_plan", counts)
    if has_plane:
        edges = left_edges(vertices, sides, exact)
        t = plane_of(vertices, sides, edges, "CHAIN_PLANE", model.Settings())
        trial.writes += plane_writes(setup + at_of("setup", "texturing"), t)
        trial.writes += start_writes(room["left"], edges, t)
    return trial


def beyond() -> list[list[tuple]]:
    """Triangles and a square with one coordinate just outside the range, or far outside."""
    made = []
    for count in (3, 4):
        for index in range(count):
            for field in range(4):
                for value in (FAR, -FAR - 1, 0x7FFFFFFF, -0x80000000):
                    corners = [[0, 0, 0, 0], [ONE, 0, 0, 0], [ONE, ONE, 0, 0], [0, ONE, 0, 0]][:count]
                    corners[index][field] = value
                    made.append([tuple(v) for v in corners])
    return made


def outline_trials(rng) -> list[Trial]:
    """Polygons in all orders of vertices, large and without area, in the frame and beyond."""
    made = [*seen_polygons(rng)[::4], *triangles(rng, 60), *polygons(rng)]
    made += [[*p[k:], *p[:k]][::way] for p in triangles(rng, 20) for k in range(3) for way in (1, -1)]
    made += beyond()
    trials = []
    for k, p in enumerate(made):
        kernel = ("polygon_find", "polygon_outline")[k & 1]
        trials.append(outline_trial(kernel, p, bool(k // 3 & 1), bool(k // 6 & 1)))
    return trials


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
    makers = (gentle_trials, outline_trials, plane_find_trials, longest_trials, along_trials, shade_trials)
    made = [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng([9, seed]))]
    for kernel, other in (("texturing_longest", "longest_find"), ("texturing_edges", "crossings_find")):
        made += called_as(other, [trial for trial in made if trial.case.kernel == kernel][::2])
    return made
