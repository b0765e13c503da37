"""The pages' tables of loops, polygons, meshes and rules, with cycles from the baselines."""

from tmap.accuracy import dither_errors
from tmap.base.markdown import MACHINES, table
from tmap.bench import bench, edges, published, rules
from tmap.corpus.polygon_sets import SIZES
from tmap.guest.emulator import CLOCK_HZ
from tmap.setup.shading import LIT

#: Lines of the comparison: title, name with {} for the form, length.
LINES = [("step, 1 interpolant", "step_{}_1", 1024), ("step, 2", "step_{}_2", 1024),
         ("step, 3", "step_{}_3", 1024), ("pixel, 1 interpolant", "pixel_{}_1", 256),
         ("pixel, 2 (affine)", "pixel_{}_2", 256), ("pixel, 3 (affine, lit)", "pixel_{}_3", 256),
         *((f"affine span of {n} pixels, set-up included", "affine_{}", n)
           for n in (256, 64, 16, 4))]


def versus_table(baseline: dict) -> str:
    """Returns a Markdown table: swap / addx on each machine, cycles a pixel or step."""
    figures = bench.figures(baseline["rows"])
    rows = [[title, *(" / ".join(f"{figures[name.format(form), machine, length]:.1f}"
                                 for form in ("swap", "addx")) for machine in MACHINES)]
            for title, name, length in LINES]
    rows.append([f"the same span in C ({baseline['compiler']}), 256 pixels",
                 *(f"{figures['affine_c', machine, 256]:.1f}" for machine in MACHINES)])
    return table(["cycles, swap / addx", *MACHINES.values()], rows, "l")


def triangles_table(baseline: dict) -> str:
    """Returns a Markdown table: triangles with snapped vertices by mapper and pixels."""
    found = {(r["name"], r["machine"], r["length"]): r["cycles_per_polygon"]
             for r in baseline["polygons"]}
    sizes = list(dict.fromkeys(size for *_, size in found))
    rows = [[name.removeprefix("polygon_").replace("triangle_lines", "a table of lines:").replace("_", " "), MACHINES[machine],
             *(f"{found[name, machine, size]:,.0f}" for size in sizes)]
            for name, machine in dict.fromkeys((name, machine) for name, machine, _ in found)]
    return table(["mapper", "memory", *(f"{size:,} pixels" for size in sizes)], rows, "ll")


#: Lines of the table of prices by size: edges, gradients, start.
PRICE_LINES = (("integer", "polygon", "truncated"), ("subpixel", "polygon", "truncated"),
               ("subpixel", "plane", "subtexel"), ("snapped", "plane", "subtexel"),
               ("exact", "plane", "subtexel"))


def prices_table(baseline: dict, accuracy: dict,
                 mappers: tuple[str, ...] = ("flat", "gouraud", "affine", "lit", "lit_gouraud")) -> str:
    """Returns a Markdown table: triangles in fast RAM by settings and pixels, and published ones."""
    figures = {(r["name"], r["length"]): r["cycles_per_polygon"] for r in baseline["polygons"]
               if r["machine"] == "a1200-fast"}
    found = {(r["mapper"], *(r[s] for s in ("edges", "gradients", "start")), r["name"]): r
             for r in accuracy["rows"] if r["machine"] == "a1200-fast"}
    rows = []
    for mapper in mappers:
        for settings in PRICE_LINES:
            if (mapper, *settings, "8_pixels") not in found:
                continue
            some = [found[mapper, *settings, name] for name in SIZES]
            wrong = sum(r["coverage_errors_per_million"] * n for r, n in zip(some, SIZES.values()))
            errors = [f"{wrong / sum(SIZES.values()) / 10_000:.1f} %",
                      "" if mapper == "flat" else f"{max(r['texel_error_max'] for r in some):.3f}"]
            if settings[0] == "snapped" and mapper not in LIT:
                rows.append([mapper, "snapped, in a batch", *(f"{figures[f'polygon_{mapper}', n]:,.0f}"
                                                             for n in SIZES.values()), *errors])
            rows.append([mapper, ", ".join(settings),
                         *(f"{r['cycles_per_polygon']:,.0f}" for r in some), *errors])
        rows += [[mapper, f"{each.name}: {each.source}", *(f"{c:,}" for c in each.cycles),
                  f"{each.pixels:g} %", "" if each.texels is None else f"{each.texels:g} % wrong"]
                 for each in published.RENDERERS if each.kind == mapper]
    return table(["mapper", "settings, or a published renderer", *(f"{n:,} px" for n in SIZES.values()),
                  "wrong pixels", "largest error"], rows, "ll")


#: Lines of the table of accuracy's costs: edges, gradients, start, mapper.
ACCURACY_LINES = (("integer", "polygon", "truncated", "affine"),
                  ("subpixel", "polygon", "truncated", "affine"),
                  ("subpixel", "polygon", "subtexel", "affine"),
                  ("subpixel", "plane", "subtexel", "affine"),
                  ("snapped", "plane", "subtexel", "affine"),
                  ("exact", "plane", "subtexel", "affine"),
                  ("exact", "scanline", "subtexel", "affine"),
                  *(("exact", "plane", "subtexel", mapper) for mapper in (
                      "arbitrary", "tiled", "columns", "generated", "gouraud",
                      "lit", "lit_gouraud", "dithered", "keyed")))


def accuracy_table(accuracy: dict) -> str:
    """Returns a Markdown table: the medium set in fast RAM."""
    found = {(r["edges"], r["gradients"], r["start"], r["mapper"]): r for r in accuracy["rows"]
             if r["machine"] == "a1200-fast" and r["name"] == "medium"}
    rows = []
    for edges, gradients, start, mapper in ACCURACY_LINES:
        r = found[edges, gradients, start, mapper]
        rows.append([mapper, edges, gradients, start, f"{r['cycles_per_pixel']:.1f}",
                     f"{r['coverage_errors_per_million']:,.0f}", f"{r['texel_error_rms']:.4f}",
                     f"{r['wrong_texels_percent']:.2f} %"])
    return table(["mapper", "edges", "gradients", "start", "cycles a pixel",
                  "wrong pixels in 10^6", "rms error, texels", "wrong texels"], rows, "llllr")


#: Perspective: title, setting, bench row of its spans, bench row of their exact form.
PERSPECTIVE_LINES = (("none: affine", "none", "affine_addx", None),
                     ("every 16 pixels", "every16", "persp_even_16", "persp_every16_exact"),
                     ("every 8 pixels", "every8", "persp_even_8", "persp_every8_exact"),
                     ("each pixel, 1/32 texel", "pixel", "persp_pixel", "persp_pixel_exact"),
                     ("each pixel, 1/128 texel", "fine", "persp_fine", "persp_pixel_fine"))


def perspective_table(baseline: dict, accuracy: dict) -> str:
    """A Markdown table: spans of 256 pixels in fast and mixed RAM, whole polygons in fast RAM."""
    figures = bench.figures(baseline["rows"])
    found = {r["perspective"]: r for r in accuracy["rows"] if r["name"] == "depth"
             and (r["machine"], r["edges"], r["mapper"]) == ("a1200-fast", "exact", "affine")}
    rows = []
    for title, setting, name, exact in PERSPECTIVE_LINES:
        r = found[setting]
        spans = [f"{figures[name, machine, 256]:.1f}" for machine in ("a1200-fast", "a1200-mixed")]
        rows.append([
            title, *spans, f"{figures[exact, 'a1200-fast', 256]:.1f}" if exact else "",
            f"{r['cycles_per_pixel']:.0f}", f"{r['texel_error_max']:.3f}",
            f"{r['texel_error_rms']:.4f}"])
    return table(["perspective", "span, fast RAM", "data in chip", "the exact form", "polygons",
                  "largest error, texels", "rms"], rows)


#: Effects: title, bench row, its length.
EFFECT_LINES = (("rotator, 320x256, addx", "rotator", 320),
                ("rotator, v wraps more than once a line", "rotator_wrap", 320),
                ("rotator, swap", "rotator_swap", 320),
                ("generated code, lines inside a row of the map", "generated", 256),
                ("v's step 0: floors, upright pictures", "affine_row", 256),
                ("u's step 0: walls on their side", "affine_column", 256),
                ("texels and frame of 16 bits", "affine_16", 256),
                ("the same, v's step 0, a texel a pixel: copied", "affine_16_copy", 256),
                ("texels and frame of 32 bits", "affine_32", 256),
                ("lit, one level", "affine_lit", 256),
                ("lit, a level each pixel", "affine_gouraud", 256))


def effects_table(baseline: dict) -> str:
    """Returns a Markdown table: cycles a pixel on each machine, pixels a second."""
    figures, rows = bench.figures(baseline["rows"]), []
    for title, name, length in EFFECT_LINES:
        found = [figures[name, machine, length] for machine in MACHINES]
        rows.append([title, *(f"{n:.1f}" for n in found), f"{CLOCK_HZ / found[0]:,.0f}"])
    return table(["cycles a pixel", *MACHINES.values(), "pixels a second, fast RAM"], rows)


#: Dithered points compared with points: title, bench rows.
DITHERED_LINES = (("8 bits", "dithered", "affine_addx"),
                  ("8 bits, where v may wrap", "dithered_wrap", "affine_addx_wrap"),
                  ("16 or 32 bits", "dithered_16", "affine_16"),
                  ("16 or 32 bits, where v may wrap", "dithered_16_wrap", "affine_16_wrap"))


def dithered_tables(baseline: dict) -> str:
    """Markdown tables: errors of dithered points against the bilinear filter, and cycles."""
    figures = bench.figures(baseline["rows"])
    rows = [[title, *(" / ".join(f"{figures[name, machine, 256]:.1f}" for name in names)
                      for machine in MACHINES)] for title, *names in DITHERED_LINES]
    costs = table(["cycles a pixel, dithered / points", *MACHINES.values()], rows)
    return f"{dither_errors.table()}\n\n{costs}"


#: Transparent texels: title, bench row, its length.
KEYED_LINES = (("opaque texels: affine", "affine_addx", 256), ("keyed", "keyed", 256),
               ("keyed, where v may wrap more than once", "keyed_wrap", 256),
               ("opaque texels in rows: affine", "affine_row", 256), ("keyed, in rows", "keyed_row", 256),
               ("keyed, in rows without holes", "keyed_rows", 256),
               ("a line whose row's ends are left out, cycles", "edge_opaque", edges.LINES))


def keyed_table(baseline: dict) -> str:
    """Returns a Markdown table: cycles a pixel of spans, or a line."""
    figures = bench.figures([*baseline["rows"], *baseline["lines"]])
    return table(["cycles a pixel", *MACHINES.values()],
                 [[title, *(f"{figures[name, machine, length]:.1f}" for machine in MACHINES)]
                  for title, name, length in KEYED_LINES])


#: Meshes: title of a line, bench row.
MESH_LINES = (("a point, to the screen, 16-bit operands", "mesh_transform"),
              ("a point, to the camera and the screen, 32-bit operands", "mesh_transform_wide"),
              ("... outside the borders", "mesh_transform_wide_outside"),
              ("... snapped", "mesh_snap"),
              ("a face seen from the back, 16-bit operands", "mesh_faces_back"),
              ("a face of four corners that is seen", "mesh_faces"),
              ("... its corners' places and greatest depth", "mesh_orders_quads"),
              ("a face seen from the back, 32-bit operands", "mesh_faces_wide_back"),
              ("a face of four corners that is seen", "mesh_faces_wide"),
              ("a normal: s and t, to a vertex", "mesh_mirror"),
              ("a normal: the shade, to a vertex", "mesh_shade"),
              ("a normal: one of s, t and shade, to a table", "mesh_attributes"),
              ("a face sorted by depth", "mesh_spread"),
              ("a node of a tree that divides others", "mesh_walk"),
              ("a triangle of shared vertices into a batch", "mesh_link"),
              ("a triangle of copied vertices: flat", "mesh_gather_flat"),
              ("... shades", "mesh_gather_gouraud"),
              ("... environment", "mesh_gather_affine"),
              ("a new corner where a border cuts", "mesh_cut"))


def mesh_table(baseline: dict) -> str:
    """Returns a Markdown table: cycles of meshes before their polygons are drawn."""
    figures = bench.figures(baseline["points"])
    return table(["cycles", *MACHINES.values()],
                 [[title, *(f"{figures[name, machine, 1]:.0f}" for machine in MACHINES)]
                  for title, name in MESH_LINES])


def rules_table(baseline: dict) -> str:
    """Returns a Markdown table: kilocycles of a polygon without and with each rule of lowering."""
    figures = bench.figures(baseline["rules"])
    machines = ("a1200-fast", "a1200")
    rows = []
    for case in rules.CASES:
        cells = []
        for machine in machines:
            on, off = (figures[f"rule_{case.name}{end}", machine, 1] / 1000
                       for end in ("", rules.WITHOUT))
            cells.append(f"{off:.1f} / {on:.1f}")
        rows.append([case.name, case.asked or "none", case.lowered or "none", *cells])
    return table(["rule", "spans without it", "with it",
                  *(MACHINES[machine] for machine in machines)], rows, "lllr")
