"""How far the vertices of a polygon with depth are from the planes through three of them."""

from collections.abc import Iterator
from fractions import Fraction

from tmap.ideal import ideal, perspective


def off_surface(vertices, texel: Fraction) -> Iterator[tuple[str, Fraction, Fraction]]:
    """Yields (what, error, the most that rounding explains) of 1/w, u and v at each vertex (x, y,
    u, v, w), in units; ``texel``: the rounding of u and v. Derived in
    tools/tmap/corpus/hard_depths.py."""
    three = [vertices[k] for k in ideal.corners(vertices)]
    points = [v[:2] for v in three]
    parts = [ideal.Plane(points, [int(k == n) for n in range(3)]) for k in range(3)]
    inexact = [Fraction(1, v[4] * (2 * v[4] - 1)) for v in three]
    curves = perspective.curves(vertices)
    for k, (x, y, *texels, w) in enumerate(vertices):
        b = [part.at(x, y) for part in parts]
        q = sum(share / corner[4] for share, corner in zip(b, three))
        shift = sum(abs(share) * r for share, r in zip(b, inexact))
        yield f"1/w of {k}", abs(Fraction(1, w) - q), shift + Fraction(1, w * (2 * w - 1))
        for noun, key, here, curve in zip("uv", (2, 3), texels, curves):
            if q > 0:
                moved = sum(abs(share) * (texel / corner[4] + r * (abs(corner[key] - here) + 2 * texel))
                            for share, corner, r in zip(b, three, inexact)) / q
                yield f"{noun} of {k}", abs(here - curve.at(x, y)), texel + moved
