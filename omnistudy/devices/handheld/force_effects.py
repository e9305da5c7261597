"""A law's force field as the effects that force-feedback devices know: push, spring, damper.

A device renders a spring and a damper itself, at its own rate, along each of its axes alone.
Whatever else the field says (coupling between axes, negative or too much stiffness) goes into the
push, as it is at the moment of rendering; too much or negative damping is left out.
"""

from __future__ import annotations

from math import hypot
from typing import Annotated, NamedTuple

from pydantic import Field

from omnistudy.geometry import ForceField
from omnistudy.registry import Model
from omnistudy.units import MetresPerSecond, Newtons, Positive, Ratio


class Strength(Model):
    """What the strongest effect of a device is at the handle; drivers do not tell."""

    force: Annotated[Newtons, Positive] = 5.0
    """Force of a full effect; nominal (ours) until it is measured, see the page on devices."""
    speed: Annotated[MetresPerSecond, Positive] = 0.2
    """Handle speed at which a full damper gives the full force; nominal (ours)."""
    gain: Annotated[Ratio, Field(ge=0, le=1)] = 1.0
    """Part of the law's field that is rendered."""
    turned: bool = False
    """For a driver that takes a push's direction the other way round; springs know no direction."""
    measured: str = ""
    """When and with what `force` was measured; the data call the force nominal without."""


class Lever(NamedTuple):
    """An axis with a motor: which axis of the stick it is (0 x, 1 y), which way, how far it goes.

    sign : -1 when the device's numbers fall while the stick's rise.
    travel : m of the stick at the device's end.
    """

    axis: int
    sign: int
    travel: float


class AxisEffect(NamedTuple):
    """Shares of the full effect along one axis of the device, in its own direction.

    push : -1 to 1. spring : of the full force at full deflection, 0 to 1, about `centre` (-1 to 1).
    damper : 0 to 1.
    """

    push: float = 0.0
    spring: float = 0.0
    centre: float = 0.0
    damper: float = 0.0


class ForceEffects(NamedTuple):
    """Effects along the device's axes X and Y, to be left alone after `seconds`."""

    x: AxisEffect
    y: AxisEffect
    seconds: float


NO_EFFECT = AxisEffect()
NO_EFFECTS = ForceEffects(NO_EFFECT, NO_EFFECT, 0.0)


def effects_of(
    field: ForceField,
    position: tuple[float, ...],
    levers: tuple[Lever | None, Lever | None],
    strength: Strength,
    springs: bool = True,
    dampers: bool = True,
) -> ForceEffects:
    """Give the effects that make a field felt with the stick at `position` (m, m, rad)."""
    x, y = (
        _along(lever, field, position, strength, springs, dampers) if lever else NO_EFFECT
        for lever in levers
    )
    size = hypot(x.push, y.push)
    if size > 1.0:
        x, y = x._replace(push=x.push / size), y._replace(push=y.push / size)
    return ForceEffects(x, y, field.valid_for)


def _along(
    lever: Lever,
    field: ForceField,
    position: tuple[float, ...],
    strength: Strength,
    springs: bool,
    dampers: bool,
) -> AxisEffect:
    i, sign, travel = lever
    full = strength.force / strength.gain if strength.gain else float("inf")
    stiffness = field.stiffness[i]
    spring = max(0.0, min(1.0, stiffness[i] * travel / full)) if springs else 0.0
    damper = max(0.0, min(1.0, field.damping[i][i] * strength.speed / full)) if dampers else 0.0
    centre = max(-1.0, min(1.0, field.about[i] / travel))
    away = zip(stiffness, position, field.about, strict=True)
    force = field.wrench[i] - sum(k * (q - about) for k, q, about in away)
    push = force / full + spring * (position[i] / travel - centre)
    return AxisEffect(sign * push, spring, sign * centre, damper)


def force_of(
    effects: ForceEffects,
    position: tuple[float, ...],
    rate: tuple[float, ...],
    age: float,
    levers: tuple[Lever | None, Lever | None],
    strength: Strength,
) -> tuple[float, float]:
    """Give the force in x and y of the stick, N, that effects of that age (s) were told to make.

    Spring and damper end when the effects are stale; the push fades over as long again.
    """
    force = [0.0, 0.0]
    fresh = age <= effects.seconds
    left = 1.0 if fresh else max(0.0, 2.0 - age / effects.seconds) if effects.seconds else 0.0
    for effect, lever in zip((effects.x, effects.y), levers, strict=True):
        if lever is None:
            continue
        share = left * effect.push
        if fresh:
            share -= effect.spring * (
                lever.sign * position[lever.axis] / lever.travel - effect.centre
            )
            share -= effect.damper * lever.sign * rate[lever.axis] / strength.speed
        force[lever.axis] = lever.sign * strength.force * max(-1.0, min(1.0, share))
    return force[0], force[1]
