"""A live trial is the same trial, only at the wall clock's pace."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from core_world import trial

from omnistudy.channel import Channel
from omnistudy.session import live
from omnistudy.session.live import RealTime
from omnistudy.trial import Glimpse, TrialResult, run_trial
from omnistudy.trial.loop import STOPPED


class Clock:
    """Stands in for the clock on the wall: sleeping is all that takes time."""

    def __init__(self) -> None:
        self.now = 0.0
        self.slept: list[float] = []

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.slept.append(seconds)
        self.now += seconds


class Onlooker(RealTime):
    """Keeps what it sees, and stops the trial at a time."""

    def __init__(self, stop_at: float = float("inf")) -> None:
        super().__init__()
        self.names: tuple[str, ...] = ()
        self.seen: list[Glimpse] = []
        self.ended = ""
        self._stop_at = stop_at

    def begin(self, plant: tuple[Channel, ...], axes: tuple[Channel, ...]) -> None:
        super().begin(plant, axes)
        self.names = tuple(channel.name for channel in plant)

    def see(self, glimpse: Glimpse) -> None:
        self.seen.append(glimpse)

    def end(self, status: str) -> None:
        self.ended = status

    @property
    def stopped(self) -> bool:
        return bool(self.seen) and self.seen[-1].t >= self._stop_at


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    monkeypatch.setattr(live, "time", made)
    return made


@cache
def lockstep() -> TrialResult:
    return run_trial(trial())


def test_live_equals_lockstep_to_the_byte(clock: Clock) -> None:
    accompanied = run_trial(trial(), Onlooker())
    plain = lockstep()
    assert accompanied.samples.tobytes() == plain.samples.tobytes()
    assert accompanied.events == plain.events
    for one, other in zip(accompanied.streams, plain.streams, strict=True):
        assert one.data.tobytes() == other.data.tobytes()


def test_a_trial_lasts_as_long_as_it_says(clock: Clock) -> None:
    onlooker = Onlooker()
    result = run_trial(trial(), onlooker)
    assert clock.now == pytest.approx(result.samples[-1, 0], abs=0.05)
    assert onlooker.late == 0
    assert max(clock.slept) == pytest.approx(1 / 240)


def test_steps_that_come_late_are_counted_and_caught_up(clock: Clock) -> None:
    onlooker = Onlooker()
    onlooker.begin((), ())
    assert onlooker.goes_on(0.0)
    clock.now = 0.1
    for step in range(1, 25):
        assert onlooker.goes_on(step / 240)
    assert onlooker.late == 22
    assert clock.now == pytest.approx(0.1)
    onlooker.goes_on(30 / 240)
    assert clock.now == pytest.approx(0.125)


def test_an_onlooker_sees_sixty_states_a_second_and_the_last(clock: Clock) -> None:
    onlooker = Onlooker()
    result = run_trial(trial(), onlooker)
    times = [glimpse.t for glimpse in onlooker.seen]
    np.testing.assert_allclose(np.diff(times)[:-1], 1 / 60, atol=1e-9)
    x = onlooker.names.index("x")
    sampled = dict(zip(result.samples[:, 0].round(6), result.samples[:, 1], strict=True))
    for glimpse in onlooker.seen[::3]:
        assert glimpse.plant[x] == sampled.get(round(glimpse.t, 6), glimpse.plant[x])
    assert (onlooker.ended, list(onlooker.seen[-1].events)) == (result.status, list(result.events))


def test_a_stopped_trial_is_aborted_there(clock: Clock) -> None:
    onlooker = Onlooker(stop_at=0.5)
    result = run_trial(trial(), onlooker)
    assert (result.status, result.reason) == ("aborted", STOPPED)
    assert result.samples[-1, 0] == pytest.approx(0.5, abs=0.05)
    kept = len(result.samples)
    assert result.samples.tobytes() == lockstep().samples[:kept].tobytes()
