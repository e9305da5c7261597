"""Finds the greatest force that somebody wants to meet, before the first trial.

A force rises on each axis until the person lets go of the dead-man's switch, which also ends it.
"""

from __future__ import annotations

from collections.abc import Callable

from omnistudy.devices.stick.ceiling import Ceiling
from omnistudy.devices.stick.check import LATCHING
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Fault, Sign, State, Three
from omnistudy.devices.stick.motions import (
    NONE,
    RENEWAL,
    SLOWLY,
    SOFT_START,
    along,
    device_field,
    heard_now,
)
from omnistudy.devices.stick.watch import AXES
from omnistudy.errors.stick_checks import ForceGone, NobodyHeld

RISE = 12.75
"""PWM steps a second: full duty in 20 s, 0.7 N/s nominal (ours)."""
SHARE = 0.8
"""Of the force at which somebody let go, that becomes the ceiling: deciding took time (ours)."""
FIRST = 19
"""PWM steps, 1 N nominal, below which nobody's ceiling is set: nothing would be felt (ours)."""
PATIENCE = 60.0
"""s to take hold again (ours)."""


def find_ceiling(
    line: StickLine,
    per_duty: tuple[float, float, float],
    protocol: Ceiling,
    tell: Callable[[str], None],
    patience: float = PATIENCE,
) -> Ceiling:
    """Let a force rise on each axis, to the protocol's ceiling at most; give the person's.

    per_duty : N, N, N·m of a PWM step. tell : shows a sentence to whoever leads the session.
    Raises NobodyHeld, ForceGone, Refused, NoAnswer, NoTelemetry.
    """
    settings = line.configuration()
    x, y, theta = (
        min(pair) for pair in zip(settings.force_limit, protocol.duties(per_duty), strict=True)
    )
    most: Three = (x, y, theta)
    line.disarm()
    line.configure(
        settings._replace(
            centring_stiffness=NONE, centring_damping=NONE, force_limit=most, soft_start=SOFT_START
        )
    )
    try:
        found = [_rise(line, axis, most[axis], tell, patience) for axis in range(3)]
    finally:
        line.disarm()
        line.configure(settings)
    forces = [
        limit if duty is None else max(FIRST, SHARE * duty) * step
        for duty, step, limit in zip(found, per_duty, protocol.forces, strict=True)
    ]
    return Ceiling(x=forces[0], y=forces[1], theta=forces[2]).under(protocol)


def _rise(
    line: StickLine, axis: int, most: int, tell: Callable[[str], None], patience: float
) -> float | None:
    """Raise the force of an axis; give the PWM steps at which it was let go; None: not at all."""
    tell(
        f"Hold the handle and the dead-man's switch: a force in {AXES[axis]} rises. Let go of the "
        "switch when it is as strong as you want it ever to be."
    )
    _wait_for_hold(line, patience)
    line.arm()
    push = 0.0
    while push < most:
        push = min(float(most), push + RISE * RENEWAL)
        line.send(device_field(wrench=along(axis, push), damping=SLOWLY))
        last = heard_now(line, RENEWAL)[-1]
        if last.state == State.FAULT:
            raise ForceGone(State.FAULT.name, Fault(last.faults).name or "no fault")
        if last.state == State.IDLE:
            return push
    line.disarm()
    return None


def _wait_for_hold(line: StickLine, patience: float) -> None:
    end = line.transport.now() + patience
    while line.transport.now() < end:
        last = heard_now(line, RENEWAL)[-1]
        if last.faults & LATCHING:
            line.clear_faults()
        elif last.signs & Sign.HELD:
            return
    raise NobodyHeld(patience)
