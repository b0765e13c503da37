"""Calls kernels and checks the results against their contract blocks.

A trial is one call together with its expected results. Everything else must stay as it was: the
stack pointer, the registers that the block lists neither under ``out`` nor under ``trashes``, and
every byte of memory that the trial does not expect to be written. Each block of memory is between
guards of noise.
"""

import random
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.bench.trial import Trial, both
from tmap.build import layout
from tmap.build.contracts import Contract
from tmap.guest import kernels
from tmap.guest.kernels import Place

MACHINE = "a1200-fast"
GUARD = 64  # least number of bytes before and behind each block
REPORTED = 4  # most failed trials of one kernel that are shown
RERUN = '.deps/venv/bin/python -m pytest "tests/kernels/test_kernels.py::test_contract[{}]"'
#: No trial can call these: three_draw calls routines whose addresses its plan has, and C, deep_draw and
#: cover_draw C; the frames of tests/polygon and the fuzzer draw by three_draw and deep_draw, those of tests/mesh by
#: cover_draw. triangle_outline takes a routine's address, and texturing_gentle_from memory from the stack;
#: polygon_outline and texturing_gentle end with them. n64_stages_draw, n64_stages_together, glide_lines and
#: glide_lines_together call the passes whose addresses their lists have, n64_in_c C: polygons of tests/n64 and
#: tests/glide are drawn by them.
UNCALLED = {"cover_draw", "deep_draw", "glide_lines", "glide_lines_together", "n64_in_c", "n64_stages_draw",
            "n64_stages_together", "three_draw", "three_run", "three_longest", "three_one", "triangle_outline",
            "texturing_gentle_from"}
#: Bits of an ``out`` register that its C type covers.
WIDTHS = {"uint8": 8, "int8": 8, "uint16": 16, "int16": 16}


class Block(NamedTuple):
    """A piece of an arena; with a ``shape`` it is an array of that struct."""

    at: int
    size: int
    name: str
    shape: layout.Struct | None


class Memory(kernels.Arena):
    """An arena whose blocks have names and lie between guards."""

    def __init__(self, seed: int = 64) -> None:
        super().__init__()
        self.blocks: list[Block] = []
        self.noise = random.Random(seed)
        self.pad(GUARD)

    def pad(self, size: int) -> None:
        self.data += self.noise.randbytes(size)

    def add(self, content: bytes | bytearray, align: int = 4, name: str = "data",
            shape: layout.Struct | None = None) -> int:
        self.pad(-len(self.data) % align)
        at = len(self.data)
        self.data += content
        self.blocks.append(Block(at, len(content), name, shape))
        self.pad(GUARD + -(at + len(content)) % 4)
        return at

    def blank(self, size: int, name: str = "data", shape: layout.Struct | None = None) -> int:
        """The same of noise."""
        return self.add(self.noise.randbytes(size), name=name, shape=shape)

    def place(self, offset: int) -> Place:
        """Returns the item at an offset."""
        def distance(block: Block) -> int:
            return max(block.at - offset, offset - block.at - block.size + 1, 0)

        if not self.blocks:
            return Place("the guard", offset, 1)
        block = min(self.blocks, key=distance)
        beyond, inside = distance(block), offset - block.at
        if beyond:
            side = "before" if inside < 0 else "past the end of"
            return Place(f"{beyond} byte{'s'[:beyond > 1]} {side} {block.name}", offset, 1)
        if block.shape is None:
            return Place(f"{block.name} + {inside}", offset, 1)
        index, rest = divmod(inside, block.shape.size)
        name, entry = next((n, e) for n, e in block.shape.fields.items()
                           if e["offset"] <= rest < e["offset"] + e["size"] * e["count"])
        start = inside - rest + entry["offset"]
        if entry["count"] > 1 or entry["size"] == 1:  # an array, or a nested struct
            size = entry["size"] if entry["size"] > 1 else 4
            number = (inside - start) // size
            return Place(f"{block.name}.{name}[{number}]", block.at + start + number * size, size)
        which = f"[{index}]" if block.size > block.shape.size else ""
        return Place(f"{block.name}{which}.{name}", block.at + start, entry["size"])


def register_complaints(trial: Trial, result: kernels.Result, contract: Contract) -> list[str]:
    """Complains about registers that differ from what the block and the trial say."""
    case, found = trial.case, result.registers
    types = {a.register: a.type for a in contract.outputs}
    before = {name: kernels.POISON + n for n, name in enumerate(kernels.REGISTERS)} | case.registers
    before |= {name: at + result.address for name, at in case.pointers.items()}
    before |= {name: at + result.far_address for name, at in case.far_pointers.items()}
    expected = trial.expected(result)
    if expected.keys() != types.keys():
        raise ValueError(f"{contract.name}: the block's out is {', '.join(types) or '-'}, the trial's "
                         f"{', '.join(expected) or '-'}")
    lines = []
    for name in kernels.REGISTERS:
        if name in expected:
            mask = (1 << WIDTHS.get(types[name], 32)) - 1
            if (found[name] ^ expected[name]) & mask:
                lines.append(f"{name}: expected {both(expected[name] & mask)}, "
                             f"found {both(found[name] & mask)}")
        elif name not in contract.trashes and found[name] != before[name] & M32:
            lines.append(f"{name} is trashed, and the block does not say so: "
                         f"was {both(before[name])}, is {both(found[name])}")
    if result.stack:
        lines.append(f"sp is off by {result.stack}")
    return lines


def complaints(trial: Trial, result: kernels.Result, contract: Contract) -> list[str]:
    """Returns everything that is wrong after one call."""
    lines = register_complaints(trial, result, contract)
    lines += filter(None, (trial.memory_complaint(result, far) for far in (False, True)))
    also = trial.also(result) if trial.also else None
    return lines + [also] if also else lines


def with_writes(trial: Trial) -> kernels.Case:
    """Returns the trial's case with what it changes of the far arena: what else it changes is found there,
    after this call or a later one."""
    image, step, writes = trial.case.far.data, layout.load().constants["PLAN_PIECE"], []
    for write in trial.writes if trial.case.far.data else ():
        for at in range(0, len(write.expected) if write.far else 0, step):
            part = write.expected[at:at + step]
            if write.mask or write.pointer or part != image[write.at + at:write.at + at + len(part)]:
                writes.append((write.at + at, len(part)))
    return replace(trial.case, writes=writes)


def run(trials: list[Trial], machine: str = MACHINE) -> list[kernels.Result | str | None]:
    """Calls all trials in a few boots; returns the results in their order.

    A crash ends a boot. The trial that caused it is then searched among the trials of the routine
    in which the crash was, and by halves. Its result is the crash report, and no further trial of
    that kernel is called (None).

    Unchanged pieces of the far arena are neither restored nor returned between calls, so a kernel that writes
    where it must not is found at a later call, or at the end: all trials of its boot are called again, each
    with the whole arena restored and returned.
    """
    results: list[kernels.Result | str | None] = [None] * len(trials)
    crashed: set[str] = set()

    def attempt(part: list[int], case_of: Callable[[Trial], kernels.Case] = with_writes) -> None:
        part = [index for index in part if trials[index].case.kernel not in crashed]
        if not part:
            return
        try:
            called = kernels.call_batch([case_of(trials[index]) for index in part], machine, None, timed=False)
        except kernels.Changed as changed:
            attempt(part, lambda trial: trial.case)
            if not any(map(wrong, part)):
                raise UserError(f"{changed}; each call alone changes none") from None
            return
        except UserError as error:
            if "crashed" not in str(error):
                raise
            if len(part) == 1:
                results[part[0]] = str(error)
                crashed.add(trials[part[0]].case.kernel)
                return
            blamed = [i for i in part if f" in {trials[i].case.kernel}+" in str(error)]
            others = [i for i in part if i not in blamed]
            middle = len(part) // 2
            for some in (others, blamed) if blamed and others else (part[:middle], part[middle:]):
                attempt(some, case_of)
            return
        for index, result in zip(part, called):
            results[index] = result
        if case_of is with_writes and any(map(wrong, part)):
            attempt(part, lambda trial: trial.case)

    def wrong(index: int) -> bool:
        found = results[index]
        return isinstance(found, kernels.Result) and trials[index].memory_complaint(found, True) is not None

    done = 0
    for batch in kernels.batches([trial.case for trial in trials], machine):
        attempt(list(range(done, done + len(batch))))
        done += len(batch)
    return results


def report(contract: Contract, trials: list[Trial],
           results: list[kernels.Result | str | None]) -> str | None:
    """Describes what is wrong with one kernel, over all its trials, and how to run them again; None
    if nothing is."""
    failed = []
    for trial, result in zip(trials, results):
        lines = [result] if isinstance(result, str) else \
            complaints(trial, result, contract) if result else []
        if lines:
            failed.append("\n".join([f"{contract.name}: {trial.title}",
                                     *(f"  {line}" for line in lines)]))
    if not trials:
        failed.append(f"{contract.name} ({contract.file}:{contract.line}) has no trial: "
                      "add some to tests/kernels/trials/")
    if not failed:
        return None
    return "\n".join([*failed[:REPORTED], f"{len(failed)} of {len(trials)} calls failed; again:",
                      "  " + RERUN.format(contract.name)])
