"""Trials of src68k/math: products, quotients and planes against exact integers."""

from fractions import Fraction

import numpy as np

from kernel_checker import Memory, Trial, Write, values
from tools import layout, model
from tools.kernels import M32, Case, Result

MIN, MAX = -(1 << 31), (1 << 31) - 1
CORNERS = (0, 1, -1, 2, -2, 3, -3, 0x8000, -0x8000, 0xFFFF, 0x10000, -0x10000, 0x18000, -0x18000,
           0x7FFFFFFF, -0x7FFFFFFF, MIN, 0x40000000, -0x40000000)


def longs(*numbers: int, bits: int = 32) -> bytes:
    """Big-endian numbers, modulo 2^bits."""
    return b"".join((n & (1 << bits) - 1).to_bytes(bits // 8, "big") for n in numbers)


def centred(value: int, bits: int) -> int:
    """The number nearest to 0 that equals ``value`` modulo 2^bits."""
    value &= (1 << bits) - 1
    return value - (value >> bits - 1 << bits)


def any_size(rng: np.random.Generator, bits: int = 31) -> int:
    """A random number of random magnitude and sign."""
    value = int(rng.integers(0, 1 << int(rng.integers(1, bits + 1))))
    return -value if rng.integers(2) else value


def mul_fix_trials(rng) -> list[Trial]:
    pairs = [(a, b) for a in CORNERS for b in CORNERS]
    pairs += [(any_size(rng), any_size(rng)) for _ in range(60)]
    return [Trial(Case("mul_fix", registers={"d0": a, "d1": b}), values(a=a, b=b),
                  {"d0": (a * b >> 16) & M32}) for a, b in pairs]


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


def wide_mul_trials(rng) -> list[Trial]:
    wides = (0, 1, -1, 1 << 31, (1 << 31) - 1, 1 << 32, -1 << 32, (1 << 32) - 1, 3 << 31,
             (1 << 63) - 1, -1 << 63, 0x7FFFFFFF << 32, (-1 << 63) + 1, 0x80000000FFFFFFFF - (1 << 64))
    pairs = [(g, o) for g in wides for o in CORNERS]
    pairs += [(any_size(rng, 62), any_size(rng)) for _ in range(100)]
    # half units: the last bit that counts is decided by the rounding
    pairs += [((2 * k + 1 << 31) + near, 1) for k in (-2, -1, 0, 1) for near in (-1, 0, 1)]
    trials = []
    for gradient, offset in pairs:
        memory = Memory()
        at = memory.struct("wide", {}, hi=gradient >> 32, lo=gradient & M32)
        title = f"gradient ${gradient & (1 << 64) - 1:016x} ({gradient}), {values(offset=offset)}"
        trials.append(Trial(Case("wide_mul", memory, {"d0": offset}, {"a0": at}), title,
                            {"d0": (gradient * offset + (1 << 31) >> 32) & M32}))
    return trials


def vectors(kernel: str, out: str, e1: tuple, e2: tuple):
    """The case of a routine that takes two vectors; where its result goes."""
    memory = Memory()
    at = [memory.struct("vertex", {}, shade=0, **dict(zip("xyst", e))) for e in (e1, e2)]
    out_at = memory.room(out)
    pointers = {"a0": at[0], "a1": at[1], "d0": out_at}
    return Case(kernel, memory, pointers=pointers), out_at


def cross_product(e1: tuple, e2: tuple, p: int, q: int) -> int:
    """e1.p e2.q - e2.p e1.q; vectors are (x, y, s, t)."""
    return e1[p] * e2[q] - e2[p] * e1[q]


def cross_trials(rng) -> list[Trial]:
    some = (0, 1, -1, 0x10000, -0x18000, MAX, -MAX, MIN)
    corners = [(a, b, c, d) for a in some for b in some for c in some for d in some]
    picked = [corners[k] for k in rng.choice(len(corners), 250, replace=False)]
    picked += [(MAX, -MAX, MAX, MAX), (-MAX, MAX, MAX, MAX), (MIN, 0, 0, MIN), (MIN, MAX, 1, 1)]
    for _ in range(100):
        a, b, k = any_size(rng, 24), any_size(rng, 24), int(rng.integers(-100, 100))
        picked.append((a, b, a * k, b * k + int(rng.integers(-1, 2))))  # on one line, or nearly
        picked.append(tuple(any_size(rng) for _ in range(4)))
    trials = []
    for x1, y1, x2, y2 in picked:
        e1, e2 = ((x, y, any_size(rng), any_size(rng)) for x, y in ((x1, y1), (x2, y2)))
        product = cross_product(e1, e2, 0, 1)
        if abs(product) < 1 << 63:
            case, at = vectors("cross", "wide", e1, e2)
            trials.append(Trial(
                case, values(x1=x1, y1=y1, x2=x2, y2=y2),
                {"d0": ((product > 0) - (product < 0)) & M32},
                writes=[Write(at, longs(abs(product), bits=64))]))
    return trials


def cut_quotient(numerator: int, divisor: int) -> int | None:
    """What the block says of a quotient in 32.32: of the divisor the upper 32
    significant bits, cut; None where only its bound holds."""
    size = abs(divisor)
    upper = size >> max(size.bit_length() - 32, 0) << max(size.bit_length() - 32, 0)
    quotient = (abs(numerator) << 32) // upper
    if quotient >= 1 << 62:
        return None
    return -quotient if (numerator < 0) != (divisor < 0) else quotient


def gradients_trial(e1: tuple, e2: tuple) -> Trial | None:
    """One plane; None where a product does not fit the block's formats."""
    divisor = cross_product(e1, e2, 0, 1)
    numerators = {"dsdx": cross_product(e1, e2, 2, 1), "dsdy": cross_product(e1, e2, 0, 2),
                  "dtdx": cross_product(e1, e2, 3, 1), "dtdy": cross_product(e1, e2, 0, 3)}
    if max(map(abs, [divisor, *numerators.values()])) >= 1 << 63:
        return None
    case, at = vectors("gradients", "plane", e1, e2)
    title = "; ".join(f"{name}: {values(**dict(zip('xyst', e)))}"
                      for name, e in (("e1", e1), ("e2", e2))) + f"; D = {divisor}"
    trial = Trial(case, title, {"d0": ((divisor > 0) - (divisor < 0)) & M32})
    if divisor == 0:
        return trial
    fields = layout.load().struct("plane").fields
    for name, numerator in numerators.items():
        quotient = cut_quotient(numerator, divisor)
        trial.writes.append(Write(at + fields[name]["offset"], longs(quotient or 0, bits=64),
                                  bytes(8) if quotient is None else None))

    def bound(result: Result) -> str | None:
        for name, numerator in numerators.items():
            place = at + fields[name]["offset"]
            found = int.from_bytes(result.memory[place:place + 8], "big")
            exact = Fraction(numerator << 32, divisor)
            error = found - exact
            error -= round(error / (1 << 64)) * (1 << 64)
            if abs(error) > abs(exact) / (1 << 31) + 1:
                return (f"{name}: ${found:016x} ({centred(found, 64)}), exact is "
                        f"{float(exact):.3f} modulo 2^64: off by {float(error):.3f}/2^32, "
                        f"the block allows {float(abs(exact) / (1 << 31) + 1):.3f}/2^32")
        return None

    trial.also = bound
    return trial


def gradients_trials(rng) -> list[Trial]:
    one, far = 0x10000, 0x3FFFFFFF
    fixed = [((1, 0, 5, 7), (0, 1, -5, 9)),                                     # D = 1 unit
             ((0, 1, 5, 7), (1, 0, -5, 9)),                                     # D = -1
             ((1, 0, MAX, -MAX), (0, 1, -MAX, MAX)),                            # overflows 32.32
             ((far, 1, far, 1), (far, 2, 1, far)), ((far, 0, 1, -1), (0, far, -1, 1)),
             ((far, far, far, far), (-far, far, -far, far)),
             ((MAX, 0, MAX, 0), (0, MAX, 0, MAX)), ((-MAX, 0, MAX, 0), (0, MAX, 0, -MAX)),
             ((3, 5, 0, 0), (7, 11, 0, 0)),                                     # all zero
             ((3 * one, one, one, 0), (one, 2 * one, 0, one)),
             ((0, 0, 0, 0), (one, one, one, one)), ((one, one, 1, 2), (one, one, 3, 4)),
             ((2 * one, 3 * one, 1, 2), (-4 * one, -6 * one, 3, 4)),            # on one line
             ((one, 0, one, 0), (0, one, 0, one)), ((one, 0, -one, 0), (0, one, 0, -one)),
             ((0x10001, 0, 1, 0), (0, 0x10001, 0, 1)), ((0x8000, 0, MAX, 0), (0, 0x8000, 0, MAX))]
    for bits in (16, 31, 32, 33, 40, 62):  # D around a power of two
        p, q = 1 << bits // 2, 1 << bits - bits // 2
        fixed += [((min(p + near, MAX), 0, one, 3), (0, min(q, MAX), 5, one)) for near in (-1, 0, 1)]
    for sign in range(16):  # all combinations of signs
        x, y, s, t = (-1 if sign >> k & 1 else 1 for k in range(4))
        fixed.append(((x * 100 * one, y * 1234, s * 55555, t * one),
                      (-x * 777, y * 90 * one, -s * 12 * one, t * 99999)))
    screen = [tuple(tuple(int(n) for n in rng.integers(-320 * one, 320 * one, 4)) for _ in range(2))
              for _ in range(60)]
    wild = [tuple(tuple(any_size(rng) for _ in range(4)) for _ in range(2)) for _ in range(120)]
    slivers = []
    for _ in range(60):
        e = [any_size(rng, 22) for _ in range(4)]
        slivers.append((tuple(e), tuple(3 * n + int(rng.integers(-1, 2)) for n in e)))
    trials = [gradients_trial(e1, e2) for e1, e2 in fixed + screen + wild + slivers]
    return [trial for trial in trials if trial]


def edge_exact_trial(upper: tuple[int, int], lower: tuple[int, int], line: int) -> Trial:
    """One edge from a line on; x and y are 16.16."""
    memory = Memory()
    at = [memory.struct("vertex", {}, x=x, y=y, s=0, t=0, shade=0) for x, y in (upper, lower)]
    out = memory.room("edge")
    width, height = lower[0] - upper[0], lower[1] - upper[1]
    numerator = upper[0] * height + width * ((line << 16) - upper[1])  # of x in 16.16
    pixels = -(-numerator // (height << 16))
    below = (pixels * height << 16) - numerator >> 16
    wanted = {"x": pixels + 16384, "whole": width // height, "error": ~below,
              "part": width % height, "height": height}
    fields = layout.load().struct("edge").fields
    return Trial(
        Case("edge_exact", memory, {"d1": line}, {"a0": out, "a1": at[0], "d0": at[1]}),
        values(x0=upper[0], y0=upper[1], x1=lower[0], y1=lower[1], line=line),
        writes=[Write(out + fields[name]["offset"], longs(value)) for name, value in wanted.items()])


def edge_rounded_trial(upper: tuple[int, int], lower: tuple[int, int], line: int) -> Trial:
    """The same in 16.16."""
    memory = Memory()
    at = [memory.struct("vertex", {}, x=x, y=y, s=0, t=0, shade=0) for x, y in (upper, lower)]
    out = memory.room("edge")
    edge = model.Edge(upper, lower, line, line + 1, exact=False)
    x = edge.at(line) + (16384 << 16) + 0xFFFF
    wanted = {"x": x >> 16 & 0xFFFF, "whole": edge.slope >> 16, "error": x << 16,
              "part": edge.slope << 16, "height": 0}
    fields = layout.load().struct("edge").fields
    return Trial(
        Case("edge_rounded", memory, {"d1": line}, {"a0": out, "a1": at[0], "d0": at[1]}),
        values(x0=upper[0], y0=upper[1], x1=lower[0], y1=lower[1], line=line),
        writes=[Write(out + fields[name]["offset"], longs(value)) for name, value in wanted.items()])


def edge_trials(rng, one_trial) -> list[Trial]:
    far = (16384 << 16) - 1
    ends = [((0, 0), (0, 1), 0), ((-far, -far), (far, far), 0), ((far, -far), (-far, far), 16383),
            ((-far, -far), (far, far), -16383), ((far, -1), (-far, 0), 0), ((5, -1), (7, 1), 0),
            ((-far, 0), (far, 1), 0), ((1 << 16, 3 << 16), (-1 << 16, 5 << 16), 4),
            ((0x8000, -0x8000), (0x18000, 0x18000), 1), ((7, 0), (7, 9 << 16), 9)]
    for _ in range(300):
        x0, x1, y0 = (any_size(rng, 30) for _ in range(3))
        y1 = y0 + int(rng.integers(1, 1 << int(rng.integers(1, 31))))
        first, last = y0 + 0xFFFF >> 16, y1 >> 16
        if y1 > far or last < first:
            continue
        for line in {first, last, int(rng.integers(first, last + 1))}:
            ends.append(((x0, y0), (x1, y1), line))
    return [one_trial(*end) for end in ends]


def edge_exact_trials(rng) -> list[Trial]:
    return edge_trials(rng, edge_exact_trial)


def edge_rounded_trials(rng) -> list[Trial]:
    return edge_trials(rng, edge_rounded_trial)


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    makers = (mul_fix_trials, mul_div_trials, wide_mul_trials, cross_trials, gradients_trials,
              edge_exact_trials, edge_rounded_trials)
    return [trial for seed, maker in enumerate(makers)
            for trial in maker(np.random.default_rng(seed))]
