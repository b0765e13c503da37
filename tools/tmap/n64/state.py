"""The state of a texture unit: TMEM, tiles, modes, combiner, colours."""

from dataclasses import dataclass, field

import numpy as np

from tmap.n64.misuse import Misuse

RGBA, YUV, CI, IA, I = range(5)
FORMATS = ("RGBA", "YUV", "CI", "IA", "I")
ONE_CYCLE, TWO_CYCLES, COPY, FILL = range(4)
TMEM_BYTES = 4096
TMEM_WORDS = 512  # of 64 bits
TILES = 8
REACH = 1024  # texels: the limit of vertices' s and t, and of the difference between two

#: The kinds of state that drawing leaves pending until a sync, in strict mode.
PENDING_LOAD, PENDING_TILE, PENDING_PIPE = 1, 2, 4
SYNC = {PENDING_LOAD: "load sync", PENDING_TILE: "tile sync", PENDING_PIPE: "pipe sync"}

#: (format, size) pairs that the manual allows.
LEGAL = frozenset([(RGBA, 2), (RGBA, 3), (YUV, 2), (CI, 0), (CI, 1), (IA, 0), (IA, 1), (IA, 2),
                   (I, 0), (I, 1)])


@dataclass
class Axis:
    """s or t of a tile. ``mask``: bits of the texel index kept, 0 none; ``shift``: 0..15;
    ``low``, ``high``: sl and sh, or tl and th, in 10.2 texels."""

    clamp: int = 0
    mirror: int = 0
    mask: int = 0
    shift: int = 0
    low: int = 0
    high: int = 0


@dataclass
class Tile:
    """A tile descriptor. ``size``: 0 to 3 for 4 to 32 bits per texel; ``line`` and ``tmem`` in
    64-bit words."""

    format: int = 0
    size: int = 0
    line: int = 0
    tmem: int = 0
    palette: int = 0
    s: Axis = field(default_factory=Axis)
    t: Axis = field(default_factory=Axis)


@dataclass
class Modes:
    """The texture modes of set other modes; each is 0 or 1 except ``cycle``."""

    cycle: int = ONE_CYCLE
    perspective: int = 0
    detail: int = 0
    sharpen: int = 0
    lod: int = 0
    tlut: int = 0
    tlut_type: int = 0  # 0 RGBA16, 1 IA16
    quad: int = 0
    mid: int = 0
    filter0: int = 0
    filter1: int = 0
    convert_one: int = 0


@dataclass(frozen=True)
class Inputs:
    """Codes of (A - B) * C + D, as in the set combine word."""

    a: int = 0
    b: int = 0
    c: int = 0
    d: int = 0


@dataclass
class Combine:
    """The combiner's inputs in cycle 0 and 1."""

    rgb: tuple[Inputs, Inputs] = (Inputs(), Inputs())
    alpha: tuple[Inputs, Inputs] = (Inputs(), Inputs())


@dataclass
class Image:
    """Set texture image: ``address`` in DRAM, ``width`` in texels."""

    address: int = 0
    format: int = 0
    size: int = 0
    width: int = 1


@dataclass
class State:
    """A texture unit.

    ``dram``: uint8 [bytes], indexed by image addresses. ``tmem``: uint8 [4096].
    ``k``: K0..K5, signed. Colours: (r, g, b, a), 0..255.
    ``checked``: forbidden uses raise Misuse; else they act as on the hardware.
    ``strict``: a change made without its sync raises Misuse.
    """

    dram: np.ndarray = field(default_factory=lambda: np.zeros(0, np.uint8))
    tmem: np.ndarray = field(default_factory=lambda: np.zeros(TMEM_BYTES, np.uint8))
    tiles: list[Tile] = field(default_factory=lambda: [Tile() for _ in range(TILES)])
    modes: Modes = field(default_factory=Modes)
    combine: Combine = field(default_factory=Combine)
    image: Image = field(default_factory=Image)
    k: list[int] = field(default_factory=lambda: [0] * 6)
    primitive: tuple[int, int, int, int] = (0, 0, 0, 0)
    environment: tuple[int, int, int, int] = (0, 0, 0, 0)
    primitive_fraction: int = 0
    min_level: int = 0
    max_level: int = 0
    primitive_tile: int = 0
    checked: bool = True
    strict: bool = False
    pending: int = 0

    def draws(self) -> None:
        """Notes that a primitive is drawn: the state that it reads must not change before a
        sync."""
        self.pending = PENDING_LOAD | PENDING_TILE | PENDING_PIPE

    def changes(self, what: int, name: str) -> None:
        """Notes that the command ``name`` changes state that a primitive may still read."""
        if self.strict and self.pending & what:
            raise Misuse("sync", f"{name} after a primitive, without a {SYNC[what]}")

    def synced(self, what: int) -> None:
        """Notes a sync: the kinds of state ``what`` may change again."""
        self.pending &= ~what

    def forbids(self, wrong: bool, name: str, text: str) -> None:
        """Raises a Misuse if the unit is checked and something is wrong."""
        if self.checked and wrong:
            raise Misuse(name, text)

    def check_tile(self, number: int) -> None:
        """Refuses a tile whose pair of format and size is not documented."""
        tile = self.tiles[number & 7]
        name = FORMATS[min(tile.format, I)]
        bits = 4 << tile.size
        if self.modes.tlut:
            self.forbids(tile.format == YUV or tile.size > 1, "tile format",
                         f"tile {number}: {name} of {bits} bits with a TLUT")
        else:
            self.forbids((tile.format, tile.size) not in LEGAL or tile.format == CI, "tile format",
                         f"tile {number}: {name} of {bits} bits without a TLUT")
