"""The loop: one trial at a fixed step, in simulated time, as fast as the machine goes."""

from __future__ import annotations

from math import nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omnistudy.controllers import Control
from omnistudy.devices import DeviceState, RunningDevice
from omnistudy.geometry import NO_FORCE, PlanarTwist, Scan, Vector3
from omnistudy.laws import Sensed
from omnistudy.plants import RunningPlant
from omnistudy.trial.collisions import CollisionCounter
from omnistudy.trial.companion import Companion, Glimpse
from omnistudy.trial.recorder import Recorder
from omnistudy.trial.result import TrialResult
from omnistudy.trial.sources import HandSource, RecordSource, Source
from omnistudy.trial.spec import TrialSpec
from omnistudy.worlds import Situation, passing

STOPPED = "stopped by hand"
"""Reason of a trial that its companion ended."""

STILL = PlanarTwist(0.0, 0.0, 0.0)


def run_trial(
    spec: TrialSpec, companion: Companion | None = None, held: RunningDevice | None = None
) -> TrialResult:
    """Run a trial with its operator and device; the same spec gives the same bytes.

    A device in trouble ends it: the trial is void, with the trouble as its reason.

    companion : keeps the pace and looks on; without one the trial goes as fast as it can.
    held : the device, connected already and left connected; else the trial connects its own.

    Raises OnlyLive for a device or an operator that needs `held`, NobodyHolds.
    """
    return _run(spec, HandSource(spec, held), companion)


def resimulate(spec: TrialSpec, recorded: NDArray[np.float64]) -> TrialResult:
    """Run a trial again from its recorded input alone, without operator and device.

    recorded : the data of the stream "input", (steps, 2·axes).
    """
    return _run(spec, RecordSource(spec, recorded))


def _run(spec: TrialSpec, source: Source, companion: Companion | None = None) -> TrialResult:
    plant = spec.plant.build(
        spec.world.scene, spec.world.start.pose, spec.recording.physics_hz, spec.person.trial_seed
    )
    try:
        return _Loop(spec, source, plant, companion).run()
    finally:
        plant.close()
        source.close()


class _Loop:
    def __init__(
        self, spec: TrialSpec, source: Source, plant: RunningPlant, companion: Companion | None
    ) -> None:
        self._spec = spec
        self._source = source
        self._plant = plant
        self._companion = companion
        self._moving = spec.world.scene.moving
        self._task = spec.task.begin(spec.world, spec.route, spec.messages)
        self._collisions = CollisionCounter(spec.recording.physics_hz)
        self._recorder = Recorder(spec.recording, source.axes, source.channels, plant.channels)
        self._scan: Scan | None = None
        self._field = NO_FORCE
        axes = len(source.axes)
        self._device = DeviceState((0.0,) * axes, (0.0,) * axes)
        self._control = Control(STILL, None, spec.controller.initial_state())
        self._started_at = nan
        self._ended_at = nan

    def run(self) -> TrialResult:
        companion = self._companion
        if companion is None:
            return self._turned()
        companion.begin(self._plant.channels, self._source.axes)
        result = self._turned()
        companion.see(self._glimpse(self._ended_at, self._task.situation))
        companion.end(result.status)
        return result

    def _turned(self) -> TrialResult:
        recording = self._spec.recording
        physics_hz, scan_hz = recording.physics_hz, recording.scan_hz
        sample_every = physics_hz // recording.sample_hz
        dt = 1.0 / physics_hz
        situation = self._task.situation
        ended, step, scans = "", 0, -1
        while not ended:
            if self._companion and not self._accompanied(self._companion, step, dt, situation):
                return self._result("aborted", STOPPED, step * dt)
            if step * scan_hz // physics_hz != scans:
                scans = step * scan_hz // physics_hz
                self._sense()
            if step % sample_every == 0:
                self._sample(step * dt)
            if not self._source.has(step):
                return self._result(self._task.when_input_ends, "the input ended", step * dt)
            if trouble := self._source.trouble():
                return self._result("void", trouble, step * dt)
            self._step(step, dt, situation)
            step += 1
            situation, ended = self._notice(step * dt)
        return self._result(ended, "", step * dt)

    def _accompanied(
        self, companion: Companion, step: int, dt: float, situation: Situation
    ) -> bool:
        """Show the trial as it is before a step, and wait; False when it is to end."""
        if step % max(1, self._spec.recording.physics_hz // companion.glimpse_hz) == 0:
            companion.see(self._glimpse(step * dt, situation))
        return companion.goes_on(step * dt)

    def _glimpse(self, t: float, situation: Situation) -> Glimpse:
        return Glimpse(
            t,
            self._plant.values(),
            self._device.position,
            self._field.wrench,
            self._scan,
            situation,
            self._collisions.count,
            self._recorder.events,
        )

    def _sense(self) -> None:
        """Scan, ask the law, hand the field to the device."""
        self._scan = scan = self._plant.scan()
        if scan is None:
            return
        device = self._device
        self._field = self._spec.law.field(
            Sensed(
                scan,
                PlanarTwist(*self._control.intent),
                self._spec.controller.twist_per_stick,
                _first_three(device.position),
                _first_three(device.rate),
            )
        )
        self._source.render(self._field)

    def _sample(self, t: float) -> None:
        self._recorder.sample(
            t,
            self._plant.values(),
            self._device.position,
            self._field.wrench,
            self._source.values(),
        )

    def _step(self, step: int, dt: float, situation: Situation) -> None:
        plant = self._plant
        if self._moving:
            situation = situation._replace(passing=passing(self._moving, step * dt))
        self._device = device = self._source.next(step, step * dt, plant.state, situation)
        self._recorder.consumed(device)
        self._control = control = self._spec.controller.control(
            device, plant.state, self._scan, self._control.state, dt
        )
        plant.command(control.command)
        plant.step()

    def _notice(self, t: float) -> tuple[Situation, str]:
        state = self._plant.state
        events = self._collisions.update(t, state.contacts)
        progress = self._task.update(
            t,
            state,
            any(self._control.intent),
            self._collisions.count,
            self._collisions.colliding,
        )
        if progress.started and self._started_at != self._started_at:
            self._started_at = t
        if events or progress.events:
            self._recorder.events.extend((*events, *progress.events))
        return progress.situation, progress.ended

    def _result(self, status: Any, reason: str, t: float) -> TrialResult:
        self._ended_at = t
        return TrialResult(
            status=status,
            reason=reason,
            duration_s=t - self._started_at,
            path_length_m=self._plant.travelled,
            collisions=self._collisions.count,
            collisions_legacy=self._collisions.legacy,
            contact_time_s=self._collisions.contact_time,
            events=tuple(self._recorder.events),
            samples=self._recorder.samples(),
            streams=self._recorder.streams(),
            device=self._source.record(),
        )


def _first_three(values: tuple[float, ...]) -> Vector3:
    """Give the axes that a law's field is written in."""
    x, y, theta, *_ = values
    return (x, y, theta)
