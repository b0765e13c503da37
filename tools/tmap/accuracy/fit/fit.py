"""``tmap fit``: the most exact settings of a scene that hold a frame rate on the screen of the emulated machine.

Writes fit.md, fit.json and fit.png, which shows error against frames a second; prints the table of all trials, the
choice, what it costs, and the lines to paste into the scene's file.
"""

import json
from dataclasses import asdict
from pathlib import Path

from tmap.accuracy.fit import search, toml
from tmap.accuracy.fit.picture import plot
from tmap.accuracy.fit.search import Found
from tmap.accuracy.fit.steps import Choice, in_words, keys_of
from tmap.accuracy.fit.trials import FIELDS, Trial
from tmap.base import markdown
from tmap.base.errors import UserError
from tmap.base.outputs import bars, check_directory, replaced
from tmap.compiler.scene import checked
from tmap.guest import provenance
from tmap.guest.emulator import CLOCK_HZ

WRITTEN = ("fit.json", "fit.md", "fit.png")
TITLES = ("pixels", "settings", "frames", "cycles, worst", "frames a second, worst", "mean", "other colours, %",
          "rms, of 255", "")
MOST_FPS = 50  # fields a second


def marks(found: Found) -> dict[Choice, str]:
    """Returns what is to be said of choices."""
    made = {}
    for trial, text in ((found.own, "as it is"), (found.exact, "most exact"),
                        (found.best, "chosen" if found.holds else "nearest")):
        if trial:
            made[trial.choice] = ", ".join(filter(None, (made.get(trial.choice), text)))
    return made


def rows(found: Found) -> list[list[str]]:
    """Returns the rows of the trials' table, of each choice that with the most frames, the most exact first."""
    said, made = marks(found), []
    most = {trial.choice: trial for trial in sorted(found.trials, key=lambda each: len(each.numbers))}
    for trial in sorted(most.values(), key=lambda each: (each.off.rms, each.worst)):
        worst, mean = trial.rates
        made.append([trial.choice.pixel, in_words(found.space, trial.choice), f"{len(trial.numbers)}",
                     f"{trial.worst:,}", f"{worst:.1f}", f"{mean:.1f}", f"{trial.off.percent:.1f}",
                     f"{trial.off.rms:.1f}", said.get(trial.choice, "")])
    return made


def table(found: Found) -> str:
    """Returns the table in columns, for a terminal."""
    lines = [list(TITLES), *rows(found)]
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join("  ".join(word.rjust(width) if 1 < k < len(TITLES) - 1 else word.ljust(width)
                               for k, (word, width) in enumerate(zip(line, widths))).rstrip() for line in lines)


def markdown_table(found: Found) -> str:
    """Returns the table as Markdown."""
    return markdown.table(list(TITLES), rows(found), "llrrrrrrl")


def shortest_lines(found: Found, choice: Choice, path: Path) -> str:
    """Returns the lines that set a choice in a scene's file, without edges where it has the same unsaid."""
    keys, space = keys_of(found.space, choice), found.space
    wanted = checked(space.raw | keys, path)["materials"]
    plain = {name: dict(each) for name, each in keys.get("materials", {}).items()}
    for name, each in plain.items():
        if "edges" not in space.raw["materials"][name]:
            each.pop("edges", None)
    if plain and any(each["edges"] != wanted[name]["edges"]
                     for name, each in checked(space.raw | keys | {"materials": plain}, path)["materials"].items()):
        plain = keys["materials"]
    changed = {name: each for name, each in plain.items() if each != space.raw["materials"][name]}
    return toml.lines(choice.pixel if choice.pixel != space.raw.get("pixel", "1x1") else None, changed)


def count(number: float, noun: str) -> str:
    """Returns a number of things."""
    return f"{number:.4g} {noun}{'s' if number != 1 else ''}"


def cost_of(trial: Trial) -> str:
    """Returns what a trial costs, in a sentence."""
    at, (worst, mean) = int(trial.work.argmax()), trial.rates
    return (f"The worst frame ({trial.numbers[at]}) takes {trial.worst:,} cycles, {trial.drawing[at]:,} to draw and "
            f"{trial.showing[at]:,} to convert and to show: {worst:.1f} frames a second; the mean is {mean:.1f}. "
            f"On the screen {count(len(trial.fields), 'frame')} took {count(sum(trial.fields), 'field')}, none more "
            f"than {max(trial.fields)}.")


def error_of(trial: Trial) -> str:
    """Returns a trial's error in a sentence."""
    return (f"Against the exact picture in pixels of 1x1, {trial.off.percent:.1f} % of the screen's pixels have other "
            f"colours; the error is {trial.off.rms:.1f} of 255 (rms).")


def sentences(found: Found, path: Path, fps: float, machine: str) -> list[str]:
    """Returns the result in sentences, one for each paragraph."""
    best = found.best
    if best is None:
        why = next(iter(found.refused.values()), "")
        return [f"cannot: no settings of {path.name} can be shown on {machine}: {why}"]
    name = f"pixels of {best.choice.pixel}, {in_words(found.space, best.choice)}"
    said = [f"Chosen: {name}." if found.holds else
            f"cannot: no settings hold {count(fps, 'frame')} a second on {machine}; the nearest that can are {name}: "
            f"they hold {best.rates[0]:.1f}.", cost_of(best), error_of(best)]
    if found.own:
        said.append(f"As it is, the scene's worst frame allows {found.own.rates[0]:.1f} frames a second, with an error "
                    f"of {found.own.off.rms:.1f} (rms).")
    return said


def goal_of(fps: float) -> str:
    """Returns a rate as fields and cycles of a frame."""
    return f"{count(fps, 'frame')} a second: {count(FIELDS / fps, 'field')} a frame, {CLOCK_HZ / fps:,.0f} cycles"


def paste(found: Found, path: Path) -> str:
    """Returns the lines to paste, or an empty text if the scene is as it was chosen."""
    return shortest_lines(found, found.best.choice, path) if found.best else ""


def as_json(found: Found, path: Path, fps: float, machine: str) -> dict:
    """Returns the content of fit.json."""
    said = marks(found)
    return {"scene": path.stem, "machine": machine, "fps": fps, "holds": found.holds, **provenance.record(),
            "conditions": "drawing, conversion, and the wait for the blitter; display, DMA and interrupts on",
            "lines": paste(found, path),
            "trials": [{"pixel": trial.choice.pixel, "settings": in_words(found.space, trial.choice),
                        "mark": said.get(trial.choice, ""), "numbers": trial.numbers, "drawing": trial.drawing,
                        "showing": trial.showing, "fields": trial.fields, **asdict(trial.off)}
                       for trial in found.trials]}


def page(found: Found, path: Path, fps: float, machine: str) -> str:
    """Returns the text of fit.md."""
    lines = paste(found, path)
    pasted = f"\nIn place of the same keys of {path.name}:\n\n```toml\n{lines}\n```\n" if lines else ""
    said = "\n\n".join(sentences(found, path, fps, machine))
    return (f"# {path.stem} at {fps:g} frames a second on {machine}\n\n{said}\n{pasted}\n"
            "![Error against frames a second](fit.png)\n\n"
            + markdown_table(found) + "\n")


def write(found: Found, path: Path, folder: Path, fps: float, machine: str) -> None:
    """Writes what was found."""
    plot(found, path.stem, fps, machine, folder / "fit.png")
    (folder / "fit.md").write_text(page(found, path, fps, machine))
    (folder / "fit.json").write_text(json.dumps(as_json(found, path, fps, machine), indent=1) + "\n")


def command(path: Path, fps: float, machine: str, out: Path) -> int:
    """``tmap fit``: searches, prints the choice. Returns 1 if no settings hold the rate."""
    if not 0 < fps <= MOST_FPS:
        raise UserError(f"fit: --fps: {fps:g} is not above 0 and at most {MOST_FPS}, the fields of a second")
    check_directory(out)
    with bars() as progress:
        task = progress.add_task("fit", total=None)
        found = search.fit(path, fps, machine, lambda what, done, total:
                           progress.update(task, description=what, completed=done, total=total))
    with replaced(out, WRITTEN, WRITTEN[0]) as folder:
        write(found, path, folder, fps, machine)
    print(f"{path.stem} on {machine}, {goal_of(fps)}\n\n{table(found)}\n")
    print("\n".join(sentences(found, path, fps, machine)))
    for choice, why in found.refused.items():
        print(f"Left out: pixels of {choice.pixel}, {in_words(found.space, choice)}: {why}")
    if lines := paste(found, path):
        print(f"\nIn place of the same keys of {path.name}:\n\n{lines}\n")
    elif found.best:
        print(f"{path.name} has these settings already.")
    print(f"written to {out}: {', '.join(WRITTEN)}")
    return 0 if found.holds else 1
