"""What is seen of a robot in a scene at one instant."""

from __future__ import annotations

from math import nan
from typing import NamedTuple

from omnistudy.geometry import PlanarPose, PlanarTwist


class Contacts(NamedTuple):
    """Which bodies a robot touches.

    walls : names of walls in contact with base or wheels.
    others : names of targets, finish blocks and doors touched.
    clear : True when every wall is further off than the release gap of 5 mm.
    base, wheels : whether the wall contact is of the base, of a wheel.
    bearing : where the most deeply touched wall lies, square to its face, in the robot's frame,
        rad in [-pi, pi); NaN without one. (The point of contact would jump from corner to corner.)
    """

    walls: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    clear: bool = True
    base: bool = False
    wheels: bool = False
    bearing: float = nan


NO_CONTACT = Contacts()


class PlanarState(NamedTuple):
    """A robot on the floor: world pose, own-frame twist that really happened, contacts."""

    pose: PlanarPose
    twist: PlanarTwist
    contacts: Contacts = NO_CONTACT
