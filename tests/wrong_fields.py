"""Scene files in which one field cannot be, as test_guest_input writes them."""

from tools import layout, scene_file
from tools.scene_file import Scene

#: File, place, value, field.
Row = tuple[bytes, int, int, str]


class WrongFields:
    """Values that a scene's fields cannot have, each a row added to ``rows``."""

    def __init__(self, scene: Scene, rows: list[Row]) -> None:
        self.shapes, self.data, self.rows = layout.load(), scene_file.write(scene), rows

    def entry(self, table: str, index: int, field: str, *values: int, said: str = "") -> None:
        """One row of a table: named by its struct and the field, if ``said`` gives no other name."""
        struct = self.shapes.struct(scene_file.TABLES[table])
        at = self.shapes.struct("scene_header").unpack(self.data)[f"{table}_at"]
        at += index * struct.size + struct.fields[field]["offset"]
        name = said or f"{struct.name.removeprefix('scene_')}.{field}"
        self.rows.extend((self.data, at, value, name) for value in values)

    def header(self, field: str, *values: int, said: str = "") -> None:
        at = self.shapes.struct("scene_header").fields[field]["offset"]
        self.rows.extend((self.data, at, value, said or field) for value in values)
