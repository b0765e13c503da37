"""Reference data of the N64's texture engine: its commands, and the program's operations."""

from collections.abc import Iterator
from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.build import layout
from tmap.vectors import vector_text
from tmap.vectors.vector_file import Operations
from tmap.vectors.vector_text import DECIMAL, HEX, Line, Shape, check_longs, check_range

NINE_BITS = 0x1FF
FOUR, FOUR_MASKS = (HEX,) * 4, (NINE_BITS,) * 4

#: Names in a ``mode`` line: field of struct n64_modes, bits.
MODE_FIELDS = {
    "persp_tex_en": ("perspective", 1), "detail_tex_en": ("detail", 1),
    "sharpen_tex_en": ("sharpen", 1), "tex_lod_en": ("lod", 1), "en_tlut": ("tlut", 1),
    "tlut_type": ("tlut_type", 1), "sample_type": ("quad", 1), "mid_texel": ("mid", 1),
    "bi_lerp0": ("filter0", 1), "bi_lerp1": ("filter1", 1), "convert_one": ("convert_one", 1),
    "cycle_type": ("cycle", 2)}

#: Fields of a ``tile`` line, with their bits.
TILE_BITS = {"n": 3, "fmt": 3, "siz": 2, "line": 9, "tmem": 9, "pal": 4, "cs": 1, "ms": 1,
             "masks": 4, "shs": 4, "ct": 1, "mt": 1, "maskt": 4, "sht": 4, "sl": 12, "tl": 12,
             "sh": 12, "th": 12}

SHAPES = {
    "tmemrand": Shape((DECIMAL,)),  # seed
    "tlutrand": Shape((DECIMAL,)),
    "rdramrand": Shape((DECIMAL,)),
    "tmem": Shape((HEX,), many=True),  # address, bytes
    "rdram": Shape((HEX,), many=True),
    "mode": Shape(names=tuple(MODE_FIELDS)),
    "tile": Shape((DECIMAL,) * len(TILE_BITS)),
    "convert": Shape((DECIMAL,) * 6),  # k0 .. k5
    "rdp": Shape((HEX, HEX), many=True),  # pairs of command words
    "tmemhash": Shape((), (HEX,), (M32,)),
    "fetch": Shape((DECIMAL,) * 3, FOUR, FOUR_MASKS),  # tile s t = r g b a
    "sample": Shape((DECIMAL,) * 4, FOUR, FOUR_MASKS),  # tile s t cycle = r g b a
    "sample2": Shape((DECIMAL,) * 4, FOUR * 2, FOUR_MASKS * 2),  # t0 t1 s t = both cycles'
    # s t w = raw_s raw_t s t
    "persp": Shape((DECIMAL,) * 3, (HEX, HEX, DECIMAL, DECIMAL), (None, None, M32, M32)),
    # s t w dsdx dtdx dwdx dsdy dtdy dwdy prim max_level min_level
    #     = s t tile0 tile1 lodfrac texel0 texel1
    "pix2": Shape((DECIMAL,) * 12, (DECIMAL,) * 4 + (HEX,) + FOUR * 2,
                  (M32,) * 4 + (NINE_BITS,) + FOUR_MASKS * 2),
    "copy": Shape((DECIMAL,) * 3, (HEX, HEX), (M32, M32)),  # tile s t = hi lo
}

#: The operation of each command, without the prefix VECTOR_.
OPERATIONS = {
    "tmemrand": "TMEM_RANDOM", "tlutrand": "TLUT_RANDOM", "rdramrand": "DRAM_RANDOM",
    "tmem": "TMEM", "rdram": "DRAM", "tile": "TILE", "convert": "CONVERT", "rdp": "WORDS",
    "tmemhash": "HASH", "fetch": "FETCH", "sample": "SAMPLE", "sample2": "SAMPLE_BOTH",
    "persp": "DIVIDE", "pix2": "PIXEL", "copy": "COPY"}


def read(path: str | Path) -> Iterator[Line]:
    """Reads the lines of a file."""
    return vector_text.read(path, SHAPES)


class N64Lines:
    """Adds the lines of a file. All answers must be exact."""

    SHAPES = SHAPES
    ALLOWED = {"exact": 0}

    def __init__(self, operations: Operations, path: Path) -> None:
        self.operations = operations
        operations.add("RESET")

    def kind(self) -> str:
        """Returns the only kind."""
        return "exact"

    def modes(self, pairs: tuple[tuple[str, int], ...], place: str) -> None:
        """Adds the operations of a line ``mode``."""
        fields = layout.load().struct("n64_modes").fields
        for name, value in pairs:
            field_name, bits = MODE_FIELDS[name]
            check_range([value], [(name, bits)], place)
            self.operations.add("MODE", fields[field_name]["offset"], value)

    def check_poke(self, line: Line, place: str) -> None:
        """Refuses a line ``tmem`` or ``rdram`` with values that are not bytes, or outside the
        memory."""
        size = self.operations.codes[
            "N64_TMEM_BYTES" if line.command == "tmem" else "VECTOR_DRAM_BYTES"]
        address, *values = line.arguments
        check_range(values, [("a byte", 8)] * len(values), place)
        if not 0 <= address <= address + len(values) <= size:
            raise UserError(f"{place}: {len(values)} bytes from {address:x} on are not within "
                            f"{size:x} bytes")

    def add(self, line: Line, place: str) -> None:
        """Adds the operations of one line."""
        if line.command == "mode":
            self.modes(line.arguments, place)
            return
        if line.command == "tile":
            check_range(line.arguments, TILE_BITS.items(), place)
        elif line.command in ("tmem", "rdram"):
            self.check_poke(line, place)
        check_longs(line.arguments, place)
        self.operations.add(OPERATIONS[line.command], *line.arguments)
