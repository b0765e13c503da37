"""The content of the report, measured or taken from the cache: one function for each part."""

import json
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, wait
from dataclasses import asdict, dataclass
from itertools import count
from pathlib import Path

from rich.progress import Progress

from tmap.base import workers
from tmap.base.errors import UserError
from tmap.base.paths import ACCURACY_BASELINE, BASELINE, POLYS_BASELINE, SCENES
from tmap.guest import cache, provenance
from tmap.guest.cache import Entry
from tmap.guest.emulator import MEASURED

#: The machine of methods and hard cases.
MACHINE = "a1200-fast"
#: What the section on settings by the clock shows.
FIT_SCENE, FIT_RATE = "corridor", 12.5
#: Files of a scene's run that the page shows.
SCENE_FILES = ("run.json", "animation.gif", "frame_000.png")
#: To be increased when the form of a part's cache entry changes.
FORM = "1"
#: Called with the numbers of steps done and of all steps; None: not known.
Tell = Callable[[int, int | None], None]


@dataclass
class Found:
    """All parts of the report; a part that was not measured is None."""

    bench: dict  # in the form of bench.json, accuracy.json and polys.json
    accuracy: dict
    polys: dict
    scenes: list[Entry]
    sets: Entry | None = None  # the files beside accuracy.json
    methods: Entry | None = None
    hard: Entry | None = None
    fit: Entry | None = None


def scene_names(chosen: list[str] | None) -> list[str]:
    """Returns the chosen scenes, or all. Refuses unknown names."""
    known = sorted(path.stem for path in SCENES.glob("*.toml"))
    unknown = [name for name in chosen or () if name not in known]
    if unknown:
        raise UserError(f"report: no scene is called {unknown[0]}; there are {', '.join(known)}")
    return list(dict.fromkeys(chosen)) if chosen else known


def key(module: str, files: Iterable[Path] = (), *words: str) -> str:
    """Returns the cache key of a part that one of the tools' modules measures."""
    return cache.key(module, files, [FORM, *words])


def of_scene(name: str, machine: str) -> Entry:
    """Draws a scene; returns run.json without dumps and palette, with the texels' errors."""
    path = SCENES / f"{name}.toml"

    def make(folder: Path) -> dict:
        from tmap.accuracy import scene_errors
        from tmap.run import run
        from tmap.compiler.scene import compile_scene

        about = run.make(path, folder, machine, None, "addx")
        for file in set(folder.iterdir()) - {folder / kept for kept in SCENE_FILES}:
            file.unlink()
        return {name: value for name, value in about.items() if name != "palette"} | {
            "errors": asdict(scene_errors.errors_of(compile_scene(path)))}

    identity = key("tmap/accuracy/scene_errors", cache.scene_files(path), machine)
    return cache.kept(f"scene_{name}", identity, make)


def of_bench(tell: Tell) -> Entry:
    """Returns all rows of the bench on all machines."""
    from tmap.bench import scenes

    def make(folder: Path) -> dict:
        from tmap.bench import bench
        from tmap.report import bench_results

        found = bench.bench(list(bench.CONDITIONS), on_case=lambda done: tell(done, None))
        bench_results.write(found, folder)
        return found

    files = [file for name in scenes.NAMES for file in cache.scene_files(SCENES / f"{name}.toml")]
    return cache.kept("bench", key("tmap/bench/bench", files), make)


def of_accuracy(tell: Tell) -> Entry:
    """Returns all sets under all settings, on all machines."""
    def make(folder: Path) -> dict:
        from tmap.accuracy import accuracy
        from tmap.corpus import polygon_sets

        names, done = polygon_sets.every(), count(1)
        total = len(names) * len(MEASURED)
        accuracy.write_sets(folder, names, list(MEASURED), False, lambda: tell(next(done), total))
        return json.loads((folder / "accuracy.json").read_text())

    files = cache.scene_files(SCENES / "mappers.toml")
    return cache.kept("accuracy", key("tmap/accuracy/accuracy", files), make)


def of_methods(tell: Tell) -> Entry:
    """Returns a turning face by each method."""
    def make(folder: Path) -> dict:
        from tmap.accuracy import italian_methods

        done = count(1)
        table = italian_methods.write(folder, MACHINE, lambda: tell(next(done),
                                                                    len(italian_methods.METHODS)))
        return provenance.record() | {"machine": MACHINE, "table": table}

    files = cache.scene_files(SCENES / "face.toml")
    return cache.kept("methods", key("tmap/accuracy/italian_methods", files, MACHINE), make)


def of_polys(_: Tell) -> Entry:
    """Returns polygons a second."""
    def make(_: Path) -> dict:
        from tmap.accuracy import polys

        return polys.measure_all()

    return cache.kept("polys", key("tmap/accuracy/polys"), make)


def of_hard_cases(tell: Tell) -> Entry:
    """Returns the page of hard cases, and the cases that exceed a bound."""
    def make(folder: Path) -> dict:
        from tmap.accuracy import accuracy

        complaints = accuracy.write_hard_cases(folder, MACHINE, tell)
        return provenance.record() | {"machine": MACHINE, "complaints": complaints}

    return cache.kept("hard", key("tmap/accuracy/accuracy", [], MACHINE), make)


def of_fit(tell: Tell) -> Entry:
    """Returns the settings of a scene that hold a rate."""
    path = SCENES / f"{FIT_SCENE}.toml"

    def make(folder: Path) -> dict:
        from tmap.accuracy.fit import fit

        found = fit.search.fit(path, FIT_RATE, MACHINE, lambda _, done, total: tell(done, total))
        fit.write(found, path, folder, FIT_RATE, MACHINE)
        return fit.as_json(found, path, FIT_RATE, MACHINE) | {
            "table": fit.markdown_table(found), "sentences": fit.sentences(found, path, FIT_RATE, MACHINE)}

    identity = key("tmap/accuracy/fit/fit", cache.scene_files(path), MACHINE, f"{FIT_RATE:g}")
    return cache.kept("fit", identity, make)


def committed(path: Path) -> dict:
    """Reads a committed baseline."""
    return json.loads(path.read_text())


#: The parts that are measured besides scenes, by what the progress says of them, the longest first.
PARTS: dict[str, Callable[[Tell], Entry]] = {
    "hard cases": of_hard_cases, "bench": of_bench, "settings by the clock": of_fit, "accuracy": of_accuracy,
    "polygons a second": of_polys, "methods": of_methods}


def part(title: str) -> Entry:
    """Measures a part, in a worker."""
    return PARTS[title](lambda done, total: workers.tell(title, done, total))


def gather_all(scenes: list[str], machine: str, progress: Progress) -> tuple[dict[str, Entry], list[Entry]]:
    """Returns the parts and the scenes, measured on all of the host's processors."""
    queue = workers.SPAWNED.Queue()
    tasks = {title: progress.add_task(title, total=None) for title in PARTS}
    drawn = progress.add_task("scenes", total=len(scenes))
    with workers.pool(len(PARTS) + len(scenes), queue) as pool:
        parts = {title: pool.submit(part, title) for title in PARTS}
        runs = [pool.submit(of_scene, name, machine) for name in scenes]
        waiting = {*parts.values(), *runs}
        while waiting:
            done, waiting = wait(waiting, timeout=0.5, return_when=FIRST_COMPLETED)
            while not queue.empty():
                title, some, total = queue.get()
                progress.update(tasks[title], completed=some, total=total)
            for each in done:
                each.result()  # or its exception
            progress.update(drawn, completed=sum(run.done() for run in runs))
            for title in (title for title, each in parts.items() if each.done()):
                progress.update(tasks[title], total=1, completed=1)
        return {title: each.result() for title, each in parts.items()}, [run.result() for run in runs]


def gather(scenes: list[str], machine: str, only_committed: bool, progress: Progress) -> Found:
    """Returns everything the page shows; ``progress`` shows the parts being measured."""
    if only_committed:
        drawn = [of_scene(name, machine) for name in progress.track(scenes, description="scenes")]
        return Found(*map(committed, (BASELINE, ACCURACY_BASELINE, POLYS_BASELINE)), drawn)
    found, drawn = gather_all(scenes, machine, progress)
    sets = found["accuracy"]
    return Found(found["bench"].result, sets.result, found["polygons a second"].result, drawn, sets, found["methods"],
                 found["hard cases"], found["settings by the clock"])
