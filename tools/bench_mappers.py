"""Bench rows of the mappers beside the affine one: Gouraud, arbitrary size, generated."""

import numpy as np

from . import layout
from .kernels import Arena, Case, Result
from .model_spans import texel_generated
from .scanline import add_span_plan, pack

DU, DV, DS = 0x18000, 0x14000, 0xA000  # texels and shades a pixel, 16.16
PICTURE = 331, 417  # rows and columns of the arbitrary map: at an odd address


def first_difference(expected: np.ndarray, found: np.ndarray) -> str | None:
    """Where two pictures first differ, in words; None where they are equal."""
    wrong = np.argwhere(expected != found)
    if not len(wrong):
        return None
    y, x = wrong[0]
    return (f"{len(wrong)} pixels differ, the first at ({x}, {y}): "
            f"expected {expected[y, x]:#04x}, found {found[y, x]:#04x}")


def mapper_case(name: str, length: int, du: int = DU, dv: int = DV, lines: int = 0):
    """A table of spans of one length, as tools.bench_cases.span_case."""
    rng = np.random.default_rng(length)
    lines = lines or min(128, max(16, 2048 // length))
    pitch = length + 4  # bytes from line to line: each line begins 0 to 3 bytes on
    constants = layout.load().constants
    arena, far, n = Arena(), Arena(), np.arange(length)
    rows, columns = PICTURE if name == "arbitrary" else (256, 256)
    picture = rng.integers(0, 256, (rows, columns), dtype=np.uint8)
    if name == "generated":
        lying = np.concatenate([picture[128:], picture, picture[:128]]).tobytes()
        map_at = far.add(bytes(32768) + lying, 65536) + 65536
    elif "gouraud" in name:
        map_at = 0  # there is none
    else:
        map_at = far.add(b"\0" + picture.tobytes()) + 1
    entries = np.zeros(lines, layout.load().struct("scanline").dtype)
    expected = np.zeros((lines, pitch), np.uint8)
    for k in range(lines):
        if "gouraud" in name:
            u, v = int(rng.integers(0, 90 << 16)), 0
            drawn = (u + n * DS) >> 16
        elif name == "arbitrary":
            travel = [d * (length - 1) for d in (du, dv)]
            u, v = (int(rng.integers(max(0, -t), (side << 16) - max(0, t)))
                    for t, side in zip(travel, (columns, rows)))
            drawn = picture[(v + n * dv) >> 16, (u + n * du) >> 16]
        else:
            u, v = (int(x) for x in rng.integers(0, 256 << 16, 2))
            drawn = picture.reshape(-1)[texel_generated(u, v, du, dv, length) & 0xFFFF]
        for field, value in pack("plain", u, v).items():
            entries[k][field] = value
        entries[k]["left"] = constants["EDGE_BIAS"] + k % 4
        entries[k]["last"] = entries[k]["left"] + length - 1
        expected[k, k % 4:k % 4 + length] = drawn
    table_at = arena.add(entries.tobytes())
    code_at = arena.add(bytes(constants["CODE_BYTES"]))
    frame_at = far.add(bytes(pitch * lines))
    plan_at = add_span_plan(
        arena, dict(lines=table_at, code=code_at),
        dict(row=frame_at - constants["EDGE_BIAS"], map=map_at), count=lines, pitch=pitch,
        dudx=DS if "gouraud" in name else du, dvdx=dv, map_width=columns, map_height=rows)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, np.uint8, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return lines * length, Case(f"span_{name}", arena, pointers={"a0": plan_at}, far=far), check
