"""Leads a person through pushes of a bought stick while an instrument is read."""

from __future__ import annotations

import time
from collections.abc import Callable
from datetime import date
from typing import NamedTuple

from omnistudy.devices.device import NO_HAND, Identity
from omnistudy.devices.handheld.force_scale import (
    FullForce,
    Push,
    PushRead,
    full_force,
    measured,
    pushes,
)
from omnistudy.devices.handheld.handheld import Handheld, RunningHandheld
from omnistudy.errors.handheld import NoMotors, Unplugged
from omnistudy.geometry import NO_FORCE, ForceField, PlanarWrench

PUSH_S = 3.0
"""How long each push lasts; by itself it ends soon after, whatever becomes of us (ours)."""

Lead = Callable[[Push], None]
"""Shows which push comes, and returns when the person is ready."""
Read = Callable[[Push], float]
"""Gives what the instrument read, N."""


class ForceMeasured(NamedTuple):
    """A device whose force was measured."""

    device: Handheld
    identity: Identity
    found: FullForce


def measure_force(
    device: Handheld, levels: int, instrument: str, lead: Lead, read: Read
) -> ForceMeasured:
    """Push each way in `levels` steps along each axis that has a motor, and fit what was read.

    Raises NoMotors, Unplugged, NoForceFelt, and what opening it raises.
    """
    strength = device.rendered
    if strength is None:
        raise NoMotors(device.kind)
    whole = device.model_copy(update={"strength": strength.model_copy(update={"gain": 1.0})})
    running = whole.connect(device.tick_hz)
    try:
        running.advance(NO_HAND)
        if not any(running.forces):
            raise NoMotors(device.kind)
        axes = [axis for axis in (0, 1) if running.forces[axis]]
        reads = []
        for push in pushes(axes, levels):
            lead(push)
            _push(running, push, strength.force, device.tick_hz)
            reads.append(PushRead(push, read(push)))
        identity = running.identity()
    finally:
        running.close()
    found = full_force(reads, strength.turned)
    said = f"{date.today().isoformat()}, {instrument}"
    changed = {"strength": measured(strength, found, said), "serial": identity.serial}
    return ForceMeasured(device.model_copy(update=changed), identity, found)


def _push(running: RunningHandheld, push: Push, full: float, tick_hz: int) -> None:
    wrench = [0.0, 0.0]
    wrench[push.axis] = push.share * full
    running.render(ForceField(PlanarWrench(wrench[0], wrench[1], 0.0), valid_for=PUSH_S))
    for _ in range(round(PUSH_S * tick_hz)):
        running.advance(NO_HAND)
        time.sleep(1.0 / tick_hz)
    running.render(NO_FORCE)
    if running.trouble():
        raise Unplugged(running.trouble())
