"""The first robot as a whole: it lags, it sees, it is recorded and drives again from its record."""

from __future__ import annotations

from functools import cache
from math import hypot

import numpy as np
import pytest
from core_world import scene, straight_world, trial, wall_ahead
from infrared_world import HZ, ORIGIN, drive, nexus
from pydantic import ValidationError

from omnistudy.channel import SAMPLE_COLUMNS
from omnistudy.errors.plants import StartsInWall
from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.laws.infrared import InfraredLaw
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.lidar import Lidar
from omnistudy.plants.nexus import LidarAtCentre, Nexus
from omnistudy.plants.youbot import Youbot
from omnistudy.session.parts import part
from omnistudy.trial import TrialResult, TrialSpec, resimulate, run_trial

WHEELS = ("front_left", "front_right", "rear_left", "rear_right")


def first_robot(**changes: object) -> TrialSpec:
    """A short drive along a narrow corridor, feedback on."""
    whole = {"plant": Nexus(), "law": InfraredLaw(), **changes}
    return trial(straight_world(0.6, half_width=0.29), **whole)


@cache
def driven() -> TrialResult:
    return run_trial(first_robot())


def test_size() -> None:
    assert Nexus().width == pytest.approx(0.36)
    assert Nexus().circumradius == pytest.approx(hypot(0.20, 0.18))


def test_it_drives_as_told_once_its_wheels_have_caught_up() -> None:
    with nexus() as plant:
        drive(plant, PlanarTwist(0.2, 0.1, 0.0), 48)  # one second
        begin = plant.state.pose
        drive(plant, PlanarTwist(0.2, 0.1, 0.0), 96)
        end = plant.state.pose
        assert begin.to_local(end.x, end.y) == pytest.approx((0.4, 0.2), abs=5e-3)


def test_it_lags_its_command_where_the_youbot_does_not() -> None:
    speeds = {}
    for robot in (Nexus(), Youbot()):
        plant = robot.build(scene(), ORIGIN, HZ, "seed")
        plant.command(PlanarTwist(0.1, 0.0, 0.0))
        for _ in range(4):
            plant.step()
            plant.command(PlanarTwist(0.1, 0.0, 0.0))
        speeds[robot.kind] = plant.state.twist.vx
        plant.close()
    # 1/60 s of the step response of (35 s + 400)/(s² + 36 s + 400), see test_wheel_servo.py:
    # 1 - 0.7408·(0.9895 - 1.950·0.1448) = 0.476
    assert speeds["nexus"] == pytest.approx(0.1 * 0.476, abs=3e-3)
    assert speeds["youbot"] == pytest.approx(0.1, abs=1e-6)


def test_its_base_goes_where_its_wheels_turn() -> None:
    with nexus() as plant:
        for _ in range(60):
            drive(plant, PlanarTwist(0.2, -0.1, 0.4), 1, every=1)
            names = [channel.name for channel in plant.channels]
            values = dict(zip(names, plant.values(), strict=True))
            wheels = tuple(values[f"wheel_{at}"] for at in WHEELS)
            assert plant.state.twist == pytest.approx(Nexus().twist(wheels), abs=0.01)


def test_a_wall_stops_it() -> None:
    with nexus(wall_ahead(0.4)) as plant:
        drive(plant, PlanarTwist(0.3, 0.0, 0.0), 100)
        assert plant.state.contacts.walls == ("ahead",)
        assert plant.state.pose.x == pytest.approx(0.2, abs=1e-3)


def test_a_start_inside_a_wall_is_refused_by_name() -> None:
    with pytest.raises(StartsInWall, match=r"plant 'nexus' starts at x = 0\.3 m"):
        Nexus().build(scene(wall_ahead(0.4)), PlanarPose(0.3, 0, 0), HZ, "seed")


def test_what_its_sensors_told_is_recorded() -> None:
    plant = next(stream for stream in driven().streams if stream.name == "plant")
    names = [channel.name for channel in plant.channels]
    assert names[-6:] == [f"infrared_{number}" for number in range(1, 7)]
    told = plant.data[:, -6:]
    # left and right look between walls 0.58 m apart, 0.36 m apart on a robot that turns
    theta = driven().samples[:, SAMPLE_COLUMNS.index("theta")]
    apart = told[:, 0] + told[:, 5] - (0.58 / np.cos(theta) - 0.36)
    assert np.median(apart) == pytest.approx(0.0, abs=5e-3)
    assert not np.isnan(told).any()


def test_a_trial_drives_again_from_its_record_to_the_same_bytes() -> None:
    spec, result = first_robot(), driven()
    record = next(stream for stream in result.streams if stream.name == "input")
    again = resimulate(spec, record.data)
    assert again.samples.tobytes() == result.samples.tobytes()
    sensors = [
        next(stream.data for stream in one.streams if stream.name == "plant")
        for one in (again, result)
    ]
    assert sensors[0].tobytes() == sensors[1].tobytes()
    assert result.status == "completed"
    assert np.abs(result.samples[:, -3:]).max() > 0.1  # and the law had something to say


def test_another_trial_seed_is_another_noise() -> None:
    other = run_trial(first_robot(seed="b"))
    width = min(len(other.samples), len(driven().samples))
    assert other.samples[:width].tobytes() != driven().samples[:width].tobytes()


def test_pages_give_the_robot_with_either_kind_of_sensor() -> None:
    assert part("plant", "nexus") == Nexus()
    assert part("plant", "nexus_lidar") == Nexus(sensors=LidarAtCentre())


def test_its_lidar_is_that_of_the_youbot() -> None:
    scans = []
    for robot in (Nexus(sensors=LidarAtCentre()), Youbot()):
        plant = robot.build(scene(wall_ahead(0.5)), PlanarPose(0.0, 0.0, 0.2), HZ, "seed")
        scans.append(plant.scan())
        plant.close()
    first, second = scans
    assert first is not None
    assert second is not None
    assert first.ranges.tobytes() == second.ranges.tobytes()
    assert len(first.ranges) == Lidar().rays == 128
    assert first.rates is None


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"kind": "lidr"}, "infrared_ring"),
        ({"kind": "lidar", "noise": 1}, "noise"),
        ({"rays": 64}, "rays"),
    ],
)
def test_unknown_sensors_are_refused(given: dict[str, object], said: str) -> None:
    with pytest.raises(ValidationError, match=said):
        Nexus.model_validate({"sensors": given})


def test_sensors_without_a_kind_are_the_ring() -> None:
    assert Nexus.model_validate({"sensors": {"noise": 0.0}}).sensors == InfraredRing(noise=0.0)
