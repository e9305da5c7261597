"""Numbers that Linux and SDL share for effects: times in ms, levels of 15 bits, directions."""

from __future__ import annotations

from math import atan2, degrees, hypot
from typing import NamedTuple

from omnistudy.devices.handheld.force_effects import AxisEffect, ForceEffects

FULL_LEVEL = 0x7FFF
FULL_SATURATION = 0xFFFF
LONGEST_MS = 0x7FFF
"""Linux refuses longer effects."""


class Push(NamedTuple):
    """A constant force. Level 0 to 0x7FFF.

    pulls_to : degrees from towards the user, by the left: 0 user, 90 left, 180 away, 270 right.
        Linux codes it as 0 to 0xFFFF and means where the force pulls to; SDL codes it in hundredths
        of a degree and means where it comes from, counted from away by the right: the same number.
    """

    level: int
    pulls_to: float


class Condition(NamedTuple):
    """A spring or a damper along one axis: coefficient 0 to 0x7FFF, centre -0x7FFF to 0x7FFF."""

    coefficient: int
    centre: int = 0


class EffectShape(NamedTuple):
    """A push, and a spring and a damper for each of the axes X and Y.

    valid_ms : how long spring and damper act; the push fades over as long again.
    """

    push: Push
    spring: tuple[Condition, Condition]
    damper: tuple[Condition, Condition]
    valid_ms: int


def shape_of(effects: ForceEffects, turned: bool = False) -> EffectShape:
    """Give the numbers of effects; X rises to the right and Y to the user, as drivers have it.

    turned : for a driver that takes a push's direction the other way round.
    """
    x, y = effects.x, effects.y
    away = -1.0 if turned else 1.0
    size = min(1.0, hypot(x.push, y.push))
    return EffectShape(
        Push(
            round(FULL_LEVEL * size),
            degrees(atan2(-away * x.push, away * y.push)) % 360.0 if size else 0.0,
        ),
        (_spring(x), _spring(y)),
        (Condition(round(FULL_LEVEL * x.damper)), Condition(round(FULL_LEVEL * y.damper))),
        max(1, min(LONGEST_MS // 2, round(1000.0 * effects.seconds))),
    )


def _spring(effect: AxisEffect) -> Condition:
    return Condition(round(FULL_LEVEL * effect.spring), round(FULL_LEVEL * effect.centre))
