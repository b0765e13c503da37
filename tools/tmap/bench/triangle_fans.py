"""Calls of the routines that make a batch from polygons: triangle_vertices, triangle_fans."""

import functools
import random
from dataclasses import dataclass

from tmap.base.fixed import M32, ONE
from tmap.bench.examples.example import longs
from tmap.bench.trial import Trial, Write, anything, fields, long_write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import snapped

COUNT = 32  # of a row
#: Mappers and the names of their values; lit has one level a polygon.
VALUES = {"flat": "VALUES_NONE", "gouraud": "VALUES_SHADES", "affine": "VALUES_TEXELS",
          "lit": "VALUES_LEVEL", "lit_gouraud": "VALUES_LEVELS"}
#: Bits of a shade that make a level.
LEVEL_BITS = 18


@dataclass
class Made:
    """What polygons become: their mapper, the largest x and y in 1/16 pixel, the map's scale or 0 for 1."""

    mapper: str
    right: int = 320 * 16
    bottom: int = 256 * 16
    scale: int = 0

    def values(self, vertex) -> tuple[int, ...] | None:
        """The values of a vertex by offsets of struct snapped_vertex; None: out of range."""
        _, _, s, t, shade = vertex[:5]
        keys = snapped.VALUES[self.mapper]
        if keys == 1:
            low = shade & ~0xFFFF
            return (min(max(shade, low + snapped.INSET), low + 0xFFFF - snapped.INSET) + snapped.RAISED << 4,)
        texels = [value * self.scale + 0x8000 >> 16 if self.scale else value for value in (s, t)][:keys]
        if any(not -snapped.TEXELS << 16 <= value < snapped.TEXELS << 16 for value in texels):
            return None
        found = tuple(value + snapped.RAISED << 4 for value in texels)
        if self.mapper in ("lit", "lit_gouraud"):
            level, low = shade >> 2, shade >> 2 & ~0xFFFF
            found += min(max(level, low + snapped.INSET), low + 0xFFFF - snapped.INSET) << 4,
        return found

    def record(self, vertex) -> tuple[int, ...] | None:
        """x and y, and the values."""
        x, y = (snapped.snap(c) for c in vertex[:2])
        found = self.values(vertex) if 0 <= x <= self.right and 0 <= y <= self.bottom else None
        return found if found is None else (x + 16 << 16 | y + 15, *found)

    def is_beyond(self, vertices) -> bool:
        """Returns true if a polygon is wholly beyond one side of the frame, and not too far away."""
        far = 16384 * ONE
        return all(-far <= c < far for v in vertices for c in v[:4]) and (
            max(v[0] for v in vertices) < -ONE or min(v[0] for v in vertices) >= (self.right // 16 + 1) * ONE
            or max(v[1] for v in vertices) < -ONE or min(v[1] for v in vertices) >= self.bottom // 16 * ONE)

    def is_odd(self, vertices) -> bool:
        """Returns true if a cheaper kind may draw a polygon."""
        levels = [v[4] >> LEVEL_BITS for v in vertices]
        if self.mapper == "affine":
            made = [(self.record(v)[0] & 0xFFFF, *self.values(v)) for v in vertices]
            return any(a[0] == b[0] and (a[1] == b[1] or a[2] == b[2])
                       for a, b in zip(made, made[1:] + made[:1]))
        return {"gouraud": len({v[4] >> 16 for v in vertices}) == 1, "lit": levels[0] in (0, 63),
                "lit_gouraud": len(set(levels)) == 1}.get(self.mapper, False)

    def plan(self, **more: int) -> dict[str, int]:
        """Fields that both plans have."""
        return {"right": self.right, "bottom": self.bottom, "scale": self.scale,
                "values": layout.load().constants[VALUES[self.mapper]]} | more


def writes_of(made: tuple[int, ...], at: int) -> Write:
    """A vertex that is written."""
    return Write(at, longs(made))


def add_vertices(arena: Arena, vertices) -> int:
    """Puts structs vertex into an arena."""
    return arena.add(b"".join(longs((*v, 0)) for v in vertices), name="vertices")


def vertices_trial(arena: Arena, made: Made, vertices: list, title: str = "") -> Trial:
    """Vertices, some of them out of range. ``vertices``: x, y, s, t, shade."""
    size = layout.load().struct("snapped_vertex").size
    to = arena.room("snapped_vertex", len(vertices), "to") if vertices else 0
    plan = arena.struct("vertices_plan", {"from": add_vertices(arena, vertices), "to": to},
                        count=len(vertices), **made.plan())
    writes = []
    for k, vertex in enumerate(vertices):
        record, at = made.record(vertex), to + size * k
        writes += [long_write(at, -1), anything(at + 4, 12)] if record is None else [writes_of(record, at)]
    return Trial(Case("triangle_vertices", arena, pointers={"a0": plan}), title, writes=writes)


def fans_trial(arena: Arena, made: Made, polygons: list, title: str = "", judged: int = 0,
               skips: int = 0) -> Trial:
    """Polygons up to one that is not taken. ``polygons``: lists of x, y, s, t, shade."""
    known = layout.load()
    size, polygon_size = (known.struct(name).size for name in ("snapped_vertex", "polygon"))
    places = [add_vertices(arena, vertices) for vertices in polygons]
    first = arena.add(b"".join(longs((at, 0, len(vertices), 0)) for at, vertices in zip(places, polygons)),
                      name="polygons")
    arena.pointers += [first + polygon_size * k for k in range(len(polygons))]
    to = arena.room("snapped_vertex", snapped.CORNERS * (len(polygons) + 1), "to")
    listed = arena.room("triangle", 2 * len(polygons) + 2, "list")
    plan = arena.struct("fans_plan", {"vertices": to, "from": first, "list": listed,
                                      "end": first + polygon_size * len(polygons)},
                        **made.plan(judged=judged, skips=skips, beyond_x=(made.right // 16 + 1) * ONE,
                                    beyond_y=made.bottom // 16 * ONE, is_odd=7, free=0, last=0))
    writes, at, last, taken, odd = [], to, listed, 0, 0
    for vertices in polygons:
        records = [made.record(v) for v in vertices] if len(vertices) in (3, 4) else [None]
        ys = [snapped.snap(v[1]) for v in vertices]
        if skips and None in records and made.is_beyond(vertices):
            taken += 1
            writes.append(anything(at, size * snapped.CORNERS))
            continue
        if None in records or max(ys) - min(ys) >= 16 * snapped.LINES:
            writes.append(anything(at, size * snapped.CORNERS))
            break
        writes += [writes_of(record, at + size * k) for k, record in enumerate(records)]
        if judged or made.is_odd(vertices):
            odd = 1
            break
        for k in range(2, len(records)):
            writes += [Write(last + 4 * n, longs((at + size * which,)), pointer=True)
                       for n, which in enumerate((0, k - 1, k))]
            last += 12
        at += size * len(records)
        taken += 1
    writes += fields(plan, "fans_plan", {"is_odd": odd}, {"free": at, "last": last})
    return Trial(Case("triangle_fans", arena, pointers={"a0": plan}), title,
                 near_ends={"d0": first + polygon_size * taken}, writes=writes)


def corners(rng: random.Random, count: int) -> list[tuple[int, ...]]:
    """Vertices in range, none of them level, of different shades."""
    return [(rng.randrange(100 * ONE), (5 * k + 3) * ONE + rng.randrange(ONE), rng.randrange(256 * ONE),
             rng.randrange(256 * ONE), (8 + 16 * k) * ONE) for k in range(count)]


def vertices_case(mapper: str):
    """COUNT vertices in range."""
    rng = random.Random("vertices")
    return vertices_trial(Arena(), Made(mapper), sum((corners(rng, 4) for _ in range(COUNT // 4)), [])).row(COUNT)


def fans_case(mapper: str, count: int):
    """COUNT polygons that are taken."""
    rng = random.Random("fans")
    return fans_trial(Arena(), Made(mapper), [corners(rng, count) for _ in range(COUNT)]).row(COUNT)


#: Names of rows and what makes each: units, case and check.
CASES = {f"triangle_vertices_{mapper}": functools.partial(vertices_case, mapper) for mapper in VALUES} \
    | {f"triangle_fans_{mapper}": functools.partial(fans_case, mapper, 3) for mapper in VALUES} \
    | {"triangle_fans_quads": functools.partial(fans_case, "affine", 4)}
