"""``tmap emulate``: runs any Amiga program headless on the emulated machine.

``guard`` (c/programs) runs it as the shell does and reports a crash. What the program writes ends up in a folder of
the host's, chunky buffers as pictures too if their size is given.
"""

import json
import re
import sys
from pathlib import Path

import numpy as np
from elftools.common.exceptions import ELFError
from elftools.elf.elffile import ELFFile
from PIL import Image

from tmap.base.errors import UserError
from tmap.base.outputs import check_directory
from tmap.base.pixel_formats import FORMATS
from tmap.build import hunk
from tmap.guest import emulator

GUARD = "guard"
#: Files of a run's volume that are not the program's.
RUN_FILES = {GUARD, "batch", "uae", "end", "0.log", "0.code", "s/startup-sequence"}
NAME_MOST, LINE_MOST = 30, 400  # letters of a name in AmigaDOS; of the shell's line
HEADER = hunk.longs(hunk.HUNK_HEADER)
PLACE = re.compile(r"\Aguard: (-?\d+)\n")
FAULT = re.compile(r"(fault: exception [0-9a-f]{8} pc )([0-9a-f]{8})")


def shell_name(path: Path) -> str:
    """Returns a file's name as the shell takes it without quotes, other than a run's own."""
    name = re.sub(r"[^A-Za-z0-9_.-]", "_", path.name)[:NAME_MOST]
    return name if name.lower() not in RUN_FILES | {"s"} else f"x_{name}"


def quoted(word: str) -> str:
    """Returns an argument as the shell and ReadArgs take it."""
    if "\n" in word or not word.isprintable():
        raise UserError(f"{word!r}: an argument of more than a line of text")
    if word and not re.search(r'[\s"*;<>|`?&+()]', word):
        return word
    return '"' + word.replace("*", "**").replace('"', '*"') + '"'


def executable(path: Path) -> tuple[bytes, str]:
    """Returns the hunk file of a program and its map: lines of offset and name. Raises UserError."""
    data = path.read_bytes()
    if data[:4] == HEADER:
        beside = path.with_name(path.name + ".map")
        return data, beside.read_text() if beside.is_file() else f"00000000 {path.stem.split()[0]}\n"
    if data[:4] != b"\x7fELF":
        raise UserError(f"{path}: neither an Amiga program (hunk file) nor an ELF program")
    try:
        with path.open("rb") as stream:
            elf = ELFFile(stream)
            if elf["e_machine"] != "EM_68K" or elf["e_type"] != "ET_EXEC":
                raise ValueError("not a linked program for the 68000's family")
            sections = {s.name: s for s in elf.iter_sections()}
            places = [sections[name]["sh_addr"] for name in hunk.SECTIONS if name in sections]
            if ".text" not in sections or any(places) or (len(places) > 1 and ".rela.text" not in sections):
                raise ValueError("link it with ld -q and sections at 0, as the SDK's amiga.ld has them")
            return hunk.executable(elf), hunk.symbol_map(elf)
    except (ELFError, ValueError) as error:
        raise UserError(f"{path}: cannot be made a hunk file: {error}") from None


def judged(output: str, program: Path) -> tuple[str, str | None]:
    """Returns a program's output, without what guard added, and its crash in words, or None."""
    place = PLACE.match(output)
    if not place:
        return output, None
    output = output[place.end():]
    size = 4 * int.from_bytes(program.read_bytes()[20:24], "big")

    def moved(match: re.Match) -> str:
        """Relative to the program, unless its own handler has said so."""
        at = int(match[2], 16)
        return match[1] + f"{at if at < size else (at - int(place[1])) % (1 << 32):08x}"

    fault = emulator.explain_fault(program, FAULT.sub(moved, output))
    return (output[:FAULT.search(output).start()] if fault else output), fault


class Terminal:
    """Shows output as it comes."""

    def __init__(self) -> None:
        self.shown = 0

    def show(self, output: str, is_all: bool = False) -> None:
        """Writes what is new; before the end only whole lines that are no crash report."""
        place = PLACE.match(output)
        text = output[place.end():] if place else "" if output.startswith(GUARD) and not is_all else output
        if not is_all:
            text = text[:text.rfind("\n") + 1].partition("fault: exception")[0]
        sys.stdout.write(text[self.shown:])
        sys.stdout.flush()
        self.shown = max(self.shown, len(text))


def pictured(path: Path, size: tuple[int, int], pixel: str, palette: np.ndarray) -> bool:
    """Writes PATH.png if a file has just the bytes of a chunky buffer; returns True if so."""
    width, height = size
    made, data = FORMATS[pixel], path.read_bytes()
    if len(data) != width * height * made.bytes:
        return False
    pixels = np.frombuffer(data, made.dtype.newbyteorder(">")).reshape(height, width)
    if made.colours:
        image = Image.fromarray(made.picture(pixels))
    else:
        image = Image.fromarray(pixels, "P")
        image.putpalette(palette.tobytes())
    image.save(path.with_name(path.name + ".png"))
    return True


def colours(path: Path | None) -> np.ndarray:
    """Returns the palette of a PNG, of what ``tmap map`` writes beside a map, or greys."""
    if path is None:
        return np.repeat(np.arange(256, dtype=np.uint8), 3)
    try:
        if path.suffix == ".json":
            return np.array(json.loads(path.read_text())["palette"], np.uint8).ravel()
        with Image.open(path) as image:
            found = image.getpalette("RGB") if image.mode == "P" else None
    except (OSError, ValueError) as error:
        raise UserError(f"{path}: not a usable picture: {error}") from None
    except (KeyError, TypeError, OverflowError):
        raise UserError(f"{path}: palette: not one that tmap map has written") from None
    if not found:
        raise UserError(f"{path}: has no palette")
    return np.array(found, np.uint8)


def written(volume: Path, given: dict[str, bytes]) -> dict[str, Path]:
    """Returns the files that a program has made or changed, by their path in its volume; not those in which the
    emulator keeps their bits and dates."""
    files = {path.relative_to(volume).as_posix(): path for path in sorted(volume.rglob("*")) if path.is_file()}
    return {name: path for name, path in files.items()
            if name.lower() not in RUN_FILES and path.suffix != ".uaem"
            and (name not in given or path.read_bytes() != given[name])}


def keep(files: dict[str, Path], out: Path, size: tuple[int, int] | None, pixel: str, palette: np.ndarray) -> None:
    """Copies what a program wrote to ``out``, with pictures; says so on standard error."""
    if not files:
        return
    try:
        for name, path in files.items():
            to = out / name
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_bytes(path.read_bytes())
            is_picture = size and pictured(to, size, pixel, palette)
            print(f"{to}: {to.stat().st_size:,} bytes{', and as a PNG' if is_picture else ''}", file=sys.stderr)
    except OSError as error:
        raise UserError(f"{error.filename or out}: {error.strerror or error}") from None


def command(program: Path, arguments: list[str], out: Path, machine: str, inputs: list[Path],
            size: tuple[int, int] | None, pixel: str, palette: Path | None, limit: float) -> int:
    """``tmap emulate``: returns the program's return code; raises UserError for a crash or a hang.

    ``inputs``: files put beside the program; ``size``, ``pixel``: of chunky buffers; ``limit``: seconds of the
    host's processor time without a sign of life after which it hangs."""
    check_directory(out)
    try:
        given = {shell_name(path): path.read_bytes() for path in inputs}
        content, symbols = executable(program)
    except OSError as error:
        raise UserError(f"{error.filename}: {error.strerror}") from None
    table, name = colours(palette), shell_name(program)
    if name in given:
        raise UserError(f"{program}: an input has its name")
    line = " ".join([GUARD, name, *map(quoted, arguments)])
    if len(line) > LINE_MOST:
        raise UserError(f"{program}: {len(line)} letters of arguments, more than {LINE_MOST}")
    terminal = Terminal()
    with emulator.workspace() as folder:
        copy, run = folder / name, folder / "run"
        copy.write_bytes(content)
        copy.with_name(name + ".map").write_text(symbols)
        given[name] = content
        try:
            done, = emulator.run_batch([line], dict(given), machine, run, terminal.show, patience=limit)
        except UserError as error:
            log = emulator.read(run / "volume" / "0.log")
            output, fault = judged(log, copy)
            terminal.show(output, True)
            keep(written(run / "volume", given), out, size, pixel, table)
            why = re.sub(r"its last words: 'guard: -?\d+'", "it wrote nothing", str(error))
            raise UserError(fault or why.removeprefix(f"{GUARD} ")) from None
        output, fault = judged(done.output, copy)
        terminal.show(output, True)
        keep(written(done.directory, given), out, size, pixel, table)
    if fault:
        raise UserError(fault)
    return done.code
