"""The contract parser, tested with broken blocks and with the real tree."""

import re

import pytest

from tmap.base import paths
from tmap.base.errors import UserError
from tmap.build import contracts

FIELDS = {
    "in": "d0  int32  a\n;          a1  const struct plan*  the plan,\n;                  all of it",
    "out": "d0:d1  wide  product",
    "trashes": "d0-d2/a1",
    "reads": "the plan",
    "writes": "memory",
    "formats": "16.16\n;            x = a / b",
    "error": "none: exact",
    "cost": "about 50 cycles",
}


def source(code="        routine scale,d0,a1\n        rts\n", title="scale - scales a plan", **changes):
    """A file with one routine; a field given as None is left out."""
    fields = {name: text for name, text in (FIELDS | changes).items() if text is not None}
    block = [f"; {title}", ";", *(f"; {name + ':':<9}{text}" for name, text in fields.items())]
    return "\n".join(['        include "routine.i"', "", *block, code])


@pytest.fixture
def parse(tmp_path):
    """Parses a text as a source file."""
    def run(text):
        path = tmp_path / "scale.s"
        path.write_text(text)
        return contracts.complete(contracts.read(path))
    return run


def complaint(parse, text):
    """The error for a text, which must name the file and one of its lines."""
    with pytest.raises(UserError) as caught:
        parse(text)
    place, message = str(caught.value).split(": ", 1)
    file, number = place.rsplit(":", 1)
    assert file.endswith("scale.s") and 1 <= int(number) <= len(text.splitlines())
    return message


def test_good_block(parse):
    contract, = parse(source())
    assert (contract.name, contract.summary, contract.line) == ("scale", "scales a plan", 3)
    assert contract.inputs == (("d0", "int32", "a"),
                               ("a1", "const struct plan*", "the plan, all of it"))
    assert contract.outputs == (("d0:d1", "wide", "product"),)
    assert contract.trashes == {"d0", "d1", "d2", "a1"}
    assert (contract.reads, contract.writes) == ("the plan", "memory")
    assert contract.formats == "16.16 x = a / b"
    assert contract.error == "none: exact"
    assert contract.cost == "about 50 cycles"
    assert contract.registers == ("d0", "a1")


def test_nothing_or_everything_trashed(parse):
    nothing, everything = (parse(source(trashes=text))[0].trashes for text in ("-", "everything"))
    assert nothing == set() and len(everything) == 15 and "a7" not in everything


def test_fields_may_be_left_out(parse):
    contract, = parse(source("        routine scale\n", **dict.fromkeys(FIELDS)))
    assert contract.inputs == contract.outputs == () and contract.trashes == {"d0", "d1", "a0", "a1"}
    assert contract.reads == contract.writes == contract.formats == contract.error == contract.cost == ""


def test_like_another_routine(parse):
    """Fields that a block does not give are the other routine's, except its cost."""
    text = source("        routine grow,d0,a1\n", "grow - grows a plan",
                  **dict.fromkeys(FIELDS) | {"error": "a unit"})
    text = text.replace(";\n; error", ";\n; like:    scale\n; error") + source()
    grow, scale = parse(text)
    for field in set(contracts.INHERITED) - {"error"}:
        assert getattr(grow, field) == getattr(scale, field) != ""
    assert (grow.error, grow.cost) == ("a unit", "")
    for wrong in ("shrink", "grow"):
        assert f"no other routine {wrong}" in complaint(parse, text.replace("like:    scale",
                                                                            f"like:    {wrong}"))
    assert "field 'error' says nothing" in complaint(parse, text.replace("a unit", "none: exact"))
    grow, _ = parse(text.replace("; error:   a unit",
                                 "; in:      d0  int32  b\n; out:     a0  void*  c"))
    assert grow.inputs == (("d0", "int32", "b"), scale.inputs[1])
    assert grow.outputs == (*scale.outputs, ("a0", "void*", "c"))
    assert "d0 says nothing" in complaint(parse, text.replace("error:   a unit", "in:      d0  int32  a"))


def test_defaults_of_a_kernel(tmp_path):
    """A kernel without error or cost has no error and the bench row of its name."""
    path = tmp_path / "span" / "scale.s"
    path.parent.mkdir()
    path.write_text(source(error=None, cost=None).replace("scale", "span_scale"))
    contract, = contracts.complete(contracts.read(path))
    assert (contract.error, contract.cost) == ("none", "bench row scale")
    path.write_text(path.read_text().replace("x = a / b\n", "x = a / b\n; error:   none\n"))
    with pytest.raises(UserError, match="field 'error' says nothing"):
        contracts.complete(contracts.read(path))


@pytest.mark.parametrize("text, message", [
    *((source(**{field: "-"}), f"field {field!r} says nothing")
      for field in sorted(FIELDS.keys() - {"trashes"})),
    *((source(**{field: ""}), f"field {field!r} is empty") for field in FIELDS),
    *((source(**changes), message) for changes, message in (
        ({"in": "d8  int32  a"}, "in: 'd8' is no register"),
        ({"in": "a7  int32  a"}, "in: 'a7' is no register"),
        ({"out": "d0:e1  int32  a"}, "out: 'd0:e1' is no register"),
        ({"out": "d0:d1:d2  wide  a"}, "out: 'd0:d1:d2' is no register"),
        ({"in": "d0  int32"}, "in: d0 needs a C type and a meaning"),
        ({"in": "d0 int32 a"}, "in: 'd0 int32 a' is no register"),
        ({"trashes": "d0-a1"}, "trashes: 'd0-a1' is no register or range"),
        ({"trashes": "d2-d0"}, "trashes: 'd2-d0' is no register or range"),
        ({"trashes": "d0,d1"}, "trashes: 'd0,d1' is no register or range"),
        ({"colour": "blue"}, "unknown field 'colour'"),
        ({"cost": "none\n; cost:    none"}, "second field 'cost'"),
        ({"title": "scale: scales a plan"}, "routine scale has no contract block"),
        ({"title": "Before:\n; scale - scales a plan"}, "routine scale has no contract block"))),
    (source(cost=None).replace("; reads:", "; cost:    none\n; reads:"), "order"),
    (source("        routine scale,a1,d0\n"), "scale: takes a1, d0 from C"),
    (source("grow:   rts\n"), "no routine scale"),
    (source("") + source(), "second contract block"),
    *((source(code), "routine shrink has no contract block") for code in (
        "        routine scale,d0,a1\n        rts\n        routine shrink,d0 ; comment\n",
        "        xdef grow,shrink\nscale:  rts\nshrink  moveq #0,d0\n",
        "        xdef shrink\nscale:\n        bra.s .on\n.on     jmp (a0)\nshrink:\n        rts\n",
        "        routine shrink\n")),
])
def test_wrong_blocks(parse, text, message):
    assert message in complaint(parse, text)


def test_assembly_only_routine(parse):
    """Arguments that C cannot pass: the macro then names no register at all."""
    assert parse(source("        routine scale\n        rts\n"))[0].registers == ()


@pytest.mark.parametrize("code", [
    "        xdef shrink\nscale:\n        moveq #0,d0\nshrink: rts\n",           # second entry
    "scale:  rts\nshrink: rts\n",                                                # not exported
    "        xdef table,size\nscale:  rts\ntable   dc.b 1\nsize    equ 5\n",     # no code
    "        xdef table\nscale:  rts\ntable:\n        dc.b 1\n",
    "        xdef table\nscale:  rts\n        section .bss.x,bss\ntable ds.l 1\n",
    "        xdef start\nstart:  rts\n",                                         # a command's entry
    "shrink  macro\n        xdef shrink\nshrink: rts\n        endm\nscale:  rts\n",
    "        xdef shrink\nscale:  rts   ; shrink:\n*shrink:\n",
])
def test_no_block_needed(parse, code):
    contract, = parse(source(code))
    assert contract.registers is None


def test_files_written(tmp_path):
    tree, out = tmp_path / "tree", tmp_path / "out"
    for room in ("amiga", "span"):
        (tree / room).mkdir(parents=True)
        (tree / room / "scale.s").write_text(source().replace("scale", f"{room}_scale"))
    contracts.main(str(tree), str(out))
    table = (out / "kernel_table.s").read_text()
    assert "span_scale" in table and "amiga_scale" not in table and "dc.l    0,0" in table


def test_real_tree():
    """Every routine of the tree has a block, all names differ, and every kernel is in the table
    linked into bench."""
    names = [contract.name for contract in contracts.all_contracts(paths.ROOT / "src68k")]
    assert len(names) == len(set(names)) > 200
    table = (paths.BUILD / "gen" / "kernel_table.s").read_text()
    kernels = {contract.name for contract in contracts.kernels(paths.ROOT / "src68k")}
    assert kernels <= set(re.findall(r"\w+", table)), kernels - set(re.findall(r"\w+", table))
