"""The integer model's chain of two registers, by which u and v are stepped along pieces: src68k/include/far.i."""

import numpy as np

from tmap.base.fixed import M32, swap


def steps(du: int, dv: int, carry: int) -> tuple[int, int]:
    """Returns the steps of B and A from those of u and v, 8.24."""
    u, v = du + carry & M32, swap(dv & M32)
    u = (u << 8 | u >> 24) & M32
    return u & 0xFFFF0000 | v & 0xFFFF, v & 0xFFFF0000 | u & 0xFFFF


def piece(state: tuple[int, int], du: int, dv: int, count: int, bs: list[int], as_: list[int]) -> tuple[int, int]:
    """Steps the chain's registers B and A for ``count`` pixels by du and dv, 8.24, and appends them; returns their
    state."""
    b, a = state
    db, da = steps(du, dv, 0)
    a += da & 0xFFFF0000
    for _ in range(count):
        bs.append(b)
        as_.append(a)
        b += db + (a >> 32)
        ahead = a & 0xFFFF0000
        a = (a & M32) + da + (b >> 32)
        b &= M32
    return b, ahead | a & 0xFFFF


def values(b: np.ndarray, a: np.ndarray, u: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of pixels from the registers, which are near ``u`` and ``v``, 8.24."""
    return lift((a & 0xFF) << 16 | b >> 16, u), lift((b & 0xFFFF) << 8, v, 255)


def begun(u: int, v: int) -> tuple[int, int]:
    """Returns the chain's registers B and A for u and v, 8.24."""
    b, a = steps(u, v, 0)
    return b, a & 0xFFFF00FF


def lift(x: np.ndarray, near: np.ndarray, hidden: int = 0) -> np.ndarray:
    """Extends x, 8.16, to the 16.16 numbers, modulo 2^32, that are nearest to ``near``, which has 24
    fraction bits. The result may be up to ``hidden`` above x."""
    near = near >> 8
    x = near + (x - near + (1 << 23) & 0xFFFFFF) - (1 << 23)
    return np.minimum(np.maximum(near, x), x + hidden) & M32
