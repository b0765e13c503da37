"""``python -m tools.knot``: the torus knot of tests/scenes/environment.toml, as a Wavefront OBJ
on standard output: a tube round the (2, 3) knot, all quadrilaterals, without texture
coordinates and normals.
"""

import math

import numpy as np

ALONG, AROUND = 48, 8  # rings along the knot, corners of a ring
RADIUS = 0.42  # of the tube; the knot reaches from 1 to 3


def centre(angle: float) -> np.ndarray:
    """A point of the knot's line, for 0 to 2 pi."""
    reach = 2 + math.cos(3 * angle)
    return np.array([reach * math.cos(2 * angle), reach * math.sin(2 * angle), math.sin(3 * angle)])


def ring(angle: float) -> list[np.ndarray]:
    """The corners of a ring, counterclockwise seen against the knot's way; the first one
    points away from the knot's axis."""
    along = centre(angle + 1e-4) - centre(angle - 1e-4)
    along /= np.linalg.norm(along)
    out = centre(angle) * (1, 1, 0)
    out -= along * (out @ along)
    out /= np.linalg.norm(out)
    side = np.cross(along, out)
    turns = (math.tau * k / AROUND for k in range(AROUND))
    return [centre(angle) + RADIUS * (math.cos(t) * out + math.sin(t) * side) for t in turns]


def text() -> str:
    """The OBJ file."""
    lines = [f"# A tube round the (2, 3) torus knot: python -m tools.knot, {ALONG} x {AROUND}"]
    for i in range(ALONG):
        lines += ["v " + " ".join(f"{c:.4f}" for c in point)
                  for point in ring(math.tau * i / ALONG)]
    for i in range(ALONG):
        here, there = i * AROUND + 1, (i + 1) % ALONG * AROUND + 1
        lines += [f"f {here + k} {here + n} {there + n} {there + k}"
                  for k, n in ((k, (k + 1) % AROUND) for k in range(AROUND))]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(text(), end="")
