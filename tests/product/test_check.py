"""What ``make check`` chooses."""

import pytest

from tests.helpers import check


@pytest.mark.parametrize("file, kernels", [
    ("src68k/span/affine_swap.s", {"span_affine_swap"}),
    ("src68k/include/far.i", {"span_far_left", "span_cubic_right"}),  # by another include
    ("c/drawing/deep.h", set())])
def test_kernels_of_changed_files_are_tried(file: str, kernels: set[str]) -> None:
    found = set(check.touched_kernels({file}))
    assert kernels <= found and bool(found) == bool(kernels)
    assert "span_fill" not in found


def test_files_that_import_a_changed_module_are_run() -> None:
    assert check.concerned({"tools/tmap/trees/bsp.py", "README.md"}) == ["tests/mesh/test_trees.py"]
    assert check.concerned({"tests/mesh/test_fog.py"}) == ["tests/mesh/test_fog.py"]


def test_what_always_runs_is_there() -> None:
    for place in check.ALWAYS:
        file, _, name = place.partition("::")
        assert f"def {name}" in (check.ROOT / file).read_text(), place
