"""The ring of infrared sensors in PyBullet: noise, interference, averaging and low-pass."""

from __future__ import annotations

from math import cos, exp, pi, sin, sqrt

import numpy as np

from omnistudy.channel import Channel
from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.plants.chassis_rays import Chassis, ChassisRays
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.sensor_on_chassis import SensorOnChassis
from omnistudy.seeds import generator

SETBACK = 0.05
"""Rays start this much behind their sensor, in m: one that starts inside a wall meets nothing."""

NAMES = ("left", "front left", "ahead left", "ahead right", "front right", "right")


class InfraredOnChassis(SensorOnChassis):
    """Six sensors that remember what they last told."""

    channels = tuple(
        Channel(f"infrared_{number}", "m", f"range told by the infrared sensor {name}")
        for number, name in enumerate(NAMES, 1)
    )

    def __init__(self, ring: InfraredRing, chassis: Chassis, physics_hz: int, seed: str) -> None:
        """Mount the ring; `seed`, of the trial, is behind noise and interference."""
        self._ring = ring
        self._angles, self._origins = ring.angles, ring.origins
        self._mounts = [
            (x, y, cos(angle), sin(angle))
            for (x, y), angle in zip(self._origins.tolist(), self._angles.tolist(), strict=True)
        ]
        self._rays = ChassisRays(
            [
                (x - SETBACK * c, y - SETBACK * s, angle)
                for (x, y, c, s), angle in zip(self._mounts, self._angles.tolist(), strict=True)
            ],
            SETBACK + ring.max_range,
            ring.height,
            chassis,
        )
        self._noise = generator(seed, "infrared noise")
        self._interference = generator(seed, "infrared interference")
        self._sd = ring.noise / (ring.max_range**2 * sqrt(ring.readings))
        self._decay_per_step = exp(-2.0 * pi * ring.cutoff / physics_hz)
        self._step_time = 1.0 / physics_hz
        self._step = 0
        self._told: list[float] = []

    def values(self) -> tuple[float, ...]:
        """Give the range that each sensor last told, m; NaN before the first scan."""
        return tuple(self._told) or (float("nan"),) * len(self._mounts)

    def scan(self, step: int, twist: PlanarTwist) -> Scan:
        """Measure, average, filter; the first scan fills the filter."""
        measured = self._measured()
        before, steps = self._told or measured, step - self._step
        keep = self._decay_per_step**steps if self._told else 0.0
        self._told = told = [
            new + keep * (old - new) for old, new in zip(before, measured, strict=True)
        ]
        self._step = step
        if self._ring.rates_from == "encoders":
            rates = self._rates_of(twist)
        else:
            elapsed = max(1, steps) * self._step_time
            rates = [(new - old) / elapsed for old, new in zip(before, told, strict=True)]
        return Scan(
            self._angles, np.array(told), self._ring.max_range, self._origins, np.array(rates)
        )

    def _measured(self) -> list[float]:
        """Give the mean of each sensor's readings; they share a reflection and differ in noise."""
        near, far, sd = self._ring.min_range, self._ring.max_range, self._sd
        true = [min(far, max(0.0, reach - SETBACK)) for reach in self._rays.ranges()]
        noise = self._noise.standard_normal(len(true)).tolist()
        return [
            min(far, max(near, seen + sd * seen * seen * draw)) if seen < far else far
            for seen, draw in zip(self._with_interference(true), noise, strict=True)
        ]

    def _with_interference(self, true: list[float]) -> list[float]:
        """Let sensors take a neighbour's reflection for theirs, where both see something near."""
        chance, limit = self._ring.interference, self._ring.interference_range
        seen = list(true)
        for i, draw in enumerate(self._interference.random(len(true)).tolist()):
            if draw < chance:
                neighbour = i - 1 if draw < 0.5 * chance else i + 1
                if 0 <= neighbour < len(true) and true[i] < limit and true[neighbour] < limit:
                    seen[i] = true[neighbour]
        return seen

    def _rates_of(self, twist: PlanarTwist) -> list[float]:
        """Give how fast each range grows if only the robot moves and all stands square."""
        vx, vy, omega = twist
        return [0.0 - (vx - omega * y) * c - (vy + omega * x) * s for x, y, c, s in self._mounts]
