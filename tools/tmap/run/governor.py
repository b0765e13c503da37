"""The integer model of c/demo/governor.c, which chooses the step of a part to draw next."""

from tmap.build import layout


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
