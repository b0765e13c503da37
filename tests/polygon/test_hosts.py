"""The tools make the same bytes on every machine: their output under the settings of several
processors, and a check that no function in them rounds differently by processor."""

import ast
import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__

from tests.polygon import host_digests
from tmap.base.paths import ROOT

#: NumPy's optional processor features that this processor has.
DISPATCHED = [name for name in __cpu_dispatch__ if __cpu_features__.get(name)]
#: Settings like the oldest processor: OpenBLAS, NumPy and the C library without later instructions.
OLDEST = {"OPENBLAS_CORETYPE": "Prescott", "NPY_DISABLE_CPU_FEATURES": " ".join(DISPATCHED),
          "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA"}
#: OpenBLAS's kernels, and the NumPy feature a processor needs to run them.
KERNELS = {"Haswell": "X86_V3", "Zen": "X86_V3", "SkylakeX": "X86_V4"}
SETTINGS = {"the oldest processor": (OLDEST, ["scenes", "textures", "inputs", "files", "probes"])} | {
    name: ({"OPENBLAS_CORETYPE": name}, ["textures", "inputs"])
    for name, needed in KERNELS.items() if __cpu_features__.get(needed)}
NAMES = {"OPENBLAS_CORETYPE", "NPY_DISABLE_CPU_FEATURES", "GLIBC_TUNABLES"}


def digests(parts: list[str], settings: dict[str, str]) -> dict[str, str]:
    """Runs host_digests.py in a separate process and returns its digests."""
    clean = {name: value for name, value in os.environ.items() if name not in NAMES}
    done = subprocess.run([sys.executable, host_digests.__file__, *parts], cwd=ROOT, text=True,
                          env=clean | {"PYTHONPATH": str(ROOT / "tools")} | settings, capture_output=True)
    assert not done.returncode, f"{settings}: {done.stderr[-2000:]}"
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def own() -> dict[str, str]:
    """All digests under this machine's own settings."""
    return digests(list(host_digests.PARTS), {})


@pytest.mark.parametrize("name", SETTINGS)
def test_same_bytes_as_on(name: str, own) -> None:
    """Everything has the same bytes under other settings. If this processor has fused
    multiplication, the oldest processor's settings must change the probes, which depend on the
    processor."""
    settings, parts = SETTINGS[name]
    found = digests(parts, settings)
    probes = {probe: found.pop(probe) for probe in ("BLAS", "libm") if probe in found}
    wrong = [made for made, digest in found.items() if digest != own[made]]
    assert not wrong, (f"{', '.join(wrong)}: other bytes with "
                       + " ".join(f'{key}="{value}"' for key, value in settings.items()))
    if __cpu_features__.get("FMA3"):
        assert all(digest != own[probe] for probe, digest in probes.items()), \
            f"{name}: the settings change nothing"


def test_noise_has_room(monkeypatch, own) -> None:
    """The Fourier transform takes its sines from the C library. Noise with errors ten thousand
    times those of a last bit gives the same pictures."""
    transform, rng, calls = np.fft.irfft2, np.random.default_rng(1), []

    def moved(*arguments) -> np.ndarray:
        found = transform(*arguments)
        calls.append(found.size)
        return found * (1 + rng.uniform(-1e-11, 1e-11, found.shape))

    monkeypatch.setattr(np.fft, "irfft2", moved)
    wrong = [name for name, made in host_digests.files()
             if hashlib.sha256(made).hexdigest() != own[name]]
    assert calls and not wrong, f"other bytes where noise differs by 1e-11 of it: {wrong}"


#: Functions of np, math and cmath that have versions for processors; below, those of any module
#: that use such functions or add in an order that depends on the processor.
ELEMENTARY = set("""exp exp2 expm1 log log2 log10 log1p sin cos tan sinh cosh tanh asin acos atan atan2 asinh
    acosh atanh arcsin arccos arctan arctan2 arcsinh arccosh arctanh sinc i0 power pow cbrt rect polar
    float_power logaddexp""".split())
OTHERS = set("""gauss normalvariate dot vdot inner matmul tensordot einsum convolve correlate polyfit cov
    corrcoef linalg fft""".split())
MODULES = ("math", "cmath", "np", "numpy")
#: Uses that are allowed, by file in tools/tmap, and why no stored byte or figure depends on them.
HARMLESS = {
    "assets/noise.py": {"fft"},  # see test_noise_has_room
    "ideal/bounds_perspective.py": {"log2", "**"},  # a bound; no page shows that many digits
    "base/elementary.py": {"atan2"},  # a first guess, corrected to the exact value
    "fuzz/depths.py": {"log10", "log2", "**"},  # random test cases, which are not stored
    "compiler/mesh_build.py": {"atan2"},  # a sum of angles, 2 pi or 4 pi and more, compared with 3 pi
    "setup/perspective.py": {"**"},  # of integers
    "images/palette.py": {"@"},  # of integers below 2^24, exact in any order
    "corpus/polygon_sets.py": {"gauss"},  # fixed; test_same_bytes_as_on compares them
    "corpus/random_meshes.py": {"cos", "sin", "**"},  # random test cases
    "corpus/random_polygons.py": {"cos", "sin", "**"},
    "corpus/random_n64.py": {"exp", "**"},
    "corpus/random_glide.py": {"exp", "**"},
    "compiler/polygons.py": {"atan2"},  # as in mesh_build.py
    "glide/lod.py": {"**"}}  # of integers


def is_exact(base: ast.expr, exponent: ast.expr) -> bool:
    """Returns whether a power seems to be of a constant to an integer: no fraction, no division, no
    random number."""
    return isinstance(base, ast.Constant) and not any(
        isinstance(node, ast.Div) or isinstance(node, ast.Constant) and isinstance(node.value, float)
        or isinstance(node, ast.Attribute) and node.attr == "uniform" for node in ast.walk(exponent))


def rounding_by_processor(text: str) -> Iterator[str]:
    """Yields the functions and operators of a module that may round by processor."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult):
            yield "@"
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) \
                and not is_exact(node.left, node.right):
            yield "**"
        elif isinstance(node, ast.Attribute) and (
                node.attr in OTHERS or node.attr in ELEMENTARY and ast.unparse(node.value) in MODULES):
            yield node.attr
        elif isinstance(node, ast.ImportFrom) and node.module in MODULES:
            yield from {alias.name for alias in node.names} & (ELEMENTARY | OTHERS)


def test_nothing_rounds_by_processor() -> None:
    """Checks all tools except for the harmless uses; a listed use that no longer exists also
    fails."""
    found = {str(path.relative_to(ROOT / "tools" / "tmap")): set(rounding_by_processor(path.read_text()))
             for path in (ROOT / "tools").rglob("*.py")}
    found = {name: used for name, used in found.items() if used}
    assert found == HARMLESS, "tmap.base.elementary and tmap.base.linear have what is the same everywhere"


@pytest.mark.parametrize("text, used", [
    ("a @ b", {"@"}), ("x ** 0.5", {"**"}), ("x ** (1 / n)", {"**"}), ("x ** 3", {"**"}),
    ("2.0 ** -12", set()),
    ("np.linalg.norm(x)", {"linalg"}), ("from math import sin", {"sin"}), ("x.dot(y)", {"dot"}),
    ("from .elementary import sin\nsin(x)", set()), ("elementary.power(x, y)", set())])
def test_what_rounds_by_processor_is_found(text: str, used: set[str]) -> None:
    assert set(rounding_by_processor(text)) == used
