"""Where all joints and the chair are, and what follows from it: the hand, and how it moves."""

from __future__ import annotations

from functools import cached_property
from math import cos, sin, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.chair import base_frame, driven, hand_per_rates
from omnistudy.arm.clearance import ClearanceFinder
from omnistudy.arm.profile import ArmProfile
from omnistudy.arm.zones import Intrusions, ZoneChecker
from omnistudy.geometry import PlanarPose
from omnistudy.scene import NO_CONTACT, Contacts

Floats = NDArray[np.float64]


class ArmBody:
    """A profile made ready for arithmetic; immutable, shared by all its configurations."""

    def __init__(self, profile: ArmProfile) -> None:
        self.profile = profile
        self.count = len(profile.joints)
        self.lower, self.upper = profile.lower, profile.upper
        self.top_rates = profile.top_rates
        self.zones = ZoneChecker(profile.zones, profile.chair.arm_height)
        self.clearances = ClearanceFinder(profile.zones, profile.chair.arm_height, self.count)
        self._fixed, self._with_cosine, self._with_sine = _transform_parts(profile)

    def frames(self, joints: Floats) -> Floats:
        """Give each joint's frame as seen from the arm's base, (n, 4, 4); the last is the hand."""
        steps = (
            self._fixed
            + self._with_cosine * np.cos(joints)[:, None, None]
            + self._with_sine * np.sin(joints)[:, None, None]
        )
        # each round joins runs of twice as many transforms: three products for seven joints
        reach = 1
        while reach < self.count:
            steps[reach:] = steps[:-reach] @ steps[reach:]
            reach *= 2
        return steps

    def jacobian(self, frames: Floats) -> Floats:
        """Give J_A of eq. (7), (6, n): the hand's twist in axes of the arm's base, per joint rate.

        Rows are m/rad, then 1.
        """
        columns = frames[:, :3, 2:].T
        axes, places = columns[0], columns[1]
        lever = places[:, -1:] - places
        rows = np.empty((6, self.count))
        rows[0] = axes[1] * lever[2] - axes[2] * lever[1]
        rows[1] = axes[2] * lever[0] - axes[0] * lever[2]
        rows[2] = axes[0] * lever[1] - axes[1] * lever[0]
        rows[3:] = axes
        return rows


def _transform_parts(profile: ArmProfile) -> tuple[Floats, Floats, Floats]:
    """Split each joint's transform into what is fixed, goes with cos(q) and goes with sin(q)."""
    count = len(profile.joints)
    fixed, with_cosine, with_sine = (np.zeros((count, 4, 4)) for _ in range(3))
    for index, joint in enumerate(profile.joints):
        c, s = cos(joint.alpha), sin(joint.alpha)
        d = joint.d + (profile.gripper if index == count - 1 else 0.0)
        fixed[index, :, 2] = (0.0, -s, c, 0.0)
        fixed[index, :, 3] = (joint.a, -s * d, c * d, 1.0)
        with_cosine[index, :3, 0] = (1.0, 0.0, 0.0)
        with_cosine[index, :3, 1] = (0.0, c, s)
        with_sine[index, :3, 0] = (0.0, c, s)
        with_sine[index, :3, 1] = (-1.0, 0.0, 0.0)
    return fixed, with_cosine, with_sine


class Configuration:
    """Joints and chair at one moment. What follows from them is computed once, when asked for."""

    def __init__(self, body: ArmBody, joints: Floats, chair: PlanarPose) -> None:
        self.body = body
        self.joints = joints
        self.chair = chair

    @cached_property
    def frames(self) -> Floats:
        """Each joint's frame as seen from the arm's base, (n, 4, 4)."""
        return self.body.frames(self.joints)

    @cached_property
    def base(self) -> Floats:
        """The arm's base as seen from the ground, (4, 4)."""
        return base_frame(self.body.profile.chair, self.chair)

    @cached_property
    def hand(self) -> Floats:
        """The hand as seen from the ground, (4, 4): eq. (8)."""
        hand: Floats = self.base @ self.frames[-1]
        return hand

    @cached_property
    def arm_jacobian(self) -> Floats:
        """The hand's twist in axes of the arm's base per joint rate, (6, n): eq. (7)."""
        return self.body.jacobian(self.frames)

    @cached_property
    def jacobian(self) -> Floats:
        """The hand's twist in ground axes, (6, n + 2): eq. (9), (10).

        Columns: joints per rad/s, then the chair's drive per m/s and its turn per rad/s. The
        thesis forgets to turn J_A into ground axes, and counts its drive in wheel radians.
        """
        count = self.body.count
        rows = np.empty((6, count + 2))
        turned = self.base[:3, :3]
        arm = self.arm_jacobian
        np.matmul(turned, arm[:3], out=rows[:3, :count])
        np.matmul(turned, arm[3:], out=rows[3:, :count])
        x, y = self.frames[-1, :2, 3].tolist()
        rows[:, count:] = hand_per_rates(self.body.profile.chair, self.chair.theta, (x, y))
        return rows

    @property
    def arm_manipulability(self) -> float:
        """Give sqrt det(J_A J_A'), eq. (11) for the arm alone, in m^3."""
        rows = self.arm_jacobian
        return sqrt(max(float(np.linalg.det(rows @ rows.T)), 0.0))

    @property
    def intrusions(self) -> Intrusions:
        """Zones that points of the arm are in."""
        return self.body.zones.intrusions(self.frames)

    def moved(self, rates: Floats, dt: float) -> Configuration:
        """Go on for `dt` seconds at constant rates, (n + 2,): joints, drive, turn."""
        count = self.body.count
        distance, turn = (rates[count:] * dt).tolist()
        chair = driven(self.body.profile.chair, self.chair, distance, turn)
        return Configuration(self.body, self.joints + rates[:count] * dt, chair)


class ArmState(NamedTuple):
    """What a controller sees of the arm and its chair."""

    configuration: Configuration
    contacts: Contacts = NO_CONTACT
