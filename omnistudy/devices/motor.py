"""What the thesis's firmware lets reach a motor of feedback, centring and gravity compensation."""

from __future__ import annotations

from omnistudy.devices.stick_scale import FULL_DUTY


def motor_counts_as_published(
    force: float, centring: float, gravity: float, limit: float = FULL_DUTY
) -> float:
    """Give the net of the two pins as the firmware drives them (Tyagi 2017, App. B).

    Force and centring are split by sign, added per pin and each pin clipped to 0..255; gravity
    rides on the pin chosen by the sign of the centring effort, and what turns negative is lost.
    Ours adds signed and clips once (StickInMotion), so that never both pins of a pair are on.
    """
    plus = max(0.0, force) + max(0.0, centring)
    minus = max(0.0, -force) + max(0.0, -centring)
    if centring >= 0.0:
        plus += gravity
    else:
        minus -= gravity
    return max(0.0, min(limit, plus)) - max(0.0, min(limit, minus))
