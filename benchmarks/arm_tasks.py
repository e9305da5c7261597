"""Random tasks for an arm on a wheelchair, each with an end that can be reached."""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm import ArmBody, Configuration, load_arm
from omnistudy.arm.task import ArmTask, ChairPose, Goal, Motion
from omnistudy.controllers import Controller
from omnistudy.geometry import PlanarPose
from omnistudy.seeds import generator

Floats = NDArray[np.float64]

CLASSES = (30, 60, 90, 180)
"""Degrees either way of bearing and heading of the chair's goal."""

NEAREST, FURTHEST = 0.5, 2.5
"""m to the chair's goal."""

SPREAD = radians(35.0)
"""Of every joint from the ready posture, either way, at the end."""

LEAST_MANIPULABILITY = 0.04
"""m^3, of the arm at the end."""


def random_task(seed: str, number: int, degrees: int, controller: Controller) -> ArmTask:
    """Draw the `number`-th task of a bearing class; the same for every controller."""
    draw = generator(seed, f"arm task {degrees} {number}")
    body = ArmBody(load_arm("wmra1"))
    across, half = draw.uniform(NEAREST, FURTHEST), radians(degrees)
    bearing, heading = draw.uniform(-half, half, 2).tolist()
    chair = PlanarPose(across * cos(bearing), across * sin(bearing), heading)
    hand = Configuration(body, _posture(body, draw), chair).hand
    goal = Goal(
        position=tuple(hand[:3, 3].tolist()),
        rotation=tuple(tuple(row) for row in hand[:3, :3].tolist()),
    )
    motion = Motion(
        name="approach", goal=goal, carried=True, chair_goal=ChairPose(**chair._asdict())
    )
    return ArmTask(controller=controller, motions=(motion,))


def _posture(body: ArmBody, draw: np.random.Generator) -> Floats:
    """Draw a posture within its limits, far from singular and clear of all zones."""
    ready = np.array(body.profile.ready)
    while True:
        joints = ready + draw.uniform(-SPREAD, SPREAD, body.count)
        at = Configuration(body, joints, PlanarPose(0.0, 0.0, 0.0))
        inside = ((joints > body.lower) & (joints < body.upper)).all()
        if inside and at.arm_manipulability > LEAST_MANIPULABILITY and not at.intrusions.names:
            return joints
