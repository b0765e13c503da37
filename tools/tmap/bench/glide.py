"""Bench rows of the passes for Glide's texture unit."""

from tmap.bench import n64
from tmap.bench.examples import glide

NAMES = n64.names(glide)


def pass_case(name: str):
    """One line of n64.LENGTH pixels."""
    return n64.pass_case(name, glide)
