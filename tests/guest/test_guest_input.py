"""The Amiga programs with bad files: one clear line each, return code 10, or 20 if memory is short,
no crash.

Bad files are scene files s0, s1, ..., plans p0, p1, ...
"""

import numpy as np

from tests.compiler.scene_bad_files import bad_scenes, large_with
from tests.compiler.scene_examples import example
from tests.guest.plan_bad_files import bad_plans, good_plan
from tmap.guest import emulator, guest_frames, kernels
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material, Object, Scene

#: Commands a boot: the emulator searches a whole folder for each name.
BATCH = 100


def tangles(seed: int, reach: int) -> Scene:
    """A scene no compiler writes: 300 polygons of random corners, concave and crossing, within
    ``reach`` pixels of a small frame."""
    random = np.random.default_rng(seed)
    counts = random.choice([3, 3, 4, 5, 8, 64], 300)
    vertices = random.integers(-reach * 65536, reach * 65536, (counts.sum(), 6))
    vertices[random.random(len(vertices)) < 0.2] &= ~0xFFFF
    scene = example()
    scene.width, scene.height, scene.frames, scene.vertices = 64, 48, 1, vertices
    scene.poses = np.array([(65536, 0, 0, 65536, 32 * 65536, 24 * 65536)])
    scene.objects = [Object(n % 2, first, count, 0, 1, 0) for n, (count, first) in
                     enumerate(zip(counts.tolist(), (counts.cumsum() - counts).tolist()))]
    return scene


def check(results, said: dict[str, str]) -> None:
    """Asserts that each command printed one line, as expected, and returned 20 if memory is short,
    else 10."""
    wrong = []
    for (command, line), result in zip(said.items(), results, strict=True):
        lines = [text for text in result.output.splitlines() if not text.startswith("case ")]
        code = 20 if "not enough memory" in line else 10
        if result.code != code or len(lines) != 1 or not lines[0].startswith(line):
            wrong.append(
                f"{command}: wanted {line!r}, code {code}; got {result.output!r}, {result.code}")
    assert not wrong, "\n".join(wrong)


def test_bad_input_is_refused(tmp_path):
    files, said = {"good": scene_file.write(example()), "calls": good_plan()}, {}
    for number, (data, line) in enumerate(bad_scenes()):
        files[f"s{number}"] = data
        said[f"render s{number}"] = f"s{number}{line}"
    for number, (data, line) in enumerate(bad_plans()):
        files[f"p{number}"] = data
        said[f"bench p{number} out"] = f"p{number}{line}" if line[0] == ":" else line
    usage = "render: usage: render SCENE"
    said |= {"render none": "none: cannot be opened", "render S": "S: cannot be opened",
             "render good FORM": usage, "render good FRAMES": usage,
             "render good FRAMES many": usage, "render good DIGEST": usage, "render good and more": usage,
             "render good FORM ADDX": "render: FORM: not one of",
             "render good FRAMES 0": "render: FRAMES: not between 1 and the scene's frames",
             "render good FRAMES 4": "render: FRAMES: not between",
             "render good FRAMES -1": "render: FRAMES: not between",
             "bench none out": "none: cannot be opened", "bench S out": "S: cannot be opened",
             "bench calls": "bench: usage", "bench calls S": "S: cannot be created",
             "bench calls :no/where": ":no/where: cannot be created"}
    commands = list(said.items())
    for first in range(0, len(commands), BATCH):
        some, place = dict(commands[first:first + BATCH]), tmp_path / str(first)
        named = {word for command in some for word in command.split()}
        check(emulator.run_batch(list(some), {name: files[name] for name in named & set(files)},
                                 "a1200", place, timed=False), some)
        assert not list((place / "volume").glob("frame_*"))


def test_strange_scenes_draw_inside_the_frame(tmp_path):
    """Numbers that no compiler writes but the file may hold: all is drawn or left out, the same in
    every form, and render's guards hold. Plans without output also run."""
    large = example(8, side=1024)
    files = {"noise": scene_file.write(example()), "more": scene_file.write(example(corners=64)),
             "near": scene_file.write(tangles(1, 40)), "wide": scene_file.write(tangles(2, 300)),
             "far": scene_file.write(tangles(3, 16383)), "large": scene_file.write(large),
             "fine": scene_file.write(large_with("fine")),
             "calls": good_plan(), "idle": kernels.plan([])}
    scenes = ("noise", "more", "near", "wide", "far", "fine")
    good = [f"render {name} FRAMES 1 COUNT FORM {form}" for name in scenes
            for form in ("addx", "swap", "c")] + ["bench calls out", "bench idle out"]
    said = {"render noise": "frame_001.chunky: cannot be created",
            "render noise DIGEST :no/where": ":no/where: cannot be created",
            "render large": f"render: not enough memory for the frame: {2**20 + 8192} bytes; the"}
    (tmp_path / "volume" / "frame_001.chunky").mkdir(parents=True)
    results = emulator.run_batch(good + list(said), files, "a1200", tmp_path, timed=False)
    for command, result in zip(good, results):
        left_out = "render: not all could be drawn: a vertex is out of range\n" in result.output
        assert result.code == 5 * left_out, f"{command}: {result.output}"
    lines = [result.output.splitlines()[0] for result in results[:3 * len(scenes)]]
    pixels = [line.split("polygons")[1].split() for line in lines]
    totals = [(count, sum(map(int, spans[1::2]))) for count, *spans in pixels]
    for number, name in enumerate(scenes):
        forms = totals[3 * number:3 * number + 3]
        assert len(set(forms)) == 1, f"{name}: polygons and pixels by form: {forms}"
    drawn = dict(zip(scenes, totals[::3]))
    assert all(drawn[name][1] > 1000 for name in ("near", "wide")), drawn
    failed = results[len(good):]
    for result in failed[:2]:  # frame 0 was drawn
        result.output = result.output.partition("\n")[2]
    check(failed, said)


def test_dented_polygons_are_cut_inside_their_arrays():
    """64 corners that alternate across a border would be 96 after clipping: that polygon is left
    out. Fewer corners are drawn, and so are the polygons after them."""
    scene = example(0)
    scene.width, scene.height = 64, 48
    scene.materials = [Material(colour=200, clip="vertices"), Material(colour=99)]
    zigzag = [[(-40, 100)[k % 2] << 16, 2 * k - 40 << 16, 0, 0, 0, 65536] for k in range(64)]
    triangle = [[x << 16, y << 16, 0, 0, 0, 65536] for x, y in ((5, 5), (20, 5), (5, 20))]
    scene.vertices = np.array([*zigzag, *triangle])
    scene.objects = [Object(0, 0, 64, 0, 1, 0), Object(1, 64, 3, 0, 3, 0), Object(0, 0, 40, 0, 1, 1),
                     Object(0, 5, 46, 0, 1, 2)]
    scene.poses = np.array([scene_file.IDENTITY] * 3)
    digests, = guest_frames.draw([(scene, "addx")], "a1200-fast", timed=False)
    for number, digest in enumerate(digests):
        drawn = model.render(scene, number)
        assert guest_frames.is_models(drawn, digest), number
        assert (drawn == 99).any()
