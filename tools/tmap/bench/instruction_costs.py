"""Bench rows of single instructions: what each takes on the emulated machine, 16 of them in a loop that
the instruction cache holds.

A row counts the loop's dbra too; ``prices`` take it off.
"""

from tmap.base import markdown
from tmap.guest.kernels import Arena, Case, Result

IN_LOOP = 16
ROUNDS = 64
COUNT = IN_LOOP * ROUNDS
ROW = "instruction_"
NONE, LOOP = "none", "dbra"
DBRA = bytes.fromhex("51cf")  # dbra d7
RTS = bytes.fromhex("4e75")
#: Row: instruction, its words in hexadecimal. d1 is 3, d2 is 0, a0 and a1 are the data's address.
INSTRUCTIONS = {
    "move": ("move.l d1,d0", "2001"), "movea": ("movea.l d1,a2", "2441"),
    "add": ("add.l d1,d0", "d081"), "addx": ("addx.l d1,d0", "d181"),
    "and": ("and.l d1,d0", "c081"), "swap": ("swap d0", "4840"), "exg": ("exg d0,d1", "c141"),
    "lsl": ("lsl.l #8,d0", "e188"), "asr": ("asr.l #8,d0", "e080"),
    "lea": ("lea (a0,d2.w),a2", "45f02000"), "branch": ("bra.w to the next", "60000002"),
    "mulu_w": ("mulu.w d1,d0", "c0c1"), "muls_l": ("muls.l d1,d0", "4c010800"),
    "muls_64": ("muls.l d1,d3:d0", "4c010c03"), "divu_w": ("divu.w d1,d0", "80c1"),
    "divs_l": ("divs.l d1,d0", "4c410800"), "divu_64": ("divu.l d1,d2:d0", "4c410402"),
    "read": ("move.b (a0),d0", "1010"), "read_index": ("move.b (a0,d2.w),d0", "10302000"),
    "read_long": ("move.l (a0),d0", "2010"), "write": ("move.b d0,(a1)", "1280"),
    "write_long": ("move.l d0,(a1)", "2280")}


def code(words: str, count: int = IN_LOOP) -> bytes:
    """The instruction so many times, a dbra back to the first one, and the return."""
    body = bytes.fromhex(words) * count
    return body + DBRA + (-len(body) - 2 & 0xFFFF).to_bytes(2, "big") + RTS


def calls() -> list[tuple]:
    """Name, length and call of each row; its loop must be gone through to its end."""
    def check(result: Result) -> str | None:
        return None if result.registers["d7"] & 0xFFFF == 0xFFFF else "the code did not count down"

    def case(words: str, count: int, rounds: int) -> Case:
        arena, far = Arena(), Arena()
        code_at, data_at = arena.add(code(words, count)), far.add(bytes(16))
        registers = {"d0": 0x12345, "d1": 3, "d2": 0, "d7": rounds - 1}
        return Case("instructions", arena, registers=registers, pointers={"a4": code_at},
                    far=far, far_pointers={"a0": data_at, "a1": data_at})

    kinds = {NONE: ("", 0, ROUNDS), LOOP: ("", 0, COUNT)}
    kinds |= {name: (words, IN_LOOP, ROUNDS) for name, (_, words) in INSTRUCTIONS.items()}
    return [(ROW + name, COUNT, (COUNT, case(*how), check)) for name, how in kinds.items()]


def prices(baseline: dict) -> dict[tuple[str, str], float]:
    """Cycles of an instruction, by row and machine: without the loop."""
    found = {(row["name"].removeprefix(ROW), row["machine"]): row["cycles_per_instruction"]
             for row in baseline["instructions"]}
    made = {}
    for (name, machine), cycles in found.items():
        more = cycles - found[NONE, machine]
        made[name, machine] = more * COUNT / (COUNT - ROUNDS) if name == LOOP else more
    return made


def table(baseline: dict, machines: dict[str, str]) -> str:
    """Markdown: cycles of each instruction on each machine; ``machines``: names to titles."""
    found = prices(baseline)
    titles = {name: title for name, (title, _) in INSTRUCTIONS.items()} | {LOOP: "dbra, taken"}
    return markdown.table(["instruction", *machines.values()],
                          [[f"`{title}`", *(f"{found[name, machine]:.1f}" for machine in machines)]
                           for name, title in titles.items()])
