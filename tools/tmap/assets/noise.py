"""Noise for computed pictures: it repeats at every border, and its seed says all of it."""

import numpy as np

from tmap.base.elementary import each, power as power_of


def noise(height: int, width: int, power: float, seed: int, lowest: int = 0) -> np.ndarray:
    """White noise whose waves of n periods along the longer side are weakened to n^-power, and
    those of less than ``lowest`` left out; the mean is 0, the standard deviation 1."""
    white = np.random.default_rng(seed).standard_normal((height, width))
    periods = max(height, width) * np.hypot(np.fft.fftfreq(height)[:, None],
                                            np.fft.rfftfreq(width)[None])
    periods[0, 0] = 1
    waves = np.fft.rfft2(white) * each(power_of, periods, -power) * (periods >= lowest)
    made = np.fft.irfft2(waves, (height, width))
    made -= made.mean()
    return made / made.std()


def grain(height: int, width: int, power: float, seed: int) -> np.ndarray:
    """The same from 0 to 1."""
    made = noise(height, width, power, seed)
    return (made - made.min()) / np.ptp(made)


def smeared(made: np.ndarray) -> np.ndarray:
    """Noise drawn out downwards over four texels, as wood is."""
    return sum(np.roll(made, k, 0) for k in range(4)) / 2.2


def tinted(tint: tuple[float, float, float], light: np.ndarray) -> np.ndarray:
    """A colour in the light of each texel: height, width, 3."""
    return np.array(tint) * light[..., None]
