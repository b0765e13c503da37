"""Calls of the mappers beside the affine one: Gouraud, arbitrary size, generated."""

import numpy as np

from tmap.base.fixed import ONE
from tmap.bench.spans import DU, DV, GAP, Ground, Line, framed, line_count, table_trial
from tmap.bench.trial import Trial
from tmap.guest.kernels import Arena
from tmap.setup.spans import generated_offsets, texel_generated

DS = 0xA000  # shades a pixel, 16.16
DU_ROW = 0x3000  # texels a pixel, of generated code: 1024 pixels stay in a row of the map
PICTURE = 331, 417  # rows and columns of the arbitrary map: at an odd address


def with_margins(picture: np.ndarray) -> bytes:
    """A page as generated code wants it, from 64 KB before it on: its halves once more around it."""
    page = picture.tobytes()
    return bytes(32768) + page[32768:] + page + page[:32768]


def code_of(dudx: int, dvdx: int, longest: int) -> bytes:
    """What is written for lines of up to ``longest`` pixels; nothing where none has any."""
    offsets = generated_offsets(dudx, dvdx, -(-max(0, longest) // 8) * 8)
    return b"".join(b"\x13\x2a" + int(o & 0xFFFF).to_bytes(2, "big") for o in offsets[::-1]) \
        + b"\x4e\xd3" * bool(len(offsets))


def mapper_trial(kernel: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
                 title: str = "", *, dudx: int, dvdx: int, **more) -> Trial:
    """One table of lines; those of the arbitrary map stay inside it."""
    picture = ground.picture

    def drawn(_: int, __: int, ___: int, count: int, u: int, v: int) -> np.ndarray:
        n = np.arange(count, dtype=np.int64)
        if "gouraud" in kernel:
            return ((u + n * dudx) >> 16 & 255).astype(np.uint8)
        if "arbitrary" in kernel:
            return picture[(v + n * dvdx) >> 16, (u + n * dudx) >> 16]
        return picture.reshape(-1)[texel_generated(u, v, dudx, dvdx, count) & 0xFFFF]

    if "generated" in kernel:
        more["code"] = code_of(dudx, dvdx, max(count for _, count, *_ in lines))
    return table_trial(kernel, "plain", lines, pitch, arena, ground, drawn, title, dudx=dudx,
                       dvdx=dvdx, **more)


def add_map(far: Arena, name: str, picture: np.ndarray) -> int:
    """Adds a map as a mapper wants it; where the mapper's pointer goes."""
    if "gouraud" in name:
        return 0  # there is none
    if name == "arbitrary":
        return far.add(b"\0" + picture.tobytes()) + 1
    return far.add(with_margins(picture), ONE) + ONE


def start_of(name: str, rng: np.random.Generator, steps: tuple[int, int], length: int) -> tuple[int, int]:
    """u and v of a line: shades that do not run over; all of it inside the arbitrary map, or inside a
    row of generated code's."""
    if "gouraud" in name:
        return int(rng.integers(0, 90 << 16)), 0
    if name == "arbitrary":
        travel = [step * (length - 1) for step in steps]
        return tuple(int(rng.integers(max(0, -t), (side << 16) - max(0, t)))
                     for t, side in zip(travel, PICTURE[::-1]))
    return int(rng.integers(0, (255 << 16) - steps[0] * length)), int(rng.integers(0, 256 << 16))


def mapper_case(name: str, length: int, dv: int = DV, lines: int = 0):
    """A table of spans of one length, as tmap.bench.spans.span_case; all have room for code."""
    rng, lines, far = np.random.default_rng(length), lines or line_count(length), Arena()
    rows, columns = PICTURE if name == "arbitrary" else (256, 256)
    picture = rng.integers(0, 256, (rows, columns), dtype=np.uint8)
    map_at = add_map(far, name, picture)
    steps = DS if "gouraud" in name else DU_ROW if name == "generated" else DU, dv
    starts = [(k % 4, length, *start_of(name, rng, steps, length)) for k in range(lines)]
    return mapper_trial(f"span_{name}", starts, length + GAP, Arena(),
                        framed(far, map_at, picture, lines, length), dudx=steps[0], dvdx=dv, code=b"",
                        map_width=columns, map_height=rows).row(lines * length)
