"""The combiner: (A - B) * C + D of texels and colours, in one cycle or two."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import signed
from tmap.n64.misuse import Misuse
from tmap.n64.opcodes import bits
from tmap.n64.state import TWO_CYCLES, Combine, Inputs, State

RGB, ALPHA = slice(0, 3), slice(3, 4)

#: The meanings of codes, in order; None: zero. ".a": a colour's alpha in all channels.
RGB_A = ("combined", "texel0", "texel1", "primitive", "shade", "environment", "one", "noise")
RGB_B = ("combined", "texel0", "texel1", "primitive", "shade", "environment", "key centre", "k4")
RGB_C = ("combined", "texel0", "texel1", "primitive", "shade", "environment", "key scale",
         "combined.a", "texel0.a", "texel1.a", "primitive.a", "shade.a", "environment.a",
         "lod fraction", "primitive lod fraction", "k5")
RGB_D = RGB_A[:7] + (None,)
ALPHA_ABD = RGB_D
ALPHA_C = ("lod fraction", "texel0", "texel1", "primitive", "shade", "environment",
           "primitive lod fraction", None)

#: Names of the inputs' codes: (A, B, C, D) of colour and of alpha.
RGB_NAMES = (RGB_A, RGB_B, RGB_C, RGB_D)
ALPHA_NAMES = (ALPHA_ABD, ALPHA_ABD, ALPHA_C, ALPHA_ABD)
TEXELS = ("texel0", "texel0.a", "texel1", "texel1.a")
#: Inputs that this combiner does not have.
ABSENT = ("noise", "key centre", "key scale")


@dataclass
class Sources:
    """The combiner's possible inputs at pixels. ``texel0``, ``texel1``: [..., 4], 9 bits, those of
    cycle 0; ``shade``: [..., 4], 0..255, or None; ``fraction``: [...], 9 bits."""

    texel0: np.ndarray
    texel1: np.ndarray
    shade: np.ndarray | None
    fraction: np.ndarray


def inputs_of(hi: int, lo: int) -> dict[str, tuple[Inputs, Inputs]]:
    """Returns the codes in a set combine word, for cycle 0 and 1, as fields of Combine."""
    return {
        "rgb": (Inputs(bits(hi, 23, 20), bits(lo, 31, 28), bits(hi, 19, 15), bits(lo, 17, 15)),
                Inputs(bits(hi, 8, 5), bits(lo, 27, 24), bits(hi, 4, 0), bits(lo, 8, 6))),
        "alpha": (Inputs(bits(hi, 14, 12), bits(lo, 14, 12), bits(hi, 11, 9), bits(lo, 11, 9)),
                  Inputs(bits(lo, 23, 21), bits(lo, 5, 3), bits(lo, 20, 18), bits(lo, 2, 0)))}


def names(inputs: Inputs, table) -> list[str | None]:
    """Returns the four inputs' names; None: zero."""
    codes = (inputs.a, inputs.b, inputs.c, inputs.d)
    return [row[code] if code < len(row) else None for code, row in zip(codes, table)]


def cycle_names(combine: Combine, cycle: int) -> set[str]:
    """Returns the names of a cycle's inputs."""
    return {name for inputs, table in ((combine.rgb[cycle], RGB_NAMES),
                                       (combine.alpha[cycle], ALPHA_NAMES))
            for name in names(inputs, table) if name}


def used(combine: Combine, cycles: int) -> set[str]:
    """Returns the names of the inputs in use in 1 or 2 cycles."""
    return set().union(*(cycle_names(combine, cycle) for cycle in range(2 - cycles, 2)))


def samples(state: State) -> set[int]:
    """Returns the samples in use: 0 is tile T0's, 1 is T1's."""
    if state.modes.cycle != TWO_CYCLES:
        return {0} if used(state.combine, 1) & set(TEXELS) else set()
    return {number ^ cycle for cycle in (0, 1) for number in (0, 1)
            if cycle_names(state.combine, cycle) & {f"texel{number}", f"texel{number}.a"}}


def uses_shade(state: State) -> bool:
    """Returns true if vertex colours are used."""
    cycles = 2 if state.modes.cycle == TWO_CYCLES else 1
    return bool(used(state.combine, cycles) & {"shade", "shade.a"})


def check(combine: Combine) -> None:
    """Refuses inputs that this combiner does not have."""
    for name in ABSENT:
        if name in used(combine, 2):
            raise Misuse("combine input", f"the combiner has no {name}")


def extended(value: np.ndarray) -> np.ndarray:
    """Extends 9 bits as for A, B and D: negative only from 384 on; C's are signed."""
    value = value & 511
    return np.where(value >= 384, value - 512, value)


def clamp(value: np.ndarray) -> np.ndarray:
    """Clamps 9 bits to a colour 0..255: 256..383 are too bright, from 384 on below black."""
    value = value & 511
    return np.where(value >= 384, 0, np.where(value >= 256, 255, value))


def value_of(name: str | None, channels: slice, state: State, sources: Sources,
             combined: np.ndarray, cycle: int) -> np.ndarray:
    """Returns an input's value for channels, int64 that broadcasts to [..., n]."""
    name, dot, _ = (name or "").partition(".")
    colours = {"combined": combined, "primitive": np.array(state.primitive),
               "environment": np.array(state.environment)}
    # in the second cycle the samples are exchanged
    colours["texel0"], colours["texel1"] = (sources.texel0, sources.texel1)[::-1 if cycle else 1]
    if sources.shade is not None:
        colours["shade"] = sources.shade
    if name in colours:
        return colours[name][..., ALPHA if dot else channels]
    if name == "shade":
        raise Misuse("combine input", "the combiner reads shade, which this primitive has not")
    if name == "lod fraction":
        return sources.fraction[..., None]
    constants = {"one": 256, "k4": state.k[4], "k5": state.k[5],
                 "primitive lod fraction": state.primitive_fraction}
    return np.array([constants.get(name, 0)])


def cycle_of(state: State, sources: Sources, combined: np.ndarray, cycle: int,
             second: bool) -> np.ndarray:
    """Returns one cycle's result, [..., 4], 9 bits. ``cycle``: the one whose codes are used;
    ``second``: true if it runs as the second one."""
    results = []
    for inputs, table, channels in ((state.combine.rgb[cycle], RGB_NAMES, RGB),
                                    (state.combine.alpha[cycle], ALPHA_NAMES, ALPHA)):
        a, b, c, d = (value_of(name, channels, state, sources, combined, second)
                      for name in names(inputs, table))
        sums = (extended(a) - extended(b)) * signed(c, 9) + (extended(d) << 8) + 128
        shape = (*sources.fraction.shape, channels.stop - channels.start)
        results.append(np.broadcast_to(sums >> 8 & 511, shape))
    return np.concatenate(results, -1)


def combine(state: State, sources: Sources) -> np.ndarray:
    """Returns colours of pixels, uint8 [..., 4]. One-cycle mode runs the second cycle's codes."""
    combined = np.zeros((*sources.fraction.shape, 4), np.int64)
    if state.modes.cycle == TWO_CYCLES:
        combined = cycle_of(state, sources, combined, 0, False)
        combined = cycle_of(state, sources, combined, 1, True)
    else:
        combined = cycle_of(state, sources, combined, 1, False)
    return clamp(combined).astype(np.uint8)
