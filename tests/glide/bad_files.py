"""Scene files with invalid texture units of Glide: file, offset, value, field."""

import numpy as np

from tests.helpers.wrong_fields import M32, Row, WrongFields
from tmap.build import layout
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene

LOCAL = 0x1 << 12 | 0x1 << 18 | 0x1 << 21 | 0x1 << 27  # colours are the texels


def scene() -> Scene:
    """A triangle of one unit, one of two units of which the second has separate coordinates, and a
    flat one."""
    vertices = np.full((12, 6), 65536)
    return Scene(8, 4, 1, 0, np.zeros((256, 3), np.uint8), [],
                 [Material("glide", unit=0), Material("glide", unit=1), Material()],
                 [Object(0, 0, 3, 0, 1, 0), Object(1, 3, 6, 0, 1, 0), Object(2, 9, 3, 0, 1, 0)],
                 vertices, np.array([IDENTITY]), "rgb565",
                 glide_units=np.array([[LOCAL | 10 << 8, 0, 0, 0, 0, 64, -1, 128, 4, 0, 8]] * 2),
                 pipes=np.array([[0, 1, 0, 0, 0], [0, 2, 2, 0, 1]]), glide_memory=bytes(256))


def wrong_pipes() -> list[Row]:
    """Returns rows with the name that the error must contain: the field, after the name of its
    struct."""
    rows: list[Row] = []
    wrong = WrongFields(scene(), rows)
    entry, memory = wrong.entry, "glide_memory or glide_memory_at"
    constants = layout.load().constants
    registers = "glide_unit.mode, lod, detail or base"
    wrong.header("glide_memory", 257, 1 << 20, M32, said=memory)
    wrong.header("glide_memory_at", 0, 2, len(wrong.data), M32 - 7, said=memory)
    entry("glide_units", 1, "mode", LOCAL | 6 << 8, LOCAL | 15 << 8, LOCAL | 6 << 14, LOCAL | 7 << 23,
          said=registers)
    entry("glide_units", 0, "lod", 1 << 23, M32, said=registers)
    entry("glide_units", 0, "detail", 1 << 17, M32, said=registers)
    entry("glide_units", 0, "base", 1 << 29, M32, said=registers)
    entry("glide_units", 0, "memory", 2, 196, 256, M32 - 3)
    entry("glide_units", 0, "bytes", 0, 4, 65)
    entry("glide_units", 0, "bytes", 512, 1 << 31, said="glide_unit.memory")
    entry("glide_units", 0, "palette", 0, 2, M32 - 1, 1 << 31)
    entry("glide_units", 0, "ncc", 164, 2, M32 - 1)
    entry("glide_units", 1, "fraction_bits", 0, 5, M32)
    entry("glide_units", 1, "dithered", 2, M32)
    entry("glide_units", 1, "subdivision", 1, 4, 32, M32)
    entry("pipes", 0, "glide_units", 0, 3, M32)
    entry("pipes", 1, "glide", 1, 2, M32, said="pipe.glide_units")
    entry("pipes", 0, "own", 1, 2)
    entry("pipes", 1, "own", 1, 3, M32)
    entry("pipes", 0, "adds", 2, M32)
    entry("materials", 0, "unit", 2, M32)
    entry("materials", 0, "mapper", constants["MAPPER_N64"], constants["MAPPER_KINDS"])
    entry("materials", 0, "primitive", 1)
    entry("materials", 0, "edges", 0)
    entry("objects", 1, "vertices", 3, 5)
    entry("vertices", 0, "w", 0, M32)
    entry("vertices", 5, "w", 0, M32)
    entry("vertices", 7, "w", 0, (1 << 30) + 1, 1 << 31)
    return rows
