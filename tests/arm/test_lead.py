"""Where hand, chair and joints are to be, on one parameter."""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration
from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.lead import CarriedLead, ChairLead, FoldedLead, PostureLead, WorldLead
from omnistudy.arm.paths import LinePath
from omnistudy.arm.timing import Timing
from omnistudy.geometry import PlanarPose
from omnistudy.geometry.rigid_motion import transform

HERE, THERE = PlanarPose(0.0, 0.0, 0.0), PlanarPose(1.0, 0.5, 0.8)
LINEAR = Timing(law="linear")


def chair_lead(body: ArmBody, goal: PlanarPose = THERE) -> ChairLead:
    return ChairLead(body, ChairRoute.of_chair(body.profile.chair, HERE, goal), LINEAR)


def test_a_carried_hand_starts_and_ends_where_it_should(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    bent = ready + 0.2
    seen = LinePath(wmra1.frames(ready)[-1], wmra1.frames(bent)[-1])
    lead = CarriedLead(seen, LINEAR, chair_lead(wmra1), PostureLead(ready, bent, LINEAR))
    assert lead.hand(0.0) == pytest.approx(Configuration(wmra1, ready, HERE).hand)
    assert lead.hand(1.0) == pytest.approx(Configuration(wmra1, bent, THERE).hand)
    assert lead.chair(1.0) == pytest.approx(THERE)
    assert lead.joints(0.5) == pytest.approx(0.5 * (ready + bent))


def test_a_carried_hand_that_stays_where_the_chair_sees_it_turns_with_the_chair(
    wmra1: ArmBody,
) -> None:
    ready = np.array(wmra1.profile.ready)
    hand = wmra1.frames(ready)[-1]
    still = PostureLead(ready, ready, LINEAR)
    lead = CarriedLead(LinePath(hand, hand), LINEAR, chair_lead(wmra1), still)
    for u in (0.2, 0.5, 0.9):
        chair = lead.chair(u)
        assert lead.hand(u) == pytest.approx(Configuration(wmra1, ready, chair).hand)


def test_a_folded_arm_goes_through_its_postures_by_their_greatest_change(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    first, second = ready.copy(), ready.copy()
    first[0] += 0.3
    second[0] += 0.3
    second[1] += 0.1
    lead = FoldedLead((ready, first, second), LINEAR, chair_lead(wmra1))
    # 0.3 rad, then 0.1 rad: three quarters of the time for the first
    assert lead.joints(0.75) == pytest.approx(first)
    assert lead.joints(0.375) == pytest.approx(0.5 * (ready + first))
    assert lead.hand(1.0) == pytest.approx(Configuration(wmra1, second, THERE).hand)


def test_a_folded_arm_that_stays_as_it_is(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    lead = FoldedLead((ready, ready), LINEAR, chair_lead(wmra1))
    assert lead.joints(0.5) == pytest.approx(ready)


def test_a_lead_over_the_ground_leaves_chair_and_posture_free() -> None:
    begin, end = np.eye(4), transform(np.eye(3), np.array((1.0, 0.0, 0.0)))
    lead = WorldLead(LinePath(begin, end), LINEAR)
    assert lead.hand(0.25)[:3, 3] == pytest.approx((0.25, 0.0, 0.0))
    assert (lead.chair(0.5), lead.joints(0.5)) == (None, None)
