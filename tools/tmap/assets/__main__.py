"""Writes all FILES again."""

from tmap.assets import FILES
from tmap.base.paths import SCENES

for name, make in FILES.items():
    (SCENES / name).write_bytes(make())
print(f"written: {len(FILES)} files in tests/scenes")
