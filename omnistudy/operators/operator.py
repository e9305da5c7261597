"""What every operator can do: see the robot and the task, and hold the stick."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, ClassVar, NamedTuple

from omnistudy.devices import Device, Hand
from omnistudy.errors.devices import NobodyHolds
from omnistudy.registry import KindModel
from omnistudy.worlds import Situation


class Person(NamedTuple):
    """Who drives: stored seeds from which all of an operator's draws are made.

    participant_seed : the same in all of a participant's trials.
    trial_seed : of this trial and attempt alone.
    position : 1-based place of the trial in the participant's order, for practice.
    """

    participant_seed: str
    trial_seed: str
    position: int


class Operator(KindModel, ABC):
    """Parameters of an operator; `begin` makes the one who drives a trial."""

    in_lockstep: ClassVar[bool] = True
    """False: a real person, who drives live trials with real devices only."""

    def check_hold(self, device: Device) -> None:
        """Raise NobodyHolds where the operator is a person and the device is simulated."""
        if device.in_lockstep and not self.in_lockstep:
            raise NobodyHolds(self.kind, device.kind)

    @abstractmethod
    def begin(self, person: Person, physics_hz: int) -> RunningOperator:
        """Give the operator before the first step."""


class RunningOperator(ABC):
    """An operator during one trial. It never learns the condition nor the law."""

    finished: bool = False
    """True once there is nothing more to do, such as at the end of a recording."""

    @abstractmethod
    def hand(self, t: float, plant_state: Any, situation: Situation) -> Hand:
        """Give what the hand does during the coming physics step, at t seconds."""
