"""Files with one invalid field, for test_guest_input, which gives them to the guest."""

import zlib

from tmap.build import layout
from tmap.guest import kernels
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Scene

SHAPES = layout.load()
M32 = 0xFFFFFFFF
#: File, offset, value, field.
Row = tuple[bytes, int, int, str]


def changed(data: bytes, at: int, value: int, header: str, summed: str) -> bytes:
    """Returns the file with one longword replaced; the checksum is updated if it covers that
    place."""
    fields = SHAPES.struct(header).fields
    start, place = fields[summed]["offset"], fields["checksum"]["offset"]
    out = bytearray(data[:at] + (value & M32).to_bytes(4, "big") + data[at + 4:])
    if at >= start:
        total = kernels.checksum if header == "plan_header" else zlib.crc32
        out[place:place + 4] = total(out[start:]).to_bytes(4, "big")
    return bytes(out)


def lengths(header: str, data: bytes) -> list[int]:
    """The lengths to which a file is truncated: within its header and behind it."""
    return [3, SHAPES.struct(header).size - 1, SHAPES.struct(header).size, len(data) // 2,
            len(data) - 1]


class WrongFields:
    """Adds files with invalid values of a scene's fields to ``rows``."""

    def __init__(self, scene: Scene, rows: list[Row]) -> None:
        self.data, self.rows = scene_file.write(scene), rows

    def entry(self, table: str, index: int, field: str, *values: int, said: str = "") -> None:
        """Adds invalid values for one row of a table; the name is struct.field unless ``said`` is
        given."""
        struct = SHAPES.struct(scene_file.TABLES[table])
        at = SHAPES.struct("scene_header").unpack(self.data)[f"{table}_at"]
        at += index * struct.size + struct.fields[field]["offset"]
        name = said or f"{struct.name.removeprefix('scene_')}.{field}"
        self.rows.extend((self.data, at, value, name) for value in values)

    def header(self, field: str, *values: int, said: str = "") -> None:
        at = SHAPES.struct("scene_header").fields[field]["offset"]
        self.rows.extend((self.data, at, value, said or field) for value in values)
