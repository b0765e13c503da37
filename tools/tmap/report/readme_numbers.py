"""The tables of the page on numbers: formats, and the bounds derived in tools/tmap/ideal/bounds.py
and its neighbours."""

from dataclasses import dataclass, replace
from functools import cache

from tmap.base import elementary
from tmap.base.markdown import table
from tmap.corpus import polygon_sets
from tmap.ideal import bounds, bounds_perspective, ideal, mesh
from tmap.model import model
from tmap.setup.dithered import MOST
from tmap.setup.edges import Edge
from tmap.setup.far import LOWEST, TABLE
from tmap.setup.texturing import Settings


@dataclass(frozen=True)
class Format:
    """A fixed-point format: ``bits`` in all, ``fraction`` of them (a negative number: the unit is
    more than 1), signed or not; the file that introduces it, and the test that checks it."""

    name: str
    what: str
    bits: int
    fraction: int
    is_signed: bool
    rounding: str
    place: str
    proof: str

    @property
    def step(self) -> str:
        """The least difference of two numbers."""
        return "1" if not self.fraction else f"1/{2 ** self.fraction:,}" if self.fraction < 19 \
            else f"2^-{self.fraction}"

    @property
    def ends(self) -> tuple[str, str]:
        """The least number, and the first number that is too large."""
        power = self.bits - self.fraction - self.is_signed
        end = f"{2 ** power:,}" if power < 25 else f"2^{power}"
        return f"-{end}" if self.is_signed else "0", end


FORMATS = (
    Format("16.16", "x, y, s, t, shade and w of a vertex; steps; what C passes", 32, 16, True,
           "nearest", "c/polygon/vertex.h", "tests/polygon/test_polygons.py"),
    Format("ff:ii, swapped", "the same word with its halves exchanged, for addx", 32, 16, True,
           "none", "src68k/span/step.s", "tests/kernels/trials/pixel.py"),
    Format("8.16", "u and v of a span's chain, modulo 256 texels", 24, 16, False,
           "steps: nearest, starts: up", "src68k/span/affine_addx.s", "tests/kernels/trials/span.py"),
    Format("8.15", "v of tiles, modulo 256; u keeps 16", 23, 15, False,
           "steps: nearest, starts: up", "src68k/span/tiled.s", "tests/kernels/trials/tiled.py"),
    Format("15.13", "u and v of columns, 18 bits for both integers", 28, 13, False,
           "steps: nearest, starts: up", "src68k/span/columns.s", "tests/kernels/trials/tiled.py"),
    Format("0.32", "an edge's error: what is missing to the next pixel", 32, 32, False,
           "none where edges are exact", "c/span/scanline.h", "tests/kernels/trials/edge.py"),
    Format("32.32", "gradients of planes before they are rounded to steps", 64, 32, True, "towards 0",
           "src68k/polygon/texturing_plane.s", "tests/kernels/trials/texturing.py"),
    Format("6.26", "those of spans without perspective, below 16 texels a pixel", 31, 26, True, "down",
           "src68k/polygon/texturing_gentle.s", "tests/kernels/trials/outline.py"),
    Format("6.16", "levels of light, multiples of 4 units", 22, 16, False,
           "steps: nearest, starts: up", "c/span/scanline.h", "tests/kernels/trials/lit.py"),
    Format("2.62", "q = 1/w over the least w's, on its plane", 64, 62, True, "see the bounds",
           "c/span/perspective.h", "tests/accuracy/test_ideal_perspective.py"),
    Format("8.24", "u and v of lines from their far ends, modulo 256", 32, 24, False, "see the bounds",
           "c/span/far.h", "tests/kernels/trials/far.py"),
    Format("12.4", "x and y of a snapped vertex: x + 1, y + 15/16", 16, 4, True, "nearest",
           "c/triangle/triangles.h", "tests/kernels/trials/triangle.py"),
    Format("12.20", "its u, v or shade, modulo 4,096", 32, 20, True, "up, by 1/128",
           "c/triangle/triangles.h", "tests/kernels/trials/triangle.py"),
    Format("14.0", "points of a mesh and factors of its view for 16-bit operands, in units of their own", 15,
           0, True, "nearest", "c/mesh/records.h", "tests/mesh/test_mesh16.py"),
    Format("2.30", "factors of a mesh's view", 32, 30, True, "nearest", "c/scene/scene_file.h",
           "tests/mesh/test_mesh_ideal.py"),
    Format("9.7", "factors of normals: environment, light", 16, 7, True, "nearest",
           "c/scene/scene_file.h", "tests/mesh/test_mesh_ideal.py"),
    Format("s10.5", "s and t of the N64's texture engine", 16, 5, True, "as the hardware",
           "c/n64/n64.h", "tests/n64/test_vectors.py"),
    Format("s0.15", "its w, 0x7fff being 1.0", 16, 15, True, "as the hardware", "c/n64/passes.h",
           "tests/n64/test_vectors.py"),
    Format("10.2", "edges of its tiles", 12, 2, False, "-", "c/n64/n64.h", "tests/n64/test_words.py"),
    Format("s15.16", "its iterators over a polygon", 32, 16, True, "nearest", "c/n64/polygons/plan.h",
           "tests/n64/test_model_polygons.py"),
    Format("14.18", "s and t of Glide's unit, 0 to 256 along the longer side", 32, 18, True,
           "as the hardware", "c/glide/glide.h", "tests/glide/test_vectors.py"),
    Format("2.30 of w", "1/w of Glide's unit", 32, 30, True, "as the hardware", "c/glide/glide.h",
           "tests/glide/test_vectors.py"),
    Format("8.8", "its level of detail: 0 is a texel of level 0 a pixel", 16, 8, True,
           "as the hardware", "c/glide/glide.h", "tests/glide/test_model.py"),
    Format("0.4, 0.8", "its filter's weights: of Voodoo and of Voodoo 2", 4, 4, False, "down",
           "c/glide/glide.h", "tests/glide/test_vectors.py"))


def formats_table() -> str:
    """Returns a Markdown table: each format, its range, its step, and its file."""
    rows = [[f.name, f.what, *f.ends, f.step, f.rounding, f"`{f.place}`", f"`{f.proof}`"]
            for f in FORMATS]
    return table(["format", "of", "from", "below", "step", "rounding", "introduced in", "held by"],
                 rows, "llrrrl")


EXACT = Settings("exact")
#: Lines of the table of errors: title, settings. Each is for the large triangles of
#: tools/tmap/corpus/polygon_sets.py.
JUDGED = (
    ("edges `integer`, two divides a polygon", Settings("integer", "polygon", "truncated")),
    ("edges `subpixel`, two divides a polygon", Settings("subpixel", "polygon", "truncated")),
    ("the same, started at the texel", Settings("subpixel", "polygon", "subtexel")),
    ("edges `exact`, two divides a scanline", replace(EXACT, gradients="scanline")),
    ("`subpixel`, the plane, started where the edge crosses",
     Settings("subpixel", "plane", "truncated")),
    ("`subpixel`, the plane, started at the texel", Settings()),
    ("`snapped`, in 32 bits", Settings("snapped")),
    ("`exact`, the plane, started at the texel", EXACT),
    ("the same in tiles", replace(EXACT, mapper="tiled")),
    ("in columns", replace(EXACT, mapper="columns")),
    ("by generated code", replace(EXACT, mapper="generated")),
    ("dithered points", replace(EXACT, mapper="dithered")))
DEEP = (("perspective `every16`", "every16"), ("`every8`", "every8"),
        ("`pixel`", "pixel"), ("`fine`", "fine"))
SIZE, LARGE = (polygon_sets.WIDTH, polygon_sets.HEIGHT), (1024, 1024)


def judged(settings: Settings, name: str) -> bounds.Verdict:
    """Returns the worst results of a set of triangles."""
    total = bounds.Verdict()
    for vertices in polygon_sets.polygons(name)[::4]:
        total.merge(bounds.judge(vertices, settings, *SIZE))
    return total


@cache
def judged_table() -> str:
    """A Markdown table: the largest error of every setting, and the bound derived there."""
    rows = [(title, settings, "large") for title, settings in JUDGED]
    rows += [(title, replace(EXACT, perspective=setting), "depth") for title, setting in DEEP]
    cells = []
    for title, settings, name in rows:
        found = judged(settings, name)
        cells.append([title, f"{found.coverage_errors:,}", f"{found.texel_error:.6f}",
                      f"{found.texel_bound:.6f}", f"{100 * found.texel_ratio:.0f} %"])
    return table(["setting", "wrong pixels", "largest error, texels", "its bound there",
                  "nearest to a bound"], cells)


def edge_off(lines: int) -> float:
    """Returns the error bound in pixels of a rounded edge at its line ``lines``, counted from 1."""
    return bounds.edge_bound(Edge((1, 1), (65537 * 999 + 3, 65537 * 1023 + 5), 1, 1024, False), lines)


def pixels(x: float) -> str:
    """Returns a small number as digits and as a fraction 1/n."""
    return f"{x:.2g} (1/{1 / x:,.0f})" if x < 0.1 else f"{x:g}"


def seen(size: tuple[int, int]) -> model.Texturing:
    """Returns a texturing whose plane is given at the middle of a polygon as large as a frame."""
    width, height = size
    return model.Texturing(0, 0, 0, 0, False, i=width // 2, j=height // 2, box=(0, 0, width, height),
                           gentle=True)


def bounds_table() -> str:
    """Returns a Markdown table of the derived bounds, evaluated for typical arguments."""
    # gradients halfway between two steps
    planes = [ideal.Plane([(0, 0), (1 << 24, 0), (0, 1 << 24)],
                          [0, (3 << 23) + (128 << cut), (5 << 22) + (128 << cut)]) for cut in (0, 1)]
    corner, large = ([plane.bound(*size, seen(size), cut) for cut, plane in enumerate(planes)]
                     for size in (SIZE, LARGE))
    rows = [
        ("a rounded edge, pixels: its first line", edge_off(1), "ideal.bounds.edge_bound"),
        ("... 256 lines below", edge_off(257), "ideal.bounds.edge_bound"),
        ("... 1,022 lines below, the most", edge_off(1023), "ideal.bounds.edge_bound"),
        ("an exact edge: the rational result", None, "ideal.bounds.check_coverage"),
        ("a gradient of 1 texel a pixel before it is rounded", ideal.Plane.cut(1, True),
         "ideal.ideal.Plane.cut"),
        ("... of 256", ideal.Plane.cut(256), "ideal.ideal.Plane.cut"),
        ("u in the corner of a polygon of 320x256 pixels", corner[0], "ideal.ideal.Plane.bound"),
        ("... where u's lowest bit is kept free", corner[1], "ideal.ideal.Plane.bound"),
        ("u in the corner of a polygon of 1,024x1,024 pixels", large[0], "ideal.ideal.Plane.bound"),
        ("... where u's lowest bit is kept free", large[1], "ideal.ideal.Plane.bound"),
        ("dithered points: what they are moved by", MOST, "setup.dithered.MOST"),
        ("`pixel`, between exact points", bounds_perspective.TOLERANCE["pixel"],
         "ideal.bounds_perspective.TOLERANCE"),
        ("`fine`, between exact points", bounds_perspective.TOLERANCE["fine"],
         "ideal.bounds_perspective.TOLERANCE"),
        ("a reciprocal of the table, part of the number", 0.5 / TABLE[-1],
         "setup.far.TABLE"),
        ("half the width of its least index, the same", 0.5 / LOWEST, "setup.far.LOWEST"),
        ("a mesh's point before the camera, reach 1, units", mesh.camera_error(1),
         "ideal.mesh.camera_error"),
        ("... reach 2,048", mesh.camera_error(2048), "ideal.mesh.camera_error"),
        ("on the screen, depth 1, reach 1, pixels", mesh.screen_error(9, 1, 1),
         "ideal.mesh.screen_error"),
        ("... depth 16", mesh.screen_error(9, 16, 1), "ideal.mesh.screen_error"),
        ("s, t of an environment, texels", mesh.look_error(128), "ideal.mesh.look_error")]
    return table(["what", "off by at most", "derived in tools/tmap/"],
                 [[what, pixels(x) if x else "0", f"`{where}`"] for what, x, where in rows], "lrl")


def tables() -> dict[str, str]:
    """Returns the tables by title."""
    return {"formats": formats_table(), "bounds": bounds_table(), "errors": judged_table()}
