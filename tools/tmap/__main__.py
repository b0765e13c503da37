"""The command line: ``scripts/tmap COMMAND ...``.

Exit status: 0 done; 1 a comparison found a difference; 2 bad input or a failed run, with a message
of one line; 130 interrupted; 129, 131, 143 ended by SIGHUP, SIGQUIT, SIGTERM.
"""

import argparse
import signal
import sys
from pathlib import Path

from tmap import actions
from tmap.base import streams
from tmap.base.errors import UserError
from tmap.base.pixel_formats import FORMATS
from tmap.base.signals import end_by
from tmap.fuzz import families
from tmap.guest.conditions import CONDITIONS
from tmap.guest.emulator import MACHINES, MEASURED, SECOND, STALL_SECONDS
from tmap.parser import Commands, Parser, add_machine, add_out, number, pair, rate, size
from tmap.run.convert import LAYOUTS
from tmap.scene_file.textures import MAPPERS

FORMS = ("addx", "swap", "c")


def add_scenes(commands: Commands) -> None:
    """Adds the commands that draw scenes."""
    command = commands.add("run", actions.run, "Render a scene: dumps, pictures and run.json.")
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

    command = commands.add("show", actions.show, "Play a scene in a window, on the emulated machine's screen: "
                           "space pauses, cursor keys change the accuracy, G holds a rate, escape leaves.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    command.add_argument("--fps", type=rate, metavar="RATE",
                         help="hold that many frames a second, 5 to 50, by giving up accuracy and resolution")
    add_machine(command, "a1200-fast", "as run has them (a1200-fast)", MACHINES)

    command = commands.add("demo", actions.demo,
                           "Make the demo's folder, which can be run on an Amiga as it is.")
    add_out(command, "where to (build/demo)")
    command.add_argument("--play", action="store_true", help="play it in a window too: space goes "
                         "on to the next part, escape leaves")
    add_machine(command, "a1200-fast", "what it is played on (a1200-fast)")

    command = commands.add("scene-program", actions.scene_program,
                           "Make a program that holds one scene and what draws it alone.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_out(command, "where to (build/scene/SCENE)")
    add_machine(command, "a1200", "where its frames and times are compared (a1200)")
    command.add_argument("--accept", action="store_true",
                         help="write its size to tests/baseline/programs.json, from which the page's table is made")

    command = commands.add("profile", actions.profile, "Show where a scene's cycles go, routine by routine.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_out(command, "where to (build/profile/SCENE)")
    add_machine(command, "a1200-fast", "as run has them (a1200-fast)", MACHINES)
    command.add_argument("--frames", type=int, metavar="N",
                         help="how many, from the first (as the scene says)")


def add_measurements(commands: Commands) -> None:
    """Adds the commands that measure and compare with the committed figures."""
    command = commands.add("bench", actions.bench, "Measure every kernel: bench.json, tables and pictures.")
    add_out(command, "where to (build/bench)")
    add_machine(command, None, "one machine instead of all", CONDITIONS)
    command.add_argument("--only", metavar="PATTERN", help="kernels with such names, as affine_*")
    command.add_argument("--accept", action="store_true",
                         help="make the result the committed baseline")

    command = commands.add("accuracy", actions.accuracy,
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

    command = commands.add("polys", actions.polys, "Count polygons a second, as fatmap2's test program does.")
    add_out(command, "where to (build/polys)")
    add_machine(command, None, "one machine instead of both")
    command.add_argument("--accept", action="store_true",
                         help="make the result the committed baseline")


def add_checks(commands: Commands) -> None:
    """Adds the commands that check the renderer against the model, bounds and reference data."""
    command = commands.add("fuzz", actions.fuzz,
                           "Draw random polygons and hold each to the model and to the derived bounds.")
    families.add_arguments(command)
    add_machine(command, "a1200-fast", "and musashi, the second processor; alone: the A1200 draws a quarter",
                (*MEASURED, SECOND))

    command = commands.add("vectors", actions.vectors,
                           "Ask the texture engines the questions of reference data: 0 all right "
                           "(Glide's: up to 2 of 1,000 may differ, 5 with perspective), 1 too many wrong.")
    command.add_argument("files", type=Path, nargs="+", metavar="FILE",
                         help="text, gzipped or not, for the N64's engine or Glide's, as its "
                         "commands say; a name that begins with tmu2: filter weights of 8 bits, "
                         "as in Voodoo 2; all are run in one boot")
    add_machine(command, "a1200-fast")


def add_maps(commands: Commands) -> None:
    """Adds the commands that convert textures."""
    command = commands.add("map", actions.to_map,
                           "Write PNGs or JPEGs as texture maps in memory layout; several share a palette.")
    command.add_argument("sources", type=Path, nargs="+", metavar="PICTURE")
    add_out(command, "the texels; PATH.json beside it says what they are. Of several pictures: a folder for each one's "
            "NAME.map and NAME.map.json, and the file palette, as screen_palette takes it", "PATH", required=True)
    command.add_argument("--layout", choices=LAYOUTS, default=LAYOUTS[0])
    command.add_argument("--format", choices=tuple(FORMATS), default="chunky",
                         help="palette indices (chunky), or what a texel's bytes are")
    command.add_argument("--colours", type=int, metavar="N",
                         help="palette entries that chunky texels use at most (256)")

    command = commands.add("light", actions.to_light, "Write the light table of a picture's colours, for lit mappers.")
    command.add_argument("source", type=Path, metavar="PICTURE")
    add_out(command, "64 levels of 256 bytes; FILE.json beside it has the palette", "FILE", required=True)
    command.add_argument("--towards", default="#000000", metavar="#RRGGBB", help="the colour of level 0 (black)")

    command = commands.add("mesh", actions.to_mesh, "Write a model as a C header for programs with the kit.")
    command.add_argument("source", type=Path, metavar="MODEL.obj")
    add_out(command, "the header; its name is the mesh's", "FILE.h", required=True)
    command.add_argument("--size", type=number, default=1.0, metavar="FACTOR", help="what coordinates are times (1)")
    command.add_argument("--triangles", action="store_true", help="cut all faces into triangles")

    command = commands.add("picture", actions.to_picture, "Write a texture map as a PNG.")
    command.add_argument("source", type=Path, metavar="FILE")
    add_out(command, None, "PICTURE.png", required=True)


def add_choices(commands: Commands) -> None:
    """Adds the commands that choose settings."""
    command = commands.add("fit", actions.fit, "Find the most exact settings of a scene that hold a frame rate on the "
                           "screen, by measuring: 0 found, 1 none holds it, and the nearest is said.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    command.add_argument("--fps", type=rate, required=True, metavar="RATE",
                         help="frames a second that the worst frame must hold, up to 50")
    add_machine(command, "a1200-fast", "as run has them (a1200-fast)")
    add_out(command, "where to (build/fit/SCENE)")

    command = commands.add("choose", actions.choose,
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
    command = commands.add("sdk", actions.sdk,
                           "Make the SDK: include files, C sources, hunk and ELF objects, an example.")
    add_out(command, "where to (build/sdk); an archive of it goes beside it")

    command = commands.add("report", actions.report, "Gather every figure and picture in one page: index.html.")
    add_out(command, "where to (build/report)")
    command.add_argument("--scene", action="append", metavar="NAME",
                         help="a scene of tests/scenes instead of all; may be given several times")
    add_machine(command, "a1200-fast", "what scenes are drawn on (a1200-fast)")
    command.add_argument("--committed", action="store_true",
                         help="take the committed figures of bench, accuracy and polygons instead "
                              "of measuring, and leave out what is not committed")

    command = commands.add("adf", actions.adf,
                           "Write the image of a bootable disk: demo, the owners' bench, readme.")
    add_out(command, "where to (build/adf/tmap020.adf)", "FILE")

    command = commands.add("play", actions.play, "Make a bootable disk, or a folder, with which an Amiga plays a scene.")
    command.add_argument("scene", type=Path, metavar="SCENE.toml")
    add_out(command, "where to: FILE.adf, or a folder (build/play/SCENE.adf)", "PATH")
    add_machine(command, "a1200-fast", "whose memory must hold it (a1200-fast)", MACHINES)
    command.add_argument("--fps", type=rate, metavar="RATE", help="hold that many frames a second, as show does")

    command = commands.add("emulate", actions.emulate, "Run an Amiga program without a window: its output here, its "
                           "return code as the status, what it writes in a folder. 2 too if it crashes or hangs.")
    add_out(command, "where to put what it writes (build/emulate/PROGRAM)")
    add_machine(command, "a1200-fast", "as run has them (a1200-fast)", MACHINES)
    command.add_argument("--input", action="append", type=Path, default=[], metavar="FILE",
                         help="a file to put beside it; may be given several times")
    command.add_argument("--picture", type=pair, metavar="WIDTHxHEIGHT",
                         help="what it writes of so many pixels becomes a PNG too")
    command.add_argument("--format", choices=tuple(FORMATS), default="chunky",
                         help="of these pixels: palette indices (chunky), or what their bytes are")
    command.add_argument("--palette", type=Path, metavar="FILE", help="a PNG, or map's JSON: of chunky pixels (greys)")
    command.add_argument("--limit", type=size, default=STALL_SECONDS, metavar="SECONDS",
                         help="of the host's processor time without output, after which it hangs "
                              f"({STALL_SECONDS:g})")
    command.add_argument("program", type=Path, metavar="PROGRAM", help="a hunk file, or an ELF program of ld -q")
    command.add_argument("arguments", nargs=argparse.REMAINDER, metavar="ARGUMENTS")

    commands.add("readme", actions.readme,
                 "Bring the tables and pictures of README.md and the rooms' pages up to date.")


def add_diff(commands: Commands) -> None:
    """Adds the command that compares runs."""
    command = commands.add("diff", actions.diff,
                           "Compare two dumps, pictures or run directories: 0 equal, 1 different.")
    command.add_argument("a", type=Path, metavar="A")
    command.add_argument("b", type=Path, metavar="B")
    add_out(command, "where pictures of the differences go")


def parser() -> Parser:
    """Returns the parser of all commands."""
    top = Parser(prog="tmap", description="Texture mapping on an emulated Amiga 1200.")
    commands = Commands(top)
    for add in (add_scenes, add_measurements, add_checks, add_maps, add_choices, add_products, add_diff):
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
