"""What the chair's drive and turn cost."""

from __future__ import annotations

from math import inf, nan, pi, radians

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration, load_arm
from omnistudy.arm.chair import pose_of_axle
from omnistudy.arm.guidance import Guidance
from omnistudy.controllers.chair_weights import FixedWeights, PrintedWeights, StagedWeights
from omnistudy.geometry import PlanarPose

BODY = ArmBody(load_arm("wmra1"))
CHAIR = BODY.profile.chair
STILL = np.zeros(6)


def at(pose: PlanarPose) -> Configuration:
    return Configuration(BODY, np.array(BODY.profile.ready), pose)


def facing(theta: float) -> Configuration:
    return at(PlanarPose(0.0, 0.0, theta))


def test_fixed_weights_stay() -> None:
    assert FixedWeights(drive=0.5, turn=1000.0).weights(Guidance(STILL), facing(0), None)[:2] == (
        0.5,
        1000.0,
    )


def test_printed_weights_by_hand() -> None:
    rule, guidance = PrintedWeights(), Guidance(STILL, bearing=2.0)
    first = rule.weights(guidance, facing(0.0), None)
    # at the first step the printed weight of the turn is 0, which the program divides by
    assert first == (10.0, 1e-3, 2.0)
    later = rule.weights(guidance, facing(1.0), first.memory)
    assert later == pytest.approx((10.0, (4.0 - 1.0) ** 2 / (2.0 * 4.0 * 1.0), 2.0))
    near = rule.weights(guidance, facing(1.75), first.memory)
    assert near.drive == 1.0


def test_printed_weights_know_no_side() -> None:
    rule = PrintedWeights()
    left = rule.weights(Guidance(STILL, bearing=0.5), facing(0.0), 1.0)
    right = rule.weights(Guidance(STILL, bearing=-0.5), facing(0.0), 1.0)
    assert left == right


def test_a_chair_that_faces_its_path_does_not_turn() -> None:
    assert PrintedWeights().weights(Guidance(STILL, bearing=0.0), facing(0.0), 1.0).turn == inf


def test_without_a_path_the_twist_tells_the_bearing() -> None:
    leftwards = np.array((0.0, 0.1, 0.0, 0.0, 0.0, 0.0))
    assert PrintedWeights().weights(Guidance(leftwards), facing(0.0), None).memory == pi / 2
    assert PrintedWeights().weights(Guidance(STILL), facing(0.0), None).memory == 0.0


def axle_at(x: float, y: float, theta: float) -> PlanarPose:
    return pose_of_axle(CHAIR, PlanarPose(x, y, theta))


GOAL = axle_at(1.0, 1.0, pi / 2)
"""45 degrees to turn, 1.41 m to drive, 45 degrees to turn."""


def test_stages_make_what_is_to_move_cheap_at_first() -> None:
    rule, guidance = StagedWeights(), Guidance(STILL, nan, GOAL)
    start = at(axle_at(0.0, 0.0, 0.0))
    first = rule.weights(guidance, start, None)
    assert first.drive == rule.greatest
    assert first.turn == pytest.approx(rule.turn)
    halfway = rule.weights(guidance, at(axle_at(0.0, 0.0, pi / 8)), first.memory)
    # u = 1/2: 2u / (1 - u^2)^2 = 16/9
    assert halfway.drive == pytest.approx(rule.drive + 16 / 9)
    assert halfway.turn == pytest.approx(rule.turn + 1 / (16 / 9 + rule.tolerance))


def test_stages_change_places_when_the_chair_faces_its_goal() -> None:
    rule, guidance = StagedWeights(), Guidance(STILL, nan, GOAL)
    begun = rule.weights(guidance, at(axle_at(0.0, 0.0, 0.0)), None).memory
    facing_goal = rule.weights(guidance, at(axle_at(0.0, 0.0, pi / 4)), begun)
    assert facing_goal.turn == rule.greatest
    assert facing_goal.drive == pytest.approx(rule.drive)
    arrived = rule.weights(guidance, at(axle_at(1.0, 1.0, pi / 4)), facing_goal.memory)
    assert arrived.drive == rule.greatest
    assert arrived.memory[1] == 2


def test_as_printed_a_long_way_weighs_a_thousandth_of_a_turn() -> None:
    # the gradient per metre of a way in mm: longer ways weigh less, which is an error
    far = axle_at(4.0, 0.0, 0.0)
    rule, guidance = StagedWeights(normalised=False), Guidance(STILL, nan, far)
    start = at(axle_at(0.0, 0.0, 0.0))
    memory = rule.weights(guidance, start, None).memory
    half = at(axle_at(2.0, 0.0, 0.0))
    printed = rule.weights(guidance, half, memory).turn - rule.turn
    mended = StagedWeights().weights(guidance, half, memory).turn - rule.turn
    assert printed == pytest.approx(mended / 4.0)


def test_nobody_cares_where_the_chair_ends() -> None:
    assert StagedWeights().weights(Guidance(STILL), facing(radians(10)), None)[:2] == (1.0, 1.0)
