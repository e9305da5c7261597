"""From where on the floor a hand can be brought to a pose."""

from __future__ import annotations

from math import hypot, pi

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration
from omnistudy.arm.stand_off import RADIAN, nearest_stand_off
from omnistudy.geometry import PlanarPose
from omnistudy.geometry.rigid_motion import Floats, pose_error, rotation, transform

FORWARD = np.array(((0, 0, 1), (-1, 0, 0), (0, -1, 0)))
"""Hand ahead, its x to the right."""


def goal(x: float, y: float, z: float, turned: Floats = FORWARD) -> Floats:
    return transform(turned, np.array((x, y, z)))


@pytest.fixture
def now(wmra1: ArmBody) -> Configuration:
    return Configuration(wmra1, np.array(wmra1.profile.ready), PlanarPose(0.0, 0.0, 0.0))


def test_where_the_hand_is_nothing_needs_to_move(now: Configuration) -> None:
    found = nearest_stand_off(now, now.hand)
    assert found.reached
    assert found.clear
    assert (found.distance, found.turn) == (0.0, 0.0)


def test_what_the_arm_reaches_needs_no_driving(now: Configuration) -> None:
    found = nearest_stand_off(now, goal(0.75, -0.1, 0.7))
    assert found.reached
    assert found.configuration.chair == now.chair


@pytest.mark.parametrize(
    "wanted",
    [
        goal(1.455, 1.169, 0.999),
        goal(-2.0, 0.5, 0.9),
        goal(2.0, -1.0, 0.8, rotation(np.array((0.0, 0.0, 1.0)), pi / 2) @ FORWARD),
    ],
)
def test_a_far_goal_is_reached_from_a_place_near_it(now: Configuration, wanted: Floats) -> None:
    found = nearest_stand_off(now, wanted)
    assert found.reached
    assert found.clear
    assert np.abs(pose_error(found.configuration.hand, wanted)).max() < 2e-4
    body = now.body
    assert (found.configuration.joints > body.lower).all()
    assert (found.configuration.joints < body.upper).all()
    # nearer than with the ready posture after a quarter turn, which anyone could think of
    x, y = wanted[:2, 3]
    assert found.cost < hypot(x, y) + RADIAN * pi / 2


def test_without_driving_a_far_goal_is_missed_by_what_is_left(now: Configuration) -> None:
    found = nearest_stand_off(now, goal(3.0, -0.131, 0.899), may_drive=False)
    assert not found.reached
    assert found.configuration.chair == now.chair
    # the hand comes about a metre ahead of the base at most
    assert 1.6 < found.short[0] < 2.4


def test_what_is_too_high_is_told_with_how_much_is_missing(now: Configuration) -> None:
    found = nearest_stand_off(now, goal(1.0, 0.0, 3.0))
    assert not found.reached
    assert 1.2 < found.short[0] < 2.0


def test_a_goal_near_the_floor_is_reached_but_not_clear(now: Configuration) -> None:
    found = nearest_stand_off(now, goal(1.0, -0.131, 0.05))
    assert found.reached
    assert found.configuration.intrusions.names == ("floor",)
