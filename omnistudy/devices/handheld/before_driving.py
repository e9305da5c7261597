"""What must be so before a bought device is driven with: the same one as before, at rest."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from omnistudy.channel import Measure
from omnistudy.devices.device import NO_HAND, Identity
from omnistudy.errors.handheld import AnotherDevice, NotAtRest

if TYPE_CHECKING:
    from omnistudy.devices.handheld.handheld import Handheld, RunningHandheld

LET_GO = "Let go of the device until driving begins."
RESTS_S = 0.3
"""How long it must rest without a break (ours)."""
AT_REST = 0.1
"""Part of the way that still counts as rest: a device that is not calibrated is off a little
(ours)."""
PATIENCE_S = 60.0
"""How long somebody may take to let go (ours)."""


def checked(
    device: Handheld, tell: Callable[[str], None], expected: Identity | None
) -> tuple[Measure, ...]:
    """Make sure which device it is and that it rests; it gives no force meanwhile.

    expected : which device it was before trouble. Raises AnotherDevice, NotAtRest, and what opening
    it raises.
    """
    running = device.connect(device.tick_hz)
    try:
        running.advance(NO_HAND)
        found = running.identity()
        if expected is not None and (found.model, found.serial) != (
            expected.model,
            expected.serial,
        ):
            raise AnotherDevice(expected.model, expected.serial, found.model, found.serial)
        if not _comes_to_rest(device, running, RESTS_S):
            tell(LET_GO)
            if not _comes_to_rest(device, running, PATIENCE_S):
                raise NotAtRest(PATIENCE_S)
    finally:
        running.close()
    return (Measure("check_identity", 1.0, "1"), Measure("check_rest", 1.0, "1"))


def _comes_to_rest(device: Handheld, running: RunningHandheld, within_s: float) -> bool:
    """Tell whether it rests for long enough within that time."""
    travel = (device.travel.x, device.travel.y, device.travel.theta)
    wanted, rested = round(RESTS_S * device.tick_hz), 0
    for _ in range(max(wanted, round(within_s * device.tick_hz))):
        position = running.advance(NO_HAND).position
        still = all(abs(q) <= AT_REST * full for q, full in zip(position, travel, strict=True))
        rested = rested + 1 if still else 0
        if rested >= wanted:
            return True
        time.sleep(1.0 / device.tick_hz)
    return False
