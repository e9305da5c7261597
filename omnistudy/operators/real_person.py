"""Somebody holds the real device."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from omnistudy.devices import NO_HAND, Hand
from omnistudy.operators.operator import Operator, Person, RunningOperator
from omnistudy.worlds import Situation


class RealPerson(Operator):
    """A person at a real device, in live trials alone: what the hand does, the device tells."""

    in_lockstep: ClassVar[bool] = False

    kind: Literal["person"] = "person"

    def begin(self, person: Person, physics_hz: int) -> RunningOperator:
        """Give a hand of nothing: nobody is simulated."""
        return _SomebodyElse()


class _SomebodyElse(RunningOperator):
    def hand(self, t: float, plant_state: Any, situation: Situation) -> Hand:
        """Give no hand."""
        return NO_HAND
