"""Calls of the way to the screen: a frame to its planes.

Rows that end in ``_low``, ``_high`` or ``_super`` are measured while eight planes are displayed, 256
lines of 320, 640 or 1280 dots a field, which takes chip RAM's time: what a frame costs that is
shown. They last some fields from a field's first line on, so that displayed lines and others are
in their share but for the last field's.
"""

import numpy as np

from tmap.base import planar
from tmap.bench.trial import Trial, Write
from tmap.guest.kernels import Arena, Case, Result

#: Pixels: HAM8's are four dots wide each, of 640 in a row.
SCREENS = {"c2p_8": (320, 256), "c2p_8_2x1": (160, 256), "c2p_8_blit": (320, 256), "c2p_8_blits": (320, 256),
           "c2p_8_2x1_blit": (160, 256), "c2p_8_2x1_blits": (160, 256),
           "c2p_ham8_16": (160, 256), "c2p_ham8_5551": (160, 256),
           "c2p_ham8_32": (160, 256)}
ROWS_IN_C = 16
#: What is displayed while it is converted, by the end of a row's name.
SHOWN = {"": "OFF", "_low": "LOW", "_high": "HIGH", "_super": "SUPER"}
NAMES = [name + end for name in SCREENS
         for end in ("", *(() if "_blit" in name else ("_c",)), *(("_low",) if name.startswith("c2p_8") else ("_high", "_super")))]

#: Pixels of a row and rows of the box that box_fill's bench row fills.
BOX = 256, 16


def routine_of(row: str) -> str:
    """The assembly routine that a row is of, or is the yardstick of."""
    return next(name for name in sorted(SCREENS, key=len, reverse=True) if row.startswith(name))


def frame(pixels: np.ndarray, pitch: int, padding: bytes) -> tuple[bytearray, int]:
    """Rows of pixels in memory, ``padding`` between them, and where the first one is."""
    lines = np.arange(len(pixels)) * pitch
    first, size = -int(lines.min()), int(np.ptp(lines)) + pixels[0].nbytes
    content = bytearray((padding * size)[:size])
    for row, at in zip(pixels, lines):
        content[first + at:first + at + row.nbytes] = row.tobytes()
    return content, first


def where_of(planes: planar.Planes, out: int):
    """Names a byte of the planes' block."""
    offsets = planes.offsets

    def where(offset: int, far: bool) -> str | None:
        for plane, y, byte in np.argwhere(offsets == offset - out) if far else ():
            return f"plane {planes.numbers[plane]}, row {y}, dots {8 * byte} to {8 * byte + 7}"
        return None

    return where


def writes_of(planes: planar.Planes, dots: np.ndarray, out: int) -> list[Write]:
    """What the planes' rows must be; the bytes between them stay."""
    return [Write(out + int(at[0]), row.tobytes(), far=True)
            for rows, plane in zip(planes.offsets, planes.encoded(dots))
            for at, row in zip(rows, plane)]


def frame_trial(kernel: str, pixels: np.ndarray, pitch: int, planes: planar.Planes, arena: Arena,
                far: Arena, before: bytes, title: str = "") -> Trial:
    """A frame in the near arena to planes in the far one, whose block holds ``before``."""
    content, first = frame(pixels, pitch, b"\xa5")
    at, out = arena.add(content, 8), far.add(before)
    plan = arena.struct(
        "planar_plan", {"pixels": at + first}, {"planes": out + planes.first}, pitch=pitch,
        width=pixels.shape[1], rows=planes.rows, row_pitch=planes.row_pitch,
        plane_pitch=planes.plane_pitch)
    dots = planar.FORMS[kernel.removesuffix("_c")].convert(pixels)

    def decoded(result: Result) -> str | None:
        block = np.frombuffer(result.far_memory, np.uint8, planes.size, out)
        return planar.difference(dots, planes.decoded(block))

    return Trial(Case(kernel, arena, pointers={"a0": plan}, far=far), title,
                 writes=writes_of(planes, dots, out), where=where_of(planes, out), also=decoded)


def screen_case(row_name: str):
    """A screen of noise, the maps' (a plan has it once), in one call; planes follow each other."""
    name = routine_of(row_name)
    in_c = row_name == f"{name}_c"
    form, (width, rows) = planar.FORMS[name], SCREENS[name]
    rows = ROWS_IN_C if in_c else rows
    pixels = planar.noise(name, np.random.default_rng(256), width, rows)
    row = form.dots * width // 8
    planes = planar.Planes(8 * row, rows, row, row * rows, form.planes)
    trial = frame_trial(f"{name}_c" if in_c else name, pixels, width * form.bytes, planes, Arena(),
                        Arena(), bytes(planes.size))
    trial.case.display = SHOWN["" if in_c else row_name.removeprefix(name)]
    return trial.row(width * rows)


def box_trial(longwords: int, rows: int, apart: int, pixels: int, arena: Arena, title: str = "") -> Trial:
    """A call of box_fill; ``apart``: bytes from a row's end to the next one."""
    pitch = 4 * longwords + apart
    at = arena.add(bytes(rows * pitch))
    plan = arena.struct("box_plan", {"first": at}, longwords=longwords, rows=rows, pitch=pitch, pixels=pixels)
    writes = [Write(at + row * pitch, pixels.to_bytes(4, "big") * longwords) for row in range(rows)]
    return Trial(Case("box_fill", arena, pointers={"a0": plan}), title, writes=writes)


def box_case():
    """A box in a frame of 320 pixels a row."""
    width, rows = BOX
    return box_trial(width // 4, rows, 320 - width, 0x05050505, Arena()).row(width * rows)
