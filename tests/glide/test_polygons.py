"""Random polygons of Glide's texture units: every frame of the guest is the model's, bit for bit.

GLIDE_SEED and GLIDE_COUNT choose others; GLIDE_CASE draws one of them alone.
"""

from dataclasses import replace

import numpy as np
import pytest

from tests.helpers.engine_polygons import MACHINE, Polygons
from tmap.corpus import random_glide
from tmap.corpus.random_glide import FAR, HEIGHT, PIXELS, WIDTH, Case, scene
from tmap.glide import polygon
from tmap.glide.lod import chosen, level_of_detail
from tmap.glide.words import ASPECTS, FORMATS, MIPMAPS
from tmap.guest import guest_frames
from tmap.model import model
from tmap.scene_file import pipes
from tmap.scene_file.scene_file import write

BITS = {"rgb565": 16, "rgba8888": 32}  # a pixel
POLYGONS = Polygons("GLIDE", 60, random_glide)
SEED = POLYGONS.seed


def levels(each: Case) -> list[set[int]]:
    """The levels from which each unit draws the polygon's pixels."""
    made = scene([each], SEED, "rgb565")
    units, frame = pipes.units_of(made, 0), np.zeros((HEIGHT, WIDTH), np.uint16)
    settings = model.Settings(edges=each.edges, clip=each.clip, mapper="tiled")
    half = len(each.vertices) // (1 + each.own)
    screen, found = [v[:2] for v in each.vertices[:half]], []
    for n, unit in enumerate(units):
        corners = each.vertices[half * (n and each.own):][:half]
        sharing = [unit] if each.own else units
        divided = any(u.modes.perspective for u in sharing)
        at = polygon.points(screen, [(s, t, w) for _, _, s, t, _, w in corners], divided, frame,
                            settings)
        if at:
            point = at[1]
            lod = level_of_detail(unit.modes, point.base, point.w, point.x, point.y)
            found.append(set(np.unique(chosen(unit.modes, lod)).tolist()))
    return found


def test_polygons_with_many_levels() -> None:
    """The generator covers all ways in which levels are drawn."""
    cases = POLYGONS.first("rgb565")
    many = [(each, most) for each in cases
            if (most := max(map(len, levels(each)), default=0)) > 2]
    assert {each.kind for each, _ in many} >= FAR
    assert max(most for _, most in many) > 5
    assert {modes["mode"] for each, _ in many for modes in each.modes} == {"nearest",
                                                                         "nearest_dither"}


def test_the_polygons_differ() -> None:
    """The generator covers formats, modes and settings, and a scene of its polygons can be
    written."""
    cases = POLYGONS.first("rgb565")
    units = [modes for each in cases for modes in each.modes]
    for key, names in (("format", FORMATS), ("aspect", ASPECTS), ("mode", MIPMAPS),
                       ("levels", ("even", "odd", "both")), ("bits", (4, 8)), ("blend", (0, 1)),
                       ("pieces", (0, 8, 16)),
                       ("perspective", (False, True)), ("clamp_w", (False, True))):
        assert {modes[key] for modes in units} == set(names), key
    assert len({modes["clamp"] for modes in units}) == len({m["filters"] for m in units}) == 4
    assert {(len(each.units), each.own) for each in cases} == {(1, False), (2, False), (2, True)}
    ws = [v[5] for each in cases for v in each.vertices]
    assert min(ws) < 0 and max(ws) > 1 << 16 + 10 and min(map(abs, ws)) < 1 << 16 - 6
    made = scene(cases, SEED, "rgb565")
    write(made)
    drawn = [len(np.unique(model.render(made, n))) for n, each in enumerate(cases)
             if not each.adds]
    assert sum(n > 2 for n in drawn) > 0.7 * len(drawn)
    assert sum(n > 9 for n in drawn) > len(drawn) / 3


def test_the_polygons_that_are_added_differ() -> None:
    """Most change the frame, with sums of many colours, some of them clamped; there are all
    kinds."""
    cases = POLYGONS.first("rgba8888")
    added = [each for each in cases if each.adds]
    assert {each.kind for each in added} == {each.kind for each in cases}
    made = scene(added, SEED, "rgba8888")
    without = replace(made, objects=[o for o in made.objects if o.material >= len(added)])
    pairs = [(model.render(made, n), model.render(without, n)) for n in range(len(added))]
    assert all(len(np.unique(there)) > 4 for _, there in pairs)
    colours = [made.pixel.colours(found[found != there]) for found, there in pairs]
    assert sum(len(np.unique(some, axis=0)) > 9 for some in colours) > len(added) / 2
    assert sum((some == 255).any() and (some[:, :3] < 255).any() for some in colours) > 5


def test_pieces_are_seen() -> None:
    """Pieces of 8 pixels and of 16, filtered, wrapped and clamped in all ways, with one unit and
    two: some polygons differ from those with a division at each pixel; none does if a unit
    dithers."""
    seen, found = 0, {"pieces": set(), "filters": set(), "clamp": set(), "own": set()}
    for each in POLYGONS.first("rgba8888"):
        made = scene([each], SEED, "rgba8888")
        glide_units = made.glide_units.copy()
        glide_units[:, pipes.COLUMNS["glide_units"].index("subdivision")] = 0
        exact = model.render(replace(made, glide_units=glide_units), 0)
        if np.array_equal(exact, model.render(made, 0)):
            continue
        assert all(modes["mode"] != "nearest_dither" for modes in each.modes), each
        seen += 1
        found["own"].add(each.own)
        for key, values in found.items():
            values |= {modes[key] for modes in each.modes if key in modes}
    assert seen > 15 and found["pieces"] >= {8, 16} and len(found["clamp"]) == 4
    assert len(found["filters"]) > 2 and found["own"] == {False, True}, found


@pytest.mark.parametrize("pixels", PIXELS)
def test_frames_are_the_models(pixels: str) -> None:
    """Each polygon has a separate frame, many in a boot, drawn with the rules of lowering."""
    rules, spans = POLYGONS.check(pixels)
    assert "glide_pixels" not in spans, f"seed {SEED}: some are drawn pixel by pixel"
    if not POLYGONS.asked("CASE"):
        assert rules >= {"glide_plain", "glide_passes", "constant_w"}, rules
        assert spans & {f"dithered_{BITS[pixels]}{end}" for end in ("", "_wrap")}, spans
        assert "glide_passes" in spans, spans


@pytest.mark.parametrize("pixels", PIXELS)
def test_frames_are_the_models_without_rules(pixels: str) -> None:
    """Fewer polygons, and other ones."""
    _, spans = POLYGONS.check(pixels, "all")
    if not POLYGONS.asked("CASE"):
        assert "glide_pixels" in spans and "glide_passes" not in spans, spans


def test_units_that_share_a_point_have_each_their_own_lod() -> None:
    """Two units by the LOD's fraction, which is the same for all pixels but differs between them by a bias. Found by
    ``scripts/tmap fuzz --family glide --seed 22``."""
    each = random_glide.case(22, 1549)
    (_, other), depths = (modes["bias"] for modes in each.modes), {v[-1] for v in each.vertices}
    assert each.kind == "trilinear" and not each.own and other and len(depths) == 1
    made = scene([each], 22, "rgba8888")
    expected, found = model.render(made, 0), guest_frames.frame_of(made, "addx", MACHINE)
    assert (found == expected).all(), guest_frames.first_wrong(expected, found)
