"""The versions that made a result: emulator, commit, compiler."""

import functools
import subprocess

from tmap.base.paths import BUILD, ROOT
from tmap.guest import emulator


def commit() -> str:
    """Returns the commit of the tree, marked if there are changes; "unknown" outside git."""
    done = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT,
                          capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


@functools.cache
def commit_seconds() -> int:
    """Returns the commit's date in seconds since 1970, so that the same tree makes the same products; a date in 2001
    outside git."""
    done = subprocess.run(["git", "show", "-s", "--format=%ct"], cwd=ROOT, capture_output=True, text=True)
    return int(done.stdout) if done.stdout.strip() else 10**9


def compiler() -> str:
    """Returns the C compiler that built the programs, as noted by the Makefile."""
    name = (BUILD / "obj" / "objects").read_text().split()[0]
    if name != "gcc":
        return name
    version = subprocess.run(["m68k-linux-gnu-gcc", "-dumpfullversion"], capture_output=True,
                             text=True).stdout.strip()
    return f"gcc {version}"


def record() -> dict[str, str]:
    """Returns the fields at the head of every report."""
    return {"emulator": f"FS-UAE {emulator.emulator_version()}", "commit": commit(),
            "compiler": compiler()}
