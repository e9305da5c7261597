"""A trial with a device that somebody else has connected, and what must not be coupled."""

from __future__ import annotations

from typing import ClassVar, Literal

import pytest
from core_world import trial

from omnistudy.devices import DeviceState, Hand, RunningDevice
from omnistudy.devices.direct import DirectDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.errors.devices import NobodyHolds, OnlyLive
from omnistudy.geometry import ForceField
from omnistudy.operators.real_person import RealPerson
from omnistudy.tasks.free import FreeTask
from omnistudy.trial import run_trial


class RealDevice(DirectDevice):
    """Stands in for hardware: it lives in real time."""

    in_lockstep: ClassVar[bool] = False
    kind: Literal["direct"] = "direct"


class Pushed(RunningDevice):
    """Stands in for hardware that somebody pushes forward, until it ails."""

    axes = SimulatedStick().connect(240).axes
    forces = (True, False, True)

    def __init__(self, ails_after: int) -> None:
        self.hands: list[Hand] = []
        self.closed = False
        self._ails_after = ails_after

    def render(self, field: ForceField) -> None:
        """Feel nothing."""

    def advance(self, hand: Hand) -> DeviceState:
        self.hands.append(hand)
        return DeviceState((0.05, 0.0, 0.0), (0.0, 0.0, 0.0))

    def trouble(self) -> str:
        return "the cable is off" if len(self.hands) >= self._ails_after else ""

    def close(self) -> None:
        self.closed = True


def test_a_person_drives_with_a_real_device_that_stays_connected() -> None:
    device = Pushed(ails_after=1000)
    spec = trial(device=RealDevice(), operator=RealPerson(), task=FreeTask(duration=1.0))
    result = run_trial(spec, held=device)
    assert (result.status, len(device.hands), device.closed) == ("completed", 240, False)
    assert result.path_length_m > 0.1
    assert set(device.hands) == {Hand((), (), (), ())}
    assert result.device is not None
    assert (result.device.kind, result.device.pushes) == ("direct", ("stick_x", "stick_theta"))


def test_a_device_that_ails_voids_the_trial_with_its_cause_and_keeps_the_record() -> None:
    device = Pushed(ails_after=120)
    spec = trial(device=RealDevice(), operator=RealPerson(), task=FreeTask(duration=1.0))
    result = run_trial(spec, held=device)
    assert (result.status, result.reason) == ("void", "the cable is off")
    assert len(result.streams[0].data) == 120
    assert result.samples[-1, 0] == pytest.approx(0.5)


def test_a_real_device_is_refused_in_simulated_time() -> None:
    with pytest.raises(OnlyLive, match="device 'direct' lives in real time"):
        run_trial(trial(device=RealDevice()))


def test_a_person_cannot_hold_a_simulation() -> None:
    with pytest.raises(NobodyHolds, match="no person can hold the simulated device"):
        run_trial(trial(operator=RealPerson()))


def test_a_trial_tells_the_device_that_it_connected_itself() -> None:
    result = run_trial(trial(task=FreeTask(duration=0.1)))
    assert result.device is not None
    assert (result.device.kind, result.device.wrench) == ("simulated_stick", "clipped")
