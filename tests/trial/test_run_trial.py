"""A whole trial: what it records, that it repeats to the byte, and that its input is enough."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from dataclasses import replace
from functools import cache
from math import isnan
from typing import Any, Literal

import numpy as np
import pytest
from core_world import door, straight_world, trial, wall_ahead
from numpy.typing import NDArray

from omnistudy.channel import SAMPLE_COLUMNS, Channel, Recording, Stream
from omnistudy.controllers.rate import RateController
from omnistudy.devices import Hand
from omnistudy.geometry import ForceField, PlanarPose, PlanarTwist, PlanarWrench
from omnistudy.laws import Law, Sensed
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.laws.zero_torque import ZeroTorqueLaw
from omnistudy.operators import Operator, Person, RunningOperator
from omnistudy.plants import Plant, RunningPlant
from omnistudy.scene import Contacts, PlanarState, Scene
from omnistudy.tasks.route import RouteTask
from omnistudy.trial import TrialResult, TrialSpec, resimulate, run_trial
from omnistudy.worlds import Situation


class Stuck(Operator):
    """Pushes the stick somewhere for some seconds, then has nothing more to do."""

    kind: Literal["stuck"] = "stuck"
    push: tuple[float, float, float] = (0.06, 0.0, 0.0)
    seconds: float = 1.0
    begins: float = 0.0
    arm: float = 400.0
    """N/m."""

    def begin(self, person: Person, physics_hz: int) -> RunningOperator:
        return _Stuck(self, physics_hz)


class _Stuck(RunningOperator):
    def __init__(self, stuck: Stuck, physics_hz: int) -> None:
        self._stuck = stuck
        self._steps = round(stuck.seconds * physics_hz)
        self.finished = self._steps == 0

    def hand(self, t: float, plant_state: Any, situation: Situation) -> Hand:
        self._steps -= 1
        self.finished = self._steps <= 0
        push = self._stuck.push if t >= self._stuck.begins else (0.0, 0.0, 0.0)
        arm = self._stuck.arm
        return Hand(push, (arm, arm, arm / 20.0), (20.0, 20.0, 0.5), (0.8, 0.8, 0.003))


@cache
def cornering(law: str) -> tuple[TrialSpec, TrialResult]:
    laws: dict[str, Law] = {
        "none": NoLaw(),
        "component": ComponentLaw(),
        "component as published": ComponentLaw(as_published=True, compliance_centre=0.1),
        "zero_torque": ZeroTorqueLaw(),
    }
    spec = trial(law=laws[law], controller=RateController(compliance_centre=0.1))
    return spec, run_trial(spec)


def stream(result: TrialResult, name: str) -> Stream:
    return next(found for found in result.streams if found.name == name)


def column(result: TrialResult, name: str) -> NDArray[np.float64]:
    return result.samples[:, SAMPLE_COLUMNS.index(name)]


def digest(result: TrialResult) -> str:
    """Everything that a trial leaves behind, as one digest."""
    parts = [result.samples.tobytes(), repr(result.events).encode()]
    parts += [part.data.tobytes() for part in result.streams]
    parts.append(
        repr(
            (result.status, result.duration_s, result.path_length_m, result.collisions,
             result.collisions_legacy, result.contact_time_s)
        ).encode()
    )  # fmt: skip
    return hashlib.sha256(b"".join(parts)).hexdigest()


LAWS = ["none", "component", "component as published", "zero_torque"]


@pytest.mark.parametrize("law", LAWS)
def test_a_trial_resimulates_from_its_input_alone(law: str) -> None:
    spec, result = cornering(law)
    assert result.status == "completed"
    again = resimulate(spec, stream(result, "input").data)
    assert again.samples.tobytes() == result.samples.tobytes()
    assert again.events == result.events
    assert (again.status, again.duration_s, again.collisions, again.contact_time_s) == (
        result.status,
        result.duration_s,
        result.collisions,
        result.contact_time_s,
    )


class Impedance(Law):
    """A law that answers the stick's own place and rate."""

    kind: Literal["impedance"] = "impedance"

    def field(self, sensed: Sensed) -> ForceField:
        x, _, theta = sensed.stick_rate
        return ForceField(PlanarWrench(-20.0 * sensed.stick[0], -2.0 * x, -0.1 * theta))


def test_a_law_that_senses_the_stick_resimulates() -> None:
    spec = trial(law=Impedance())
    result = run_trial(spec)
    assert column(result, "fy").any()
    again = resimulate(spec, stream(result, "input").data)
    assert again.samples.tobytes() == result.samples.tobytes()


def test_a_trial_out_of_time_resimulates() -> None:
    world = straight_world()
    world = world.model_copy(update={"bodies": (*world.bodies, wall_ahead(1.0))})
    spec = trial(world, operator=Stuck(seconds=100.0), task=RouteTask(time_limit=0.9))
    result = run_trial(spec)
    assert (result.status, result.collisions) == ("timed_out", 1)
    assert result.duration_s == pytest.approx(0.9 * 2.0 / 0.36, abs=1 / 240)
    assert result.contact_time_s > 2.0
    again = resimulate(spec, stream(result, "input").data)
    assert again.samples.tobytes() == result.samples.tobytes()
    assert again.events == result.events


def test_an_operator_who_has_nothing_more_to_do_aborts_the_trial() -> None:
    spec = trial(straight_world(), operator=Stuck(seconds=1.5))
    result = run_trial(spec)
    assert (result.status, result.reason) == ("aborted", "the input ended")
    assert stream(result, "input").data.shape == (360, 6)
    again = resimulate(spec, stream(result, "input").data)
    assert again.samples.tobytes() == result.samples.tobytes()
    assert (again.status, again.events) == (result.status, result.events)


def test_a_trial_without_a_single_step_is_a_result_too() -> None:
    result = run_trial(trial(straight_world(), operator=Stuck(seconds=0.0)))
    assert result.status == "aborted"
    assert isnan(result.duration_s)
    assert stream(result, "input").data.shape == (0, 6)
    assert result.samples.shape == (1, 13)


def test_same_spec_same_bytes_here_and_in_another_process() -> None:
    spec, result = cornering("component")
    assert digest(run_trial(spec)) == digest(result)
    script = "import test_run_trial as t; print(t.digest(t.cornering('component')[1]))"
    paths = f"import sys; sys.path[:0] = {[*sys.path, __file__.rpartition('/')[0]]!r}; "
    there = subprocess.run(
        [sys.executable, "-c", paths + script], capture_output=True, text=True, check=True
    )
    assert there.stdout.split()[-1] == digest(result)


def test_another_seed_another_drive() -> None:
    _, result = cornering("component")
    spec = cornering("component")[0]
    other = run_trial(replace(spec, person=spec.person._replace(trial_seed="another")))
    assert other.samples.tobytes() != result.samples.tobytes()


def test_samples_are_the_published_columns_twenty_times_a_second() -> None:
    _, result = cornering("component")
    assert result.samples.shape[1] == 13
    t = column(result, "t")
    assert np.allclose(t, np.arange(len(t)) / 20)
    opened = result.events[0].t
    assert t[-1] <= opened + result.duration_s < t[-1] + 1 / 20 + 1e-9
    assert not np.isnan(result.samples).any()
    assert tuple(result.samples[0, 1:7]) == (0, 0, 0, 0, 0, 0)


def test_streams_keep_the_input_of_every_step_and_what_sample_has_no_column_for() -> None:
    _, result = cornering("component")
    given = stream(result, "input")
    assert given.rate_hz == 240
    assert [c.name for c in given.channels] == [
        "stick_x", "stick_y", "stick_theta", "stick_x_rate", "stick_y_rate", "stick_theta_rate",
    ]  # fmt: skip
    assert [c.unit for c in given.channels] == ["m", "m", "rad", "m/s", "m/s", "rad/s"]
    assert len(given.data) == round((result.events[0].t + result.duration_s) * 240)
    plant, device = stream(result, "plant"), stream(result, "device")
    assert [c.name for c in plant.channels] == [
        "wheel_front_left", "wheel_front_right", "wheel_rear_left", "wheel_rear_right",
    ]  # fmt: skip
    assert [c.name for c in device.channels] == ["motor_x", "motor_y", "motor_theta"]
    assert len(plant.data) == len(device.data) == len(result.samples)
    # the stick in a sample is the input of the step before it
    twelfths = np.arange(1, len(result.samples)) * 12
    assert np.array_equal(column(result, "stick_x")[1:], given.data[twelfths - 1, 0])


def test_the_clock_runs_from_the_first_command_to_the_finish() -> None:
    spec = trial(straight_world(), operator=Stuck(seconds=20.0, begins=1.0))
    result = run_trial(spec)
    start, *_, finish = (e for e in result.events if e.kind in {"start", "finish"})
    assert result.status == "completed"
    assert 1.0 < start.t < 1.3
    assert result.duration_s == finish.t - start.t
    # 2 m to the block less half a block and half a robot, nearly all at 0.36 m/s
    assert result.path_length_m == pytest.approx(2.0 - 0.075 - 0.29, abs=0.01)
    assert result.duration_s == pytest.approx(result.path_length_m / 0.36, abs=0.2)


def test_backwards_is_a_command_too() -> None:
    spec = trial(straight_world(), operator=Stuck(seconds=1.0, push=(-0.06, 0.0, 0.0)))
    assert [event.kind for event in run_trial(spec).events][:1] == ["start"]


class Counted(Law):
    """Notes when it is asked, by the size of the scans that it gets."""

    kind: Literal["counted"] = "counted"

    def field(self, sensed: Sensed) -> ForceField:
        asked.append(sensed)
        return ForceField(PlanarWrench(float(len(asked)), 0.0, 0.0))


asked: list[Sensed] = []


@pytest.mark.parametrize("scan_hz", [50, 40, 240])
def test_the_law_is_asked_once_a_scan_even_where_the_rates_do_not_divide(scan_hz: int) -> None:
    asked.clear()
    spec = trial(
        straight_world(),
        law=Counted(),
        operator=Stuck(seconds=2.0),
        recording=Recording(scan_hz=scan_hz),
    )
    result = run_trial(spec)
    assert len(asked) == 2 * scan_hz + 1  # the last when the trial is found to be over
    steps_of_scans = np.ceil(np.arange(2 * scan_hz + 1) * 240 / scan_hz)
    expected = np.searchsorted(steps_of_scans, np.arange(41) * 12, side="right")
    assert np.array_equal(column(result, "fx"), expected)


def test_the_law_senses_intent_and_stick() -> None:
    asked.clear()
    run_trial(trial(straight_world(), law=Counted(), operator=Stuck(seconds=1.0),
                    controller=RateController(compliance_centre=0.2)))  # fmt: skip
    last = asked[-1]
    assert last.twist == pytest.approx((0.36, 0.0, 0.0))
    assert last.stick[0] == pytest.approx(0.0415, abs=1e-4)
    assert last.twist_per_stick == RateController().twist_per_stick
    assert last.scan.ranges.shape == (128,)


class Blind(Plant):
    """A cart on a rail: has x and vx, no heading, no lidar."""

    kind: Literal["blind"] = "blind"

    @property
    def width(self) -> float:
        return 0.1

    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        return _Blind(start, physics_hz)


class _Blind(RunningPlant):
    channels = (
        Channel("x", "m", "place on the rail"),
        Channel("vx", "m/s", "speed"),
        Channel("battery", "V", "of the cart"),
    )

    def __init__(self, start: PlanarPose, physics_hz: int) -> None:
        self._x, self._vx, self._dt = start.x, 0.0, 1 / physics_hz

    @property
    def state(self) -> PlanarState:
        touched = ("red",) if self._x > 0.5 else ()
        twist = PlanarTwist(self._vx, 0.0, 0.0)
        return PlanarState(PlanarPose(self._x, 0.0, 0.0), twist, Contacts(others=touched))

    @property
    def travelled(self) -> float:
        return abs(self._x)

    def values(self) -> tuple[float, ...]:
        return (self._x, self._vx, 12.0)

    def command(self, command: PlanarTwist) -> None:
        self._vx = command.vx

    def step(self) -> None:
        self._x += self._vx * self._dt

    def close(self) -> None:
        pass


def test_what_a_plant_lacks_is_nan_and_what_it_has_more_is_a_stream() -> None:
    result = run_trial(trial(straight_world(), plant=Blind(), operator=Stuck(seconds=5.0)))
    assert result.status == "completed"
    assert column(result, "x")[-1] == pytest.approx(0.5, abs=0.03)
    for missing in ("y", "theta", "vy", "omega"):
        assert np.isnan(column(result, missing)).all()
    assert not np.isnan(column(result, "stick_x")).any()
    battery = stream(result, "plant")
    assert [channel.name for channel in battery.channels] == ["battery"]
    assert (battery.data == 12.0).all()


@pytest.mark.parametrize(("arm", "opened"), [(400.0, True), (100.0, False)])
def test_a_door_is_pushed_open_against_the_feedback_by_who_means_it(
    arm: float, opened: bool
) -> None:
    # the law sees a wall where the door is; at most 13.5 N of it reach the hand
    world = straight_world(half_width=0.55)
    world = world.model_copy(update={"bodies": (*world.bodies, door(1.0))})
    spec = trial(world, law=ComponentLaw(), operator=Stuck(seconds=12.0, arm=arm))
    result = run_trial(spec)
    assert bool(column(result, "x")[-1] > 1.0) is opened
    assert column(result, "fx").min() < (-13.5 if opened else -1.0)
    assert result.collisions == 0
