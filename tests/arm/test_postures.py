"""Joints for a pose of the hand."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from omnistudy.arm import ArmBody
from omnistudy.arm.detour import detour
from omnistudy.arm.postures import postures


def test_each_posture_brings_the_hand_there_clear_of_zones_and_within_limits(
    wmra1: ArmBody,
) -> None:
    ready = np.array(wmra1.profile.ready)
    away = ready + np.array((0.3, -0.2, 0.3, 0.1, -0.4, -0.3, 0.2))
    hand = wmra1.frames(away)[-1]
    found = list(postures(wmra1, hand, ready))
    assert found
    for joints in found:
        assert wmra1.frames(joints)[-1] == pytest.approx(hand, abs=1e-5)
        assert ((joints >= wmra1.lower) & (joints <= wmra1.upper)).all()
        assert wmra1.zones.intrusions(wmra1.frames(joints)).names == ()


def test_a_posture_that_is_there_already_comes_first(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    assert next(postures(wmra1, wmra1.frames(ready)[-1], ready)) == pytest.approx(ready)


def test_a_hand_out_of_reach_or_in_the_users_lap_has_none(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    hand = wmra1.frames(ready)[-1].copy()
    # the arm is 110 + 549 + 130 + 241 + 310 mm long at most
    hand[:3, 3] = (1.6, 0.0, 0.5)
    assert list(postures(wmra1, hand, ready)) == []
    hand[:3, 3] = (0.2, -0.2, 0.3)
    assert list(postures(wmra1, hand, ready)) == []


def test_a_way_with_nothing_in_between_is_straight(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    goal = ready + np.array((0.2, 0.0, 0.2, 0.0, 0.0, 0.0, 0.3))
    way = detour(wmra1, ready, goal)
    assert [joints.tolist() for joints in way] == [ready.tolist(), goal.tolist()]


@pytest.mark.parametrize(
    "change",
    [
        (0.95, -0.4, -0.37, 0.78, 0.17, -0.06, 0.55),
        (0.04, -0.23, 0.02, 0.66, 0.49, -0.87, -0.57),
        (0.98, 0.45, -0.14, -0.6, -0.76, -0.17, 0.31),
    ],
)
def test_a_way_round_the_zones_is_clear_all_along(
    wmra1: ArmBody, change: tuple[float, ...]
) -> None:
    ready = np.array(wmra1.profile.ready)
    goal = ready + np.array(change)
    assert wmra1.zones.intrusions(wmra1.frames(goal)).names == ()
    way = detour(wmra1, ready, goal)
    assert len(way) > 2
    assert way[0] == pytest.approx(ready)
    assert way[-1] == pytest.approx(goal)
    for begin, end in pairwise(way):
        for share in np.linspace(0.05, 1.0, 20):
            frames = wmra1.frames(begin + share * (end - begin))
            assert wmra1.zones.intrusions(frames).names == ()
    back = detour(wmra1, goal, ready)
    assert (back[0].tolist(), back[-1].tolist()) == (goal.tolist(), ready.tolist())
    again = detour(wmra1, ready, goal)
    assert all((a == b).all() for a, b in zip(way, again, strict=True))


def test_no_way_into_a_zone(wmra1: ArmBody) -> None:
    ready = np.array(wmra1.profile.ready)
    park = np.clip(np.array(wmra1.profile.park), wmra1.lower, wmra1.upper)
    assert wmra1.zones.intrusions(wmra1.frames(park)).names != ()
    assert detour(wmra1, ready, park) == ()
