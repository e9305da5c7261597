"""The checks before force on a stick's own transport, as a session asks for them."""

from __future__ import annotations

from collections.abc import Callable

from omnistudy.channel import Measure
from omnistudy.devices.device import Identity
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.checks import check_before_force, findings, insist
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import PROTOCOL_VERSION
from omnistudy.devices.stick.messages import Identity as Told
from omnistudy.devices.stick.transport import Transport

DRIFTED = "The zero had drifted: what was driven since the last checks is in doubt."


def checked(
    transport: Transport,
    stick: SimulatedStick,
    tell: Callable[[str], None],
    expected: Identity | None,
) -> tuple[Measure, ...]:
    """Have a stick checked and give the findings to be stored; the transport is closed.

    expected : which stick it was before; another one gets no force.
    Raises ChecksFailed, and what the line raises.
    """
    try:
        known = None if expected is None else _as_told(expected)
        checks = insist(check_before_force(StickLine(transport), stick.stops, tell, known))
    finally:
        transport.close()
    if checks.drifted and expected is not None:
        tell(DRIFTED)
    return findings(checks)


def _as_told(identity: Identity) -> Told:
    return Told(PROTOCOL_VERSION, 0, int(identity.firmware, 16), int(identity.serial))
