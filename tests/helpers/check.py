"""``make check``: in about a minute, the tests that a change concerns and a sample of the others.

The change is what differs from the upstream branch, from the last commit where there is none. It concerns the trials of
kernels in changed files, or that include one; test files that changed; and those that import a changed module
themselves. Files that take long (tests/helpers/longest.py) are named and left to ``make test``.
"""

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

from tests.helpers.kernel_checker import UNCALLED
from tests.helpers.longest import LONGEST
from tmap.base.paths import ROOT
from tmap.build import contracts

#: Contract blocks, layouts, rooms; both processors' frames of ten scenes; polygons against model and bounds.
ALWAYS = ("tests/guest/test_contracts.py", "tests/guest/test_layout.py", "tests/product/test_rooms.py",
          "tests/guest/test_second_processor.py::test_frames_are_the_same",
          "tests/accuracy/test_fuzz.py::test_a_slice_in_perspective_holds", "tests/accuracy/test_written.py")
#: Kernels whose trials run if no kernel changed.
SAMPLE = ("span_affine_addx", "edge_addx_exact", "mesh_transform", "far_span_find", "glide_walk", "n64_walk")
LONG = 24  # of LONGEST, test files with more than 20 seconds
MOST = 24  # most kernels whose trials run: more are a matter of make test


def git(*words: str) -> list[str]:
    """Returns the lines of a git command's output; none if it fails."""
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True)
    return done.stdout.splitlines() if done.returncode == 0 else []


def changed() -> set[str]:
    """Returns the changed files, from the root."""
    base = git("merge-base", "HEAD", "@{upstream}") or ["HEAD"]
    return {*git("diff", "--name-only", base[0]), *git("ls-files", "--others", "--exclude-standard")}


def touched_kernels(files: set[str]) -> list[str]:
    """Returns the kernels in changed files of assembly, or that include one, at any depth."""
    names = {Path(file).name for file in files if file.startswith("src68k/")}
    includes = {path.name: set(re.findall(r'^\s+include\s+"(.*)"', path.read_text(), re.MULTILINE))
                for path in (ROOT / "src68k").rglob("*.[si]")}
    while more := {name for name, some in includes.items() if some & names} - names:
        names |= more
    return [each.name for each in contracts.kernels(ROOT / "src68k")
            if Path(each.file).name in names and each.name not in UNCALLED]


def imports(path: Path) -> set[str]:
    """Returns the modules that a file of Python imports itself."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return found


def concerned(files: set[str]) -> list[str]:
    """Returns the test files that changed or import a changed module."""
    modules = {file.removeprefix("tools/").removesuffix(".py").replace("/", ".") for file in files
               if file.endswith(".py")}
    return [path.relative_to(ROOT).as_posix() for path in sorted((ROOT / "tests").glob("*/test_*.py"))
            if path.relative_to(ROOT).as_posix() in files or imports(path) & modules]


def main() -> None:
    """Runs pytest."""
    files = changed()
    kernels = touched_kernels(files) or list(SAMPLE)
    tests = concerned(files)
    long = [test for test in tests if test.removeprefix("tests/").removesuffix(".py").replace("test_", "")
            in LONGEST[:LONG]]
    if len(kernels) > MOST:
        print(f"check: {len(kernels)} kernels are concerned, {MOST} are tried")
        kernels = kernels[::-(-len(kernels) // MOST)][:MOST]
    if long:
        print(f"check: left to make test: {' '.join(long)}")
    chosen = [*dict.fromkeys([*ALWAYS, *(test for test in tests if test not in long)]),
              *(f"tests/kernels/test_kernels.py::test_contract[{name}]" for name in kernels)]
    sys.stdout.flush()
    os.execv(sys.executable, [sys.executable, "-m", "pytest", "-q", "-n", "2", "--dist", "loadfile", *chosen])


if __name__ == "__main__":
    main()
