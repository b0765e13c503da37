"""Standard streams: whatever happens to them must not end in a traceback."""

import os
import sys


def prepare() -> None:
    """Makes the streams usable. Those that were closed when Python started become the null device, so
    that no other file gets their numbers; names that are not text are written with backslashes."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, mode))
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")


def drop_output() -> bool:
    """Returns whether standard output cannot be written. If so, Python does not try it again at the end."""
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return True
    return False
