"""The command line: ``scripts/tmap COMMAND ...``.

Exit status: 0 done; 1 a comparison found a difference; 2 bad input or a failed run, with a message
of one line; 130 interrupted; 129, 131, 143 ended by SIGHUP, SIGQUIT, SIGTERM.
"""

import argparse
import signal
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from tmap.base import streams
from tmap.base.errors import UserError
from tmap.base.paths import BUILD, ROOT
from tmap.base.pixel_formats import FORMATS
from tmap.base.signals import end_by
from tmap.fuzz import families
from tmap.guest.conditions import CONDITIONS
from tmap.guest.emulator import MACHINES, MEASURED, SECOND
from tmap.run.convert import LAYOUTS
from tmap.scene_file.textures import MAPPERS

FORMS = ("addx", "swap", "c")


class Parser(argparse.ArgumentParser):
    """Reports argument errors in one line, like all other errors."""

    def error(self, message: str):
        raise UserError(f"{self.prog.removeprefix('tmap').strip() or 'usage'}: {message}; "
                        f"see {self.prog} --help")


def build_programs() -> None:
    """Brings the Amiga programs up to date; prints nothing unless that fails."""
    done = subprocess.run(["make", "-s", "-C", str(ROOT), "programs"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode:
        print(done.stdout, end="", file=sys.stderr)
        raise UserError("the Amiga programs cannot be built: make programs failed")


def run(args: argparse.Namespace) -> int:
    """Renders a scene."""
    build_programs()
    from tmap.run import run as tool
    return tool.command(args.scene, args.out or BUILD / "run" / args.scene.stem, args.machine,
                        args.frames, args.form, args.off)


def show(args: argparse.Namespace) -> int:
    """Plays a scene in a window."""
    from tmap.run import show as tool
    window = tool.window()
    build_programs()
    return tool.command(args.scene, args.machine, window)


def demo(args: argparse.Namespace) -> int:
    """Makes the demo's folder."""
    build_programs()
    from tmap.run import demo as tool
    return tool.command(args.out or BUILD / "demo", args.machine if args.play else None)


def scene_program(args: argparse.Namespace) -> int:
    """Makes the program of one scene."""
    build_programs()
    from tmap.product import scene_program as tool
    return tool.command(args.scene, args.out or BUILD / "scene" / args.scene.stem, args.machine)


def profile(args: argparse.Namespace) -> int:
    """Shows where a scene's cycles go."""
    build_programs()
    from tmap.product import profile as tool
    return tool.command(args.scene, args.out or BUILD / "profile" / args.scene.stem, args.machine, args.frames)


def bench(args: argparse.Namespace) -> int:
    """Measures the kernels."""
    build_programs()
    from tmap.report import bench_results as tool
    return tool.command(args.out or BUILD / "bench", args.machine, args.only, args.accept)


def accuracy(args: argparse.Namespace) -> int:
    """Measures what accuracy costs."""
    build_programs()
    from tmap.accuracy import accuracy as tool
    return tool.command(args.out or BUILD / "accuracy", args.set, args.machine,
                        args.accept)


def polys(args: argparse.Namespace) -> int:
    """Measures polygons a second."""
    build_programs()
    from tmap.accuracy import polys as tool
    return tool.command(args.out or BUILD / "polys", args.machine, args.accept)


def fuzz(args: argparse.Namespace) -> int:
    """Checks random polygons against the model and the bounds."""
    build_programs()
    from tmap.fuzz import fuzz as tool
    return tool.command(args.seed, args.first, args.count, args.machine, args.keep, args.family)


def choose(args: argparse.Namespace) -> int:
    """Looks up a setting."""
    from tmap.accuracy import choose as tool
    return tool.command(tool.Wish(args.error, args.machine, args.depth, args.wrong, args.mapper,
                                  tool.RMS if args.rms else tool.LARGEST, args.pixels), args.data)


def sdk(args: argparse.Namespace) -> int:
    """Makes the SDK."""
    build_programs()
    from tmap.product import sdk as tool
    return tool.command(args.out or BUILD / "sdk")


def report(args: argparse.Namespace) -> int:
    """Makes the report."""
    build_programs()
    from tmap.report import report as tool
    return tool.command(args.out or BUILD / "report", args.scene, args.machine, args.committed)


def adf(args: argparse.Namespace) -> int:
    """Makes the disk."""
    build_programs()
    from tmap.product import disk as tool
    return tool.command(args.out or tool.IMAGE)


def readme(_: argparse.Namespace) -> int:
    """Writes the tables of the pages."""
    from tmap.report import readme as tool
    return tool.command()


def diff(args: argparse.Namespace) -> int:
    """Compares frames."""
    from tmap.run import diff as tool
    return tool.command(args.a, args.b, args.out)


def vectors(args: argparse.Namespace) -> int:
    """Checks the texture engines against reference data."""
    build_programs()
    from tmap.vectors import vectors as tool
    return tool.command(args.files, args.machine)


def to_map(args: argparse.Namespace) -> int:
    """Converts a picture to a map."""
    from tmap.run import convert as tool
    return tool.map_command(args.source, args.out, args.layout, args.format)


def to_picture(args: argparse.Namespace) -> int:
    """Converts a map to a picture."""
    from tmap.run import convert as tool
    return tool.picture_command(args.source, args.out)


def number(text: str) -> float:
    """Returns a finite number from 0 on. Messages on wrong numbers contain this function's name."""
    value = float(text)
    if not 0 <= value < float("inf"):
        raise ValueError
    return value


def size(text: str) -> float:
    """Returns a finite number above 0."""
    if not number(text):
        raise ValueError
    return float(text)


class Commands:
    """Adds commands to a parser."""

    def __init__(self, top: Parser) -> None:
        self.commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)

    def add(self, name: str, function, text: str) -> argparse.ArgumentParser:
        """Adds a command that calls a function with its arguments."""
        command = self.commands.add_parser(name, help=text, description=text)
        command.set_defaults(function=function)
        return command


def add_out(command: argparse.ArgumentParser, text: str, metavar: str = "DIR", **more) -> None:
    """Adds a command's output option."""
    command.add_argument("-o", dest="out", type=Path, metavar=metavar, help=text, **more)


def add_machine(command: argparse.ArgumentParser, default: str | None = None, text: str | None = None,
                choices: Iterable[str] = MEASURED, **more) -> None:
    """Adds the option that chooses the emulated machine."""
    command.add_argument("--machine", choices=tuple(choices), default=default, help=text, **more)


def add_scenes(commands: Commands) -> None:
    """Adds the commands that draw scenes."""
    command = commands.add("run", run, "Render a scene: dumps, pictures and run.json.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_out(command, "where to (build/run/SCENE); results of an earlier run are replaced")
    add_machine(command, "a1200-fast", "a1200: 2 MB chip RAM; a1200-fast: + 8 MB fast RAM; a1200-030: the same "
                "with a 68EC030", MACHINES)
    command.add_argument("--frames", type=int, metavar="N",
                         help="how many, from the first (as the scene says)")
    command.add_argument("--form", choices=FORMS, default=FORMS[0],
                         help="which span and edge loops (addx); the picture is the same")
    command.add_argument("--off", metavar="RULES", help="rules of lowering that are not followed, "
                         "by commas, or all: the picture is the same but for tolerances")

    command = commands.add("show", show, "Play a scene in a window, on the emulated machine's screen: "
                           "space pauses, cursor keys change the accuracy, escape leaves.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_machine(command, "a1200-fast", "as run has them (a1200-fast)", MACHINES)

    command = commands.add("demo", demo,
                           "Make the demo's folder, which can be run on an Amiga as it is.")
    add_out(command, "where to (build/demo)")
    command.add_argument("--play", action="store_true", help="play it in a window too: space goes "
                         "on to the next part, escape leaves")
    add_machine(command, "a1200-fast", "what it is played on (a1200-fast)")

    command = commands.add("scene-program", scene_program,
                           "Make a program that holds one scene and what draws it alone.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_out(command, "where to (build/scene/SCENE)")
    add_machine(command, "a1200", "where its frames and times are compared (a1200)")

    command = commands.add("profile", profile, "Show where a scene's cycles go, routine by routine.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_out(command, "where to (build/profile/SCENE)")
    add_machine(command, "a1200-fast", "as run has them (a1200-fast)", MACHINES)
    command.add_argument("--frames", type=int, metavar="N",
                         help="how many, from the first (as the scene says)")


def add_measurements(commands: Commands) -> None:
    """Adds the commands that measure and compare with the committed figures."""
    command = commands.add("bench", bench, "Measure every kernel: bench.json, tables and pictures.")
    add_out(command, "where to (build/bench)")
    add_machine(command, None, "one machine instead of all", CONDITIONS)
    command.add_argument("--only", metavar="PATTERN", help="kernels with such names, as affine_*")
    command.add_argument("--accept", action="store_true",
                         help="make the result the committed baseline")

    command = commands.add("accuracy", accuracy,
                           "Measure error and cycles of every accuracy setting and mapper.")
    add_out(command, "where to (build/accuracy)")
    add_machine(command, None, "one machine instead of both")
    command.add_argument("--set", action="append", metavar="NAME",
                         help="one set of polygons (small, medium, large, thin, steep; with depth: "
                              "depth, deep), a turning face by each method (methods), the scenes "
                              "(scenes), the orders of meshes (orders), texture engines' modes (n64, "
                              "glide), or the hard cases (hard); may be given several times")
    command.add_argument("--accept", action="store_true",
                         help="make the medium set the committed baseline")

    command = commands.add("polys", polys, "Count polygons a second, as fatmap2's test program does.")
    add_out(command, "where to (build/polys)")
    add_machine(command, None, "one machine instead of both")
    command.add_argument("--accept", action="store_true",
                         help="make the result the committed baseline")


def add_checks(commands: Commands) -> None:
    """Adds the commands that check the renderer against the model, bounds and reference data."""
    command = commands.add("fuzz", fuzz,
                           "Draw random polygons and hold each to the model and to the derived bounds.")
    families.add_arguments(command)
    add_machine(command, "a1200-fast", "and musashi, the second processor; alone: the A1200 draws a quarter",
                (*MEASURED, SECOND))

    command = commands.add("vectors", vectors,
                           "Ask the texture engines the questions of reference data: 0 all right "
                           "(Glide's: up to 2 of 1,000 may differ, 5 with perspective), 1 too many wrong.")
    command.add_argument("files", type=Path, nargs="+", metavar="FILE",
                         help="text, gzipped or not, for the N64's engine or Glide's, as its "
                         "commands say; a name that begins with tmu2: filter weights of 8 bits, "
                         "as in Voodoo 2; all are run in one boot")
    add_machine(command, "a1200-fast")


def add_maps(commands: Commands) -> None:
    """Adds the commands that convert textures."""
    command = commands.add("map", to_map, "Write a PNG or JPEG as a texture map in memory layout.")
    command.add_argument("source", type=Path, metavar="PICTURE")
    add_out(command, "the texels; FILE.json beside it says what they are", "FILE", required=True)
    command.add_argument("--layout", choices=LAYOUTS, default=LAYOUTS[0])
    command.add_argument("--format", choices=tuple(FORMATS), default="chunky",
                         help="palette indices (chunky), or what a texel's bytes are")

    command = commands.add("picture", to_picture, "Write a texture map as a PNG.")
    command.add_argument("source", type=Path, metavar="FILE")
    add_out(command, None, "PICTURE.png", required=True)


def add_choose(commands: Commands) -> None:
    """Adds the command that looks up settings."""
    command = commands.add("choose", choose,
                           "Name the cheapest setting of a material that keeps an error.")
    command.add_argument("--error", type=number, required=True, metavar="TEXELS",
                         help="how far u and v may be off, anywhere")
    add_machine(command, required=True)
    command.add_argument("--rms", action="store_true",
                         help="hold the root of the mean square to it instead of the largest error")
    command.add_argument("--wrong", type=number, metavar="PIXELS",
                         help="how many pixels in a million may be on an edge's wrong side (any)")
    kind = command.add_mutually_exclusive_group()
    kind.add_argument("--pixels", type=size, metavar="N",
                      help="polygons of about N pixels: 8, 25, 100, 500 or 2,000 (2,000)")
    kind.add_argument("--depth", action="store_true",
                      help="polygons with depth, whose texture is seen in perspective")
    command.add_argument("--mapper", choices=MAPPERS[1],
                         help="this mapper alone (affine, generated, tiled or columns)")
    command.add_argument("--data", type=Path, metavar="FILE",
                         help="an accuracy.json, as make accuracy writes it (the committed baseline)")


def add_products(commands: Commands) -> None:
    """Adds the commands that make products: library, report, disk, pages."""
    command = commands.add("sdk", sdk,
                           "Make the SDK: include files, C sources, hunk and ELF objects, an example.")
    add_out(command, "where to (build/sdk); an archive of it goes beside it")

    command = commands.add("report", report, "Gather every figure and picture in one page: index.html.")
    add_out(command, "where to (build/report)")
    command.add_argument("--scene", action="append", metavar="NAME",
                         help="a scene of tests/scenes instead of all; may be given several times")
    add_machine(command, "a1200-fast", "what scenes are drawn on (a1200-fast)")
    command.add_argument("--committed", action="store_true",
                         help="take the committed figures of bench, accuracy and polygons instead "
                              "of measuring, and leave out what is not committed")

    command = commands.add("adf", adf,
                           "Write the image of a bootable disk: demo, the owners' bench, readme.")
    add_out(command, "where to (build/adf/tmap020.adf)", "FILE")

    commands.add("readme", readme,
                 "Bring the tables and pictures of README.md and the rooms' pages up to date.")


def add_diff(commands: Commands) -> None:
    """Adds the command that compares runs."""
    command = commands.add("diff", diff,
                           "Compare two dumps, pictures or run directories: 0 equal, 1 different.")
    command.add_argument("a", type=Path, metavar="A")
    command.add_argument("b", type=Path, metavar="B")
    add_out(command, "where pictures of the differences go")


def parser() -> Parser:
    """Returns the parser of all commands."""
    top = Parser(prog="tmap", description="Texture mapping on an emulated Amiga 1200.")
    commands = Commands(top)
    for add in (add_scenes, add_measurements, add_checks, add_maps, add_choose, add_products, add_diff):
        add(commands)
    return top


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns the exit status."""
    end_by((signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT))
    streams.prepare()
    try:
        try:
            args = parser().parse_args(arguments)
            return args.function(args)
        finally:
            sys.stdout.flush()
    except UserError as error:
        print(f"tmap: {error}", file=sys.stderr)
    except OSError as error:
        lost = streams.drop_output() or isinstance(error, BrokenPipeError)
        print(f"tmap: {error.filename or ('standard output' if lost else 'a file')}: "
              f"{error.strerror or error}", file=sys.stderr)
    except KeyboardInterrupt:
        print("tmap: interrupted", file=sys.stderr)
        return 130
    return 2


if __name__ == "__main__":
    sys.exit(main())
