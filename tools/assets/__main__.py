"""Writes every file anew."""

from ..paths import SCENES
from . import FILES

for name, make in FILES.items():
    (SCENES / name).write_bytes(make())
print(f"written: {len(FILES)} files in tests/scenes")
