"""How far the arm is from its zones, and which joints change that."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.arm import ArmBody, load_arm
from omnistudy.arm.clearance import ClearanceFinder
from omnistudy.arm.zones import LAB_ZONES, Zone

BODY = ArmBody(load_arm("wmra1"))
READY = np.array(BODY.profile.ready)
EVERYTHING = 99.0

postures = st.lists(st.floats(-1.5, 1.5), min_size=7, max_size=7).map(lambda q: READY + np.array(q))


def test_the_ready_posture_has_one_centimetre_beside_its_elbow() -> None:
    near = BODY.clearances.near(BODY.frames(READY), 0.05)
    # joint 3 lies 110 mm left of the arm's base, and its zone ends at 100 mm
    assert near.rooms == pytest.approx([0.010], abs=1e-12)
    assert "left" in LAB_ZONES[int(near.zones[0])].name


def test_a_point_is_as_far_as_the_face_that_it_is_furthest_in_front_of() -> None:
    box = Zone(name="box", guards="chair", joint=1, x=(0.0, 1.0), y=(0.0, 1.0), z=(0.0, 1.0))
    finder = ClearanceFinder((box,), 0.0, 1)
    frames = np.eye(4)[None].copy()
    frames[0, :3, 3] = (1.3, 1.1, 0.5)
    assert finder.near(frames, EVERYTHING).rooms == pytest.approx([0.3])
    frames[0, :3, 3] = (0.5, 0.9, 0.5)
    assert finder.near(frames, EVERYTHING).rooms == pytest.approx([-0.1])
    frames[0, :3, 3] = (-0.2, 0.5, 0.5)
    assert finder.near(frames, 0.1).rooms.size == 0


@given(postures)
def test_rooms_are_negative_exactly_in_a_zone(joints: np.ndarray) -> None:
    frames = BODY.frames(joints)
    near = BODY.clearances.near(frames, EVERYTHING)
    inside = {LAB_ZONES[z].name for z, room in zip(near.zones, near.rooms, strict=True) if room < 0}
    assert inside == set(BODY.zones.intrusions(frames).names)


@given(postures)
def test_slopes_are_what_small_changes_of_the_joints_do(joints: np.ndarray) -> None:
    near = BODY.clearances.near(BODY.frames(joints), EVERYTHING)
    step = 1e-6
    for joint, change in enumerate(step * np.eye(7)):
        more = BODY.clearances.near(BODY.frames(joints + change), EVERYTHING).rooms
        less = BODY.clearances.near(BODY.frames(joints - change), EVERYTHING).rooms
        slope = (more - less) / (2 * step)
        # where two faces are equally far, the nearest one changes in between
        smooth = np.abs(more + less - 2 * near.rooms) < 1e-9
        assert slope[smooth] == pytest.approx(near.slopes[smooth, joint], abs=1e-6)


def test_an_arm_without_zones_is_far_from_them() -> None:
    near = ClearanceFinder((), 0.35, 7).near(BODY.frames(READY), EVERYTHING)
    assert (near.zones.size, near.rooms.size, near.slopes.shape) == (0, 0, (0, 7))
