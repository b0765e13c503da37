"""The integer models of c/show/governor.c, which chooses the step to draw next, and of c/show/ladder.c, whose rungs are
these steps where `show` holds a rate."""

from dataclasses import dataclass

from tmap.build import layout
from tmap.model.settings import ACCURACY, PERSPECTIVE
from tmap.scene_file.pipes import COLUMNS
from tmap.scene_file.scene_file import Scene
from tmap.scene_file.textures import UNITS

SNAPPED = [edges for edges, *_ in ACCURACY].index("snapped")
EVERY16 = PERSPECTIVE.index("every16")


class Governor:
    """As struct governor; ``budgets`` of its steps and times in colour clocks; step 0 is the best."""

    def __init__(self, budgets: list[int]):
        self.limits = layout.load().constants
        self.budgets = budgets
        self.step = self.late = self.calm = self.most = self.left = 0
        self.ratio = [0] * len(budgets)  # 24.8, time of a frame of a step to one of the next

    def change(self, by: int, left: int) -> None:
        """Changes the step; the time of the new step's frames is not known yet."""
        self.step += by
        self.late = self.calm = self.most = 0
        self.left = left

    def has_room(self) -> bool:
        """Returns True if the next better step would have had room in all of these calm frames."""
        limits = self.limits
        if self.step == 0:
            return False
        above = self.most * self.ratio[self.step - 1] >> limits["GOVERNOR_RATIO_BITS"]
        return above <= self.budgets[self.step - 1] // 8 * limits["GOVERNOR_ROOM"]

    def next(self, work: int) -> int:
        """Takes the time of a frame of the present step; returns the next frame's step."""
        limits = self.limits
        work = min(work, limits["GOVERNOR_WORK_MAX"])
        if self.left:
            ratio = (self.left << limits["GOVERNOR_RATIO_BITS"]) // (work | 1)
            self.ratio[self.step - 1] = min(ratio, 4095)
            self.left = 0
        if work > self.budgets[self.step]:
            self.late += 2
            self.calm = self.most = 0
            if self.late >= limits["GOVERNOR_LATE"] and self.step < len(self.budgets) - 1:
                self.change(1, work)
            return self.step
        self.late = max(0, self.late - 1)
        self.calm += 1
        self.most = max(self.most, work)
        if self.calm == limits["GOVERNOR_CALM"]:
            if self.has_room():
                self.change(-1, 0)
            self.calm = self.most = 0
        return self.step


@dataclass(frozen=True)
class Rung:
    """Steps of tmap.model.settings that materials are at most, and whether pixels are twice as large."""

    accuracy: int | None
    perspective: int | None
    is_coarse: bool


def has_perspective(scene: Scene) -> bool:
    """Returns True if a material or a Glide unit costs less with perspective each 16 pixels."""
    units = scene.glide_units[:, COLUMNS["glide_units"].index("subdivision")]
    return (any(PERSPECTIVE.index(each.perspective) > EVERY16 for each in scene.materials)
            or bool((units < 16).any()))


def has_edges(scene: Scene) -> bool:
    """Returns True if snapped edges are cheaper for a material."""
    return not scene.once and any(each.perspective == "none" and each.edges not in ("integer", "snapped")
                                  and each.mapper not in UNITS for each in scene.materials)


def ladder(scene: Scene, has_coarse: bool) -> list[Rung]:
    """Returns the rungs, from the scene's settings to the cheapest."""
    far = EVERY16 if has_perspective(scene) else None
    rungs = []
    for is_coarse in range(1 + has_coarse):
        rungs.append(Rung(None, None, bool(is_coarse)))
        if far:
            rungs.append(Rung(None, far, bool(is_coarse)))
        if has_edges(scene):
            rungs.append(Rung(SNAPPED, far, bool(is_coarse)))
    return rungs
