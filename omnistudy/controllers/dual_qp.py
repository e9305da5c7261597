"""Hand and chair on one path parameter, all limits as bounds of a quadratic programme."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from omnistudy.arm.chair import hand_per_rates
from omnistudy.arm.clearance import Clearance
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.step_report import StepReport
from omnistudy.controllers.controller import Control
from omnistudy.controllers.led import LedController
from omnistudy.controllers.quadratic_programme import Programme, solve
from omnistudy.devices import DeviceState
from omnistudy.geometry import ZERO_MATRIX, Matrix3, Scan
from omnistudy.units import Metres, Positive, Ratio

Floats = NDArray[np.float64]

RADIAN = 0.5
"""m that a radian of the hand counts as."""

SLOWEST = 0.005
"""m/s: below this speed of the hand, what slowing costs grows no cheaper."""

FULL = 1.0 - 1e-6
"""From this share on nothing counts as held back."""

NOTHING = np.zeros(6)

ENDLESS = 1e30
"""Stands for no bound."""


class DualMemory(NamedTuple):
    """What the controller remembers: only what it reported."""

    report: StepReport = StepReport()


class DualQp(LedController):
    """One quadratic programme a step over joints' rates V, the chair's, and a share s of the step.

    |J V - s r - c|^2 + slowing |r|^2 (1 - s)^2 + effort |V - p|^2, where r is the hand's twist that
    is asked for, c what brings it back to its way, p the posture's rates. A chair that is led does
    s times its rates: hand and chair stay on one path parameter, and slow together instead of
    leaving the path (Drake's differential inverse kinematics does so for a hand). The chair rolls
    on its wheels: it has no sideways rate. Limits of joints and speeds, and zones, are bounds; to
    stand still always keeps them.
    """

    kind: Literal["dual_qp"] = "dual_qp"
    frame: Literal["ground", "wheelchair", "gripper"] = "ground"
    """In whose axes the device gives the hand's twist."""
    follows: Literal["pose", "position"] = "pose"
    zones: Literal["none", "bounds"] = "bounds"
    zone_margin: Annotated[Metres, Field(ge=0)] = 0.001
    """Kept from every zone; ours."""
    zone_reach: Annotated[Metres, Positive] = 0.15
    """Zones further off are not looked at; more than a point can go in one step. Ours."""
    approach: Annotated[Ratio, Field(gt=0, le=1)] = 0.3
    """Share of the room to a limit or a zone that one step may take; ours."""
    slowing: Annotated[Ratio, Positive] = 0.001
    """What it costs to stand still, of what it costs to leave the path as far; ours."""
    effort: Annotated[Ratio, Positive] = 1e-9
    """In (m/s)^2, of a joint at its greatest rate; damps what is singular. Ours."""
    posture: Annotated[Ratio, Field(ge=0)] = 0.1
    """1/s, towards the ready posture in what freedom is left, unless a posture is led; ours."""

    @property
    def twist_per_stick(self) -> Matrix3:
        """No law damps an arm: nothing."""
        return ZERO_MATRIX

    @property
    def turns_hand(self) -> bool:
        """Unless it follows the position alone."""
        return self.follows == "pose"

    def initial_state(self) -> DualMemory:
        """Nothing has been reported yet."""
        return DualMemory()

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Take a twist, and perhaps the chair's rates and a posture; give (n + 2) rates."""
        at: Configuration = plant_state.configuration
        guidance = Guidance.read(device.position)
        near = self._near(at)
        programme = self._programme(guidance, at, near, dt)
        optimum = solve(programme)
        count = at.body.count
        if optimum.x is None:
            report = StepReport(hits=("unsolved",), progress=0.0)
            return Control(device.position, np.zeros(count + 2), DualMemory(report))
        share = float(optimum.x[-1])
        rates = optimum.x[:-1]
        if guidance.chair_rates is not None:
            drive, turn = guidance.chair_rates
            rates = np.append(rates, (share * drive, share * turn))
        hits = () if share >= FULL else self._hits(optimum.prices, programme, at, near, guidance)
        return Control(device.position, rates, DualMemory(StepReport(hits=hits, progress=share)))

    def _hand(self, guidance: Guidance, at: Configuration) -> tuple[Floats, Floats, Floats]:
        """Give the hand's twist per rate, what is asked for, and what is missing; turns in m.

        All in axes of the arm's base. Columns are the joints; the chair's two as well when nobody
        leads it, else what it does is taken off what is asked for.
        """
        count = at.body.count
        missing = NOTHING if guidance.correction is None else guidance.correction
        asked = np.array((guidance.twist - missing, missing))
        if self.frame != "wheelchair":
            frame = at.base[:3, :3] if self.frame == "ground" else at.frames[-1, :3, :3].T
            asked = (asked.reshape(4, 3) @ frame).reshape(2, 6)
        x, y = at.frames[-1, :2, 3].tolist()
        profile = at.body.profile.chair
        led = guidance.chair_rates is not None
        columns = np.zeros((6, count if led else count + 2))
        columns[:, :count] = at.arm_jacobian
        if guidance.chair_rates is None:
            columns[:, count:] = hand_per_rates(profile, 0.0, (x, y))
        else:
            drive, turn = guidance.chair_rates
            asked[0, 0] -= drive - turn * (profile.arm_y + y)
            asked[0, 1] -= turn * (profile.arm_x + x)
            asked[0, 5] -= turn
        columns[3:] *= RADIAN
        asked[:, 3:] *= RADIAN
        kept = 6 if self.follows == "pose" else 3
        return columns[:kept], asked[0, :kept], asked[1, :kept]

    def _near(self, at: Configuration) -> Clearance | None:
        if self.zones == "none":
            return None
        return at.body.clearances.near(at.frames, self.zone_reach)

    def _programme(
        self, guidance: Guidance, at: Configuration, near: Clearance | None, dt: float
    ) -> Programme:
        body = at.body
        columns, asked, missing = self._hand(guidance, at)
        count, size = body.count, columns.shape[1]
        task = np.empty((len(columns), size + 1))
        task[:, :size] = columns
        task[:, size] = -asked
        square = task.T @ task
        linear = -(missing @ task)
        weights = self.effort / body.top_rates[:size] ** 2
        square.flat[: size * (size + 2) : size + 2] += weights
        if guidance.posture is not None:
            linear[:count] -= weights[:count] * guidance.posture
        elif self.posture > 0.0:
            home = np.asarray(body.profile.ready)
            linear[:count] += weights[:count] * self.posture * (at.joints - home)
        slowing = self.slowing * max(float(asked @ asked), SLOWEST * SLOWEST)
        square[size, size] += slowing
        linear[size] -= slowing
        lower, upper, rows = self._bounds(guidance, at, size, near, dt)
        return Programme(square, linear, rows, lower, upper)

    def _bounds(
        self, guidance: Guidance, at: Configuration, size: int, near: Clearance | None, dt: float
    ) -> tuple[Floats, Floats, Floats]:
        body = at.body
        count = body.count
        zones = 0 if near is None else len(near.zones)
        lower, upper = np.empty(size + 1 + zones), np.empty(size + 1 + zones)
        top = body.top_rates[:size]
        lower[:size], upper[:size] = -top, top
        per_step = self.approach / dt
        room = (body.upper - at.joints) * per_step
        upper[:count] = np.minimum(upper[:count], np.maximum(room, 0.0))
        room = (body.lower - at.joints) * per_step
        lower[:count] = np.maximum(lower[:count], np.minimum(room, 0.0))
        lower[size], upper[size] = 0.0, self._fastest(guidance, at)
        rows = np.zeros((zones, size + 1))
        if near is not None and zones:
            rows[:, :count] = near.slopes
            lower[size + 1 :] = -per_step * np.maximum(near.rooms - self.zone_margin, 0.0)
            upper[size + 1 :] = ENDLESS
        return lower, upper, rows

    def _fastest(self, guidance: Guidance, at: Configuration) -> float:
        """Give the greatest share that a led chair can do."""
        if guidance.chair_rates is None:
            return 1.0
        return 1.0 / max(1.0, *_over(guidance.chair_rates, at))

    def _hits(
        self,
        prices: Floats,
        programme: Programme,
        at: Configuration,
        near: Clearance | None,
        guidance: Guidance,
    ) -> tuple[str, ...]:
        """Name the bounds that the solution presses against."""
        size = len(programme.linear) - 1
        count = at.body.count
        names = []
        for index in np.flatnonzero(np.abs(prices) > 0.0).tolist():
            if index < size:
                bound = (programme.upper if prices[index] > 0.0 else programme.lower)[index]
                fast = abs(bound) >= at.body.top_rates[index]
                names.append(f"{'speed' if fast else 'limit'} {index + 1}")
            elif index == size:
                over = _over(guidance.chair_rates or (0.0, 0.0), at)
                names.extend(f"speed {count + 1 + i}" for i in (0, 1) if over[i] == max(1.0, *over))
            elif near is not None:
                zone = at.body.profile.zones[int(near.zones[index - size - 1])]
                names.append(f"zone {zone.name}")
        return tuple(dict.fromkeys(names))


def _over(chair_rates: tuple[float, float], at: Configuration) -> tuple[float, float]:
    """Give drive and turn over the chair's greatest ones."""
    drive, turn = at.body.top_rates[at.body.count :].tolist()
    return abs(chair_rates[0]) / drive, abs(chair_rates[1]) / turn
