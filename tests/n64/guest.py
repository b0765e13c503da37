"""Builds command words by hand, and sends operations to the guest's texture engine."""

from tests.helpers import vector_guest

RGBA, YUV, CI, IA, I = range(5)
BITS_4, BITS_8, BITS_16, BITS_32 = range(4)

LOAD_SYNC, PIPE_SYNC, TILE_SYNC, FULL_SYNC = ((0xE6000000 + (n << 24), 0) for n in range(4))

Words = tuple[int, int]


def image(format: int, size: int, width: int, address: int) -> Words:
    return 0xFD << 24 | format << 21 | size << 19 | width - 1, address


def tile(n: int, format: int, size: int, line: int = 0, tmem: int = 0, *, palette: int = 0,
         t: tuple[int, int, int, int] = (0, 0, 0, 0),
         s: tuple[int, int, int, int] = (0, 0, 0, 0)) -> Words:
    """Set tile; an axis is (clamp, mirror, mask, shift)."""
    axes = [axis[0] << 9 | axis[1] << 8 | axis[2] << 4 | axis[3] for axis in (t, s)]
    return (0xF5 << 24 | format << 21 | size << 19 | line << 9 | tmem,
            n << 24 | palette << 20 | axes[0] << 10 | axes[1])


def edges(op: int, n: int, sl: int, tl: int, sh: int, th: int) -> Words:
    """Set tile size (F2), load block (F3), load tile (F4), load TLUT (F0)."""
    return op << 24 | sl << 12 | tl, n << 24 | sh << 12 | th


def size(n: int, columns: int, rows: int) -> Words:
    """Set tile size from (0, 0) on."""
    return edges(0xF2, n, 0, 0, columns - 1 << 2, rows - 1 << 2)


def modes(**fields: int) -> Words:
    """Set other modes; filters are on by default."""
    places = {"cycle": 20, "perspective": 19, "detail": 18, "sharpen": 17, "lod": 16, "tlut": 15,
              "tlut_type": 14, "quad": 13, "mid": 12, "filter0": 11, "filter1": 10,
              "convert_one": 9}
    word = 0xEF << 24
    for name, value in ({"filter0": 1, "filter1": 1} | fields).items():
        word |= value << places[name]
    return word, 0


def texture(max_level: int, first: int) -> Words:
    """Set texture: highest level and first tile for drawing."""
    return 0xD7 << 24 | max_level << 11 | first << 8 | 2, 0xFFFFFFFF


#: A tile of RGBA 16 that wraps, as the fields after n in a vector line.
WRAPPED = (RGBA, BITS_16, 4, 0, 0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 60, 28)


class Guest(vector_guest.Guest):
    def words(self, *words: Words) -> int:
        """Runs a display list; its answer is (result, command)."""
        return self.ask("LIST", *(half for pair in words for half in pair), numbers=2)


#: Results by number, without N64_.
RESULTS = vector_guest.results("N64")
