"""Trials of chunky to planar: random pixels, decoded again by tools/tmap/base/planar.py."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base import planar
from tmap.bench import screen
from tmap.bench.trial import Trial
from tmap.guest.kernels import Case

IN_C = [f"{name}_c" for name in planar.FORMS if "_blit" not in name] + ["ham8_control"]
GROUPS = (1, 2, 3, 10, 11, 40)  # of 32 dots in a row
ROWS = (1, 2, 5)
FAR_APART = 0x2404  # bytes: four planes are more than 16 bits with a sign


def layouts(row: int, rows: int) -> list[tuple[int, int]]:
    """Bytes from row to row and from plane to plane: planes one behind the other, row by row by
    turns, either with gaps, upside down, planes in falling order, and far apart."""
    return [(row, row * rows), (8 * row, row), (row + 8, (row + 8) * rows + 12),
            (8 * (row + 4) + 16, row + 4), (-row, row * rows), (-8 * row, row),
            (row + 4, -(row + 4) * rows), (row, FAR_APART)]


def frame_trial(kernel: str, groups: int, rows: int, layout: tuple[int, int], pitches: int,
                seed: int) -> Trial:
    """A frame of noise; ``pitches`` 0: rows without gaps, 1: with some, 2: upside down."""
    name = kernel.removesuffix("_c")
    form, rng = planar.FORMS[name], np.random.default_rng(seed)
    near, far = Memory(seed), Memory(seed + 1)
    planes = planar.Planes(32 * groups, rows, *layout, form.planes)
    pixels = planar.noise(name, rng, 32 * groups // form.dots, rows)
    row = pixels[0].nbytes
    return screen.frame_trial(
        kernel, pixels, (row, row + 24, -row - 8)[pitches], planes, near, far,
        rng.bytes(planes.size), f"{pixels.shape[1]} x {rows} pixels, row pitch {layout[0]}, "
        f"plane pitch {layout[1]}, pixels' pitch {pitches}, seed {seed}")


def control_trial(groups: int, rows: int, layout: tuple[int, int], seed: int) -> Trial:
    """The planes of HAM8 that say which colour a dot changes."""
    near, far = Memory(seed), Memory(seed + 1)
    planes = planar.Planes(32 * groups, rows, *layout, planar.CONTROL)
    out = far.add(near.noise.randbytes(planes.size))
    plan = near.struct("planar_plan", {"pixels": 0}, {"planes": out + planes.first}, pitch=0,
                       width=8 * groups, rows=rows, row_pitch=layout[0], plane_pitch=layout[1])
    dots = np.tile(planar.ham8_control(planes.width), (rows, 1))
    return Trial(Case("ham8_control", near, pointers={"a0": plan}, far=far),
                 f"{planes.width} x {rows} dots, row pitch {layout[0]}, plane pitch {layout[1]}",
                 writes=screen.writes_of(planes, dots, out), where=screen.where_of(planes, out))


def box_trials() -> list[Trial]:
    """Rows up to two rounds of the loop, and one that is a frame; with and without bytes between rows."""
    made = []
    for seed, longwords in enumerate((*range(1, 70), 128, 4096)):
        rows = 1 + seed % 4
        apart = (0, 4, 40)[seed % 3]
        made.append(screen.box_trial(longwords, rows, apart, 0x01020304 * (1 + seed % 60), Memory(seed),
                                     f"{longwords} longwords in {rows} rows, {apart} bytes apart"))
    return made


def trials() -> list[Trial]:
    made, shapes = [], [(groups, rows) for groups in GROUPS for rows in ROWS]
    for k, (groups, rows) in enumerate(shapes):
        for n, layout in enumerate(layouts(4 * groups, rows)):
            seed = 100 * k + n
            in_c = IN_C[:-1] if n == k % 8 else []  # slow, and plain
            made += [frame_trial(kernel, groups, rows, layout, seed % 3, seed)
                     for kernel in [*planar.FORMS, *in_c]]
            made.append(control_trial(groups, rows, layout, seed))
    return made + box_trials()
