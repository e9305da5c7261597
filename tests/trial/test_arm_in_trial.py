"""A trial runs the arm's controllers as it runs all others: nothing in the loop knows of arms.

The plant is a stand-in without physics, since the one with physics is not there yet; controller,
device, operator interface, loop and recorder are the real ones.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import pytest
from core_world import straight_world, trial

from omnistudy.arm import ArmBody, ArmState, Configuration, load_arm
from omnistudy.channel import Channel
from omnistudy.devices import Device, DeviceState, Hand, RunningDevice
from omnistudy.geometry import ForceField, PlanarPose
from omnistudy.operators import Operator, Person, RunningOperator
from omnistudy.plants import Plant, RunningPlant
from omnistudy.registry import load_kind
from omnistudy.scene import Scene
from omnistudy.tasks.free import FreeTask
from omnistudy.trial import resimulate, run_trial
from omnistudy.trial.spec import TrialSpec
from omnistudy.worlds import Situation

PUSH = (0.02, 0.0, 0.01, 0.0, 0.0, 0.05)
SECONDS = 2.0
BODY = ArmBody(load_arm("wmra1"))


class ExactArm(Plant):
    """Does the rates that it is told, exactly."""

    kind: Literal["exact_arm"] = "exact_arm"

    @property
    def width(self) -> float:
        return 0.7

    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        return RunningExactArm(Configuration(BODY, np.array(BODY.profile.ready), start), physics_hz)


class RunningExactArm(RunningPlant):
    channels = (
        *(Channel(f"joint_{n}", "rad", f"angle of joint {n}") for n in range(1, 8)),
        *(Channel(f"hand_{axis}", "m", "hand's place") for axis in "xyz"),
    )

    def __init__(self, at: Configuration, physics_hz: int) -> None:
        self._at = at
        self._dt = 1.0 / physics_hz
        self._rates = np.zeros(9)

    @property
    def state(self) -> ArmState:
        return ArmState(self._at)

    @property
    def travelled(self) -> float:
        return 0.0

    def values(self) -> tuple[float, ...]:
        return (*self._at.joints.tolist(), *self._at.hand[:3, 3].tolist())

    def command(self, command: Any) -> None:
        self._rates = command

    def step(self) -> None:
        self._at = self._at.moved(self._rates, self._dt)

    def close(self) -> None:
        """There is no physics to let go of."""


class SixAxes(Device):
    """Goes where the hand wants it."""

    kind: Literal["six_axes"] = "six_axes"

    def connect(self, physics_hz: int) -> RunningDevice:
        return RunningSixAxes()


class RunningSixAxes(RunningDevice):
    axes = tuple(
        Channel(f"{kind}_{axis}", unit, f"{kind} along {axis}")
        for kind, unit in (("way", "m/s"), ("turn", "rad/s"))
        for axis in "xyz"
    )

    def render(self, field: ForceField) -> None:
        """There is no motor."""

    def advance(self, hand: Hand) -> DeviceState:
        return DeviceState(hand.reference, (0.0,) * 6)


class Pusher(Operator):
    """Pushes the same way all the time."""

    kind: Literal["pusher"] = "pusher"

    def begin(self, person: Person, physics_hz: int) -> RunningOperator:
        return RunningPusher()


class RunningPusher(RunningOperator):
    def hand(self, t: float, plant_state: Any, situation: Situation) -> Hand:
        return Hand(PUSH, (0.0,) * 6, (0.0,) * 6, (0.0,) * 6)


def spec(kind: str) -> TrialSpec:
    return trial(
        straight_world(),
        plant=ExactArm(),
        device=SixAxes(),
        operator=Pusher(),
        controller=load_kind("controllers", kind)(zones="none"),
        task=FreeTask(duration=SECONDS),
    )


@pytest.mark.parametrize("kind", ["sri_wln", "pi_wln", "sri_ene", "pi_ene", "dual_qp"])
def test_the_hand_goes_where_it_is_pushed_and_the_record_gives_the_same_again(kind: str) -> None:
    done = run_trial(spec(kind))
    assert done.status == "completed"
    streams = {stream.name: stream.data for stream in done.streams}
    hand = streams["plant"][:, 7:10]
    assert hand[0] == pytest.approx((0.586, -0.131, 0.899))
    # samples are taken before each step: the last one a twentieth of a second before the end
    assert hand[-1] - hand[0] == pytest.approx(np.array(PUSH[:3]) * (SECONDS - 0.05), abs=1e-3)
    again = resimulate(spec(kind), streams["input"])
    assert again.samples.tobytes() == done.samples.tobytes()
