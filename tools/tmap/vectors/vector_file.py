"""Files of the program ``vectors``: operations and answers (c/bench/vector_file.h), run in one
boot."""

import zlib

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.build import layout
from tmap.guest import emulator


class Operations:
    """Collects the program's operations as big-endian longs."""

    def __init__(self) -> None:
        self.longs: list[int] = []
        self.count = 0
        self.codes = layout.load().constants

    def add(self, name: str, *values: int) -> None:
        """Appends an operation; ``name`` has no prefix VECTOR_."""
        if len(values) >= 1 << 16:
            raise UserError(f"an operation of {len(values)} numbers is too long")
        self.longs += [self.codes[f"VECTOR_{name}"] << 16 | len(values),
                       *(value & M32 for value in values)]
        self.count += 1

    def file(self) -> bytes:
        """Returns the file that the program reads."""
        header = layout.load().struct("vector_header")
        body = np.array(self.longs, ">u4").tobytes()
        values = {"magic": self.codes["VECTOR_MAGIC"], "version": self.codes["VECTOR_VERSION"],
                  "size": header.size + len(body), "checksum": 0, "operations_at": header.size,
                  "operations": self.count}
        summed = header.fields["operations_at"]["offset"]
        values["checksum"] = zlib.crc32(header.pack(**values)[summed:] + body)
        return header.pack(**values) + body


def ask_all(several: list[Operations], machine: str = "a1200-fast",
            on_output=None) -> list[np.ndarray]:
    """Runs several lists of operations, each with reset engines, all in one boot; returns their
    answers, int32."""
    commands = [f"vectors {n}.questions {n}.answers" for n in range(len(several))]
    files = {f"{n}.questions": operations.file() for n, operations in enumerate(several)}
    with emulator.workspace() as directory:
        results = emulator.run_batch(commands, files, machine, directory, on_output, timed=False)
        for done in results:
            fault = emulator.explain_fault(emulator.PROGRAMS / "vectors", done.output)
            if fault or done.code:
                raise UserError(fault or f"vectors: {emulator.last_words(done.output)}")
        return [np.fromfile(results[n].directory / f"{n}.answers", ">i4").astype(np.int32)
                for n in range(len(several))]


def ask(operations: Operations, machine: str = "a1200-fast", on_operation=None) -> np.ndarray:
    """Runs the operations in one boot; returns all answers, int32. ``on_operation`` is called with
    the number of operations begun."""
    def progress(output: str) -> None:
        lines = [line for line in output.splitlines() if line.startswith("operation ")]
        if on_operation and lines and lines[-1].split()[1].isdecimal():
            on_operation(int(lines[-1].split()[1]))

    answers, = ask_all([operations], machine, progress)
    return answers
