"""Calls of depth_fill and depth_copy: z of lines, and pixels by it."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.bench.spans import BIAS, table_of
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case

LENGTH, LINES = 64, 16
Lines = list[tuple[int, int]]  # of each line the first pixel and the last


@dataclass
class Slope:
    """q of a face, 32.32: at pixel ``left`` of the first line, and its growth a pixel and a line."""

    left: int
    at: int
    dx: int
    dy: int

    @property
    def step(self) -> int:
        """Growth a pixel, rounded to the nearest."""
        return self.dx + (1 << 31) >> 32

    def line(self, first: int, count: int, y: int) -> list[int]:
        """q of the pixels of a line."""
        start = self.at + (first - self.left) * self.dx + y * self.dy >> 32
        return [signed(start + k * self.step) for k in range(count)]

    def fields(self) -> dict:
        """The plan's fields."""
        whole = {name: list((getattr(self, name) % (1 << 64)).to_bytes(8, "big")) for name in ("at", "dx", "dy")}
        return whole | {"left": BIAS + self.left, "step": signed(self.step)}


def depth_trial(kernel: str, lines: Lines, bounds: Lines, slope: Slope, z: np.ndarray, arena: Arena,
                title: str = "") -> Trial:
    """One table. ``z``: q of the frame's pixels before, as many lines. Pixels aside have numbers, a third of them 0
    where 0 is transparent; the frame's are 0."""
    shape, (height, width) = layout.load().struct("scanline"), z.shape
    aside = (np.arange(z.size) % 255 + 1).astype(np.uint8).reshape(z.shape)
    if kernel == "depth_copy_keyed":
        aside[:, 2::3] = 0
    places = {name: arena.add(table_of([{"left": BIAS + a, "last": BIAS + b} for a, b in each]), name=name,
                              shape=shape) for name, each in (("lines", lines), ("bounds", bounds))}
    at = arena.add(z.astype(">i4").tobytes(), name="z")
    to, source = arena.add(bytes(z.size), name="frame"), arena.add(aside.tobytes(), name="aside")
    plan = arena.struct("depth_plan", places | {"row": at - 4 * BIAS, "from": source - BIAS, "to": to - BIAS},
                        count=height, pitch=4 * width, from_pitch=width, to_pitch=width, **slope.fields())
    writes = []
    for y, (line, bound) in enumerate(zip(lines, bounds)):
        left, last = max(line[0], bound[0]), min(line[1], bound[1])
        for x, q in enumerate(slope.line(left, last - left + 1, y), left):
            if kernel == "depth_fill" or q >= z[y, x] and aside[y, x]:
                place = y * width + x
                writes.append(Write(at + 4 * place, (q & M32).to_bytes(4, "big")))
                if kernel != "depth_fill":
                    writes.append(Write(to + place, aside[y, x:x + 1].tobytes()))
    return Trial(Case(kernel, arena, pointers={"a0": plan}), title, writes=writes)


def depth_case(kernel: str, before: int):
    """LINES lines of LENGTH pixels, all inside the bounds; ``before``: z of all of them."""
    slope = Slope(0, 1 << 60, 1000 << 32 | 5, 300 << 32 | 7)
    z = np.full((LINES, LENGTH), before)
    return depth_trial(kernel, [(0, LENGTH - 1)] * LINES, [(0, LENGTH - 1)] * LINES, slope, z,
                       Arena()).row(LINES * LENGTH)


CASES = {"depth_fill": lambda: depth_case("depth_fill", 0), "depth_copy": lambda: depth_case("depth_copy", 0),
         "depth_copy_hidden": lambda: depth_case("depth_copy", 1 << 30),
         "depth_copy_keyed": lambda: depth_case("depth_copy_keyed", 0)}
