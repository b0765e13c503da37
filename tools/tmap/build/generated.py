"""Shared by the modules that write assembly: ``python -m tmap.build.NAME OUT.s``."""

import sys
from pathlib import Path


def write(text: str) -> None:
    """Writes assembly to the file that the command line names; exits if there is none."""
    if len(sys.argv) != 2:
        sys.exit(f"usage: python -m tmap.build.{Path(sys.argv[0]).stem} OUT.s")
    Path(sys.argv[1]).write_text(text)
