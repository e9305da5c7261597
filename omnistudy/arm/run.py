"""What a task of an arm came to: every step as numbers, and each motion in short."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees, hypot, nan
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.chair import axle
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.step_report import StepReport
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.geometry.rigid_motion import pose_error, quaternion

Floats = NDArray[np.float64]

RADIAN = 0.5
"""m that a radian counts as where one singular value speaks for ways and turns."""


@dataclass(frozen=True)
class ArmStep:
    """One step, as it stands when it is over; SI units, ground axes.

    t : s since the task began. joints : rad. chair : at the arm's base. hand, hand_quaternion :
    where the hand is. wanted : where its path is. error, error_turn : m and rad between them.
    wanted_chair : where the chair's own route is, when it has one. chair_error, chair_turn : m
    between the middle of its axle and that of the route, and rad; nan without one.
    driven : m that the chair's axle went forward since the motion began, backwards negative.
    bearing : direction of the whole path on the floor, rad; nan for one that leads nowhere.
    arm_manipulability : sqrt det(J_A J_A') in m^3. smallest : smallest singular value of J_A, in
    m, a radian of the hand being half a metre. manipulability, damping, hits : as the controller
    reports them.
    """

    motion: str
    step: int
    t: float
    joints: tuple[float, ...]
    chair: PlanarPose
    hand: tuple[float, float, float]
    hand_quaternion: tuple[float, float, float, float]
    wanted: tuple[float, float, float]
    error: float
    error_turn: float
    wanted_chair: PlanarPose | None
    chair_error: float
    chair_turn: float
    driven: float
    bearing: float
    manipulability: float
    arm_manipulability: float
    smallest: float
    damping: float
    hits: tuple[str, ...]


@dataclass(frozen=True)
class ArmRun:
    """All steps of a task, and the arm that did them, by name or file."""

    arm: str
    steps: tuple[ArmStep, ...]


class Moment(NamedTuple):
    """What the loop knows at the end of a step, before it is measured."""

    motion: str
    step: int
    t: float
    configuration: Configuration
    wanted: Floats
    wanted_chair: PlanarPose | None
    driven: float
    bearing: float
    report: StepReport


def measured(moment: Moment) -> ArmStep:
    """Measure a step."""
    at = moment.configuration
    error = pose_error(at.hand, moment.wanted)
    rows = at.arm_jacobian.copy()
    rows[3:] *= RADIAN
    x, y, z = at.hand[:3, 3].tolist()
    chair_error, chair_turn = _chair_errors(at, moment.wanted_chair)
    wx, wy, wz = moment.wanted[:3, 3].tolist()
    return ArmStep(
        motion=moment.motion,
        step=moment.step,
        t=moment.t,
        joints=tuple(at.joints.tolist()),
        chair=at.chair,
        hand=(x, y, z),
        hand_quaternion=quaternion(at.hand[:3, :3]),
        wanted=(wx, wy, wz),
        error=float(np.linalg.norm(error[:3])),
        error_turn=float(np.linalg.norm(error[3:])),
        wanted_chair=moment.wanted_chair,
        chair_error=chair_error,
        chair_turn=chair_turn,
        driven=moment.driven,
        bearing=moment.bearing,
        manipulability=moment.report.manipulability,
        arm_manipulability=at.arm_manipulability,
        smallest=float(np.linalg.svd(rows, compute_uv=False)[-1]),
        damping=moment.report.damping,
        hits=moment.report.hits,
    )


def _chair_errors(at: Configuration, wanted: PlanarPose | None) -> tuple[float, float]:
    if wanted is None:
        return nan, nan
    profile = at.body.profile.chair
    here, there = axle(profile, at.chair), axle(profile, wanted)
    return hypot(there.x - here.x, there.y - here.y), abs(wrapped(there.theta - here.theta))


class MotionSummary(NamedTuple):
    """One motion in short: m, rad, s.

    chair_error, chair_turn : at the end, as in `ArmStep`. held_back : steps at which a limit or a
    zone held the motion back. damped : steps with damping. smallest : of any step.
    """

    motion: str
    duration: float
    steps: int
    worst_error: float
    final_error: float
    worst_turn: float
    final_turn: float
    driven: float
    chair: PlanarPose
    chair_error: float
    chair_turn: float
    held_back: int
    damped: int
    smallest: float

    @property
    def followed(self) -> bool:
        """Whether the hand ended within 1 mm and 0.2 degrees of where it should be."""
        return self.final_error < 1e-3 and degrees(self.final_turn) < 0.2


def summaries(run: ArmRun) -> tuple[MotionSummary, ...]:
    """Sum up each motion of a run."""
    names = dict.fromkeys(step.motion for step in run.steps)
    return tuple(_summary([s for s in run.steps if s.motion == name]) for name in names)


def _summary(steps: Sequence[ArmStep]) -> MotionSummary:
    last = steps[-1]
    return MotionSummary(
        motion=last.motion,
        duration=last.t - steps[0].t,
        steps=len(steps),
        worst_error=max(step.error for step in steps),
        final_error=last.error,
        worst_turn=max(step.error_turn for step in steps),
        final_turn=last.error_turn,
        driven=last.driven,
        chair=last.chair,
        chair_error=last.chair_error,
        chair_turn=last.chair_turn,
        held_back=sum(bool(step.hits) for step in steps),
        damped=sum(step.damping > 0.0 for step in steps),
        smallest=min(step.smallest for step in steps),
    )
