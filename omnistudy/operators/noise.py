"""Noise with a memory, for perception and muscles."""

from __future__ import annotations

from math import exp, sqrt

import numpy as np


class OrnsteinUhlenbeck:
    """Gaussian noise of unit variance that forgets over `time_constant` seconds."""

    __slots__ = ("_decay", "_drive", "_rng", "value")

    def __init__(self, rng: np.random.Generator, time_constant: float, dt: float) -> None:
        self._rng = rng
        self._decay = exp(-dt / time_constant)
        self._drive = sqrt(1.0 - self._decay**2)
        self.value = float(rng.standard_normal())

    def step(self) -> float:
        """Let dt seconds pass; exact for any dt."""
        self.value = self._decay * self.value + self._drive * float(self._rng.standard_normal())
        return self.value
