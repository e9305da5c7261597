"""Bring the hand to a body of the world."""

from __future__ import annotations

from math import dist
from typing import Annotated, Any, Literal

from omnistudy.channel import Event
from omnistudy.registry import Model
from omnistudy.tasks import Messages, Progress, RunningTask, Task
from omnistudy.units import Metres, Positive, Seconds
from omnistudy.worlds import Leg, Situation, World


class ReachTask(Task):
    """Reached when the hand is within 5 cm of where the route ends."""

    kind: Literal["reach"] = "reach"
    within: Annotated[Metres, Positive] = 0.05
    time_limit: Annotated[Seconds, Positive] = 20.0

    def expected_duration(self, world: World, route: str) -> float:
        return self.time_limit

    def begin(self, world: World, route: str, messages: Messages) -> RunningTask:
        leg = world.route(route).legs[-1]
        body = next(body for body in world.scene.bodies if body.name == leg.target)
        return _Reaching(self, Target(at=(body.x, body.y, body.z)), leg)


class Target(Model):
    """Where the hand is to be, m."""

    at: tuple[Metres, Metres, Metres]


class _Reaching(RunningTask):
    def __init__(self, task: ReachTask, target: Target, leg: Leg) -> None:
        self._task = task
        self._target = target
        self._situation = Situation(leg)
        self._started = False

    @property
    def situation(self) -> Situation:
        return self._situation

    def update(
        self, t: float, plant_state: Any, commanded: bool, collisions: int, colliding: bool
    ) -> Progress:
        events: list[Event] = []
        if commanded and not self._started:
            self._started = True
            events.append(Event(t, "start"))
        ended = ""
        if dist(plant_state.pose.position, self._target.at) <= self._task.within:
            ended = "completed"
            events.append(
                Event(t, "reached", self._situation.leg.target if self._situation.leg else "")
            )
        elif t >= self._task.time_limit:
            ended = "timed_out"
            events.append(Event(t, "timed_out"))
        return Progress(tuple(events), self._situation, self._started, ended)
