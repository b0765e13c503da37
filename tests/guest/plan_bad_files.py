"""Invalid plan files, and the expected error of each."""

from tests.helpers.wrong_fields import M32, SHAPES, changed, lengths
from tmap.guest import kernels
from tmap.guest.kernels import Case

NOT_USABLE = ": not a usable plan file: "


def good_plan() -> bytes:
    """Two calls that do nothing, with memory, a pointer and a timed repeat."""
    near, far = kernels.Arena(), kernels.Arena()
    near.add(b"\1" * 64)
    near.pointers.append(near.add(bytes(4)))
    far.add(b"\2" * 32)
    return kernels.plan([Case("nothing"), Case("nothing", near, {"d0": 3}, {"a0": 0}, far,
                                               {"a1": 4}, repeats=2)])


def bad_plans() -> list[tuple[bytes, str]]:
    """Like bad_scenes, for plans."""
    data = good_plan()
    header, case = SHAPES.struct("plan_header"), SHAPES.struct("plan_case")
    second = header.unpack(data)["cases_at"] + case.size
    cases = [(b"", ": is empty")]
    for length in lengths("plan_header", data):
        cases.append((data[:length], NOT_USABLE + "size"))
    for name in ("magic", "version", "size", "checksum"):
        cases += [(changed(data, header.fields[name]["offset"], value, "plan_header", "cases"),
                   NOT_USABLE + name) for value in (0, M32)]
    for name, values in (("cases", (2**16, 2**31, M32)), ("cases_at", (2, len(data), M32 - 3))):
        cases += [(changed(data, header.fields[name]["offset"], value, "plan_header", "cases"),
                   NOT_USABLE + "cases_at") for value in values]

    def case_field(name, *values, said=None):
        at = second + case.fields[name]["offset"]
        cases.extend((changed(data, at, value, "plan_header", "cases"),
                      f"{NOT_USABLE}case 1: {said or name}") for value in values)

    case_field("name_at", len(data) - 1, len(data), M32)
    for name in ("near", "far"):
        case_field(name, 2, len(data), M32 - 3, 2**31)
        case_field(f"{name}_at", 2, len(data), M32 - 3, said=name)
        case_field(f"{name}_offsets", len(data), 2**30, M32, said=f"{name}_offsets")
        case_field(f"{name}_offsets_at", 2, len(data) + 4, M32 - 3, said=f"{name}_offsets")
    case_field("near", 0, 64, said="near_offsets")  # the pointer is now behind it
    for name in ("near", "far"):  # the content of their lists
        at = case.unpack(data, second)[f"{name}_at"]
        cases += [(changed(data, at, value, "plan_header", "cases"), f"{NOT_USABLE}case 1: {name}")
                  for value in (2, len(data), M32 - 3)]
    case_field("far_memory", 1, 4, M32)
    case_field("title_at", len(data) - 1, len(data), M32)
    case_field("chip", 1, M32, said="units")
    case_field("fast", 1, M32, said="units")
    case_field("limit", 0, 65536, M32)
    cases.append((kernels.plan([Case("span_of_attention")]), "span_of_attention: no such kernel"))
    cases.append((kernels.plan([Case("x" * 300)]), "x" * 256))
    return cases
