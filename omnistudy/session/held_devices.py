"""The devices of live trials: connected when first needed, kept while they are well."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, ExitStack, nullcontext
from pathlib import Path
from typing import NamedTuple, Self

from omnistudy.channel import Measure, measured
from omnistudy.devices import Device, Identity, RunningDevice
from omnistudy.devices.handheld.axes import Travel
from omnistudy.devices.real_time import before_others
from omnistudy.devices.remote_device import RemoteDevice
from omnistudy.store.process import Recorder
from omnistudy.store.row_writer import StreamHead

STREAM = "stick"
"""Name of the stream that holds every tick of a device with a process of its own."""
FULL = (Travel().x, Travel().y, Travel().theta)
"""Full deflection of the axes, m, m, rad."""


class _Apart(NamedTuple):
    """A device with a process of its own, and the recorder of its rows."""

    device: Device
    remote: RemoteDevice
    recorder: Recorder


class HeldDevices:
    """What is held in the live trials of one study; use as a context manager.

    Each is checked before it is connected, and again after it ailed.

    tell : shows a sentence to whoever is at the device, for its checks.
    """

    def __init__(self, study: Path, tell: Callable[[str], None] = lambda sentence: None) -> None:
        self._study = study
        self._tell = tell
        self._held = ExitStack()
        self._apart: _Apart | None = None
        self._ailed = False
        self._deaths = 0
        self._trial = 0
        self._expected: Identity | None = None
        self._findings: tuple[Measure, ...] = ()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._let_go()

    @property
    def remote(self) -> RemoteDevice | None:
        """The device that a process of its own turns, if there is one at present."""
        return self._apart.remote if self._apart else None

    @property
    def recorder(self) -> Recorder | None:
        """What records its rows, if there is one at present."""
        return self._apart.recorder if self._apart else None

    def take(self, device: Device, physics_hz: int) -> RunningDevice | None:
        """Give a device ready to be driven with; None for one that each trial connects itself.

        Raises what connecting raises, and what forbids force.
        """
        reached = device.at(self._study)
        if self._apart is not None and self._apart.device == reached and not self._ailed:
            return self._apart.remote
        self._let_go()
        if reached.in_lockstep and not reached.apart:
            return None
        self._findings = reached.before_force(self._tell, self._expected if self._ailed else None)
        self._ailed = False
        if reached.apart:
            return self._connected(reached).remote
        running = reached.connect(physics_hz)
        self._held.callback(running.close)
        return running

    def open_trial(self, trial: int) -> None:
        """Say that a trial begins with the device that was taken."""
        self._trial = trial
        if self._apart is not None:
            self._deaths = self._apart.recorder.deaths
            self._apart.remote.open_trial(trial)

    def measures(self) -> tuple[Measure, ...]:
        """Tell how well the trial that is running is served so far, once its device knows of it."""
        if self._apart is None or self._apart.remote.report.trial != self._trial:
            return ()
        return self._apart.remote.measures(self._trial)

    def deflection(self) -> tuple[float, float, float] | None:
        """Give where the stick stands in parts of its full deflection, -1..1; None without one."""
        position = self._apart.remote.report.state.position if self._apart is not None else ()
        if len(position) != len(FULL):
            return None
        x, y, theta = (
            max(-1.0, min(1.0, place / full)) for place, full in zip(position, FULL, strict=True)
        )
        return (x, y, theta)

    def undisturbed(self) -> AbstractContextManager[None]:
        """Let the simulation run before other programs while a device waits for its fields."""
        return before_others() if self._apart is not None else nullcontext()

    def close_trial(self, trial: int, *, ailed: bool) -> tuple[Measure, ...]:
        """Say that it is over; give how well it was served and recorded.

        The first trial after checks has their findings too.
        """
        self._ailed = ailed
        findings, self._findings = self._findings, ()
        if self._apart is None:
            return findings
        _, remote, recorder = self._apart
        told = remote.close_trial()
        recorder.settle()
        recorded = recorder.rows(trial)
        return (
            *findings,
            *remote.measures(trial),
            measured("recorded_rows", recorded),
            measured("lost_rows", told - recorded),
        )

    def remarks(self) -> tuple[tuple[str, str], ...]:
        """Tell what befell the recorder during the last trial, as kinds and details of events."""
        deaths = self._apart.recorder.deaths - self._deaths if self._apart else 0
        if not deaths:
            return ()
        return (("recorder", f"died {deaths} times and was followed by another"),)

    def _connected(self, device: Device) -> _Apart:
        remote = self._held.enter_context(RemoteDevice(device))
        if remote.introduction.missing:
            self._tell(f"WARN: {remote.introduction.missing}")
        head = StreamHead(STREAM, device.tick_hz, remote.row_channels)
        recorder = self._held.enter_context(Recorder(self._study, remote.files.rows, head))
        self._apart = _Apart(device, remote, recorder)
        self._expected = remote.identity()
        return self._apart

    def _let_go(self) -> None:
        if self._apart is not None:
            self._apart.remote.close_trial()
        self._apart = None
        self._held.close()
