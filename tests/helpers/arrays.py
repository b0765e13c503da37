"""Arrays of numbers against those that are expected, and what a failure tells of them."""

import numpy as np


def first_wrong(expected: np.ndarray, found: np.ndarray) -> str:
    """The first pixel of two frames that differ."""
    y, x = np.argwhere(found != expected)[0]
    digits = 2 + 2 * expected.itemsize
    return f"pixel ({x}, {y}) is {found[y, x]:#0{digits}x}, not {expected[y, x]:#0{digits}x}"


def check_equal(found, expected, what: str = "") -> None:
    """Fails where arrays, one of which may be spread over the other, differ or are empty: how many
    numbers, where the first one is, expected and found."""
    __tracebackhide__ = True
    found, expected = np.broadcast_arrays(found, expected)
    assert found.size, f"{what}: nothing to compare"
    wrong = np.argwhere(found != expected)
    if len(wrong):
        at = tuple(wrong[0].tolist())
        raise AssertionError(f"{what}: {len(wrong)} of {found.size} numbers differ; the first at "
                             f"{at}: expected {expected[at]}, found {found[at]}")


def check_within(found, expected, bound, what: str = "") -> None:
    """The same where numbers are farther apart than ``bound``, a number or an array: of these the
    one that is farthest beyond."""
    __tracebackhide__ = True
    found, expected, bound = np.broadcast_arrays(found, expected, bound)
    assert found.size, f"{what}: nothing to compare"
    beyond = abs(np.subtract(found, expected, dtype=float)) - bound
    if not (beyond <= 0).all():
        at = tuple(map(int, np.unravel_index(np.argmax(np.nan_to_num(beyond, nan=np.inf)), beyond.shape)))
        raise AssertionError(
            f"{what}: {np.count_nonzero(~(beyond <= 0))} of {found.size} numbers are off by too "
            f"much; the worst at {at}: expected {expected[at]}, found {found[at]}, at most "
            f"{bound[at]} apart")
