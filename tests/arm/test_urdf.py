"""The URDF is the profile: PyBullet puts its hand where our kinematics do."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as Xml

import numpy as np
import pybullet
import pytest

from omnistudy.arm import ArmBody, ArmProfile, Configuration, arm_names, load_arm
from omnistudy.arm.urdf import CHAIR_JOINTS, HAND_LINK, urdf
from omnistudy.geometry import PlanarPose
from omnistudy.seeds import generator

MICROMETRE = 1e-6


class Loaded(NamedTuple):
    """A URDF in PyBullet: its client, body, joints by name, and the hand's link."""

    body: ArmBody
    client: int
    robot: int
    joints: dict[str, int]


BENT = "wmra1 with links that have lengths too"


def profile_of(name: str) -> ArmProfile:
    if name != BENT:
        return load_arm(name)
    straight = load_arm("wmra1")
    joints = [
        joint.model_copy(update={"a": 0.05 * number, "alpha": 0.3 * number - 1.0})
        for number, joint in enumerate(straight.joints)
    ]
    return straight.model_copy(update={"name": "bent", "joints": tuple(joints)})


@pytest.fixture(scope="module", params=[*arm_names(), BENT])
def loaded(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Loaded]:
    profile = profile_of(request.param)
    file: Path = tmp_path_factory.mktemp("urdf") / f"{profile.name}.urdf"
    file.write_text(urdf(profile), encoding="utf-8")
    client = pybullet.connect(pybullet.DIRECT)
    robot = pybullet.loadURDF(str(file), useFixedBase=True, physicsClientId=client)
    joints = {
        pybullet.getJointInfo(robot, index, physicsClientId=client)[1].decode(): index
        for index in range(pybullet.getNumJoints(robot, physicsClientId=client))
    }
    yield Loaded(ArmBody(profile), client, robot, joints)
    pybullet.disconnect(client)


def test_the_hand_is_where_bullet_puts_it(loaded: Loaded) -> None:
    draw = generator("urdf", loaded.body.profile.name)
    worst = 0.0
    for _ in range(50):
        angles = draw.uniform(loaded.body.lower, loaded.body.upper)
        chair = PlanarPose(*draw.uniform(-3.0, 3.0, 3).tolist())
        at = Configuration(loaded.body, angles, chair)
        for name, value in zip(CHAIR_JOINTS, chair, strict=True):
            _put(loaded, name, value)
        for number, value in enumerate(angles, start=1):
            _put(loaded, f"joint_{number}", float(value))
        hand = pybullet.getLinkState(
            loaded.robot,
            loaded.joints[HAND_LINK],
            computeForwardKinematics=True,
            physicsClientId=loaded.client,
        )
        worst = max(worst, float(np.abs(np.array(hand[4]) - at.hand[:3, 3]).max()))
        turned = np.reshape(pybullet.getMatrixFromQuaternion(hand[5]), (3, 3))
        assert turned == pytest.approx(at.hand[:3, :3], abs=1e-6)
    assert worst < MICROMETRE


def _put(loaded: Loaded, joint: str, value: float) -> None:
    pybullet.resetJointState(
        loaded.robot, loaded.joints[joint], value, physicsClientId=loaded.client
    )


def test_limits_are_those_of_the_profile(loaded: Loaded) -> None:
    for number, joint in enumerate(loaded.body.profile.joints, start=1):
        index = loaded.joints[f"joint_{number}"]
        found = pybullet.getJointInfo(loaded.robot, index, physicsClientId=loaded.client)
        assert found[8:10] == pytest.approx((joint.lower, joint.upper))
        assert found[11] == pytest.approx(joint.top_speed)


def test_it_is_the_same_text_every_time_and_names_every_link_once() -> None:
    profile = load_arm("wmra1")
    assert urdf(profile) == urdf(profile)
    links = [link.get("name") for link in Xml.fromstring(urdf(profile)).iter("link")]
    assert links[:4] == ["ground", "sliding_x", "sliding_y", "chair"]
    assert links[-1] == HAND_LINK
    assert len(links) == len(set(links)) == 12
