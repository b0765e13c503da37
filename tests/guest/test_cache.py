"""Cached results: measured once, and again if an input or the entry has changed."""

import json

import pytest

from tmap.base.paths import SCENES
from tmap.guest import cache


class Measurement:
    """Counts its calls."""

    def __init__(self):
        self.taken = 0

    def __call__(self, folder) -> dict:
        self.taken += 1
        (folder / "part").mkdir()
        (folder / "part" / "picture.png").write_bytes(b"pixels" * 100)
        return {"cycles": 16.9}


def test_second_time_is_from_the_cache(tmp_path) -> None:
    """The second call returns the same result and files without measuring."""
    measure = Measurement()
    first = cache.kept("bench", "0123", measure, tmp_path)
    second = cache.kept("bench", "0123", measure, tmp_path)
    assert measure.taken == 1 and first == second and first.result == {"cycles": 16.9}
    assert (second.folder / "part" / "picture.png").read_bytes() == b"pixels" * 100
    assert [path.name for path in tmp_path.iterdir()] == ["bench-0123"]
    cache.kept("bench", "4567", measure, tmp_path)
    cache.kept("polys", "0123", measure, tmp_path)
    assert measure.taken == 3


def rewritten(name: str, change):
    """Damage that changes a file's bytes."""
    return lambda folder: (folder / name).write_bytes(change((folder / name).read_bytes()))


OTHER_KIND = json.dumps({"digest": cache.of_result(1), "files": [], "result": 1}).encode()


@pytest.mark.parametrize("damage", [
    rewritten(cache.ENTRY, lambda data: data[:len(data) // 2]),
    rewritten("part/picture.png", lambda data: data[:len(data) // 2]),
    lambda folder: (folder / cache.ENTRY).unlink(),
    lambda folder: (folder / "part/picture.png").unlink(),
    *(rewritten(cache.ENTRY, lambda data, new=new: new)
      for new in (b"", b"[]", b"\xff\xfe", OTHER_KIND)),
    rewritten(cache.ENTRY, lambda data: data.replace(b"16.9", b"1.69"))],
    ids=["half an entry", "half a file", "no entry", "no file", "empty", "a list", "no text",
         "files of another kind", "another figure"])
def test_damaged_entries_are_measured_again(damage, tmp_path) -> None:
    """Whatever is wrong with an entry, a complete one replaces it."""
    measure = Measurement()
    damage(cache.kept("bench", "0123", measure, tmp_path).folder)
    entry = cache.kept("bench", "0123", measure, tmp_path)
    assert measure.taken == 2 and entry.result == {"cycles": 16.9}
    assert cache.load(entry.folder) == entry


def test_failed_measurement_leaves_nothing(tmp_path) -> None:
    """Neither an entry nor the files written before the failure."""
    def fail(folder):
        (folder / "half").write_text("half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        cache.kept("bench", "0123", fail, tmp_path)
    assert not list(tmp_path.iterdir())


def test_key_follows_every_input(tmp_path, monkeypatch) -> None:
    """Program bytes, tool sources, scene files, words, the emulator's version: each changes the
    key."""
    programs, tools = tmp_path / "programs", tmp_path / "tools"
    programs.mkdir()
    (tools / "tmap" / "n64").mkdir(parents=True)
    (programs / "render").write_bytes(b"68020")
    for name, text in {"bench": "from tmap import clock\nfrom tmap.n64 import draw\n", "clock": "TICK = 20\n",
                       "n64/draw": "from tmap.n64.state import A\nfrom tmap.fixed import ONE\n",
                       "n64/state": "A = 1\n", "fixed": "ONE = 1\n", "state": "\n", "n64/fixed": "\n",
                       "other": "\n"}.items():
        (tools / "tmap" / f"{name}.py").write_text(text)
    scene = tmp_path / "scene.toml"
    scene.write_text("frames = 1\n")
    monkeypatch.setattr(cache, "PROGRAMS", programs)
    monkeypatch.setattr(cache, "ROOT", tmp_path)
    monkeypatch.setattr(cache.emulator, "emulator_version", lambda: "1")

    def now() -> str:
        return cache.key("tmap/bench", [scene], ["a1200"])

    keys = [now()]
    assert keys == [now()]
    (programs / "render.map").write_text("addresses")
    for name in ("other", "state", "n64/fixed"):
        (tools / "tmap" / f"{name}.py").write_text("changed = 1\n")
    assert keys == [now()], "what takes no part changed the key"
    for change in (lambda: (programs / "render").write_bytes(b"68021"),
                   lambda: (programs / "bench").write_bytes(b"68020"),
                   lambda: (tools / "tmap" / "bench.py").write_text(
                       "from tmap import clock, run\nfrom tmap.n64 import draw\n"),
                   lambda: (tools / "tmap" / "clock.py").write_text("TICK = 10\n"),
                   lambda: (tools / "tmap" / "n64" / "state.py").write_text("A = 2\n"),
                   lambda: (tools / "tmap" / "fixed.py").write_text("ONE = 2\n"),
                   lambda: scene.write_text("frames = 2\n"),
                   lambda: monkeypatch.setattr(cache.emulator, "emulator_version", lambda: "2")):
        change()
        keys.append(now())
    keys.append(cache.key("tmap/bench", [scene], ["a1200-fast"]))
    assert len(set(keys)) == len(keys)


def test_sources_are_all_that_is_imported() -> None:
    """A tool's own file, imports of imports, and those inside functions; not the modules that
    import it."""
    def names(module: str) -> set[str]:
        return {str(path.relative_to(cache.ROOT / "tools" / "tmap")) for path in cache.sources(module)}

    bench = names("tmap/bench/bench")
    assert {"bench/bench.py", "bench/cases.py", "guest/emulator.py", "base/paths.py"} <= bench
    assert not any(name.startswith(("report/", "accuracy/")) for name in bench)
    assert {"accuracy/hard_report.py", "n64/state.py", "ideal/n64.py", "base/fixed.py"} <= names(
        "tmap/accuracy/accuracy")


def test_scene_files_are_those_it_names() -> None:
    """Textures and meshes in the scene's folder; pictures of packages are pinned with the
    packages."""
    assert {path.name for path in cache.scene_files(SCENES / "mappers.toml")} == {
        "mappers.toml", "bush.png", "checker.png"}
    assert "knot.obj" in {path.name for path in cache.scene_files(SCENES / "shaded.toml")}


def test_a_module_that_does_not_exist_has_no_key() -> None:
    with pytest.raises(FileNotFoundError):
        cache.sources("scene_errors")
