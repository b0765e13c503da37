"""The families of polygons that the fuzzer draws."""

from argparse import ArgumentParser

ALL = "all"
PERSPECTIVE = "perspective"
N64, GLIDE = "n64", "glide"
#: Each with what its polygons are.
FAMILIES = {ALL: "any polygon of the mapper under any setting", PERSPECTIVE: "polygons whose depth differs, in perspective",
            N64: "polygons and rectangles of the N64's texture engine", GLIDE: "polygons of Glide's texture units"}


def add_arguments(command: ArgumentParser) -> None:
    """Adds the options of ``tmap fuzz`` but for the machine's."""
    command.add_argument("--family", choices=tuple(FAMILIES), default=ALL,
                         help="; ".join(f"{name}: {what}" for name, what in FAMILIES.items()))
    command.add_argument("--seed", type=int, default=1, metavar="N", help="which polygons (1)")
    command.add_argument("--count", type=int, default=20_000, metavar="N", help="how many (20000)")
    command.add_argument("--first", type=int, default=0, metavar="N", help="from which on (0)")
    command.add_argument("--keep", metavar="NAME",
                         help="add the smallest failing polygon to the hard cases, if it is the mapper's")
    command.add_argument("--record", action="store_true", help="add the run to the page's table of them")


def named(seed: int, number: int, family: str) -> str:
    """Returns the name of a polygon in messages."""
    return f"seed {seed}, polygon {number}" + (f" of {family}" if family != ALL else "")


def again(seed: int, number: int, family: str, machine: str) -> str:
    """Returns the command that draws a polygon once more."""
    return (f"scripts/tmap fuzz{f' --family {family}' if family != ALL else ''} --seed {seed} --first {number} "
            f"--count 1 --machine {machine}")
