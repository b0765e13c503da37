"""``tmap fuzz``: random polygons drawn by the emulated 68020 and by the second processor, each compared with the
integer model bit for bit and, if its exact ideal is defined, with the derived bounds.

The guest draws blocks of polygons, one per frame, and returns a digest of each frame. A failing
polygon is made simpler as long as it fails, and explained.
"""

import sys
from collections.abc import Callable
from dataclasses import dataclass
from itertools import repeat

import numpy as np

from tmap.base import workers
from tmap.base.errors import UserError
from tmap.build import layout
from tmap.fuzz import record, units
from tmap.fuzz.families import ALL, again, named
from tmap.fuzz.polygons import BLOCK, Fuzzed, frame_size, polygon, scene, textures
from tmap.fuzz.shrink import shrink
from tmap.fuzz.tally import Fault, Tally
from tmap.guest.emulator import SECOND
from tmap.guest.guest_frames import draw, frame_of, is_models
from tmap.ideal import bounds, planarity
from tmap.model import model
from tmap.run.polygon_report import explain
from tmap.scene_file.scene_file import write

MACHINE = "a1200-fast"
#: Blocks per boot.
BLOCKS = 4
#: The forms of blocks, in turn: the plain forms are for comparison only.
FORMS = ("addx", "addx", "swap", "addx", "c")


@dataclass
class Checked:
    """The host's results for a polygon: the right frame, the verdict on the model's errors."""

    frame: np.ndarray
    result: int  # enum polygon_result that the guest must return: 0, or why it is refused
    judged: bool  # against the ideal
    verdict: bounds.Verdict


def check(each: Fuzzed, seed: int, block: int) -> Checked:
    """Returns the model's frame and its errors against the ideal, if there is one."""
    width, height = frame_size(block)
    settings, texels, size = each.settings, None, (256, 256)
    if each.texture >= 0:
        texels = textures(seed, block)[each.texture].texels
        size = texels.shape[::-1]
    frame, outside, judged, verdict = np.full((height, width), 7, np.uint8), False, True, bounds.Verdict()
    parts = model.parts(each.vertices, settings, (width, height), max(size))
    if bounds.has_ideal([v[:4] for v in each.vertices]):
        verdict.complain(planarity.judge(each.vertices, settings, len(parts)))
    for part in parts:
        adapted = model.adapt(part, settings, max(size))
        made = model.set_up(adapted, width, height, settings.mapper != "flat", settings, size)
        if made:
            model.draw(frame, made, texels, 200, textures(seed, block)[-1].texels)
        outside |= any(not -model.FAR <= c < model.FAR for v in adapted for c in v[:4])
        if bounds.has_ideal(adapted, settings):
            verdict.merge(bounds.check_set_up(adapted, made, settings, width, height, size))
        else:
            judged = False
            verdict.pixels += made.pixels if made else 0
    return Checked(frame, layout.load().constants["POLYGON_OUTSIDE_RANGE"] * outside, judged, verdict)


def other_of(machine: str, block: int) -> str | None:
    """Returns the processor that draws a block too: the second one or, for the first of BLOCKS of its blocks, the
    emulated A1200's."""
    if machine != SECOND:
        return SECOND
    return MACHINE if block % BLOCKS == 0 else None


def draw_blocks(blocks: list[tuple[int, list[Fuzzed], str]], seed: int, machine: str) -> list[dict[str, np.ndarray]]:
    """Returns the digests of polygons by machine, of each block: its number, some of its polygons, the form."""
    found: list[dict[str, np.ndarray]] = [{} for _ in blocks]
    others = {block: other_of(machine, block) for block, *_ in blocks}
    for each in dict.fromkeys((machine, *others.values())):
        part = [k for k, (block, *_) in enumerate(blocks) if each in (machine, others[block])]
        if each and part:
            scenes = [(scene(seed, block, some), form) for block, some, form in (blocks[k] for k in part)]
            for k, digests in zip(part, draw(scenes, each, timed=False)):
                found[k][each] = digests
    return found


def compare(checked: Checked, digests: dict) -> Fault | None:
    """Returns the fault of one polygon, or None; ``digests``: by machine."""
    for machine, digest in digests.items():
        if int(digest["result"]) != checked.result:
            return Fault("refused", f"{machine}: the result is {digest['result']}, not {checked.result}", machine)
        if not is_models(checked.frame, digest):
            return Fault("differs", f"{machine}: the guest's frame is not the model's", machine)
    if checked.verdict.complaint:
        return Fault("bound", checked.verdict.complaint)
    return None


def of_polygon(digests: dict[str, np.ndarray], k: int) -> dict:
    """Returns the digests of polygon ``k`` by machine."""
    return {machine: some[k] for machine, some in digests.items()}


def faults(polygons: list[Fuzzed], seed: int, block: int, form: str,
           machine: str) -> dict[int, Fault]:
    """Returns the faults of a block's polygons, by index; a crash is located by halves."""
    try:
        digests, = draw_blocks([(block, polygons, form)], seed, machine)
    except UserError as error:
        if len(polygons) == 1:
            return {0: Fault("crash", str(error))}
        middle = len(polygons) // 2
        first = faults(polygons[:middle], seed, block, form, machine)
        rest = faults(polygons[middle:], seed, block, form, machine)
        return first | {middle + k: fault for k, fault in rest.items()}
    found = {k: compare(check(each, seed, block), of_polygon(digests, k)) for k, each in enumerate(polygons)}
    return {k: fault for k, fault in found.items() if fault}


def form_of(block: int) -> str:
    """Returns the form in which a block is drawn."""
    return FORMS[block % len(FORMS)]


def run_part(seed: int, numbers: range, machine: str, family: str = ALL) -> Tally:
    """Draws and checks polygons of several blocks in one boot."""
    if workers.ended.is_set():
        sys.exit()
    parts: dict[int, list[int]] = {}
    for number in numbers:
        parts.setdefault(number // BLOCK, []).append(number)
    polygons = {block: [polygon(seed, n, family) for n in part] for block, part in parts.items()}
    tally = Tally()
    try:
        digests = draw_blocks([(block, some, form_of(block)) for block, some in polygons.items()], seed, machine)
    except UserError:  # a crash or a hang: block by block, then by halves
        for block, some in polygons.items():
            for k, fault in faults(some, seed, block, form_of(block), machine).items():
                tally.failed[parts[block][k]] = fault
        return tally
    for (block, some), found in zip(polygons.items(), digests):
        for k, (number, each) in enumerate(zip(parts[block], some)):
            try:
                checked = check(each, seed, block)
            except Exception as fault:
                fault.add_note(f"{named(seed, number, family)}; again: {again(seed, number, family, machine)}")
                raise
            tally.add(each.settings, checked.verdict, checked.result != 0, checked.judged)
            fault = compare(checked, of_polygon(found, k))
            if fault:
                tally.failed[number] = fault
    polygon.cache_clear()
    return tally


def run(seed: int, first: int, count: int, machine: str = MACHINE,
        on_part: Callable[[Tally], None] | None = None, family: str = ALL) -> Tally:
    """Checks ``count`` polygons of a seed and a family from ``first`` on, on all of the host's processors."""
    part_of, size = (units.run_part, units.part_size(family)) if family in units.UNITS else (run_part, BLOCK * BLOCKS)
    starts = [first, *range(first // size * size + size, first + count, size)]
    ranges = [range(a, min(a // size * size + size, first + count)) for a in starts]
    total = Tally()
    with workers.pool(len(ranges)) as pool:
        for part in pool.map(part_of, repeat(seed), ranges, repeat(machine), repeat(family)):
            total.merge(part)
            if on_part:
                on_part(part)
    return total


def can_be_held(each: Fuzzed, seed: int, block: int) -> bool:
    """Returns true if a scene file can contain a polygon."""
    try:
        write(scene(seed, block, [each]))
    except UserError:
        return False
    return True


def smallest(number: int, fault: Fault, seed: int, machine: str, family: str = ALL) -> tuple[Fuzzed, Fault]:
    """Returns the simplest polygon that fails in the same way, and its fault."""
    block = number // BLOCK

    def failing(candidates: list[Fuzzed]) -> dict[int, Fault]:
        # A polygon that no file can contain would look like a crash, located in many boots.
        kept = [k for k, each in enumerate(candidates) if can_be_held(each, seed, block)]
        some = [candidates[k] for k in kept]
        found = faults(some, seed, block, form_of(block), machine) if some else {}
        return {kept[k]: each for k, each in found.items() if each.kind == fault.kind}

    return shrink(polygon(seed, number, family), fault, failing)


def explanation(each: Fuzzed, fault: Fault, seed: int, number: int, machine: str, family: str = ALL) -> str:
    """Returns the text that helps to find the cause."""
    block = number // BLOCK
    this = scene(seed, block, [each])
    found = (None if fault.kind in ("crash", "refused") else
             frame_of(this, form_of(block), fault.machine or machine))
    return explain(this, 0, found, f"{named(seed, number, family)}, {form_of(block)}: {fault.text}",
                   again(seed, number, family, machine))


def command(seed: int, first: int, count: int, machine: str, keep: str | None, family: str = ALL,
            kept: bool = False) -> int:
    """``tmap fuzz``: returns 0 only if no polygon failed. ``kept``: the run is added to the page's table."""
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    if count < 1 or first < 0 or seed < 0:
        raise UserError("fuzz: --count must be 1 or more, --first and --seed 0 or more")
    with Progress(*Progress.get_default_columns()[:-1], MofNCompleteColumn(), TimeRemainingColumn(),
                  transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("polygons", total=count)
        tally = run(seed, first, count, machine,
                    lambda part: progress.advance(task, part.counts["polygons"]), family)
    print(tally)
    if kept:
        record.keep(tally, seed, first, machine, family)
    if not tally.failed:
        return 0
    number, fault = next(iter(sorted(tally.failed.items())))
    print(f"{len(tally.failed)} failed: {', '.join(map(str, sorted(tally.failed)[:20]))}; "
          "the first" + ", made smaller:" * (family not in units.UNITS))
    if family in units.UNITS:
        print(units.explanation(fault, seed, number, machine, family))
        return 1
    each, fault = smallest(number, fault, seed, machine, family)
    print(explanation(each, fault, seed, number, machine, family))
    if keep:
        from tmap.corpus.hard_cases import Case
        from tmap.corpus.hard_cases import keep as keep_case
        size = textures(seed, number // BLOCK)[each.texture].texels.shape[::-1] \
            if each.texture >= 0 else (256, 256)
        keep_case(Case(keep, f"Found by the fuzzer, {named(seed, number, family)}: {fault.text}.",
                       each.vertices, (each.settings.mapper,), size,
                       each.settings.perspective != "none"))
        print(f"kept as {keep} in tests/hard_cases.json")
    return 1
