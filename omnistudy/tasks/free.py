"""Nothing to do but drive."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from omnistudy.channel import Event
from omnistudy.tasks.messages import Messages
from omnistudy.tasks.task import Progress, RunningTask, Task
from omnistudy.units import Positive, Seconds
from omnistudy.worlds import Situation, World


class FreeTask(Task):
    """Driving without blocks and finish: complete when the input ends or the time is over."""

    kind: Literal["free"] = "free"
    duration: Annotated[Seconds, Positive] = 600.0
    """From the opening of the trial, for an operator who never stops (ours)."""

    def expected_duration(self, world: World, route: str) -> float:
        """Give the longest that it can last, s."""
        return self.duration

    def begin(self, world: World, route: str, messages: Messages) -> RunningTask:
        """Open the task; the route is not looked at."""
        return _RunningFree(self.duration)


class _RunningFree(RunningTask):
    when_input_ends = "completed"

    def __init__(self, duration: float) -> None:
        self._duration = duration
        self._started = False

    @property
    def situation(self) -> Situation:
        return Situation()

    def update(
        self, t: float, plant_state: Any, commanded: bool, collisions: int, colliding: bool
    ) -> Progress:
        """Note the first command, and the end of the time."""
        events: tuple[Event, ...] = ()
        if commanded and not self._started:
            self._started = True
            events = (Event(t, "start"),)
        ended = "completed" if t >= self._duration else ""
        return Progress(events, Situation(drive_away=colliding), self._started, ended)
