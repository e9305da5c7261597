"""Touch the blocks of a route in their order, then the finish block."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from omnistudy.channel import Event
from omnistudy.tasks.messages import Messages
from omnistudy.tasks.task import Progress, RunningTask, Task
from omnistudy.units import MetresPerSecond, Positive, Ratio, Seconds
from omnistudy.worlds import Leg, Situation, World


class RouteTask(Task):
    """Blocks in order, finish, time limit (Tyagi 2017, ch. 4)."""

    kind: Literal["route"] = "route"
    top_speed: Annotated[MetresPerSecond, Positive] = 0.36
    """What the controller reaches at full stick; the measure of the time limit."""
    time_limit: Annotated[Ratio, Positive] = 3.0
    """A trial ends as timed out after this many times the route's length at top speed (ours)."""
    good_job: Annotated[Seconds, Positive] = 4.0
    """How long the message at a block stays."""

    def limit(self, world: World, route: str) -> float:
        """Give the time limit in s of a route; raises UnknownRoute."""
        return self.time_limit * world.route(route).length / self.top_speed

    def expected_duration(self, world: World, route: str) -> float:
        """Guess one and a half times the route at top speed, s; raises UnknownRoute."""
        return 1.5 * world.route(route).length / self.top_speed

    def begin(self, world: World, route: str, messages: Messages) -> RunningTask:
        """Open the task; the first block of the route is the first target."""
        return _RunningRoute(self, world.route(route).legs, self.limit(world, route), messages)


class _RunningRoute(RunningTask):
    def __init__(
        self, task: RouteTask, legs: tuple[Leg, ...], limit: float, messages: Messages
    ) -> None:
        self._task = task
        self._legs = legs
        self._limit = limit
        self._messages = messages
        self._reached = 0
        self._started: float | None = None
        self._collisions = 0
        self._drive_away = False
        self._message_ends: float | None = None
        self._situation = Situation(legs[0])
        self._quiet = Progress((), self._situation, False, "")

    @property
    def situation(self) -> Situation:
        return self._situation

    def update(
        self, t: float, plant_state: Any, commanded: bool, collisions: int, colliding: bool
    ) -> Progress:
        """Start the clock, show and close messages, count blocks off, end."""
        contacts = plant_state.contacts
        started = self._started is not None
        leg = self._legs[self._reached]
        if (
            (started or not commanded)
            and collisions == self._collisions
            and colliding == self._drive_away
            and leg.target not in contacts.others
            and self._message_ends is None
            and t < self._limit
        ):
            return self._quiet
        events: list[Event] = []
        ended = ""
        if commanded and not started:
            self._started = t
            events.append(Event(t, "start"))
        self._warn(t, colliding, collisions, events)
        if self._message_ends is not None and t >= self._message_ends:
            self._message_ends = None
            events.append(Event(t, "message_closed", self._messages.good_job))
        if leg.target in contacts.others:
            ended = self._arrive(t, leg, collisions, events)
        if not ended and t - (self._started or 0.0) >= self._limit:
            ended = "timed_out"
            events.append(Event(t, "timed_out", f"{self._limit:.0f} s"))
        current = self._legs[min(self._reached, len(self._legs) - 1)]
        self._situation = Situation(current, self._drive_away)
        running = self._started is not None
        self._quiet = Progress((), self._situation, running, "")
        return Progress(tuple(events), self._situation, running, ended)

    def _warn(self, t: float, colliding: bool, collisions: int, events: list[Event]) -> None:
        text = self._messages.drive_away
        if self._drive_away and not colliding:
            self._drive_away = False
            events.append(Event(t, "message_closed", text.format(number=self._collisions)))
        if collisions > self._collisions:
            self._collisions = collisions
            self._drive_away = True
            events.append(Event(t, "message", text.format(number=collisions)))

    def _arrive(self, t: float, leg: Leg, collisions: int, events: list[Event]) -> str:
        messages = self._messages
        self._reached += 1
        if self._reached < len(self._legs):
            events.append(Event(t, "block", leg.target))
            events.append(Event(t, "message", messages.good_job))
            events.append(Event(t, "message", messages.next_block))
            self._message_ends = t + self._task.good_job
            return ""
        events.append(Event(t, "finish", leg.target))
        events.append(Event(t, "message", messages.game_over))
        events.append(Event(t, "message", messages.round_complete.format(number=collisions)))
        return "completed"
