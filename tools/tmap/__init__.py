"""tmap020's host side: scene compiler, references, emulator runner, reports."""

import os

#: Must be set before NumPy is imported. Its matrices are small here, and threads that wait for each
#: other take ten times as long where processes share the cores.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
#: Must be set before matplotlib is imported: plots go into files, whatever screens there are.
os.environ["MPLBACKEND"] = "Agg"
