"""Places the parts of a program and writes it as an AmigaDOS hunk file.

The 68020's instruction cache has 64 longwords, chosen by the address modulo 256. Timed code keeps
its address in the full renderer modulo 256, so that the same instructions evict each other from the
cache. Holes left by omitted code are filled with untimed parts, and with timed parts that are
separated from other timed code by as much as the processor fetches ahead.
"""

import copy
import random
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.build.elf_object import Section
from tmap.build.hunk import HUNK_BSS, HUNK_CODE, HUNK_DATA, HUNK_END, HUNK_HEADER, HUNK_RELOC32, longs
from tmap.product.program_parts import Part, Program

HUNK_RELOC32SHORT = 0x3FC  # dos 39, as on the A1200: offsets of 16 bits
CACHE = 256  # bytes
LAST = ".rodata.scene_data"  # with maps; addresses are only relocated before it
#: A section that stands for the table by which a program moves its code to its places, and the shortest hole that
#: the table names, bytes. Other programs' files contain their holes.
HOLES, HOLE = ".holes", 6
ISLAND = 1 << 16  # the most words that are moved together
#: jsr and jmp to an address become bsr and bra of the same length, which need no relocation.
BRANCHES = {bytes.fromhex("4eb9"): 0x61, bytes.fromhex("4ef9"): 0x60}
NOP = bytes.fromhex("4e71")
PROBES, BLOCK = 16, 256  # bytes of a part, and places for it, that are looked at together
AHEAD = 4  # bytes that are fetched after an instruction, at most


def fetched(live: np.ndarray, address: int) -> np.ndarray:
    """Returns bool: the bytes that are fetched when the ``live`` bytes at ``address`` are
    executed."""
    out = np.zeros(len(live) + AHEAD + 8, bool)
    for first in np.flatnonzero(live[::2]) * 2:
        place = (address + first & ~3) - (address & ~3)
        out[place:place + 4 + AHEAD] = True
    return out


def neighbours(parts: list[Part], places: dict[Section, int]) -> list[list[Part]]:
    """Returns groups of parts that are so close in the full renderer that the end of one makes the
    processor fetch the next; the largest group first."""
    groups: list[list[Part]] = []
    end = 0
    for part in sorted(parts, key=lambda p: places[p.section]):
        held = np.flatnonzero(part.live) + places[part.section]
        if groups and held[0] < (end & ~3) + 4 + AHEAD:
            groups[-1].append(part)
        else:
            groups.append([part])
        end = int(held[-1])
    return sorted(groups, key=lambda group: -sum(p.bytes for p in group))


def branch(jump: bytes, distance: int, timed: int) -> bytes | None:
    """Returns the branch that replaces a jump to an address, or None if the jump stays. ``jump``:
    its first two bytes; ``distance``: from the end of these to the target. Code that is timed once
    gets a 68020's branch, without a nop. Untimed code gets a 68000's branch, because the check for
    a 68020 runs on a 68000. Code that is timed more than once keeps its jumps and its time.
    """
    if jump not in BRANCHES or timed > 1:
        return None
    if timed:
        return bytes([BRANCHES[jump], 0xFF]) + (distance % (1 << 32)).to_bytes(4, "big")
    if not -1 << 15 <= distance < 1 << 15:
        return None
    return bytes([BRANCHES[jump], 0]) + (distance % (1 << 16)).to_bytes(2, "big") + NOP


def pieces(words: int) -> list[tuple[int, int]]:
    """Returns an island's words in parts that are moved together, each with how many words are left."""
    return [(words - first - ISLAND if first + ISLAND < words else 0, min(ISLAND, words - first))
            for first in range(0, words, ISLAND)]


def relocated(offsets: list[list[int]]) -> bytes:
    """Returns the hunk file's lists of addresses, by the hunk that they are in."""
    rows = [[len(some), hunk, *sorted(some)] for hunk, some in enumerate(offsets) if some]
    if not rows:
        return b""
    short = all(row[-1] < 1 << 16 for row in rows)
    table = np.array([*sum(rows, []), 0], ">u2" if short else ">u4").tobytes()
    return longs(HUNK_RELOC32SHORT if short else HUNK_RELOC32) + table + bytes(-len(table) % 4)


class Layout:
    """Addresses of a program's parts: code and tables in one hunk, cleared memory in another."""

    def __init__(self, program: Program, fixed: dict[Section, int], order: int = 0):
        """``fixed``: the sections whose places matter, with their addresses in the full renderer;
        ``order``: 0, or the number of another order in which they are placed, which leaves other
        holes. A whole program keeps the linker's order, in which relative addresses fit."""
        self.program = program
        self.at: dict[Section, int] = {}
        self.bss = 0
        parts = [p for p in program.parts.values() if not p.section.bss]
        room = 4 * sum(p.section.size + CACHE for p in parts) + CACHE
        self.used, self.near = np.zeros(room, bool), np.zeros(room, bool)
        self.full = self.top = 0  # there is no hole below the first address, and nothing from the second on
        entry = program.parts[program.entry]
        self.put([entry], [0], 0, CACHE)
        rest = [p for p in parts if p is not entry]
        self.put_fixed([p for p in rest if p.section in fixed], fixed, order)
        self.put_others([p for p in rest if p.section not in fixed])
        self.finish()

    def finish(self) -> None:
        """Places cleared memory, and sets the size."""
        self.put_cleared()
        self.size = int(np.flatnonzero(self.used)[-1]) + 1
        self.size += -self.size % 4

    def extended(self, program: Program) -> "Layout":
        """Returns the layout of a program that has this one's parts, each at its place, and more behind them."""
        more = copy.copy(self)
        more.program, more.at = program, dict(self.at)
        new = [p for p in program.parts.values() if p.section not in self.at and not p.section.bss]
        room = sum(p.section.size + CACHE for p in new)
        more.used = np.concatenate([self.used[:self.size], np.zeros(room, bool)])
        more.full = more.top = self.size
        more.put_others(new)
        more.finish()
        return more

    def put_fixed(self, parts: list[Part], fixed: dict[Section, int], order: int) -> None:
        """Places parts at their addresses in the full renderer modulo CACHE, neighbours
        together."""
        groups = neighbours(parts, fixed)
        if order:
            random.Random(order).shuffle(groups)
        for group in groups:
            first = fixed[group[0].section]
            self.put(group, [fixed[p.section] - first for p in group], first % CACHE, CACHE, True)

    def put_others(self, parts: list[Part]) -> None:
        """Places parts wherever there is room: the largest first or, in a whole program, in the
        linker's order. The scene is last."""
        linked = {section: n for n, section in enumerate(self.program.sections)}

        def rank(part: Part) -> tuple[bool, int]:
            is_last = part.section.name == LAST
            return is_last, -part.bytes if self.program.trace else linked.get(part.section, 0)

        for part in sorted(parts, key=rank):
            step = 2 if part.section.code and not part.timed else part.section.align
            self.put([part], [0], 0, step)

    def put_cleared(self) -> None:
        """Places cleared memory that has no place yet in its own hunk."""
        for part in self.program.parts.values():
            if part.section.name == HOLES:
                self.at[part.section] = 0
            elif part.section.bss and part.section not in self.at:
                self.bss += -self.bss % part.section.align
                self.at[part.section] = self.bss
                self.bss += part.section.size

    def holes(self, live: np.ndarray, places: range) -> Iterator[range]:
        """Yields those of the places, in order, where the longest run of ``live`` bytes finds room."""
        edges = np.flatnonzero(np.diff(live, prepend=False, append=False)).reshape(-1, 2)
        start, end = edges[np.argmax(edges[:, 1] - edges[:, 0])]
        used = self.used[self.full:self.top + 1]  # the first is free, and all from the last on
        changes = self.full + 1 + np.flatnonzero(used[1:] != used[:-1])
        first = np.maximum(np.r_[self.full, changes[1::2]] - start, places.start)
        first += (places.start - first) % places.step
        last = np.minimum(np.r_[changes[::2], len(self.used)] - end, places.stop - 1)
        some = first <= last
        for begin, stop in zip(first[some].tolist(), last[some].tolist()):
            yield range(begin, stop + 1, places.step)

    def free(self, live: np.ndarray, places: range) -> Iterator[int]:
        """Yields those of the places, in order, where some of the ``live`` bytes find room."""
        kept = np.flatnonzero(live)
        some = kept[np.linspace(0, len(kept) - 1, min(len(kept), PROBES)).astype(int)]
        for hole in self.holes(live, places):
            for begin in range(0, len(hole), BLOCK):
                block = np.array(hole[begin:begin + BLOCK])
                yield from block[~self.used[block[:, None] + some].any(axis=1)].tolist()

    def put(self, parts: list[Part], offsets: list[int], first: int, step: int,
            apart: bool = False) -> None:
        """Places parts at the lowest address first + n step with room for them.

        ``offsets``: of each part from that address; ``apart``: nothing that is fetched with them
        may be fetched with other parts placed apart.
        """
        live = np.zeros(offsets[-1] + parts[-1].section.size, bool)
        for part, offset in zip(parts, offsets):
            live[offset:offset + part.section.size] |= part.live
        near = fetched(live, first) if apart else None
        lead = int(np.argmax(live))  # bytes before the first kept one
        skip = max(0, self.full - lead - first + step - 1) // step * step
        for at in self.free(live, range(first + skip, len(self.used) - len(live) + 1, step)):
            if (self.used[at:at + len(live)] & live).any():
                continue
            begin = at & ~3
            if near is not None:
                if (self.near[begin:begin + len(near)] & near).any():
                    continue
                self.near[begin:begin + len(near)] |= near
            self.used[at:at + len(live)] |= live
            self.top = max(self.top, at + len(live))
            self.at |= {p.section: at + offset for p, offset in zip(parts, offsets)}
            self.full += int(np.argmin(self.used[self.full:]))
            return
        raise AssertionError("no room in four times the size")

    def link(self) -> tuple[bytes, list[int], list[int], list[int]]:
        """Returns the code's bytes, and the offsets in it of addresses of code, of cleared
        memory and of the table of holes. A whole program is for tracing: its instructions stay unchanged."""
        out = np.zeros(self.size, np.uint8)
        code, bss, table = [], [], []
        for part in self.program.parts.values():
            if part.section.bss:
                continue
            at = self.at[part.section]
            place = np.flatnonzero(part.live)
            out[at + place] = np.frombuffer(part.data, np.uint8)[place]
        image = bytearray(out.tobytes())
        for part in self.program.parts.values():
            for relocation in self.program.held(part) if not part.section.bss else ():
                place = self.at[part.section] + relocation.offset
                target, offset = self.program.lead(part, relocation)
                value = self.at[target] + offset
                near = branch(bytes(image[place - 2:place]), value - place, part.timed)
                if near and self.program.trace is not None and not target.bss:
                    image[place - 2:place + 4] = near
                    continue
                if relocation.relative:
                    value -= place
                else:
                    (table if target.name == HOLES else bss if target.bss else code).append(place)
                limit = 1 << 8 * relocation.size
                if not -limit // 2 <= value < limit // 2:
                    raise UserError(f"{part.section.file}: {part.section.name}: {target.name} is "
                                    f"{value} bytes away, which {relocation.size} bytes cannot say")
                image[place:place + relocation.size] = (value % limit).to_bytes(
                    relocation.size, "big")
        return bytes(image), code, bss, table

    @property
    def fits(self) -> bool:
        """Returns True if every relative address fits its field."""
        try:
            self.link()
        except UserError:
            return False
        return True

    def islands(self) -> np.ndarray:
        """Returns first and last word, excluded, of what is between holes; all is one where no table is asked for."""
        if not any(section.name == HOLES for section in self.program.parts):
            return np.array([[0, self.size // 2]])
        used = np.zeros(self.size, bool)
        used[:min(self.size, len(self.used))] = self.used[:self.size]
        words = np.flatnonzero(used.reshape(-1, 2).any(axis=1))
        ends = np.flatnonzero(np.diff(words) > HOLE // 2)
        return np.stack([np.r_[words[0], words[ends + 1]], np.r_[words[ends] + 1, self.size // 2]], axis=1)

    def hunks(self) -> bytes:
        """Returns the whole program as a hunk file."""
        image, *places = self.link()
        islands = self.islands()
        data = b"".join(image[2 * first:2 * last] for first, last in islands)
        size, data = len(data), data + bytes(-len(data) % 4)
        lengths = np.diff(islands).ravel()
        before = islands[:, 0] - np.r_[0, np.cumsum(lengths)[:-1]]  # words of holes before each island

        def packed(offset: int) -> int:
            island = np.searchsorted(islands[:, 0], offset // 2, "right") - 1
            return offset - 2 * int(before[island])

        rows = [(len(image) // 4, HUNK_CODE, data, [[packed(at) for at in offsets] for offsets in places])]
        if self.bss:
            rows.append(((self.bss + 3) // 4, HUNK_BSS, b"", []))
        if places[2]:
            steps = [(part, 2 * int(hole if not left else 0))
                     for length, hole in zip(lengths[::-1], np.diff(np.r_[0, before])[::-1])
                     for left, part in pieces(int(length))]
            table = longs(size, len(image)) + np.array(
                [number for part, hole in steps for number in (part - 1, hole)], ">u2").tobytes()
            rows.append((-(-len(table) // 4), HUNK_DATA, table + bytes(-len(table) % 4), [[0, 4], [], []]))
            if not self.bss:
                rows[0][3][1], rows[0][3][2] = rows[0][3][2], []
        out = longs(HUNK_HEADER, 0, len(rows), 0, len(rows) - 1, *(row[0] for row in rows))
        for longwords, kind, data, offsets in rows:
            out += longs(kind, len(data) // 4 if data else longwords) + data + relocated(offsets) + longs(HUNK_END)
        return out

    def code_end(self) -> int:
        """Returns the end of the last part with code."""
        return max(self.at[s] + s.size for s in self.program.parts if s.code)

    def symbols(self) -> dict[int, str]:
        """Returns the names of the code's parts, by address."""
        return {self.at[s]: s.title for s in self.program.parts if s.code}

    def write(self, path: Path) -> None:
        """Writes the program and, beside it, the ``.map`` of its routines."""
        path.write_bytes(self.hunks())
        path.with_name(path.name + ".map").write_text("".join(
            f"{at:08x} {name}\n" for at, name in sorted(self.symbols().items())))
