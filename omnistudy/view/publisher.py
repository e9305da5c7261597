"""Says what happens in a live trial, at most 60 times a second, to whoever looks."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from math import isfinite

import numpy as np
from pydantic_core import to_json

from omnistudy.channel import Channel, LatestValue, Measure, measured
from omnistudy.session.live import RealTime
from omnistudy.trial import Glimpse
from omnistudy.view.answer import Answer
from omnistudy.view.captions import Captions
from omnistudy.view.health import LoopHealth, Reading, device_health

LAST_EVENTS = 12
"""Events that a state carries: a page may have missed those before."""
WRENCH = ("fx", "fy", "tau")

Place = tuple[float, float]
Served = Callable[[], Iterable[Measure]]
DEVICE_EVERY_S = 0.5
"""How often the device is asked: its quantiles are counted out each time."""


class Publisher(RealTime):
    """Keeps a trial at the wall clock's pace and puts its state where the server finds it."""

    def __init__(
        self,
        trial: int,
        state: LatestValue,
        answer: LatestValue,
        served: Served = lambda: (),
    ) -> None:
        """Take the trial's number and its files; `served` tells how its device serves it."""
        super().__init__()
        self._served = served
        self._device: tuple[Reading, ...] = ()
        self._device_due = 0.0
        self._trial = trial
        self._state = state
        self._answer = answer
        self._names: tuple[str, ...] = ()
        self._captions = Captions()
        self._taken = 0
        self._loop = LoopHealth()
        self._shown: dict[str, object] = {}

    def begin(self, plant: tuple[Channel, ...], axes: tuple[Channel, ...]) -> None:
        """Take the names, and start the clock."""
        self._names = tuple(channel.name for channel in (*plant, *axes)) + WRENCH
        super().begin(plant, axes)

    def see(self, glimpse: Glimpse) -> None:
        """Put the state of this instant in place of the last."""
        for event in glimpse.events[self._taken :]:
            self._captions.take(event)
        self._taken = len(glimpse.events)
        values = (*glimpse.plant, *glimpse.device, *glimpse.wrench)
        leg = glimpse.situation.leg
        self._shown = {
            "trial": self._trial,
            "t": glimpse.t,
            "values": dict(zip(self._names, values, strict=True)),
            "target": leg.target if leg else None,
            "lines": self._captions.now,
            "collisions": glimpse.collisions,
            "events": glimpse.events[-LAST_EVENTS:],
            "rays": _rays(glimpse),
            "health": self._health(glimpse.t),
            "status": "running",
        }
        self._write()

    def end(self, status: str) -> None:
        """Say how it ended; the last state stays to be seen."""
        self._shown["status"] = status
        self._write()

    def measures(self) -> tuple[Measure, ...]:
        """Tell how well the pace was kept, and how the participant's screen lagged."""
        lag = Answer.latest(self._answer).lag
        if lag is None or lag.trial != self._trial:
            return super().measures()
        return (
            *super().measures(),
            measured("display_frames", lag.frames),
            measured("display_lag_p50", lag.median_ms / 1000.0),
            measured("display_lag_p99", lag.p99_ms / 1000.0),
        )

    def remarks(self) -> tuple[tuple[str, str], ...]:
        """Tell how late steps and the participant's screen were."""
        lag = Answer.latest(self._answer).lag
        if lag is None or lag.trial != self._trial:
            return super().remarks()
        told = (
            f"lag {lag.median_ms:.1f} ms median, {lag.p99_ms:.1f} ms p99, {lag.frames} frames, "
            f"clock within {lag.clock_ms:.1f} ms"
        )
        return (*super().remarks(), ("display", told))

    @property
    def stopped(self) -> bool:
        """Whether somebody pressed stop during this trial."""
        return Answer.latest(self._answer).stop == self._trial

    def _health(self, t: float) -> tuple[Reading, ...]:
        """Give what the experimenter should know of the trial's parts."""
        if t >= self._device_due:
            self._device_due = t + DEVICE_EVERY_S
            self._device = device_health(self._served())
        behind = time.monotonic() - self._opened - t
        return (*self._loop.readings(t, self.late, behind), *self._device)

    def _write(self) -> None:
        stamped = {**self._shown, "made": time.monotonic()}
        self._state.write(to_json(stamped, inf_nan_mode="null"))


def _rays(glimpse: Glimpse) -> list[tuple[Place, Place]]:
    """Give rays that met something, from and to, in the robot's frame, to the millimetre."""
    scan = glimpse.scan
    if scan is None:
        return []
    met = scan.ranges < scan.max_range
    ends = scan.points()
    starts = np.zeros_like(ends) if scan.origins is None else scan.origins
    rays = np.stack((starts, ends), axis=1)[met].round(3).tolist()
    return [((ox, oy), (x, y)) for (ox, oy), (x, y) in rays if isfinite(x)]
