"""The chair's own way: turn, drive, turn."""

from __future__ import annotations

from math import pi, radians, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.arm import load_arm
from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.timing import Timing
from omnistudy.geometry import PlanarPose

CHAIR = load_arm("wmra1").chair
ALL = (1.0, 1.0, 1.0)
poses = st.builds(PlanarPose, st.floats(-5, 5), st.floats(-5, 5), st.floats(-3.1, 3.1))


def heading_is(pose: PlanarPose, theta: float) -> bool:
    return abs((pose.theta - theta + pi) % (2 * pi) - pi) < 1e-9


def test_equation_17() -> None:
    route = ChairRoute.between(PlanarPose(0, 0, 0), PlanarPose(1, 1, radians(90)))
    assert route.amounts == pytest.approx((radians(45), sqrt(2.0), radians(45)))


def test_turns_go_the_short_way_round() -> None:
    route = ChairRoute.between(PlanarPose(0, 0, radians(170)), PlanarPose(-1, -0.1, radians(-170)))
    assert max(abs(route.amounts[0]), abs(route.amounts[2])) < radians(30)
    back = ChairRoute.between(PlanarPose(0, 0, radians(-170)), PlanarPose(-1, 0.1, radians(-170)))
    assert max(abs(back.amounts[0]), abs(back.amounts[2])) < radians(30)


@given(poses, poses, st.booleans())
def test_it_ends_at_its_goal(start: PlanarPose, goal: PlanarPose, reverse: bool) -> None:
    end = ChairRoute.between(start, goal, reverse).pose(ALL)
    assert end[:2] == pytest.approx(goal[:2], abs=1e-9)
    assert heading_is(end, goal.theta)


@given(poses, poses)
def test_a_wheelchairs_route_is_its_axles(start: PlanarPose, goal: PlanarPose) -> None:
    end = ChairRoute.of_chair(CHAIR, start, goal).chair_pose(CHAIR, ALL)
    assert end[:2] == pytest.approx(goal[:2], abs=1e-9)
    assert heading_is(end, goal.theta)


def test_backing_up_instead_of_turning_round_twice() -> None:
    start, goal = PlanarPose(0, 0, 0), PlanarPose(-0.6, 0, 0)
    assert ChairRoute.between(start, goal).amounts == pytest.approx((-pi, 0.6, pi), abs=1e-9) or (
        ChairRoute.between(start, goal).amounts == pytest.approx((-pi, 0.6, -pi), abs=1e-9)
    )
    assert ChairRoute.between(start, goal, may_reverse=True).amounts == pytest.approx(
        (0.0, -0.6, 0.0), abs=1e-9
    )


def test_a_turn_on_the_spot_drives_nowhere() -> None:
    route = ChairRoute.between(PlanarPose(1, 2, 0.5), PlanarPose(1, 2, 1.5))
    assert route.amounts == (1.0, 0.0, 0.0)


def test_how_long_the_approach_of_reach_takes() -> None:
    # there and back by 56.24 degrees at 0.15 rad/s, 1.5637 m at 0.1 m/s, times 1.0557: 30.3 s
    route = ChairRoute.between(PlanarPose(0, 0, 0), PlanarPose(0.869, 1.3, 0))
    assert route.duration(CHAIR, Timing()) == pytest.approx(30.3, abs=0.05)


def test_each_stage_has_its_time() -> None:
    route = ChairRoute(PlanarPose(0, 0, 0), (0.15, 0.2, -0.15))  # 1 s, 2 s, 1 s
    linear = Timing(law="linear")
    assert route.shares(0.0, CHAIR, linear) == (0.0, 0.0, 0.0)
    assert route.shares(0.125, CHAIR, linear) == pytest.approx((0.5, 0.0, 0.0))
    assert route.shares(0.5, CHAIR, linear) == pytest.approx((1.0, 0.5, 0.0))
    assert route.shares(1.0, CHAIR, linear) == pytest.approx(ALL)


def test_a_route_to_where_one_is_is_done() -> None:
    still = ChairRoute.between(PlanarPose(1, 1, 1), PlanarPose(1, 1, 1))
    assert still.shares(0.3, CHAIR, Timing()) == ALL
    assert still.pose(ALL) == (1, 1, 1)


def test_what_is_done_of_each_stage() -> None:
    route = ChairRoute(PlanarPose(0, 0, 0), (radians(90), 2.0, radians(-30)))
    at = PlanarPose(0.5, 0.7, radians(100))
    assert route.done(0, at) == pytest.approx(radians(100))
    assert route.done(1, at) == pytest.approx(0.7)
    assert route.done(2, at) == pytest.approx(radians(10))
