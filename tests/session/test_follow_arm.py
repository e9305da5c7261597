"""A controller stepped along a lead: what is slowed, what is corrected, when it ends."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration, load_arm
from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.lead import ChairLead, Lead, WorldLead
from omnistudy.arm.paths import LinePath
from omnistudy.arm.task import ArmTask
from omnistudy.arm.timing import Timing
from omnistudy.controllers import Controller
from omnistudy.geometry import PlanarPose
from omnistudy.geometry.rigid_motion import pose_error
from omnistudy.session.follow_arm import PATIENCE, Followed, Pace, follow

HERE = PlanarPose(0.0, 0.0, 0.0)
LINEAR = Timing(law="linear")


def page(**parameters: Any) -> ArmTask:
    return ArmTask.model_validate(
        {"controller": {"kind": "dual_qp", **parameters}, "motions": [{"name": "it", "goal": {}}]}
    )


def ahead(at: Configuration, way: float, chair: float = 0.0, heading: float = 0.0) -> Lead:
    """Both straight on, over the ground, in the chair's heading."""
    goal = at.hand.copy()
    goal[:2, 3] += way * np.array((np.cos(heading), np.sin(heading)))
    route = ChairRoute(PlanarPose(*_axle(at)), (0.0, chair, 0.0))
    return WorldLead(LinePath(at.hand, goal), LINEAR, ChairLead(at.body, route, LINEAR))


def _axle(at: Configuration) -> tuple[float, float, float]:
    profile, pose = at.body.profile.chair, at.chair
    return (*pose.to_world(-profile.arm_x, -profile.arm_y), pose.theta)


def followed(lead: Lead, at: Configuration, pace: Pace, **parameters: Any) -> list[Followed]:
    task = page(**parameters)
    controller: Controller = task.controller
    return list(follow(controller, lead, at, pace, task))


def standing(at: PlanarPose) -> Configuration:
    body = ArmBody(load_arm("wmra1"))
    return Configuration(body, np.array(body.profile.ready), at)


@pytest.fixture
def ready() -> Configuration:
    return standing(HERE)


def test_what_all_can_do_takes_a_step_more_than_the_pace(ready: Configuration) -> None:
    done = followed(ahead(ready, 0.2, 0.2), ready, Pace(80, 0.05))
    assert len(done) == pytest.approx(81, abs=2)
    assert done[-1].u == pytest.approx(1.0)
    assert sum(step.drive for step in done) == pytest.approx(0.2, abs=1e-6)


def test_a_pace_beyond_the_chair_takes_as_long_as_the_chair_needs(ready: Configuration) -> None:
    # 0.4 m in a second; the chair drives 0.1 m/s
    lead = ahead(ready, 0.4, 0.4)
    done = followed(lead, ready, Pace(20, 0.05))
    assert len(done) * 0.05 == pytest.approx(4.0, abs=0.2)
    for step in done:
        off = pose_error(step.at.hand, lead.hand(step.u))
        assert np.abs(off).max() < 1e-4
        chair = lead.chair(step.u)
        assert chair is not None
        assert step.at.chair == pytest.approx(chair, abs=1e-4)
    shares = [step.u for step in done]
    assert shares == sorted(shares)
    assert shares[len(done) // 2] == pytest.approx(0.5, abs=0.03)


def test_a_hand_that_begins_off_its_way_is_brought_to_it_at_once(ready: Configuration) -> None:
    lead = ahead(ready, 0.2, 0.2)
    joints = ready.joints.copy()
    joints[4] += 0.01
    aside = Configuration(ready.body, joints, HERE)
    before = np.linalg.norm(pose_error(aside.hand, lead.hand(0.0)))
    done = followed(lead, aside, Pace(80, 0.05))
    after = np.linalg.norm(pose_error(done[2].at.hand, lead.hand(done[2].u)))
    assert before > 1e-2
    assert after < 1e-4


@pytest.mark.parametrize("heading", [0.0, 2.0, pi])
def test_a_chair_is_led_in_its_own_heading(heading: float) -> None:
    start = standing(PlanarPose(1.0, 2.0, heading))
    done = followed(ahead(start, 0.2, 0.2, heading), start, Pace(80, 0.05))
    assert sum(step.drive for step in done) == pytest.approx(0.2, abs=1e-6)
    assert done[-1].at.chair == pytest.approx(
        (1.0 + 0.2 * np.cos(heading), 2.0 + 0.2 * np.sin(heading), heading), abs=1e-6
    )


def test_what_gets_no_further_ends(ready: Configuration) -> None:
    # the arm reaches about 0.75 m ahead of where the hand is; the chair stays
    done = followed(ahead(ready, 3.0), ready, Pace(200, 0.05))
    assert 0.05 < done[-1].u < 0.35
    assert len(done) % PATIENCE == 0
    assert done[-1].report.progress < 0.01
    assert done[-1].report.hits
