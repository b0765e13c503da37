"""Places the parts of a program and writes it as an AmigaDOS hunk file.

The 68020's instruction cache has 64 longwords, chosen by the address modulo 256. Timed code keeps
its address in the full renderer modulo 256, so that the same instructions evict each other from the
cache. Holes left by omitted code are filled with untimed parts, and with timed parts that are
separated from other timed code by as much as the processor fetches ahead.
"""

import random
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.build.elf_object import Section
from tmap.build.hunk import HUNK_BSS, HUNK_CODE, HUNK_END, HUNK_HEADER, HUNK_RELOC32, longs
from tmap.product.program_parts import Part, Program

HUNK_RELOC32SHORT = 0x3FC  # dos 39, as on the A1200: offsets of 16 bits
CACHE = 256  # bytes
LAST = ".rodata.scene_data"  # with maps; addresses are only relocated before it
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
        self.full = 0  # there is no hole below this address
        entry = program.parts[program.symbols["start"][0]]
        self.put([entry], [0], 0, CACHE)
        rest = [p for p in parts if p is not entry]
        self.put_fixed([p for p in rest if p.section in fixed], fixed, order)
        self.put_others([p for p in rest if p.section not in fixed])
        self.put_cleared()
        self.size = int(np.flatnonzero(self.used)[-1]) + 1
        self.size += -self.size % 4

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
        """Places cleared memory in its own hunk."""
        for part in self.program.parts.values():
            if part.section.bss:
                self.bss += -self.bss % part.section.align
                self.at[part.section] = self.bss
                self.bss += part.section.size

    def free(self, live: np.ndarray, places: range) -> Iterator[int]:
        """Yields those of the places, in order, where some of the ``live`` bytes find room."""
        kept = np.flatnonzero(live)
        some = kept[np.linspace(0, len(kept) - 1, min(len(kept), PROBES)).astype(int)]
        for begin in range(0, len(places), BLOCK):
            block = np.array(places[begin:begin + BLOCK])
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
            self.at |= {p.section: at + offset for p, offset in zip(parts, offsets)}
            self.full += int(np.argmin(self.used[self.full:]))
            return
        raise AssertionError("no room in four times the size")

    def link(self) -> tuple[bytes, list[int], list[int]]:
        """Returns the code's bytes, and the offsets in it of addresses of code and of cleared
        memory. A whole program is for tracing: its instructions stay unchanged."""
        out = np.zeros(self.size, np.uint8)
        code, bss = [], []
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
                    (bss if target.bss else code).append(place)
                limit = 1 << 8 * relocation.size
                if not -limit // 2 <= value < limit // 2:
                    raise UserError(f"{part.section.file}: {part.section.name}: {target.name} is "
                                    f"{value} bytes away, which {relocation.size} bytes cannot say")
                image[place:place + relocation.size] = (value % limit).to_bytes(
                    relocation.size, "big")
        return bytes(image), code, bss

    @property
    def fits(self) -> bool:
        """Returns True if every relative address fits its field."""
        try:
            self.link()
        except UserError:
            return False
        return True

    def hunks(self) -> bytes:
        """Returns the whole program as a hunk file."""
        image, *places = self.link()
        sizes = [len(image) // 4] + [(self.bss + 3) // 4] * bool(self.bss)
        out = longs(HUNK_HEADER, 0, len(sizes), 0, len(sizes) - 1, *sizes)
        out += longs(HUNK_CODE, sizes[0]) + image
        rows = [[len(offsets), hunk, *sorted(offsets)]
                for hunk, offsets in enumerate(places) if offsets]
        short = all(row[-1] < 1 << 16 for row in rows)
        if rows:
            table = np.array([*sum(rows, []), 0], ">u2" if short else ">u4").tobytes()
            out += longs(HUNK_RELOC32SHORT if short else HUNK_RELOC32)
            out += table + bytes(-len(table) % 4)
        out += longs(HUNK_END)
        if self.bss:
            out += longs(HUNK_BSS, sizes[1], HUNK_END)
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
