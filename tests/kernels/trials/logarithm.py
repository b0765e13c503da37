"""Trials of perspective by logarithms: tables, lines and spans against the model, and what the
tables cost in precision against exact fractions."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.reciprocal import PITCH, constants_of, emptied_lines, error, triangles
from tests.kernels.trials.span import BIAS, FRAME, picture_memory, texture
from tmap.bench import logarithm, perspective
from tmap.bench.trial import Trial, Write, fields_check, first_of
from tmap.build import layout
from tmap.guest.kernels import M32, Case
from tmap.setup import logarithm as model


def make_trial() -> Trial:
    """logarithms_make: all of the tables."""
    memory = Memory()
    logs_at = memory.add(bytes(2 * model.COUNT), name="logs")
    powers_at = memory.add(bytes(2 * model.POWERS), name="powers")
    at = memory.struct("logarithm_tables", dict(logs=logs_at, powers=powers_at),
                       parts=[0] * (model.PARTS + 1))
    fields = layout.load().struct("logarithm_tables").fields
    index = 2 * (model.ORIGIN - model.LOWEST)
    _, check = fields_check(at, "logarithm_tables", {}, dict(logs=logs_at + index, powers=powers_at))
    writes = [Write(logs_at, model.logs().astype(">i2").tobytes()),
              Write(powers_at, (model.powers() & 0xFFFF).astype(">u2").tobytes()),
              Write(at + fields["logs"]["offset"], bytes(4), bytes(4)),
              Write(at + fields["parts"]["offset"], np.array(model.parts(), ">u4").tobytes())]
    return Trial(Case("logarithms_make", memory, pointers={"a0": at}), "all tables", writes=writes,
                 also=check)


def lines_trial(deep, width: int, lines) -> Trial | None:
    """logarithm_lines on all lines of a polygon, those it leaves among them."""
    constants, *_ = constants_of(deep, None, width, lines)
    if constants is None:
        return None
    memory, shape = Memory(), layout.load().struct("logarithm_line")
    out = memory.room("logarithm_line", len(lines))
    planes = perspective.add_perspective_plan(memory, deep, lines, out)
    plan, tables = logarithm.add_logarithm_plan(memory, planes, constants)
    made = [model.line(deep, constants, *each) if each[1] > each[0] else None for each in lines]
    parts, others, worst = [], 0, None
    for k, (each, line) in enumerate(zip(lines, made)):
        wanted = {"n": -1 if each[1] > each[0] else each[1] - each[0] - 1}
        others += each[1] > each[0] and line is None
        if line:
            wanted = shape.unpack(logarithm.entry(line))
            del wanted["spare"]
            if k % 4 == 0:
                worst = worst or error(deep, line, {0, line.n // 3, line.n}, *model.coordinates(line),
                                       each[2], model.bound(line), constants.raised)
        parts.append(fields_check(out + k * shape.size, "logarithm_line", wanted, {}, f"line {k}"))
    blank = bytes(shape.size * len(lines))
    return Trial(Case("logarithm_lines", memory, pointers={"a0": plan, "a1": tables, "d0": out}),
                 f"{deep}, {len(lines)} lines, {others} left", {"d0": others},
                 writes=[Write(out, blank, blank), *emptied_lines(memory, planes, lines, made)],
                 also=first_of([*(part[1] for part in parts), lambda _: worst]))


def span_trial(counts, octave: int, rng) -> Trial:
    """A table of lines whose q are any that stay inside the table, and whose powers are those of
    three octaves from one on."""
    far, frame_at, map_at = picture_memory()
    memory = Memory(int(rng.integers(1 << 30)))
    shape = layout.load().struct("logarithm_line")
    table, writes, lines = b"", [], []
    for k, pixels in enumerate(counts):
        left, n = k % 4, pixels - 1
        if pixels <= 0:
            table += shape.pack(**dict.fromkeys(shape.fields, 0) | {"n": n})
            continue
        q0, q1 = (int(q) << 16 for q in rng.integers(model.LOWEST + 2, 65536, 2))
        line = model.Logarithmic(
            left, n, model.swap(q0 - (model.ORIGIN << 16) & M32),
            model.swap((q1 - q0) // max(n, 1) & M32), tuple(map(int, rng.integers(0, 1 << 16, 2))),
            tuple(int(c) * model.OCTAVE for c in rng.integers(octave, octave + 2, 2)),
            int(rng.integers(4)))
        logs = model.logs()[model.indices(line)]
        line.power = tuple(power - int(logs.min()) for power in line.power)
        lines.append(line)
        table += logarithm.entry(line)
        u, v = model.coordinates(line)
        writes.append(Write(frame_at + 64 + k * PITCH + left,
                            texture()[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
    at = memory.struct("logarithm_span",
                       dict(lines=memory.add(table, name="lines", shape=shape),
                            logs=logarithm.log_table(memory),
                            powers=logarithm.power_table(memory, lines)),
                       dict(row=frame_at + 64 - BIAS, map=map_at), count=len(counts), pitch=PITCH)
    return Trial(Case("span_logarithm", memory, pointers={"a0": at}, far=far),
                 f"{len(counts)} lines", writes=writes)


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    rng = np.random.default_rng(9)
    counts = [*range(1, 20), 0, -3, *range(30, 35), 47, 48, 49, 64, 65, 100, 256, 257, 320, 1024]
    return [make_trial(), *filter(None, (lines_trial(*each) for each in triangles(rng, 40))),
            *(span_trial(counts[:FRAME // PITCH - 1], octave, rng) for octave in range(0, 14, 2))]
