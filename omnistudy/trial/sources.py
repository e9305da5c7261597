"""Where the device's state comes from: an operator's hand on a device, or a record."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import Channel
from omnistudy.devices import NO_HAND, DeviceRecord, DeviceState, RunningDevice, record_of
from omnistudy.errors.devices import OnlyLive
from omnistudy.errors.operators import WrongAxes
from omnistudy.geometry import ForceField
from omnistudy.trial.spec import TrialSpec
from omnistudy.worlds import Situation


class Source(ABC):
    """Gives the device's state for every physics step."""

    axes: tuple[Channel, ...]
    channels: tuple[Channel, ...]

    def has(self, step: int) -> bool:
        """Tell whether there is a state for a step."""
        return True

    def trouble(self) -> str:
        """Tell in one clause why the trial cannot go on; "" while all is well."""
        return ""

    def record(self) -> DeviceRecord | None:
        """Describe the device; None when there is none."""
        return None

    def close(self) -> None:
        """Let go what the trial opened."""
        return

    @abstractmethod
    def next(self, step: int, t: float, plant_state: Any, situation: Situation) -> DeviceState:
        """Give the state that the step which begins at t seconds consumes."""

    @abstractmethod
    def render(self, field: ForceField) -> None:
        """Take a new force field."""

    @abstractmethod
    def values(self) -> tuple[float, ...]:
        """Give the present value of each channel."""


class HandSource(Source):
    """An operator holds a device; feedback reaches the operator only as force on it."""

    def __init__(self, spec: TrialSpec, held: RunningDevice | None = None) -> None:
        """Take the connected device, or connect the spec's own; raises OnlyLive, NobodyHolds."""
        _check_live(spec, held)
        self._kind = spec.device.kind
        self._own = held is None
        self._device = held or spec.device.connect(spec.recording.physics_hz)
        self._operator = spec.operator.begin(spec.person, spec.recording.physics_hz)
        self.axes = self._device.axes
        self.channels = self._device.channels

    def next(self, step: int, t: float, plant_state: Any, situation: Situation) -> DeviceState:
        """Let the hand act and the device move for one step; raises WrongAxes."""
        hand = self._operator.hand(t, plant_state, situation)
        if step == 0 and hand != NO_HAND and len(hand.reference) != len(self.axes):
            raise WrongAxes(len(hand.reference), [axis.name for axis in self.axes])
        return self._device.advance(hand)

    def has(self, step: int) -> bool:
        """Tell whether the operator goes on driving."""
        return not self._operator.finished

    def trouble(self) -> str:
        """Tell what ails the device."""
        return self._device.trouble()

    def record(self) -> DeviceRecord:
        """Describe the device."""
        return record_of(self._kind, self._device)

    def close(self) -> None:
        """Let a device go that this trial connected."""
        if self._own:
            self._device.close()

    def render(self, field: ForceField) -> None:
        """Hand the field to the device."""
        self._device.render(field)

    def values(self) -> tuple[float, ...]:
        """Give what the device records of itself."""
        return self._device.values()


class RecordSource(Source):
    """The record stands in for operator and device."""

    channels = ()

    def __init__(self, spec: TrialSpec, recorded: NDArray[np.float64]) -> None:
        self.axes = spec.device.connect(spec.recording.physics_hz).axes
        self._rows = recorded.tolist()

    def has(self, step: int) -> bool:
        """Tell whether the record reaches this step."""
        return step < len(self._rows)

    def next(self, step: int, t: float, plant_state: Any, situation: Situation) -> DeviceState:
        """Give the recorded row: positions, then rates."""
        row, axes = self._rows[step], len(self.axes)
        return DeviceState(tuple(row[:axes]), tuple(row[axes:]))

    def render(self, field: ForceField) -> None:
        """Drop the field: the record already holds what it did."""

    def values(self) -> tuple[float, ...]:
        """Give nothing: a record knows positions and rates only."""
        return ()


def _check_live(spec: TrialSpec, held: RunningDevice | None) -> None:
    """Refuse a real device in simulated time, and a person without a real device."""
    if held is None and not spec.device.in_lockstep:
        raise OnlyLive(spec.device.kind)
    spec.operator.check_hold(spec.device)
