"""Bench rows of the texture engine's passes: in assembly, and in plain C beside it."""

import numpy as np

from . import tx_examples
from .kernels import Arena, Case, Result
from .tx_examples import Example

LENGTH = 256
NAMES = [name + end for name in tx_examples.MAKERS if name not in tx_examples.IN_C_ALONE
         for end in ("", "_c") if not end or name not in tx_examples.FORMS]


def place(example: Example, kernel: str, arena: Arena, far: Arena) -> tuple[Case, int]:
    """The call of a pass, with input, output, texels and tables in the far arena; and where
    its output is there."""
    kernel = tx_examples.FORMS.get(kernel, kernel)
    source, out = far.add(example.source), far.add(bytes(len(example.expected)))
    constants = {}
    if example.struct:
        pointers = {name: far.add(block) for name, block in example.blocks.items()}
        constants["constants"] = arena.struct(example.struct, {}, pointers, **{
            name: value if isinstance(value, list) else int(value)
            for name, value in example.values.items()})
    if kernel.endswith("_c"):
        more = {} if constants else {"constants": 0}
        call = arena.struct("tx_call", constants, {"in": source, "out": out},
                            count=example.count, **more)
        return Case(kernel, arena, pointers={"a0": call}, far=far), out
    return Case(kernel, arena, registers={"d0": example.count},
                pointers={"a2": at for at in constants.values()}, far=far,
                far_pointers={"a0": source, "a1": out}), out


def pass_case(name: str):
    """One line of LENGTH pixels."""
    example = tx_examples.MAKERS[name.removesuffix("_c")](np.random.default_rng(LENGTH), LENGTH)
    case, out = place(example, name, Arena(), Arena())

    def check(result: Result) -> str | None:
        found = result.far_memory[out:out + len(example.expected)]
        if found == example.expected:
            return None
        at = next(n for n, pair in enumerate(zip(found, example.expected)) if pair[0] != pair[1])
        return f"byte {at} of the output is {found[at]:#04x}, expected {example.expected[at]:#04x}"

    return LENGTH, case, check
