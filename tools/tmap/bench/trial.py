"""One call of a kernel and what must come out of it: what bench rows and the kernels' tests share."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tmap.base.fixed import M32
from tmap.build import layout
from tmap.guest.kernels import Case, Result

Check = Callable[[Result], str | None]


class Write(NamedTuple):
    """Bytes that the call writes; ``mask`` has the bits that count (all without one). A ``pointer`` is
    expected as an offset into the near arena."""

    at: int
    expected: bytes
    mask: bytes | None = None
    far: bool = False
    pointer: bool = False


def long_write(at: int, value: int) -> Write:
    """A longword that must be there."""
    return Write(at, (value & M32).to_bytes(4, "big"))


def anything(at: int, size: int) -> Write:
    """Bytes that may become anything."""
    return Write(at, bytes(size), bytes(size))


def fields(at: int, struct: str, numbers: dict[str, int],
           pointers: dict[str, int] = {}) -> list[Write]:
    """The fields of a struct that get ``numbers``, and ``pointers`` into the near arena."""
    shape, writes = layout.load().struct(struct).fields, []
    for name, value in (numbers | pointers).items():
        size = shape[name]["size"]
        writes.append(Write(at + shape[name]["offset"], (value % (1 << 8 * size)).to_bytes(size, "big"),
                            pointer=name in pointers))
    return writes


def both(value: int, size: int = 4) -> str:
    """A number in hexadecimal and, with its sign, in decimal."""
    bits = 8 * size
    value &= (1 << bits) - 1
    signed = value - (value >> bits - 1 << bits) if size > 1 else value
    return f"${value:0{2 * size}x} ({signed})"


def values(**named: int) -> str:
    """Numbers by name, for a title."""
    return ", ".join(f"{name} {both(value)}" for name, value in named.items())


@dataclass
class Trial:
    """One call and what must come out of it; all other memory must stay as it was.

    ``outputs``, ``ends``, ``near_ends``: ``out`` registers, as values and as offsets of the far and of
    the near arena. ``where`` names an offset (of the far arena where its second argument is
    true) better than the arena can. ``also`` is one more check: an error text, or None.
    """

    case: Case
    title: str = ""
    outputs: dict[str, int] = field(default_factory=dict)
    ends: dict[str, int] = field(default_factory=dict)
    near_ends: dict[str, int] = field(default_factory=dict)
    writes: list[Write] = field(default_factory=list)
    where: Callable[[int, bool], str | None] | None = None
    also: Check | None = None

    def row(self, units: int) -> tuple[int, Case, Check]:
        """Units, case and check of a bench row that is this call."""
        return units, self.case, self.check

    def expected(self, result: Result) -> dict[str, int]:
        """The values of the ``out`` registers."""
        return (self.outputs | {name: at + result.far_address for name, at in self.ends.items()}
                | {name: at + result.address for name, at in self.near_ends.items()})

    def check(self, result: Result) -> str | None:
        """What is wrong with ``outputs``, ``ends`` and memory, in words; None where nothing is."""
        outputs = self.expected(result)
        wrong = [f"{name}: expected {both(value)}, found {both(result.registers[name])}"
                 for name, value in outputs.items() if (result.registers[name] ^ value) & M32]
        return wrong[0] if wrong else self.memory_complaint(result, False) \
            or self.memory_complaint(result, True) or (self.also(result) if self.also else None)

    def is_expected(self, result: Result, far: bool) -> bool:
        """Whether one arena is as it must be: the same as memory_complaint finds, sooner."""
        arena, memory = (self.case.far, result.far_memory) if far else (self.case.arena, result.memory)
        expected = bytearray(arena.image)
        for offsets, address in ((arena.pointers, result.address), (arena.far_pointers, result.far_address)):
            for at in offsets:
                value = int.from_bytes(expected[at:at + 4], "big") + address & M32
                expected[at:at + 4] = value.to_bytes(4, "big")
        for write in self.writes:
            if write.far == far:
                part, wanted = slice(write.at, write.at + len(write.expected)), write.expected
                if write.pointer:
                    wanted = (int.from_bytes(wanted, "big") + result.address & M32).to_bytes(4, "big")
                if write.mask:
                    right, mask, found = (np.frombuffer(each, np.uint8) for each in (wanted, write.mask, memory[part]))
                    wanted = (right & mask | found & ~mask).tobytes()
                expected[part] = wanted
        return expected == memory

    def memory_complaint(self, result: Result, far: bool) -> str | None:
        """The first byte of one arena that is not what it must be, in words."""
        arena = self.case.far if far else self.case.arena
        if self.is_expected(result, far):
            return None
        found = np.frombuffer(result.far_memory if far else result.memory, np.uint8)
        expected = np.frombuffer(arena.image, np.uint8).copy()
        for offsets, address in ((arena.pointers, result.address),
                                 (arena.far_pointers, result.far_address)):
            for at in offsets:
                value = int.from_bytes(expected[at:at + 4].tobytes(), "big") + address & M32
                expected[at:at + 4] = np.frombuffer(value.to_bytes(4, "big"), np.uint8)
        before, mask = expected.copy(), np.full(len(expected), 255, np.uint8)
        writable = np.zeros(len(expected), bool)
        for write in self.writes:
            if write.far == far:
                part, wanted = slice(write.at, write.at + len(write.expected)), write.expected
                if write.pointer:
                    wanted = (int.from_bytes(wanted, "big") + result.address & M32).to_bytes(4, "big")
                expected[part], writable[part] = np.frombuffer(wanted, np.uint8), True
                mask[part] = np.frombuffer(write.mask, np.uint8) if write.mask else 255
        wrong = np.flatnonzero((found ^ expected) & mask)
        if not len(wrong):
            return None
        at = int(wrong[0])
        place, better = arena.place(at), self.where(at, far) if self.where else None
        if better:
            place = place._replace(name=better)

        def shown(memory: np.ndarray, is_masked: bool = True) -> str:
            part = slice(place.at, place.at + place.size)
            content = memory[part] & mask[part] if is_masked else memory[part]
            return both(int.from_bytes(content.tobytes(), "big"), place.size)

        if writable[at]:
            return f"{place.name}: expected {shown(expected)}, found {shown(found)}"
        return (f"{place.name} is written, and the block does not say so: "
                f"was {shown(before, False)}, is {shown(found, False)}")
