"""Bench rows of the N64's passes, and how a pass is called."""

import numpy as np

from tmap.bench.examples import n64
from tmap.bench.examples.example import Example
from tmap.guest.kernels import Arena, Case, Result

LENGTH = 256


def names(examples) -> list[str]:
    """What is measured of a module of examples: its passes in assembly."""
    return [name for name in examples.MAKERS if name not in examples.IN_C_ALONE]


NAMES = names(n64)


def place(example: Example, kernel: str, arena: Arena, far: Arena) -> tuple[Case, dict[int, bytes]]:
    """The call of a pass, with input, output, texels and tables in the far arena; and what
    it must write there."""
    source, out = far.add(example.source), far.add(bytes(example.size))
    written, constants = {out: example.image(bytes(example.size))}, {}
    if example.table:
        constants["constants"] = arena.add(example.table)
    if example.struct:
        pointers = {name: far.add(block, example.align) + example.within.get(name, 0)
                    for name, block in example.blocks.items()}
        for name, block in example.more.items():
            pointers[name] = far.add(bytes(len(block)))
            written[pointers[name]] = block
        constants["constants"] = arena.struct(example.struct, {}, pointers, **{
            name: value if isinstance(value, list) else int(value)
            for name, value in example.values.items()})
    if kernel.endswith("_c"):
        more = {} if constants else {"constants": 0}
        call = arena.struct("pass_call", constants, {"in": source, "out": out},
                            count=example.count, **more)
        return Case(kernel, arena, pointers={"a0": call}, far=far), written
    return Case(kernel, arena, registers={"d0": example.count},
                pointers={"a2": at for at in constants.values()}, far=far,
                far_pointers={"a0": source, "a1": out}), written


def example_of(examples, name: str, rng, count: int) -> tuple[Example, str]:
    """An example of a pass, and the routine it is for."""
    example = examples.MAKERS[name.removesuffix("_c")](rng, count)
    return example, examples.FORMS.get(name, name)


def pass_case(name: str, examples=n64):
    """One line of LENGTH pixels."""
    example, kernel = example_of(examples, name, np.random.default_rng(LENGTH), LENGTH)
    case, written = place(example, kernel, Arena(), Arena())

    def check(result: Result) -> str | None:
        for at, block in written.items():
            for n, (found, expected) in enumerate(zip(result.far_memory[at:], block)):
                if found != expected:
                    return f"byte {n} of an output is {found:#04x}, expected {expected:#04x}"
        return None

    return LENGTH, case, check
