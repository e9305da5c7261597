"""What every task can do: say what is to be done, notice that it happened, and end."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, NamedTuple

from omnistudy.channel import Event
from omnistudy.registry import KindModel
from omnistudy.tasks.messages import Messages
from omnistudy.worlds import Situation, World


class Progress(NamedTuple):
    """What one step did to the task.

    events : what happened in this step.
    situation : what the person now sees of the task.
    started : True once the clock runs (the first command other than zero).
    ended : "" while it goes on, else "completed" or "timed_out".
    """

    events: tuple[Event, ...]
    situation: Situation
    started: bool
    ended: str


class Task(KindModel, ABC):
    """Parameters of a task; `begin` opens it in a world."""

    @abstractmethod
    def begin(self, world: World, route: str, messages: Messages) -> RunningTask:
        """Open the task on a route of the world; raises UnknownRoute."""

    @abstractmethod
    def expected_duration(self, world: World, route: str) -> float:
        """Say in s how long a trial is likely to take, for plans and progress."""


class RunningTask(ABC):
    """A task during one trial."""

    when_input_ends: str = "aborted"
    """Status of a trial whose operator is finished before the task is."""

    @property
    @abstractmethod
    def situation(self) -> Situation:
        """What the person sees of the task before the first step."""

    @abstractmethod
    def update(
        self, t: float, plant_state: Any, commanded: bool, collisions: int, colliding: bool
    ) -> Progress:
        """Notice what the step that ends at `t` did.

        commanded : whether the stick asked for any motion in it.
        collisions : running number of collisions, for what is shown to the person.
        colliding : whether the last of them still goes on.
        """
