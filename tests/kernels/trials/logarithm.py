"""Trials of perspective by logarithms: tables, lines and spans against the model, and what the
tables cost in precision against exact fractions."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.reciprocal import COUNTS, PITCH, lines_trial, records, triangles
from tests.kernels.trials.span import picture_ground
from tmap.bench import logarithm
from tmap.bench.trial import Trial, Write, fields
from tmap.build import layout
from tmap.guest.kernels import M32, Case
from tmap.setup import logarithm as model


def make_trial() -> Trial:
    memory = Memory()
    logs_at = memory.add(bytes(2 * model.COUNT), name="logs")
    powers_at = memory.add(bytes(2 * model.POWERS), name="powers")
    at = memory.struct("logarithm_tables", dict(logs=logs_at, powers=powers_at),
                       parts=[0] * (model.PARTS + 1))
    index = 2 * (model.ORIGIN - model.LOWEST)
    parts = at + layout.load().struct("logarithm_tables").fields["parts"]["offset"]
    writes = [Write(logs_at, model.logs().astype(">i2").tobytes()),
              Write(powers_at, (model.powers() & 0xFFFF).astype(">u2").tobytes()),
              Write(parts, np.array(model.parts(), ">u4").tobytes()),
              *fields(at, "logarithm_tables", {}, dict(logs=logs_at + index, powers=powers_at))]
    return Trial(Case("logarithms_make", memory, pointers={"a0": at}), "all tables", writes=writes)


def log_trial(deep, width: int, lines) -> Trial | None:
    """Lines by logarithms: of every fourth some pixels are held to the planes."""
    return lines_trial(logarithm, model, deep, lines,
                       lambda k, n: () if k % 4 else {0, n // 3, n})


def span_trial(octave: int, rng) -> Trial:
    """A table of lines whose q are any that stay inside the table, and whose powers are those of
    three octaves from one on."""
    def line_of(k: int, n: int) -> model.Logarithmic:
        q0, q1 = (int(q) << 16 for q in rng.integers(model.LOWEST + 2, 65536, 2))
        line = model.Logarithmic(
            k % 4, n, model.swap(q0 - (model.ORIGIN << 16) & M32),
            model.swap((q1 - q0) // max(n, 1) & M32), tuple(map(int, rng.integers(0, 1 << 16, 2))),
            tuple(int(c) * model.OCTAVE for c in rng.integers(octave, octave + 2, 2)),
            int(rng.integers(4)))
        logs = model.logs()[model.indices(line)]
        line.power = tuple(power - int(logs.min()) for power in line.power)
        return line

    return logarithm.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(),
                                records(line_of), PITCH, f"{len(COUNTS)} lines")


def trials() -> list[Trial]:
    rng = np.random.default_rng(9)
    return [make_trial(), *filter(None, (log_trial(*each) for each in triangles(rng, 40))),
            *(span_trial(octave, rng) for octave in range(0, 14, 2))]
