"""Step a controller of an arm along a lead, without physics: its rates are done exactly."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, hypot, nan, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.chair import axle
from omnistudy.arm.configuration import ArmState, Configuration
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.lead import Lead
from omnistudy.arm.step_report import StepReport
from omnistudy.arm.task import ArmTask
from omnistudy.controllers import Controller
from omnistudy.controllers.led import LedController
from omnistudy.devices import DeviceState
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.geometry.rigid_motion import pose_error, sine_error

Floats = NDArray[np.float64]

ARRIVED = 0.999
"""Share of the last step that must be done, of what was asked for in it."""

NO_PROGRESS, PATIENCE = 1e-3, 100
"""Less than this share of a step on average, over so many steps, is to be stuck; ours."""


SETTLED = 1e-6
"""m or rad; ours."""

LONGEST = 10
"""A motion may take this many times its steps at full speed; ours."""


class Pace(NamedTuple):
    """How many steps follow the first at full speed, and how long each is in s."""

    steps: int
    dt: float


class Followed(NamedTuple):
    """One step done.

    u : share of the motion's time that it came to. drive : m that the chair's axle went forward.
    """

    at: Configuration
    u: float
    drive: float
    report: StepReport


def bearing(lead: Lead, nowhere: float = 1e-6) -> float:
    """Give the direction of a lead over the floor, rad; nan when it leads nowhere, within m."""
    x, y = (lead.hand(1.0)[:2, 3] - lead.hand(0.0)[:2, 3]).tolist()
    return atan2(y, x) if hypot(x, y) > nowhere else nan


def follow(
    controller: Controller, lead: Lead, at: Configuration, pace: Pace, task: ArmTask
) -> Iterator[Followed]:
    """Ask at each step for all that is missing, and go on by what was done of it.

    Ends when the lead's end is asked for and reached, or when there is hardly any progress left.
    """
    state, direction, goal = controller.initial_state(), bearing(lead), lead.chair(1.0)
    led = isinstance(controller, LedController)
    minded = 6 if not isinstance(controller, LedController) or controller.turns_hand else 3
    difference = sine_error if task.error == "legacy" and not led else pose_error
    done, last = -1.0, -1.0
    for step in range(1, LONGEST * pace.steps + 2 * PATIENCE):
        before, u = _share(done, pace), _share(done + 1.0, pace)
        chair, wanted = lead.chair(u), lead.hand(u)
        guidance = Guidance(difference(at.hand, wanted) / pace.dt, direction, goal)
        if led:
            joints = lead.joints(u)
            guidance = guidance._replace(
                chair_rates=None if chair is None else _towards(at, chair, pace.dt),
                correction=pose_error(at.hand, lead.hand(before)) / pace.dt,
                posture=None if joints is None else (joints - at.joints) / pace.dt,
            )
        device = DeviceState(guidance.numbers, (0.0,) * len(guidance.numbers))
        control = controller.control(device, ArmState(at), None, state, pace.dt)
        state, at = control.state, at.moved(control.command, pace.dt)
        report: StepReport = state.report
        done += report.progress * min(1.0, pace.steps - done)
        drive = float(control.command[at.body.count]) * pace.dt
        yield Followed(at, u if report.progress == 1.0 else _share(done, pace), drive, report)
        if u >= 1.0 and report.progress >= ARRIVED and (not led or _settled(at, wanted, minded)):
            return
        if step % PATIENCE == 0:
            if done - last < NO_PROGRESS * PATIENCE:
                return
            last = done


def _share(steps: float, pace: Pace) -> float:
    return min(max(steps / pace.steps, 0.0), 1.0) if pace.steps else 1.0


def _settled(at: Configuration, wanted: Floats, minded: int) -> bool:
    """Whether what is left to correct, of so many rows, is too little to speak of."""
    return float(np.abs(pose_error(at.hand, wanted)[:minded]).max()) < SETTLED


def _towards(at: Configuration, wanted: PlanarPose, dt: float) -> tuple[float, float]:
    """Give the drive and the turn that lead the chair to a pose on its way."""
    profile = at.body.profile.chair
    here, there = axle(profile, at.chair), axle(profile, wanted)
    heading = 0.5 * (here.theta + there.theta)
    ahead = (there.x - here.x) * cos(heading) + (there.y - here.y) * sin(heading)
    return ahead / dt, wrapped(there.theta - here.theta) / dt
