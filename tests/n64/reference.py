"""Runs the model over the text of reference data."""

from pathlib import Path

import numpy as np

from tmap.base.paths import ROOT
from tmap.n64 import commands
from tmap.n64.copy import copy
from tmap.n64.divide import divide
from tmap.n64.filters import sample
from tmap.n64.lod import Gradients, level
from tmap.n64.state import Axis, State, Tile
from tmap.n64.texels import fetch
from tmap.vectors.n64_text import read
from tmap.vectors.vector_text import Line, xorshift

FOLDER = ROOT / "tests" / "vectors"
DRAM_BYTES = 1 << 20
RANDOM = slice(0x1000, 0x9000)  # bytes of DRAM filled at random
FIELDS = {"persp_tex_en": "perspective", "detail_tex_en": "detail", "sharpen_tex_en": "sharpen",
          "tex_lod_en": "lod", "en_tlut": "tlut", "tlut_type": "tlut_type", "sample_type": "quad",
          "mid_texel": "mid", "bi_lerp0": "filter0", "bi_lerp1": "filter1",
          "convert_one": "convert_one", "cycle_type": "cycle"}


def big_endian(values: np.ndarray, kind: str = ">u4") -> np.ndarray:
    return np.frombuffer(values.astype(kind).tobytes(), np.uint8)


def fnv(data: bytes) -> int:
    value = 0x811C9DC5
    for byte in data:
        value = (value ^ byte) * 0x01000193 & 0xFFFFFFFF
    return value


class Reference:
    """Runs lines: commands change the state, questions return answers."""

    def __init__(self):
        self.state = State(dram=np.zeros(DRAM_BYTES, np.uint8), checked=False)
        self.state.modes.filter0 = self.state.modes.filter1 = 1  # until a line says otherwise

    def answer(self, line: Line) -> list[int] | None:
        """Returns a question's answer, numbers as in the file; None for other commands."""
        return getattr(self, f"run_{line.command}")(*line.arguments)

    def run_tmemrand(self, seed):
        self.state.tmem[:] = big_endian(xorshift(seed, 1024))

    def run_tlutrand(self, seed):
        entries = np.repeat(xorshift(seed, 256) >> 16, 4)
        self.state.tmem[0x800:] = big_endian(entries, ">u2")

    def run_rdramrand(self, seed):
        self.state.dram[RANDOM] = big_endian(xorshift(seed, 8192))

    def run_mode(self, *pairs):
        for name, value in pairs:
            setattr(self.state.modes, FIELDS[name], value)

    def run_convert(self, *k):
        self.state.k = list(k)

    def run_tile(self, n, form, size, line, tmem, palette, *rest):
        cs, ms, masks, shs, ct, mt, maskt, sht, sl, tl, sh, th = rest
        self.state.tiles[n] = Tile(form, size, line, tmem, palette,
                                   Axis(cs, ms, masks, shs, sl, sh),
                                   Axis(ct, mt, maskt, sht, tl, th))

    def run_rdp(self, *words):
        for hi, lo in zip(words[::2], words[1::2]):
            commands.run(self.state, hi, lo)

    def run_tmemhash(self):
        return [fnv(self.state.tmem.tobytes())]

    def run_fetch(self, tile, s, t):
        return list(fetch(self.state, self.state.tiles[tile], s, t) & 511)

    def run_sample(self, tile, s, t, cycle):
        return list(sample(self.state, tile, np.array(s), np.array(t), cycle))

    def run_sample2(self, t0, t1, s, t):
        s, t = np.array(s), np.array(t)
        first = sample(self.state, t0, s, t)
        return [*first, *sample(self.state, t1, s, t, 1, first)]

    def run_persp(self, s, t, w):
        result = divide(np.array(s), np.array(t), np.array(w), True)
        return [None, None, int(result.s), int(result.t)]  # the first two are not compared

    def run_pix2(self, s, t, w, *rest):
        state = self.state
        *steps, state.primitive_tile, state.max_level, state.min_level = rest
        at = level(state, *(np.array(c) for c in (s, t, w)), Gradients(*steps))
        first = sample(state, int(at.tile0), at.s, at.t)
        return [*at[:4], at.fraction, *first,
                *sample(state, int(at.tile1), at.s, at.t, 1, first)]

    def run_copy(self, tile, s, t):
        a, b, c, d = copy(self.state, tile, np.array(s), np.array(t))
        return [a << 16 | b, c << 16 | d]


def differences(path: Path):
    """Returns (line, answer) of the questions of a file whose answers differ from the file's, and
    the number of questions."""
    reference, wrong, count = Reference(), [], 0
    for line in read(path):
        answer = reference.answer(line)
        if not line.expected:
            continue
        count += 1
        answer = [want if got is None else int(got)
                  for got, want in zip(answer, line.expected, strict=True)]
        if answer != list(line.expected):
            wrong.append((line, answer))
    return wrong, count
