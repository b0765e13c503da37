"""The integer model of c/demo/governor.c: which step of a part is drawn next."""

from tmap.build import layout


class Governor:
    """As struct governor; ``budget`` and times in colour clocks, 0 the best step."""

    def __init__(self, steps: int, budget: int):
        self.limits = layout.load().constants
        self.steps, self.budget = steps, budget
        self.step = self.late = self.calm = self.most = self.left = 0
        self.ratio = [0] * steps  # 24.8, of a frame of a step to one of the next

    def change(self, by: int, left: int) -> None:
        """To the next step, whose frames are not known yet."""
        self.step += by
        self.late = self.calm = self.most = 0
        self.left = left

    def has_room(self) -> bool:
        """Whether the step above would have fitted all these calm frames long."""
        limits = self.limits
        if self.step == 0:
            return False
        above = self.most * self.ratio[self.step - 1] >> limits["GOVERNOR_RATIO_BITS"]
        return above <= self.budget // 8 * limits["GOVERNOR_ROOM"]

    def next(self, work: int) -> int:
        """A frame of the present step took so long; returns the next one's step."""
        limits = self.limits
        work = min(work, limits["GOVERNOR_WORK_MAX"])
        if self.left:
            ratio = (self.left << limits["GOVERNOR_RATIO_BITS"]) // (work | 1)
            self.ratio[self.step - 1] = min(ratio, 4095)
            self.left = 0
        if work > self.budget:
            self.late += 2
            self.calm = self.most = 0
            if self.late >= limits["GOVERNOR_LATE"] and self.step < self.steps - 1:
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
