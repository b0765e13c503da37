"""The fuzzer's runs that are kept: tests/baseline/fuzzed.json, and the page's table of them."""

import json

from tmap.base.errors import UserError
from tmap.base.markdown import table
from tmap.base.paths import FUZZED
from tmap.fuzz.families import FAMILIES
from tmap.fuzz.tally import Tally
from tmap.guest import provenance

ALIKE = ("family", "machine", "commit")  # of runs that share a row


def runs() -> list[dict]:
    """Returns the kept runs."""
    return json.loads(FUZZED.read_text()) if FUZZED.exists() else []


def keep(tally: Tally, seed: int, first: int, machine: str, family: str) -> None:
    """Adds a run to the file; raises UserError if one of its polygons is kept already."""
    count, kept = tally.counts["polygons"], runs()
    for run in kept:
        if (run["family"], run["seed"]) == (family, seed) and run["first"] < first + count \
                and first < run["first"] + run["polygons"]:
            raise UserError(f"fuzz: --record: polygons {run['first']} to {run['first'] + run['polygons'] - 1} of seed "
                            f"{seed} of {family} are in {FUZZED.name} already")
    kept.append({"family": family, "seed": seed, "first": first, "polygons": count, "pixels": tally.counts["pixels"],
                 "wrong": len(tally.failed), "machine": machine, "commit": provenance.commit()})
    FUZZED.write_text("[\n " + ",\n ".join(map(json.dumps, kept)) + "\n]\n")


def tables() -> dict[str, str]:
    """Returns the page's table by title."""
    rows, kept = [], runs()
    for alike in dict.fromkeys(tuple(run[key] for key in ALIKE) for run in kept):
        some = [run for run in kept if tuple(run[key] for key in ALIKE) == alike]
        polygons, pixels, wrong = (sum(run[key] for run in some) for key in ("polygons", "pixels", "wrong"))
        family, machine, commit = alike
        rows.append([FAMILIES[family], f"{polygons:,}", f"{pixels:,}", f"{wrong:,}",
                     ", ".join(dict.fromkeys(str(run["seed"]) for run in some)), machine, commit])
    return {"what was fuzzed": table(["", "polygons", "pixels", "wrong", "seeds", "drawn by", "commit"], rows)}
