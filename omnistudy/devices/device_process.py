"""The process in which a device is turned, whatever the simulation does meanwhile."""

from __future__ import annotations

import signal
import sys
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from shutil import rmtree
from typing import NamedTuple

from omnistudy.channel import Channel, LatestValue, Ring
from omnistudy.channel.orphan import orphaned
from omnistudy.channel.trial_row import TRIAL_ROW
from omnistudy.devices.cadence import Cadence
from omnistudy.devices.device import (
    NO_HAND,
    Device,
    DeviceState,
    Health,
    Identity,
    RunningDevice,
    Wrench,
)
from omnistudy.devices.orders import Order, OrderLayout, Report, ReportLayout
from omnistudy.devices.real_time import go_real_time
from omnistudy.errors import OmnistudyError
from omnistudy.geometry import NO_FORCE

RING_S = 60
"""s of rows that wait for the writer before the oldest are lost (ours)."""
CATCHING_UP_S = 0.05
"""A loop that is further behind gives the turns up; it would starve others (ours)."""
ORPHANED_S = 1.0
"""s that an orphaned device still turns: fields become stale and fade, then it ends (ours)."""
BETWEEN_TRIALS_S = 0.02
"""Between trials no field comes; a field of no force this often keeps the device awake (ours)."""
HEARD_AT = Channel("heard_at", "s", "by the computer's clock, since the first step")
"""What stands in the ring before each row of the device, after TRIAL_ROW."""


class Introduction(NamedTuple):
    """What the process of a device says first: what it has connected, and how it is run.

    missing : what it could not get of real time, "" for nothing.
    """

    axes: tuple[Channel, ...]
    channels: tuple[Channel, ...]
    forces: tuple[bool, ...]
    wrench: Wrench
    identity: Identity
    missing: str


@dataclass(frozen=True, slots=True)
class Files:
    """The mapped files between a device's process and the simulation, in one folder."""

    folder: Path

    @property
    def orders(self) -> Path:
        """The latest order: the simulation writes."""
        return self.folder / "orders"

    @property
    def reports(self) -> Path:
        """The latest report: the device's process writes."""
        return self.folder / "reports"

    @property
    def rows(self) -> Path:
        """The ring of rows: the device's process writes, a recorder reads."""
        return self.folder / "rows"

    @property
    def cadence(self) -> Path:
        """Lateness: the device's process writes."""
        return self.folder / "cadence"


def turn_device(device: Device, folder: Path, telling: Connection) -> None:
    """Connect a device and turn it until this process is told to end or its parent is gone.

    Says an Introduction through `telling`, or a sentence when the device cannot be reached.
    """
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))  # so that the device is closed
    try:
        running = device.connect(device.tick_hz)
    except OmnistudyError as mistake:
        telling.send(str(mistake))
        return
    try:
        loop = _introduced(device, running, Files(folder), telling)
        if loop is not None:
            loop.turn_on()
    finally:
        running.close()
        if orphaned():
            rmtree(folder, ignore_errors=True)


def _introduced(
    device: Device, running: RunningDevice, files: Files, telling: Connection
) -> _Loop | None:
    """Wake the device and introduce it; None when it cannot be driven with."""
    running.rest()
    try:
        running.advance(NO_HAND)
    except OmnistudyError as mistake:
        telling.send(str(mistake))
        return None
    axes = len(running.axes)
    width = len(TRIAL_ROW) + 1 + 2 * axes + len(running.channels)
    Ring(files.rows, width, RING_S * device.tick_hz).close()
    LatestValue(files.reports, ReportLayout(axes, len(running.channels)).size).close()
    LatestValue(files.orders, OrderLayout(axes).size).close()
    Cadence(files.cadence, make=True).close()
    missing = go_real_time().missing
    loop = _Loop(running, files, device.tick_hz)
    telling.send(
        Introduction(
            running.axes, running.channels, running.forces, running.wrench, running.identity(),
            missing,
        )
    )  # fmt: skip
    telling.close()
    return loop


class _Loop:
    def __init__(self, running: RunningDevice, files: Files, tick_hz: int) -> None:
        axes = len(running.axes)
        self._running = running
        self._period = 1.0 / tick_hz
        self._idle_turns = max(1, round(BETWEEN_TRIALS_S * tick_hz))
        self._orders = LatestValue(files.orders)
        self._order_layout = OrderLayout(axes)
        self._reports = LatestValue(files.reports)
        self._report_layout = ReportLayout(axes, len(running.channels))
        self._ring = Ring(files.rows)
        self._cadence = Cadence(files.cadence)
        self._seen = 0
        self._order = Order()
        self._turn = 0
        self._rows = 0
        self._before = self._health = Health()
        self._state = DeviceState((0.0,) * axes, (0.0,) * axes)

    def turn_on(self) -> None:
        """Turn at the wall clock's pace until the device ails or nobody is there."""
        clock, sleep, period = time.monotonic, time.sleep, self._period
        due = clock()
        orphaned_at = 0.0
        going = True
        while going:
            early = due - clock()
            if early > 0.0:
                sleep(early)
            now = clock()
            late = now - due
            if self._order.trial:
                self._cadence.count(late)
            going = self._turned(now)
            due += period
            if late > CATCHING_UP_S:
                due = now + period
            if orphaned():
                orphaned_at = orphaned_at or now
                going = going and now - orphaned_at < ORPHANED_S

    def _turned(self, now: float) -> bool:
        """Take orders, advance, tell; False once the device cannot be driven with any more."""
        self._turn += 1
        running = self._running
        try:
            self._obey()
            state = running.advance(self._order.hand)
        except OmnistudyError as mistake:
            self._tell(now, str(mistake))
            return False
        trial, opened = self._order.trial, self._order.opened
        if trial:
            for row in running.rows():
                self._ring.append((trial, self._rows, now - opened, *row))
                self._rows += 1
        self._state = state
        self._tell(now, running.trouble())
        return True

    def _obey(self) -> None:
        """Take what is new of the latest order."""
        latest = self._orders.read()
        if latest is not None and latest.number != self._seen:
            self._seen = latest.number
            before, self._order = self._order, self._order_layout.unpack(latest.data)
            order = self._order
            if order.trial and order.trial != before.trial:
                self._rows = 0
                self._before = self._running.health()
                self._cadence.begin(order.trial)
                self._running.wake()
            elif before.trial and not order.trial:
                self._running.rest()
            if order.fields != before.fields and order.trial:
                self._running.render(order.field)
        if not self._order.trial and self._turn % self._idle_turns == 1:
            self._running.render(NO_FORCE)

    def _tell(self, now: float, trouble: str) -> None:
        running = self._running
        if self._order.trial:
            self._health = running.health().since(self._before)
        report = Report(
            self._turn, now, self._order.trial, self._rows, self._health, self._state,
            running.values(), trouble,
        )  # fmt: skip
        self._reports.write(self._report_layout.pack(report))
