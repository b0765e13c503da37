"""``python -m tests.mutants.model_check SUBJECT...``: whether the model of this tree is what the second processor draws.

Ends with status 1 and a line if a frame or a kernel's result differs, or if a derived bound is exceeded.
"""

import importlib
import pkgutil
import sys
from pathlib import Path

from tests.helpers import kernel_checker as checker
from tests.kernels import trials
from tests.mutants import corpora
from tmap.base.paths import ROOT
from tmap.build import contracts
from tmap.fuzz import fuzz
from tmap.fuzz.families import ALL, PERSPECTIVE
from tmap.fuzz.polygons import BLOCK, polygon
from tmap.guest.emulator import SECOND
from tmap.guest.guest_frames import is_models
from tmap.model import model

FUZZED = ((ALL, 0, 120), (PERSPECTIVE, 0, 80), (ALL, 1, 60), (ALL, 3, 60))
#: Rooms of trials that a subject's kernels are in.
ROOMS = {"polygons": ("edge", "outline", "texturing", "polygon", "perspective", "far", "cubic", "scanline", "triangle", "span"),
         "meshes": ("mesh", "trees", "visible"), "n64": ("n64",), "glide": ("glide",)}


def wrong_polygon() -> str:
    """Returns what is wrong with the fuzzer's polygons, or ""."""
    for family, block, count in FUZZED:
        some = [polygon(corpora.SEED, block * BLOCK + k, family) for k in range(count)]
        digests, = fuzz.draw([(fuzz.scene(corpora.SEED, block, some), fuzz.form_of(block))], SECOND, timed=False)
        for k, each in enumerate(some):
            if fault := fuzz.compare(fuzz.check(each, corpora.SEED, block), {SECOND: digests[k]}):
                return f"{fault.kind}: polygon {k} of {family} {block}"
    return ""


def wrong_frame(subject: str) -> str:
    """Returns the first frame that is not the model's, or ""."""
    for number in range(len(corpora.PARTS[subject])):
        for (scene, form), (digests, _) in zip(*corpora.part(subject, number)):
            if form.startswith("addx") and "OFF" not in form:
                for frame, digest in enumerate(digests):
                    if not is_models(model.render(scene, frame), digest):
                        return f"{subject} {number}: frame {frame}"
    return ""


def wrong_trial(subject: str) -> str:
    """Returns what is wrong with kernels by their trials, or ""."""
    blocks = {each.name: each for each in contracts.kernels(ROOT / "src68k")}
    for room in pkgutil.iter_modules(trials.__path__):
        if room.name in ROOMS[subject]:
            some = [trial for trial in importlib.import_module(f"{trials.__name__}.{room.name}").trials()
                    if trial.case.kernel in blocks]
            for trial, result in zip(some, checker.run(some, SECOND)):
                if isinstance(result, str) or result and checker.complaints(trial, result, blocks[trial.case.kernel]):
                    return f"{trial.case.kernel}: {trial.title}"
    return ""


def main(subjects: list[str]) -> str:
    """Returns what is wrong, or ""."""
    assert Path(model.__file__).is_relative_to(ROOT)
    for subject in subjects:
        parts = (wrong_polygon,) if subject == "polygons" else (lambda: wrong_frame(subject),)
        for part in (*parts, lambda: wrong_trial(subject)):
            if said := part():
                return said
    return ""


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]) or 0)
