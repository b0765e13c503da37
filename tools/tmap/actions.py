"""What the commands do: each brings the Amiga programs up to date, if it runs them, then calls its tool."""

import argparse
import subprocess
import sys

from tmap.base.errors import UserError
from tmap.base.paths import BUILD, ROOT


def build_programs() -> None:
    """Brings the Amiga programs up to date; prints nothing unless that fails."""
    done = subprocess.run(["make", "-s", "-C", str(ROOT), "programs"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode:
        print(done.stdout, end="", file=sys.stderr)
        raise UserError("the Amiga programs cannot be built: make programs failed")


def run(args: argparse.Namespace) -> int:
    """Renders a scene; what it prints of texture units has the addx form and all rules, as programs of scenes."""
    build_programs()
    from tmap.product import profile
    from tmap.run import run as tool
    done = tool.command(args.scene, args.out or BUILD / "run" / args.scene.stem, args.machine,
                        args.frames, args.form, args.off)
    if not args.off:
        profile.print_units(args.scene, args.machine, args.frames)
    return done


def show(args: argparse.Namespace) -> int:
    """Plays a scene in a window."""
    from tmap.run import show as tool
    window = tool.window()
    build_programs()
    return tool.command(args.scene, args.machine, window, args.fps)


def demo(args: argparse.Namespace) -> int:
    """Makes the demo's folder."""
    build_programs()
    from tmap.run import demo as tool
    return tool.command(args.out or BUILD / "demo", args.machine if args.play else None)


def scene_program(args: argparse.Namespace) -> int:
    """Makes the program of one scene."""
    build_programs()
    from tmap.product import scene_program as tool
    return tool.command(args.scene, args.out or BUILD / "scene" / args.scene.stem, args.machine, args.accept)


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
    return tool.command(args.seed, args.first, args.count, args.machine, args.keep, args.family,
                        args.record)


def fit(args: argparse.Namespace) -> int:
    """Searches settings that hold a frame rate."""
    build_programs()
    from tmap.accuracy.fit import fit as tool
    return tool.command(args.scene, args.fps, args.machine, args.out or BUILD / "fit" / args.scene.stem)


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


def play(args: argparse.Namespace) -> int:
    """Makes a folder or disk that plays a scene."""
    build_programs()
    from tmap.product import play as tool
    return tool.command(args.scene, args.out or BUILD / "play" / f"{args.scene.stem}.adf", args.machine, args.fps)


def emulate(args: argparse.Namespace) -> int:
    """Runs any Amiga program."""
    build_programs()
    from tmap.product import emulate as tool
    return tool.command(args.program, args.arguments, args.out or BUILD / "emulate" / args.program.stem, args.machine,
                        args.input, args.picture, args.format, args.palette, args.limit)


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
    """Converts pictures to maps."""
    from tmap.run import convert as tool
    return tool.map_command(args.sources, args.out, args.layout, args.format, args.colours)


def to_light(args: argparse.Namespace) -> int:
    """Makes the light table of a picture."""
    from tmap.run import convert as tool
    return tool.light_command(args.source, args.out, args.towards)


def to_mesh(args: argparse.Namespace) -> int:
    """Converts a model to a C header."""
    from tmap.run import mesh_header as tool
    return tool.command(args.source, args.out, args.size, args.triangles)


def to_picture(args: argparse.Namespace) -> int:
    """Converts a map to a picture."""
    from tmap.run import convert as tool
    return tool.picture_command(args.source, args.out)
