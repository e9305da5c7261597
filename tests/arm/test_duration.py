"""How long a motion needs."""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration
from omnistudy.arm.duration import durations
from omnistudy.arm.task import Motion
from omnistudy.geometry import PlanarPose


@pytest.fixture
def start(wmra1: ArmBody) -> Configuration:
    return Configuration(wmra1, np.array(wmra1.profile.ready), PlanarPose(0.0, 0.0, 0.0))


def needed(start: Configuration, **parts: object) -> tuple[float, float, float]:
    motion = Motion.model_validate({"name": "it", **parts})
    found = durations(motion, motion.path(start.hand, start.base), start)
    assert found.longest == max(found)
    return found


def test_the_hand_needs_its_way_or_its_turn(start: Configuration) -> None:
    ahead = {"frame": "gripper", "position": [0, 0, 0.5]}
    assert needed(start, goal=ahead)[0] == pytest.approx(10.0)
    assert needed(start, goal=ahead, speed=0.1)[0] == pytest.approx(5.0)
    turning = {**ahead, "turns": [{"axis": "z", "angle": 3.0}]}
    assert needed(start, goal=turning)[0] == pytest.approx(20.0)


def test_the_chair_needs_its_turns_and_its_way(start: Configuration) -> None:
    goal = {"frame": "gripper", "position": [0, 0, 0.1]}
    # one metre straight ahead at 0.1 m/s, at 1.0557 times the mean speed
    assert needed(start, goal=goal, chair_goal={"x": 1.0})[1] == pytest.approx(10.557, abs=1e-3)
    assert needed(start, goal=goal)[1] == 0.0


def test_joints_need_longer_the_faster_the_hand_should_be_relative_to_them(
    start: Configuration,
) -> None:
    goal = {"frame": "gripper", "position": [0, 0.3, 0]}
    _, _, slow = needed(start, goal=goal, speed=0.05)
    _, _, fast = needed(start, goal=goal, speed=0.5)
    # what the joints need does not depend on what the hand would like
    assert fast == pytest.approx(slow)
    assert needed(start, goal=goal, speed=0.5)[0] < fast


def test_nothing_to_do_takes_no_time(start: Configuration) -> None:
    assert needed(start, goal={}) == (0.0, 0.0, 0.0)
