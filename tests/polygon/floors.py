"""Affine polygons whose s or t depends on y alone: u or v is constant along a line."""

#: Polygons: vertices [x, y, s, t] where s or t depends on y alone.
FLOORS = {
    "upright": [[3.3, 5.2, 10, 7], [90.1, 5.2, 70, 7], [90.1, 60.7, 70, 40], [3.3, 60.7, 10, 40]],
    "mirrored": [[3, 5, 200, 90], [90, 5, 20, 90], [90, 60, 20, 40], [3, 60, 200, 40]],
    "over v's wrap": [[3, 5, 10, 200], [90, 5, 700, 200], [90, 60, 700, 310], [3, 60, 10, 310]],
    "62 texels a pixel": [[0, 0, 0, 0], [96, 0, 5951, 0], [96, 64, 5951, 99], [0, 64, 0, 99]],
    "beyond the frame": [[-40, -9, 5, 3], [150, -9, 250, 3], [99, 80, 250, 99], [-3, 80, 5, 99]][:3],
    "one texel": [[3, 5, 10, 7], [90, 5, 10, 7], [90, 60, 10, 7], [3, 60, 10, 7]],
}


def turned(corners: list[list[float]]) -> list[list[float]]:
    """Exchanges s and t."""
    return [[x, y, t, s] for x, y, s, t in corners]
