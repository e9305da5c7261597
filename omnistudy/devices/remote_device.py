"""A device that is turned by a process of its own, as the simulation holds it."""

from __future__ import annotations

import time
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from shutil import rmtree
from tempfile import mkdtemp
from typing import Self

from omnistudy.channel import SATURATED, LatestValue, Measure, Ring, measured, with_rates
from omnistudy.channel.child import start_child
from omnistudy.devices.cadence import Cadence
from omnistudy.devices.device import (
    Device,
    DeviceState,
    Hand,
    Health,
    Identity,
    RunningDevice,
)
from omnistudy.devices.device_process import HEARD_AT, Files, Introduction, turn_device
from omnistudy.devices.orders import Order, OrderLayout, Report, ReportLayout
from omnistudy.errors.devices import DeviceProcessFailed, DeviceSilent, NotReached
from omnistudy.geometry import NO_FORCE, ForceField

PATIENCE_S = 60.0
"""How long a process may take to connect its device: the emulator may have to be compiled."""
SILENT_S = 0.25
"""A process that reported nothing for so long is held to be stuck; by then the stick's firmware,
which heard nothing for 0.2 s, fades its force by itself (ours)."""
ENDING_S = 5.0
"""How long a process may take to let its device go before it is killed."""
MEMORY = Path("/dev/shm")
"""Files that are memory alone, where the system has that: no disk ever makes a turn late."""


class RemoteDevice(RunningDevice):
    """Gives orders and takes reports through mapped files; never waits during a trial."""

    def __init__(self, device: Device) -> None:
        """Start the process and wait until it has connected and woken the device.

        Raises NotReached with what the process said, or DeviceProcessFailed.
        """
        self._kind = device.kind
        self.tick_hz = device.tick_hz
        self.files = Files(Path(mkdtemp(prefix="omnistudy-", dir=_folder())))
        context = get_context("spawn")
        hearing, telling = context.Pipe(duplex=False)
        self._process = context.Process(
            target=turn_device, args=(device, self.files.folder, telling), daemon=True
        )
        start_child(self._process)
        telling.close()
        try:
            self.introduction = self._heard(hearing)
            self._map()
        except BaseException:
            self._end()
            raise

    def _heard(self, hearing: Connection) -> Introduction:
        try:
            told = hearing.recv() if hearing.poll(PATIENCE_S) else None
        except EOFError:
            told = None
        if isinstance(told, Introduction):
            return told
        if told is None:
            raise DeviceProcessFailed(self._kind)
        raise NotReached(str(told))

    def _map(self) -> None:
        told = self.introduction
        self.axes, self.channels = told.axes, told.channels
        self.forces, self.wrench = told.forces, told.wrench
        self.row_channels = (HEARD_AT, *with_rates(told.axes), *told.channels)
        self._order_layout = OrderLayout(len(told.axes))
        self._report_layout = ReportLayout(len(told.axes), len(told.channels))
        self._orders = LatestValue(self.files.orders)
        self._reports = LatestValue(self.files.reports)
        self._ring = Ring(self.files.rows)
        self._cadence = Cadence(self.files.cadence)
        self._field = NO_FORCE
        self._fields = 0
        self._rendered_at = 0.0
        self._trial = 0
        self._opened = 0.0
        nothing = (0.0,) * len(told.axes)
        state = DeviceState(nothing, nothing)
        values = (0.0,) * len(told.channels)
        health = Health(saturated=(0,) * len(told.axes))
        self._report = Report(0, time.monotonic(), 0, 0, health, state, values, "")
        self.late_fields = 0

    @property
    def process_id(self) -> int:
        """The process that turns the device."""
        assert self._process.pid is not None
        return self._process.pid

    @property
    def report(self) -> Report:
        """The newest report that came."""
        latest = self._reports.read()
        if latest is not None:
            self._report = self._report_layout.unpack(latest.data)
        return self._report

    def open_trial(self, number: int) -> None:
        """Say that the first step of a trial comes next; its rows are told from now on."""
        self._trial, self._opened = number, 0.0
        self.late_fields, self._rendered_at = 0, 0.0

    def close_trial(self) -> int:
        """Say that the trial is over; give the rows that were told of it.

        Waits until the process has noticed, at most SILENT_S.
        """
        trial, self._trial = self._trial, 0
        self._orders.write(self._order_layout.pack(Order()))
        until = time.monotonic() + SILENT_S
        while (report := self.report).trial == trial and time.monotonic() < until:
            time.sleep(1.0 / self.tick_hz)
        return report.rows

    def render(self, field: ForceField) -> None:
        """Order a field; it counts as late when the last was stale by now."""
        now = time.monotonic()
        if self._rendered_at and now - self._rendered_at > self._field.valid_for:
            self.late_fields += 1
        self._rendered_at = now
        self._field = field
        self._fields += 1

    def advance(self, hand: Hand) -> DeviceState:
        """Order on, and give the newest state that was told."""
        if self._trial and not self._opened:
            self._opened = time.monotonic()
        order = Order(self._trial, self._opened, self._fields, self._field, hand)
        self._orders.write(self._order_layout.pack(order))
        return self.report.state

    def values(self) -> tuple[float, ...]:
        """Give the values of the newest report."""
        return self._report.values

    def health(self) -> Health:
        """Give the counts of the newest report: of its trial, or of the last one."""
        return self._report.health

    def identity(self) -> Identity:
        """Tell which piece of hardware the process has connected."""
        return self.introduction.identity

    def trouble(self) -> str:
        """Tell what the process said ails the device, or that the process ended or is stuck."""
        if self._report.trouble:
            return self._report.trouble
        if not self._process.is_alive():
            return str(DeviceProcessFailed(self._kind, self._process.exitcode))
        if time.monotonic() - self.report.time > SILENT_S:
            return str(DeviceSilent(self._kind, SILENT_S))
        return self._report.trouble

    def measures(self, trial: int) -> tuple[Measure, ...]:
        """Tell how well a trial was served: turns, frames, fields, saturation an axis."""
        health = self.health()
        told: dict[str, float] = {
            "device_ticks": health.ticks,
            "dropped_frames": health.missed,
            "damaged_frames": health.damaged,
            "late_fields": self.late_fields,
        }
        for axis, saturated in zip(self.axes, health.saturated, strict=True):
            told[SATURATED + axis.name] = saturated / max(1, health.ticks)
        lateness = self._cadence.lateness(trial, 1.0 / self.tick_hz)
        if lateness is not None:
            told |= {
                "device_turns": lateness.turns,
                "late_turns": lateness.late,
                "turn_lateness_p50": lateness.median,
                "turn_lateness_p99": lateness.p99,
                "turn_lateness_max": lateness.greatest,
            }
        return tuple(measured(name, value) for name, value in told.items())

    def close(self) -> None:
        """End the process, which lets its device go."""
        self._end()
        for mapped in (self._orders, self._reports, self._ring, self._cadence):
            mapped.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _end(self) -> None:
        self._process.terminate()
        self._process.join(ENDING_S)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()
        rmtree(self.files.folder, ignore_errors=True)


def _folder() -> Path | None:
    return MEMORY if MEMORY.is_dir() else None
