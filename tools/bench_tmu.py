"""Bench rows of the passes for Glide's texture unit: in assembly, and in plain C beside it."""

from . import bench_tx, tmu_examples

NAMES = bench_tx.names(tmu_examples)


def pass_case(name: str):
    """One line of bench_tx.LENGTH pixels."""
    return bench_tx.pass_case(name, tmu_examples)
