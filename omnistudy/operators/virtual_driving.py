"""The virtual driver at work during one trial."""

from __future__ import annotations

from collections import deque
from math import atan2, cos, exp, hypot, inf, isnan, pi, sin
from typing import Any

from omnistudy.devices import Hand
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.operators.giving_way import waits
from omnistudy.operators.noise import OrnsteinUhlenbeck
from omnistudy.operators.operator import Person, RunningOperator
from omnistudy.operators.virtual_driver import VirtualDriver
from omnistudy.operators.way import Way
from omnistudy.seeds import generator
from omnistudy.worlds import Situation

Wish = tuple[float, float, float]
"""Wanted deflection as a share of full stick, x forward, y left, theta counter-clockwise."""
STILL: Wish = (0.0, 0.0, 0.0)
STAYS, STAYS_TURNED = 0.05, 0.1
"""m and rad within which a person sees the robot stay where it is."""


class VirtualDriving(RunningOperator):
    """Sees pose, way and contact 20 times a second; acts late; holds the stick with an arm."""

    def __init__(self, driver: VirtualDriver, person: Person) -> None:
        traits = driver.traits(person.participant_seed)
        self._driver = driver
        self._skill = traits.first_skill * float(person.position) ** -driver.learning
        self._delay = traits.delay
        self._impedance = driver.impedance(traits)
        self._rng = generator(person.trial_seed, "driver")
        dt = 1.0 / driver.perception.rate
        memory = driver.perception.noise_memory
        self._dt = dt
        self._lateral_noise = OrnsteinUhlenbeck(self._rng, memory, dt)
        self._bearing_noise = OrnsteinUhlenbeck(self._rng, memory, dt)
        self._motor_noise = OrnsteinUhlenbeck(self._rng, driver.arm.motor_memory, dt)
        stick, k = driver.stick, self._impedance.stiffness
        self._reach = (
            stick.full_travel * (1.0 + stick.centring / k[0]),
            stick.full_travel * (1.0 + stick.centring / k[1]),
            stick.full_twist * (1.0 + stick.centring_theta / k[2]),
        )
        self._dead = (stick.dead_zone, stick.dead_zone, stick.dead_zone_theta)
        self._next_look = 0.0
        self._wishes: deque[tuple[float, Wish]] = deque()
        self._wish = STILL
        self._lapse_until = -1.0
        self._turning = 0.0
        self._contact_since: float | None = None
        self._recovery_until = -1.0
        self._recovery: Wish = STILL
        self._way: Way | None = None
        self._leg: object = None
        self._stuck_at = PlanarPose(inf, inf, 0.0)
        self._stuck_since = 0.0
        self._effort = 1.0
        self._hand = Hand(STILL, *self._impedance)

    def hand(self, t: float, plant_state: Any, situation: Situation) -> Hand:
        """Give the arm's pull for the coming step; a new look only when one is due."""
        if t >= self._next_look:
            self._next_look += self._dt
            self._look(t, plant_state, situation)
        return self._hand

    def _look(self, t: float, plant_state: Any, situation: Situation) -> None:
        noise = 1.0 + self._driver.arm.motor_noise * self._skill * self._motor_noise.step()
        self._wishes.append((t, self._decide(plant_state.pose, situation)))
        acted = self._act(t, plant_state.contacts.bearing, situation)
        self._insist(t, plant_state.pose, acted, situation)
        reach = self._reach
        noise *= self._effort
        self._hand = self._hand._replace(
            reference=(
                self._past_dead_zone(acted[0], 0) * reach[0] * noise,
                self._past_dead_zone(acted[1], 1) * reach[1] * noise,
                self._past_dead_zone(acted[2], 2) * reach[2] * noise,
            )
        )

    def _insist(self, t: float, pose: PlanarPose, acted: Wish, situation: Situation) -> None:
        """Push harder while the robot stays where it is against the driver's will; then relax.

        At a wall the message says what to do instead.
        """
        decision, stuck = self._driver.decision, self._stuck_at
        moved = hypot(pose.x - stuck.x, pose.y - stuck.y) > STAYS
        turned = abs(pose.theta - stuck.theta) > STAYS_TURNED
        if moved or turned or situation.drive_away or acted == STILL:
            self._stuck_at, self._stuck_since = pose, t
        if t - self._stuck_since >= decision.patience:
            grown = self._effort + decision.insistence * self._dt
            self._effort = min(decision.greatest_effort, grown)
        else:
            self._effort = 1.0 + (self._effort - 1.0) * exp(-self._dt / decision.relaxation)

    def _past_dead_zone(self, share: float, axis: int) -> float:
        dead = self._dead[axis]
        size = abs(share)
        if size < 0.5 * dead:
            return 0.0
        return share if size >= 1.05 * dead else (1.05 * dead if share > 0.0 else -1.05 * dead)

    def _decide(self, pose: PlanarPose, situation: Situation) -> Wish:
        """Aim at the preview point, keep between the walls, as far as is seen."""
        perception, skill = self._driver.perception, self._skill
        lateral_noise = self._lateral_noise.step() * skill * perception.lateral_noise
        bearing_noise = self._bearing_noise.step() * skill * perception.bearing_noise
        leg = situation.leg
        if leg is None:
            return STILL
        if self._way is None or leg is not self._leg:
            self._way, self._leg = Way(leg), leg
        way = self._way
        place = way.find(pose.x, pose.y)
        if self._gives_way(way, pose, situation):
            return STILL
        bearing = self._bearing(pose, way.at(place + perception.preview))
        turn = self._driver.decision.bearing_gain / self._driver.stick.top_turning
        if abs(bearing) > perception.half_view:
            if self._turning == 0.0:
                self._turning = 1.0 if bearing > 0.0 else -1.0
            return (0.0, 0.0, self._turning)
        self._turning = 0.0
        wanted_turn = turn * (bearing + bearing_noise)
        sideways = self._lateral_error(pose, way, place) + lateral_noise
        decision = self._driver.decision
        forward = decision.pace * max(0.0, cos(bearing)) * (1.0 - 0.5 * min(1.0, abs(bearing)))
        left = decision.lateral_gain * sideways / self._driver.stick.top_speed
        return (forward, max(-1.0, min(1.0, left)), max(-1.0, min(1.0, wanted_turn)))

    def _gives_way(self, way: Way, pose: PlanarPose, situation: Situation) -> bool:
        decision = self._driver.decision
        speed = decision.pace * self._driver.stick.top_speed
        return waits(situation.passing, way, pose, speed, decision.foresight, decision.berth)

    def _bearing(self, pose: PlanarPose, point: tuple[float, float]) -> float:
        return wrapped(atan2(point[1] - pose.y, point[0] - pose.x) - pose.theta)

    def _lateral_error(self, pose: PlanarPose, way: Way, place: float) -> float:
        """How far left of the near point ahead of the robot the way runs, m."""
        near = self._driver.perception.near_point
        x, y = pose.to_world(near, 0.0)
        s = way.nearest(x, y, place - near, place + 2.0 * near)
        return pose.to_local(*way.at(s))[1]

    def _act(self, t: float, bearing: float, situation: Situation) -> Wish:
        """Give what the hand does now: a recovery, a lapse, or what was decided a delay ago."""
        if self._recover(t, bearing, situation):
            return self._recovery
        due = t - self._delay
        wish = self._wish
        while self._wishes and self._wishes[0][0] <= due:
            wish = self._wishes.popleft()[1]
        decision = self._driver.decision
        chance, length = float(self._rng.random()), float(self._rng.standard_exponential())
        if t >= self._lapse_until and chance < decision.lapses * self._skill * self._dt:
            self._lapse_until = t + decision.lapse_shortest + decision.lapse_mean * length
        if t >= self._lapse_until:
            self._wish = wish
        return self._wish

    def _recover(self, t: float, bearing: float, situation: Situation) -> bool:
        """Drive away from the wall for a while, once the message has been on screen a moment."""
        if t < self._recovery_until:
            return True
        if not situation.drive_away or isnan(bearing):
            self._contact_since = None
            return False
        if self._contact_since is None:
            self._contact_since = t
        decision = self._driver.decision
        if t - self._contact_since < decision.recovery_pause:
            return False
        error = float(self._rng.standard_normal()) * decision.recovery_noise * self._skill
        away = bearing + pi + error
        spread = decision.recovery_longest - decision.recovery_shortest
        self._recovery_until = t + decision.recovery_shortest + spread * float(self._rng.random())
        self._contact_since = None
        self._recovery = (
            decision.recovery_pace * cos(away),
            decision.recovery_pace * sin(away),
            0.0,
        )
        return True
