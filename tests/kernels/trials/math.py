"""Trials of src68k/math: products and quotients against exact integers."""

from functools import partial

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench.trial import Trial, values
from tmap.guest.kernels import M32, Case

MIN, MAX = -(1 << 31), (1 << 31) - 1
CORNERS = (0, 1, -1, 2, -2, 3, -3, 0x8000, -0x8000, 0xFFFF, 0x10000, -0x10000, 0x18000, -0x18000,
           0x7FFFFFFF, -0x7FFFFFFF, MIN, 0x40000000, -0x40000000)


def any_size(rng: np.random.Generator, bits: int = 31) -> int:
    """A random number of random magnitude and sign."""
    value = int(rng.integers(0, 1 << int(rng.integers(1, bits + 1))))
    return -value if rng.integers(2) else value


def product_trials(name: str, added: int, rng) -> list[Trial]:
    pairs = [(a, b) for a in CORNERS for b in CORNERS]
    pairs += [(any_size(rng), any_size(rng)) for _ in range(60)]
    return [Trial(Case(name, registers={"d0": a, "d1": b}), values(a=a, b=b),
                  {"d0": (a * b + added >> 16) & M32}) for a, b in pairs]


def mul_div_trials(rng) -> list[Trial]:
    triples = [(a, b, c) for a in CORNERS for b in (1, -1, 3, 0x10000, MAX, MIN)
               for c in (1, 2, 3, 0x10000, MAX - 1, MAX)]
    for c in (2, 4, 6, 0x10000, 0x7FFFFFFE):  # ties, and their neighbours
        for k in (-5, -2, -1, 0, 1, 2, 7):
            triples += [(c // 2 + k * c + near, 1, c) for near in (-1, 0, 1)]
    triples += [(MAX, b, MAX) for b in (MAX, MIN, -MAX)] + [(MIN, c, c) for c in (1, 7, MAX)]
    triples += [(any_size(rng), any_size(rng), abs(any_size(rng)) + 1) for _ in range(200)]
    trials = []
    for a, b, c in triples:
        quotient = (a * b + c // 2) // c
        if MIN <= quotient <= MAX and abs(a) <= 1 << 31 and 0 < c <= MAX:
            trials.append(Trial(Case("mul_div", registers={"d0": a, "d1": b, "a0": c}),
                                values(a=a, b=b, c=c), {"d0": quotient & M32}))
    return trials


def mul_shift_trials(rng) -> list[Trial]:
    triples = [(a, b, bits) for a in CORNERS for b in CORNERS[::3] for bits in (1, 15, 16, 17, 31)]
    triples += [(any_size(rng), any_size(rng), int(rng.integers(1, 32))) for _ in range(100)]
    return [Trial(Case("mul_shift", registers={"d0": a, "d1": b, "a0": bits}),
                  values(a=a, b=b) + f", bits {bits}", {"d0": (a * b >> bits) & M32})
            for a, b, bits in triples]


def mul_wide_trials(rng) -> list[Trial]:
    pairs = [(a << 32 | b & M32, c) for a in CORNERS for b in (0, 1, -1, 0x8000) for c in CORNERS[::2]]
    pairs += [(any_size(rng, 62), any_size(rng)) for _ in range(100)]
    trials = []
    for gradient, offset in pairs:
        memory = Memory()
        at = memory.struct("number64", {}, hi=gradient >> 32 & M32, lo=gradient & M32)
        trials.append(Trial(Case("mul_wide", memory, {"d0": offset}, {"a0": at}),
                            values(gradient=gradient, offset=offset),
                            {"d0": (gradient * offset + (1 << 31) >> 32) & M32}))
    return trials


def trials() -> list[Trial]:
    makers = (partial(product_trials, "mul_fix", 0), mul_div_trials, mul_shift_trials,
              mul_wide_trials, partial(product_trials, "mul_round", 0x8000))
    return [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng(seed))]
