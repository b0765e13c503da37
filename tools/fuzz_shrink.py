"""Makes a failing polygon simpler as long as it fails: fewer vertices, rounder and smaller
numbers, plainer settings."""

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from .fixed import ONE
from .fuzz_depths import limits
from .fuzz_polygons import Fuzzed
from .scene_file import SETTINGS

ROUNDS = 60  # each takes a boot
#: Settings from plain to demanding; a shrunken polygon has the plainest that still fails.
PLAIN = {"clip": ("scissor", "vertices"), "start": ("subtexel", "truncated"),
         "gradients": ("plane", "polygon", "scanline"), "edges": ("exact", "subpixel", "integer"),
         "perspective": SETTINGS["perspective"]}
SIMPLEST = (0, 0, 0, 0, 0, ONE)  # vertex
FaultT = TypeVar("FaultT")


def away(vertices) -> list[tuple[int, ...]]:
    """How far vertices are from the simplest."""
    return [tuple(c - rest for c, rest in zip(v, SIMPLEST)) for v in vertices]


def there(vertices) -> tuple[tuple[int, ...], ...]:
    """The vertices so far away, with a depth that the format takes."""
    least, most = limits()
    return tuple((*v[:5], min(max(v[5] + ONE, least), most)) for v in vertices)


def weight(each: Fuzzed) -> tuple:
    """Smaller is simpler: vertices, settings, bits and size of the numbers."""
    numbers = [c for v in away(each.vertices) for c in v]
    bits = sum(bin(abs(c)).count("1") for c in numbers)
    settings = sum(choices.index(getattr(each.settings, kind)) for kind, choices in PLAIN.items())
    return len(each.vertices), settings, bits + sum(abs(c).bit_length() for c in numbers), numbers


def simpler(c: int) -> list[int]:
    """Numbers like c, but simpler."""
    made = [0, c // 2] + [(c + (1 << bits - 1)) >> bits << bits for bits in (16, 15, 12, 8, 4)]
    return [m for m in dict.fromkeys(made) if m != c]


def candidates(each: Fuzzed) -> list[Fuzzed]:
    """Simpler polygons, the simplest first."""
    v, made = each.vertices, []
    if len(v) > 3:
        made += [replace(each, vertices=v[:k] + v[k + 1:]) for k in range(len(v))]
    for kind, choices in PLAIN.items():
        at = choices.index(getattr(each.settings, kind))
        made += [replace(each, settings=replace(each.settings, **{kind: c})) for c in choices[:at]]
    v = away(v)
    for column in range(6):  # all vertices at once
        changed = [simpler(vertex[column]) + [vertex[column]] * 9 for vertex in v]
        for choice in range(7):
            made.append(replace(each, vertices=there(
                (*vertex[:column], options[choice], *vertex[column + 1:])
                for vertex, options in zip(v, changed))))
        low = min(vertex[column] for vertex in v) // ONE * ONE
        made.append(replace(each, vertices=there(
            (*vertex[:column], vertex[column] - low, *vertex[column + 1:]) for vertex in v)))
    for k, vertex in enumerate(v):
        for column in range(6):
            for c in simpler(vertex[column]) + [w[column] for w in v]:
                moved = (*vertex[:column], c, *vertex[column + 1:])
                made.append(replace(each, vertices=there((*v[:k], moved, *v[k + 1:]))))
    made = [m for m in dict.fromkeys(made) if weight(m) < weight(each)]
    return sorted(made, key=weight)


def shrink(each: Fuzzed, fault: FaultT,
           failing: Callable[[list[Fuzzed]], dict[int, FaultT]]) -> tuple[Fuzzed, FaultT]:
    """The simplest failing polygon found, and its fault. ``failing`` tells which of some
    candidates fail, by index."""
    for _ in range(ROUNDS):
        tried = candidates(each)
        found = failing(tried) if tried else {}
        if not found:
            break
        best = min(found)
        each, fault = tried[best], found[best]
    return each, fault
