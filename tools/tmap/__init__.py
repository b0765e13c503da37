"""tmap020's host side: scene compiler, references, emulator runner, reports."""

import os

#: Before NumPy is imported: its matrices are small here, and threads that wait for each other take
#: ten times as long where processes share the cores.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
#: Before matplotlib is: plots go into files, whatever screens there are.
os.environ["MPLBACKEND"] = "Agg"
