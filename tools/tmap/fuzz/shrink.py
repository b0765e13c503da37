"""Makes a failing polygon simpler as long as it fails: fewer vertices, rounder and smaller
numbers, simpler settings."""

from collections.abc import Callable
from dataclasses import replace
from itertools import zip_longest
from typing import TypeVar

from tmap.base.fixed import ONE
from tmap.fuzz.depths import limits
from tmap.fuzz.polygons import Fuzzed
from tmap.scene_file.scene_file import SETTINGS

ROUNDS = 60  # each needs a boot
#: Settings from simple to demanding; a shrunken polygon has the simplest that still fail.
PLAIN = {"clip": ("scissor", "vertices"), "start": ("subtexel", "truncated"),
         "gradients": ("plane", "polygon", "scanline"), "edges": ("exact", "snapped", "subpixel", "integer"),
         "perspective": SETTINGS["perspective"]}
SIMPLEST = (0, 0, 0, 0, 0, ONE)  # vertex
FaultT = TypeVar("FaultT")


def away(vertices) -> list[tuple[int, ...]]:
    """Returns the differences of vertices from the simplest one."""
    return [tuple(c - rest for c, rest in zip(v, SIMPLEST)) for v in vertices]


def there(vertices) -> tuple[tuple[int, ...], ...]:
    """Returns the vertices with these differences, w clamped to the format's range."""
    least, most = limits()
    return tuple((*v[:5], min(max(v[5] + ONE, least), most)) for v in vertices)


def weight(each: Fuzzed) -> tuple:
    """Returns a sort key, smaller for simpler: vertices, settings, bits and size of the numbers."""
    numbers = [c for v in away(each.vertices) for c in v]
    bits = sum(abs(c).bit_count() for c in numbers)
    settings = sum(choices.index(getattr(each.settings, kind)) for kind, choices in PLAIN.items())
    return len(each.vertices), settings, bits + sum(abs(c).bit_length() for c in numbers), numbers


def simpler(c: int) -> list[int]:
    """Returns simpler numbers near c."""
    made = [0, c // 2] + [(c + (1 << bits - 1)) >> bits << bits for bits in (16, 15, 12, 8, 4)]
    return [m for m in dict.fromkeys(made) if m != c]


def candidates(each: Fuzzed) -> list[Fuzzed]:
    """Returns simpler polygons, the simplest first."""
    v, made = each.vertices, []
    if len(v) > 3:
        made += [replace(each, vertices=v[:k] + v[k + 1:]) for k in range(len(v))]
    for kind, choices in PLAIN.items():
        at = choices.index(getattr(each.settings, kind))
        made += [replace(each, settings=replace(each.settings, **{kind: c})) for c in choices[:at]]
    v = away(v)
    for column in range(6):
        own = [vertex[column] for vertex in v]
        low = min(own) // ONE * ONE
        changed = [[c - low for c in own]]  # all vertices at once
        changed += [[old if new is None else new for old, new in zip(own, some)]
                    for some in zip_longest(*map(simpler, own))]
        changed += [[*own[:k], c, *own[k + 1:]] for k in range(len(v)) for c in simpler(own[k]) + own]
        made += [replace(each, vertices=there((*a[:column], c, *a[column + 1:])
                                              for a, c in zip(v, values))) for values in changed]
    made = [m for m in dict.fromkeys(made) if weight(m) < weight(each)]
    return sorted(made, key=weight)


def shrink(each: Fuzzed, fault: FaultT,
           failing: Callable[[list[Fuzzed]], dict[int, FaultT]]) -> tuple[Fuzzed, FaultT]:
    """The simplest failing polygon, and its fault. ``failing``: faults of candidates, by index."""
    for _ in range(ROUNDS):
        tried = candidates(each)
        found = failing(tried) if tried else {}
        if not found:
            break
        best = min(found)
        each, fault = tried[best], found[best]
    return each, fault
