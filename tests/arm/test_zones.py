"""Boxes that points of the arm must not enter."""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration, load_arm
from omnistudy.arm.zones import LAB_ZONES, Zone, ZoneChecker
from omnistudy.geometry import PlanarPose

HERE = PlanarPose(0.0, 0.0, 0.0)


def frames_at(**places: tuple[float, float, float]) -> np.ndarray:
    """Seven frames far above everything, but for those named `j3`, `j7`, ..."""
    frames = np.tile(np.eye(4), (7, 1, 1))
    frames[:, :3, 3] = (2.0, 2.0, 2.0)
    frames[6, 2, 3] = 3.0
    for name, place in places.items():
        frames[int(name[1:]) - 1, :3, 3] = place
    return frames


LAB = ZoneChecker(LAB_ZONES, 0.350)


def test_the_ready_posture_is_clear_and_the_park_posture_lies_on_the_shoulder(
    wmra1: ArmBody,
) -> None:
    ready, park = (np.array(p) for p in (wmra1.profile.ready, wmra1.profile.park))
    assert Configuration(wmra1, ready, HERE).intrusions.names == ()
    assert Configuration(wmra1, park, HERE).intrusions.names == ("shoulder",)


@pytest.mark.parametrize(
    ("place", "zone"),
    [
        ({"j7": (0.2, 0.0, 0.3)}, "lap"),
        ({"j5": (0.2, -0.1, 0.4)}, "lap"),
        ({"j7": (-0.3, 0.1, 0.9)}, "shoulder"),
        ({"j5": (-0.3, 0.1, 0.9)}, "shoulder"),
        ({"j3": (0.5, -0.2, 0.5)}, "front left side"),
        ({"j3": (0.2, 0.05, 0.5)}, "rear left side"),
        ({"j4": (0.2, -0.05, 0.5)}, "left side"),
        ({"j4": (-0.2, 0.05, 0.5)}, "rear left side"),
        ({"j3": (1.0, 1.0, -0.26)}, "floor"),
    ],
)
def test_each_of_the_labs_zones(place: dict[str, tuple[float, float, float]], zone: str) -> None:
    assert LAB.intrusions(frames_at(**place)).names == (zone,)


def test_how_deep_is_told_by_the_nearest_face() -> None:
    # 3 cm below the lap's upper face, further from all its other ones
    found = LAB.intrusions(frames_at(j7=(0.2, -0.3, 0.49)))
    assert (found.names, found.depths.max()) == (("lap",), pytest.approx(0.03))


def test_a_new_zone_is_deeper_even_when_an_old_one_is_being_left() -> None:
    before = LAB.intrusions(frames_at(j7=(0.2, -0.3, 0.30)))
    leaving = LAB.intrusions(frames_at(j7=(0.2, -0.3, 0.40)))
    another = LAB.intrusions(frames_at(j7=(0.2, -0.3, 0.40), j3=(0.2, 0.099, 0.5)))
    assert not leaving.deeper_than(before)
    assert another.deeper_than(before)


def test_the_floor_is_as_far_down_as_the_chair_is_high() -> None:
    higher = ZoneChecker(LAB_ZONES, 0.370)
    low = frames_at(j7=(1.0, 1.0, -0.255))
    assert LAB.intrusions(low).names == ("floor",)
    assert higher.intrusions(low).names == ()


def test_a_zone_may_go_with_another_joint() -> None:
    zone = Zone(name="near", guards="self", joint=2, seen_from="joint", seen_from_joint=1, x=(0, 1))
    checker = ZoneChecker((zone,), 0.35)
    frames = np.tile(np.eye(4), (2, 1, 1))
    # the first frame is turned by a quarter about z: its x is the base's y
    frames[0, :3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    frames[1, :3, 3] = (5.0, 0.5, 0.0)
    assert checker.intrusions(frames).names == ("near",)
    frames[1, :3, 3] = (0.5, 5.0, 0.0)
    assert checker.intrusions(frames).names == ()


def test_the_hand_may_not_fold_back_onto_the_upper_arm(wmra1: ArmBody) -> None:
    # elbow bent by 165 degrees, wrist by 90 towards the upper arm, and away from it
    joints = np.radians([90.0, 20.0, 0.0, 165.0, 90.0, -90.0, 0.0])
    assert Configuration(wmra1, joints, HERE).intrusions.names == ("upper arm",)
    joints[5] *= -1.0
    assert Configuration(wmra1, joints, HERE).intrusions.names == ()


def test_no_zones_are_never_entered() -> None:
    assert ZoneChecker((), 0.35).intrusions(frames_at()).names == ()


def test_a_profile_may_have_zones_of_its_own() -> None:
    profile = load_arm("wmra1").model_copy(update={"zones": ()})
    body = ArmBody(profile)
    assert Configuration(body, np.array(profile.park), HERE).intrusions.names == ()
