"""What memory a machine has free, and where a program's requests go in it.

exec gives a request the first free piece that is large enough, of fast RAM before chip RAM. ``Memory`` does
the same, with the walls that AROS, the emulated machines' system, puts around each block.

AROS begins to look at a piece that it has noted for the request's size, a power of two or more. It notes a piece when
a request leaves that, and forgets all pieces when a block at a certain address is taken, or when a request finds none.
So small requests behind a large one may miss pieces in front of it.
"""

from dataclasses import dataclass, field

#: Bytes around each block: the head that a program keeps its blocks by, src68k/amiga/memory.s, and AROS's walls.
HEAD = 8
WALL_BEFORE, WALL_BEHIND = 72, 32
#: Powers of two of bytes, for which AROS notes pieces.
POWERS = range(5, 15)
#: What c/scene/maps_read.c keeps free at the ends of a piece.
PIECE_ENDS = 128
#: Pieces from this size on are the same before every program. Smaller ones, which the system's start and the shell's
#: lines leave, are SPARE bytes together at most, 24,800 on a1200-030. What fits without them fits. What is refused
#: would have left less than SPARE bytes, and less than a page in each kind of memory, as pages at multiples of 65,536
#: may begin one multiple earlier where a small request went to a small piece.
LEAST, SPARE = 16 << 10, 25 << 10
#: The free pieces when a program is about to be loaded: first address and bytes, by machine and kind of memory.
#: tests/guest/test_memory.py holds them, and SPARE, to the list of exec on the emulated machine.
FREE = {
    "a1200": {"chip": [(271328, 1813432)]},
    "a1200-fast": {"fast": [(3001808, 7483952)], "chip": [(24352, 2060408)]},
    "a1200-030": {"fast": [(3018784, 7446424)], "chip": [(27424, 2057336)]},
}


@dataclass
class Memory:
    """Free pieces of memory, from which requests are taken."""

    pieces: dict[str, list[tuple[int, int]]]
    taken: dict[str, int] = field(default_factory=dict)  # bytes by kind
    noted: dict[str, dict[int, int]] = field(default_factory=dict)  # by kind: a size's power of two to an address

    @classmethod
    def of(cls, machine: str) -> "Memory":
        """Returns the memory of a machine when a program is about to be loaded."""
        return cls({kind: list(pieces) for kind, pieces in FREE[machine].items()})

    def free(self) -> dict[str, int]:
        """Returns the bytes that are free, by kind."""
        return {kind: sum(size for _, size in pieces) for kind, pieces in self.pieces.items()}

    def cut(self, kind: str, number: int, first: int, end: int) -> None:
        """Takes the bytes from ``first`` to ``end`` out of a piece."""
        at, size = self.pieces[kind][number]
        rest = [(at, first - at), (end, at + size - end)]
        self.pieces[kind][number:number + 1] = [piece for piece in rest if piece[1] > 0]
        self.taken[kind] = self.taken.get(kind, 0) + end - first

    def find(self, kind: str, size: int) -> int | None:
        """Returns the number of the piece that a request of ``size`` bytes gets; None if there is none."""
        pieces, noted = self.pieces.get(kind, []), self.noted.setdefault(kind, {})
        power = min(size.bit_length() - 1, POWERS[-1])
        first = noted[max(known)] if (known := [each for each in noted if each <= power]) else 0
        for number, (at, piece) in enumerate(pieces):
            if at >= first and piece >= size:
                return number
        if not noted:
            return None
        noted.clear()
        return self.find(kind, size)

    def note(self, kind: str, taken: list[int], left: tuple[int, int] | None) -> None:
        """Forgets the pieces that began at ``taken``; notes what is left of one, first address and bytes."""
        noted = {power: first for power, first in self.noted[kind].items() if first not in taken}
        at, size = left or (0, 0)
        self.noted[kind] = noted | {power: min(at, noted.get(power, at)) for power in POWERS if 1 << power <= size}

    def take(self, size: int, kinds: tuple[str, ...] = ("fast", "chip"), head: int = HEAD) -> bool:
        """Takes a block; returns False if no piece is large enough."""
        whole = -(-(size + head) // 8) * 8 + WALL_BEFORE + WALL_BEHIND
        for kind in kinds:
            number = self.find(kind, whole)
            if number is not None:
                (at, piece), *behind = self.pieces[kind][number:number + 2]
                self.cut(kind, number, at, at + whole)
                self.note(kind, [at, *(first for first, _ in behind)],
                          (at + whole, piece - whole) if piece > whole else None)
                return True
        return False

    def leave(self, size: int) -> None:
        """Takes the last bytes of the last piece of each kind."""
        for kind, pieces in self.pieces.items():
            at, last = pieces[-1]
            if last > size:
                self.cut(kind, len(pieces) - 1, at + last - size, at + last)

    def take_units(self, unit: int, count: int, kind: str) -> int:
        """Takes up to ``count`` units, each at a multiple of ``unit``, from the piece that has the most; returns how
        many: find_units in c/scene/maps_read.c."""
        best = (0, 0, 0)
        for number, (at, size) in enumerate(self.pieces.get(kind, [])):
            first = -(-(at + PIECE_ENDS) // unit) * unit
            units = max(at + size - PIECE_ENDS - first, 0) // unit
            if units > best[0] and best[0] < count:
                best = units, number, first
        units, number, first = min(best[0], count), *best[1:]
        if units:
            self.noted.pop(kind, None)
            self.cut(kind, number, first - HEAD - WALL_BEFORE, first + units * unit + WALL_BEHIND)
        return units
