"""Paths in the project's tree."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BUILD = ROOT / "build"
PROGRAMS = BUILD / "programs"
LAYOUT = BUILD / "gen" / "layout.json"
GUEST = ROOT / "tests" / "guest"  # programs of the tests
SCENES = ROOT / "tests" / "scenes"
BASELINE = ROOT / "tests" / "baseline" / "bench.json"
ACCURACY_BASELINE = ROOT / "tests" / "baseline" / "accuracy.json"  # the medium set
PROGRAMS_BASELINE = ROOT / "tests" / "baseline" / "programs.json"  # sizes of scenes' programs
POLYS_BASELINE = ROOT / "tests" / "baseline" / "polys.json"
FUZZED = ROOT / "tests" / "baseline" / "fuzzed.json"
