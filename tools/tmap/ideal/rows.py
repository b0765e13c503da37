"""Rows of pixels, all in the same arrays: what is checked line by line is computed for a whole polygon at once."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np


@dataclass
class Rows:
    """Rows of adjacent pixels: columns ``lefts`` to ``ends`` - 1 of lines ``ys``, int64, one pixel or more each."""

    ys: np.ndarray
    lefts: np.ndarray
    ends: np.ndarray

    @classmethod
    def of(cls, columns: np.ndarray, y: int) -> "Rows":
        """Returns one row of adjacent pixels."""
        return cls(np.array([y]), np.array([columns[0]]), np.array([columns[-1] + 1]))

    def __len__(self) -> int:
        return len(self.ys)

    @cached_property
    def counts(self) -> np.ndarray:
        """The pixels of each row."""
        return self.ends - self.lefts

    @cached_property
    def starts(self) -> np.ndarray:
        """The index of each row's first pixel in arrays of all pixels."""
        return np.cumsum(self.counts) - self.counts

    @cached_property
    def columns(self) -> np.ndarray:
        """The column of each pixel."""
        return np.arange(int(self.counts.sum())) + self.spread(self.lefts - self.starts)

    def spread(self, values) -> np.ndarray:
        """Returns the rows' values for each of their pixels."""
        return np.repeat(values, self.counts)

    def part(self, number: int) -> slice:
        """Returns the pixels of a row."""
        start = int(self.starts[number])
        return slice(start, start + int(self.counts[number]))

    def most(self, values: np.ndarray) -> np.ndarray:
        """Returns the largest of each row's pixels' values."""
        return np.maximum.reduceat(values, self.starts)

    def some(self, flags: np.ndarray) -> np.ndarray:
        """Returns which rows have a pixel with a flag."""
        return np.logical_or.reduceat(flags, self.starts)

    def inside(self, drawn: "Rows") -> np.ndarray:
        """Returns the indices of the rows' pixels among those of longer rows, which contain them."""
        return self.columns + self.spread(drawn.starts - drawn.lefts)
