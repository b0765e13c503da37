"""Calls of the passes of both texture units."""

import numpy as np

from tmap.bench.trial import Trial, Write
from tmap.guest.kernels import Arena, Case

LENGTH = 256


def names(examples) -> list[str]:
    """What is measured of a module of examples: its passes in assembly."""
    return [name for name in examples.MAKERS if name not in examples.IN_C_ALONE]


def pass_trial(name: str, rng, count: int, arena: Arena, far: Arena, title: str,
               examples, in_place: bool = False) -> Trial:
    """A pass on ``count`` pixels: input, output, texels and tables are in the far arena. ``in_place``: the output
    replaces the input."""
    example = examples.MAKERS[name.removesuffix("_c")](rng, count)
    kernel = examples.FORMS.get(name, name)
    source = far.add(example.source)
    out = source if in_place else far.add(bytes(example.size))
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
        case = Case(kernel, arena, pointers={"a0": call}, far=far)
    else:
        case = Case(kernel, arena, registers={"d0": example.count},
                    pointers={"a2": at for at in constants.values()}, far=far,
                    far_pointers={"a0": source, "a1": out})

    def where(offset: int, is_far: bool) -> str | None:
        for at, block in written.items():
            pixel, byte = divmod(offset - at, max(len(block) // count, 1))
            if is_far and 0 <= offset - at < len(block):
                return f"pixel {pixel}, byte {byte} of an output"
        return None

    return Trial(case, title, where=where,
                 writes=[Write(at, block, far=True) for at, block in written.items()])


def pass_case(name: str, examples):
    """One line of LENGTH pixels."""
    return pass_trial(name, np.random.default_rng(LENGTH), LENGTH, Arena(), Arena(), "",
                      examples).row(LENGTH)
