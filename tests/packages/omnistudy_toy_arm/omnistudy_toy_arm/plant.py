"""The arm: seven joints that turn as fast as they are told."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

import numpy as np

from omnistudy.channel import Channel
from omnistudy.geometry import PlanarPose, Pose
from omnistudy.plants import Plant, RunningPlant
from omnistudy.scene import NO_CONTACT, Box, Contacts, Cylinder, Joint, Link, Scene
from omnistudy.units import Metres
from omnistudy_toy_arm.kinematics import AXES, LINKS, hand_pose

FOOT_HEIGHT = 0.04
HOME = (0.0, 0.4, 0.0, 1.2, 0.0, 0.6, 0.0)


class ArmState(NamedTuple):
    """Pose of the hand in the world, joint angles in rad, and what is touched: nothing."""

    pose: Pose
    joints: tuple[float, ...]
    contacts: Contacts = NO_CONTACT


class ToyArm(Plant):
    """Seven revolute joints on a foot that stands at the world's start."""

    kind: Literal["toy_arm"] = "toy_arm"
    foot: Metres = 0.2
    """Side of the square that it stands on."""

    @property
    def width(self) -> float:
        return self.foot

    @property
    def links(self) -> tuple[Link, ...]:
        """A hub in every joint, which turns, and a tube from there to the next."""
        foot = Box(x=self.foot, y=self.foot, z=FOOT_HEIGHT)
        made = [Link(name="foot", geometry=foot, z=0.5 * FOOT_HEIGHT, colour="#3c434d")]
        parent, height = "foot", -0.5 * FOOT_HEIGHT
        for number, (axis, length) in enumerate(zip(AXES, LINKS, strict=True), start=1):
            turns = Joint(
                channel=f"joint_{number}",
                axis=(0.0, 0.0, 1.0) if axis == "z" else (0.0, 1.0, 0.0),
            )
            hub = Cylinder(radius=0.06, length=0.11)
            name = f"hub_{number}"
            made.append(
                Link(
                    name=name, parent=parent, geometry=hub, z=height, colour="#edb40e", joint=turns
                )
            )
            if length > 0.0:
                tube = Cylinder(radius=0.045, length=length)
                made.append(Link(name=f"tube_{number}", parent=name, geometry=tube, z=0.5 * length))
            parent, height = name, length
        return tuple(made)

    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        return _RunningArm(start, physics_hz)


class _RunningArm(RunningPlant):
    channels = (
        *(Channel(f"joint_{i}", "rad", f"angle of joint {i} from the foot") for i in range(1, 8)),
        *(Channel(f"hand_{axis}", "m", "hand's place in the world") for axis in "xyz"),
        *(Channel(f"hand_q{axis}", "1", "hand's orientation as a quaternion") for axis in "xyzw"),
    )

    def __init__(self, start: PlanarPose, physics_hz: int) -> None:
        self._start = start
        self._dt = 1.0 / physics_hz
        self._joints = np.array(HOME)
        self._rates = np.zeros(7)
        self._pose = self._look()
        self._travelled = 0.0

    def _look(self) -> Pose:
        place, quaternion = hand_pose(self._joints)
        x, y = self._start.to_world(place[0], place[1])
        return Pose((x, y, place[2]), quaternion)

    @property
    def state(self) -> ArmState:
        return ArmState(self._pose, tuple(self._joints.tolist()))

    @property
    def travelled(self) -> float:
        return self._travelled

    def values(self) -> tuple[float, ...]:
        return (*self.state.joints, *self._pose.position, *self._pose.quaternion)

    def command(self, command: Any) -> None:
        self._rates = np.asarray(command)

    def step(self) -> None:
        last = np.array(self._pose.position)
        self._joints = self._joints + self._rates * self._dt
        self._pose = self._look()
        self._travelled += float(np.linalg.norm(np.array(self._pose.position) - last))

    def close(self) -> None:
        """There is no physics to let go of."""
