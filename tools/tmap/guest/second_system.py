"""Runs programs of ours on the second processor: Musashi's 68020 (machine68k) below vamos (amitools), which does what
AmigaDOS does.

``python -m tmap.guest.second_system [--folders] COMMAND...`` runs commands in the current folder, or each in the folder
of its number, and leaves there what tmap.guest.emulator's start-up script does: N.log, N.code, ``end``. A crash ends
it; standard error then has the processor's state.

There are no chips, caches or interrupts: registers of chips read as 0, nothing is done in supervisor mode, no watchdog
bites. vamos lacks what this file adds: exec's list of free memory, where scene files look for pages, memory at
an address, and CIA-B's resource.
"""

import ctypes
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

from amitools.vamos.astructs import AccessStruct
from amitools.vamos.error import VamosInternalError
from amitools.vamos.lib.ExecLibrary import ExecLibrary
from amitools.vamos.lib.LibList import vamos_libs
from amitools.vamos.lib.lexec import Alloc
from amitools.vamos.libstructs import MemHeaderStruct, NodeType
from amitools.vamos.libtypes import Node
from amitools.vamos.machine.regs import REG_A1, REG_D0, REG_D1
from amitools.vamos.main import main

PR_SET_PDEATHSIG = 1  # of Linux
CODES = (0, 5, 10, 20)  # of programs; vamos has others for crashes and for faults of its own
CHIPS = (0xBF0000, 0xDF0000)  # 64 KB each: the CIAs, the custom chips
RAM_KB = 11 << 10  # ends below them
FREE = 8 << 20  # bytes that programs can take
ALIGN = 8  # of blocks of memory
STACK_KB = 32  # more than programs may use, so that too much is told
STACK_MOST = 4096 - 256  # bytes: a shell's stack, and what exec saves there when it switches tasks
MEMF_ANY, MEMF_CLEAR, MEMF_LARGEST = 7, 1 << 16, 1 << 17  # all memory is of every kind
RETURN_0 = bytes.fromhex("7000 4e75 4e71")  # moveq #0,d0; rts; nop: as long as a call in a library's table
RESOURCE_CALLS = 8


class Exec(ExecLibrary):
    """exec.library with one piece of memory, whose list of free chunks is in the memory itself."""

    def setup_lib(self, ctx, base_addr: int) -> None:
        """Makes the list of memory, the resource, and chips that do nothing."""
        super().setup_lib(ctx, base_addr)
        for page in CHIPS:
            ctx.mem.set_special_range_read_funcs(page, 1, *[lambda at: 0] * 3)
            ctx.mem.set_special_range_write_funcs(page, 1, *[lambda at, value: None] * 3)
        table = RETURN_0 * RESOURCE_CALLS
        self.resource = self.alloc.alloc_mem(len(table)) + len(table)
        ctx.mem.w_block(self.resource - len(table), table)

        size = MemHeaderStruct.get_size() + ALIGN - 1 & -ALIGN
        self.header = self.alloc.alloc_mem(size + FREE + ALIGN) + ALIGN - 1 & -ALIGN
        header, first = AccessStruct(ctx.mem, MemHeaderStruct, self.header), self.header + size
        for field, value in (("Attributes", MEMF_ANY), ("First", first), ("Lower", first), ("Upper", first + FREE),
                             ("Free", FREE)):
            header.w_s(f"mh_{field}", value)
        Alloc.MemChunk(0, FREE, first).write(ctx)
        self.exec_lib.mem_list.new_list(NodeType.NT_MEMORY)
        self.exec_lib.mem_list.add_tail(Node(ctx.mem, self.header))

    def chunks(self, ctx) -> Iterator[tuple[Alloc.MemChunk | None, Alloc.MemChunk]]:
        """Yields each free chunk with the one before it."""
        header, before = Alloc.MemHdr(), None
        header.read(ctx, self.header)
        chunk = header.read_first(ctx)
        while chunk:
            yield before, chunk
            before, chunk = chunk, chunk.read_next(ctx)

    def AllocMem(self, ctx) -> int:
        """Takes the first chunk that is large enough."""
        size = ctx.cpu.r_reg(REG_D0)
        at = Alloc.allocate(ctx, self.header, size)
        if at and ctx.cpu.r_reg(REG_D1) & MEMF_CLEAR:
            ctx.mem.clear_block(at, size, 0)
        return at

    def AllocAbs(self, ctx) -> int:
        """Takes memory at an address: all of its chunk, then gives back what is before and behind."""
        at, size = ctx.cpu.r_reg(REG_A1), ctx.cpu.r_reg(REG_D0) + ALIGN - 1 & -ALIGN
        header = Alloc.MemHdr()
        header.read(ctx, self.header)
        for before, chunk in self.chunks(ctx):
            end = chunk.addr + chunk.bytes
            if not chunk.addr <= at <= at + size <= end:
                continue
            if before:
                before.next = chunk.next
                before.write(ctx)
            else:
                header.first = chunk.next
            header.free -= chunk.bytes
            header.write(ctx)
            Alloc.deallocate(ctx, self.header, chunk.addr, at - chunk.addr)
            Alloc.deallocate(ctx, self.header, at + size, end - at - size)
            return at
        return 0

    def FreeMem(self, ctx) -> None:
        """Gives a block back."""
        Alloc.deallocate(ctx, self.header, ctx.cpu.r_reg(REG_A1), ctx.cpu.r_reg(REG_D0))

    def AvailMem(self, ctx) -> int:
        """Returns the bytes that are free, or those of the largest chunk."""
        sizes = [chunk.bytes for _, chunk in self.chunks(ctx)]
        return max(sizes, default=0) if ctx.cpu.r_reg(REG_D1) & MEMF_LARGEST else sum(sizes)

    def CloseLibrary(self, ctx) -> None:
        """Checks at a program's end how deep its stack was: the lowest byte that is not 0, as all were before."""
        stack = ctx.mem.r_block(self.stk_lower, self.stk_upper - self.stk_lower)
        if (used := len(bytes(stack).lstrip(b"\0"))) > STACK_MOST:
            raise VamosInternalError(f"{used} bytes of stack were used; a shell gives 4096")
        super().CloseLibrary(ctx)

    def OpenResource(self, ctx) -> int:
        """Returns a resource whose calls return 0."""
        return self.resource

    def Supervisor(self, ctx) -> None:
        """Does nothing: what programs do there is for caches and vectors of interrupts."""


def run(command: str, program: str) -> int:
    """Runs one command; returns its code. ``program``: the path from the current folder."""
    return main(args=["--skip-configs", "--quiet", "--no-ts", "--cpu", "68020", "--ram-size", str(RAM_KB),
                      "--hw-access", "disable", "--stack-size", str(STACK_KB), "--", program, *command.split()[1:]])


def run_all(commands: list[str], folders: bool) -> int:
    """Runs the commands one after the other, each in a process of its own; ends after a crash. Returns 0, or 1 after
    a crash."""
    for number, command in enumerate(commands):
        log = Path(f"{number}.log")
        log.touch()
        child = os.fork()
        if not child:
            ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # it ends with whoever is ended
            os.dup2(os.open(log, os.O_WRONLY), sys.stdout.fileno())
            if folders:
                os.chdir(str(number))
            os._exit(run(command, f"{'.' * (1 + folders)}/{command.split()[0]}"))
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        if code not in CODES:
            return 1
        Path(f"{number}.code").write_text(f"{code}\n")
    Path("end").touch()
    return 0


if __name__ == "__main__":
    vamos_libs["exec.library"] = Exec
    sys.exit(run_all([each for each in sys.argv[1:] if each != "--folders"], "--folders" in sys.argv))
