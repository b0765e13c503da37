"""The integer model's chain of two registers, by which u and v are stepped along pieces: src68k/include/far.i."""

from tmap.base.fixed import M32, swap


def steps(du: int, dv: int, carry: int) -> tuple[int, int]:
    """Returns the steps of B and A from those of u and v, 8.24."""
    u, v = du + carry & M32, swap(dv & M32)
    u = (u << 8 | u >> 24) & M32
    return u & 0xFFFF0000 | v & 0xFFFF, v & 0xFFFF0000 | u & 0xFFFF


def piece(state: tuple[int, int], at, du: int, dv: int, count: int):
    """Steps the chain's registers B and A for ``count`` pixels by du and dv, 8.24; returns their state, the sums
    of the steps from ``at`` on, and u and v of the pixels."""
    (b, a), us, vs = state, [], []
    db, da = steps(du, dv, 0)
    a += da & 0xFFFF0000
    for _ in range(count):
        us.append(lift((a & 0xFF) << 16 | b >> 16, at[0]))
        vs.append(lift((b & 0xFFFF) << 8, at[1], 255))
        at = at[0] + du, at[1] + dv
        b += db + (a >> 32)
        ahead = a & 0xFFFF0000
        a = (a & M32) + da + (b >> 32)
        b &= M32
    return (b, ahead | a & 0xFFFF), at, us, vs


def begun(u: int, v: int) -> tuple[int, int]:
    """Returns the chain's registers B and A for u and v, 8.24."""
    b, a = steps(u, v, 0)
    return b, a & 0xFFFF00FF


def lift(x: int, near: int, hidden: int = 0) -> int:
    """Extends x, 8.16, to the 16.16 number, modulo 2^32, that is nearest to ``near``, which has 24
    fraction bits. The result may be up to ``hidden`` above x."""
    near >>= 8
    x = near + (x - near + (1 << 23) & 0xFFFFFF) - (1 << 23)
    return min(max(near, x), x + hidden) & M32
