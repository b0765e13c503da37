"""Products with small constants as shifts and additions, for the filters' generated code.

A weight is written in digits -1, 0 and 1, the lowest power first. A weighted sum of registers is
then one chain of additions and shifts, from the highest power down.
"""

from collections.abc import Sequence
from functools import cache
from itertools import product

Digits = tuple[int, ...]


@cache
def forms(weight: int, digits: int, more: int = 1) -> tuple[Digits, ...]:
    """Returns the sums of powers of two that give a weight. Those with over ``more`` digits more
    than the shortest are left out."""
    found = [form for form in product((-1, 0, 1), repeat=digits)
             if sum(digit << n for n, digit in enumerate(form)) == weight]
    fewest = min(sum(map(abs, form)) for form in found)
    return tuple(form for form in found if sum(map(abs, form)) <= fewest + more)


def shifted(register: str, bits: int) -> list[str]:
    """Returns code that multiplies a register by 2^bits."""
    return [] if not bits else [
        f"add.l {register},{register}" if bits == 1 else f"lsl.l #{bits},{register}"]


def horner(terms: Sequence[tuple[Digits, str]], out: str) -> list[str] | None:
    """Returns code that computes ``out`` from registers and their weights' digits; None if it would
    begin by subtracting."""
    code: list[str] = []
    due = 0
    for n in reversed(range(len(terms[0][0]))):
        for digits, register in terms:
            if not digits[n]:
                continue
            if not code and digits[n] < 0:
                return None
            code += shifted(out, due if code else 0)
            name = "move" if not code else "add" if digits[n] > 0 else "sub"
            code.append(f"{name}.l {register},{out}")
            due = 0
        due += bool(code)
    return code + shifted(out, due - 1 if code else 0)


def cycles(code: list[str]) -> int:
    """Returns a relative cost of instructions in the cache: lsl costs two, others one."""
    return sum(2 if "lsl" in line else 1 for line in code)


def in_place(code: list[str], register: str, out: str) -> bool:
    """Returns true if the code begins by copying a register to ``out`` and never reads it again."""
    return bool(code) and code[0] == f"move.l {register},{out}" and not any(
        f" {register}," in line for line in code[1:])


def shortest(codes) -> list[str]:
    """Returns the shortest code, the fastest of equally short ones; None entries are skipped."""
    return min((code for code in codes if code is not None),
               key=lambda code: (len(code), cycles(code)))
