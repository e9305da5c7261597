"""What the stick pushes by itself, without any field."""

from __future__ import annotations

from math import radians, sin

import numpy as np
import pytest

from omnistudy.devices import Hand
from omnistudy.devices.direct import DirectDevice
from omnistudy.devices.simulated_stick import SimulatedStick

STICK = SimulatedStick()


def test_a_still_centred_stick_pushes_nothing() -> None:
    assert (STICK.own_force(np.zeros((1, 3)), np.zeros((1, 3))) == 0.0).all()


def test_centring_and_weight_at_one_degree() -> None:
    """0.7 PWM counts a motor degree, 12 encoder counts of a quarter degree a handle degree; the
    weight's compensation adds 100 counts times the sine of the handle's angle (App. B)."""
    position = np.array([[0.095 * radians(1.0), 0.0, 0.0]])
    counts = 0.7 * 12 * 0.25 + 100.0 * sin(radians(1.0))
    force = STICK.own_force(position, np.zeros((1, 3)))
    assert force[0] == pytest.approx([-counts * 13.5 / 255.0, 0.0, 0.0])


def test_it_is_clipped_as_the_motors_are() -> None:
    force = STICK.own_force(np.full((1, 3), 10.0), np.full((1, 3), -1000.0))
    assert force[0] == pytest.approx([13.5, 13.5, 4.4])


@pytest.mark.parametrize("as_published", [False, True])
def test_it_is_what_the_motors_give_when_no_field_is_rendered(as_published: bool) -> None:
    stick = SimulatedStick(as_published=as_published)
    running = stick.connect(240)
    hand = Hand((0.02, -0.01, 0.3), (300.0, 300.0, 3.0), (20.0, 20.0, 0.2), (1.0, 1.0, 0.01))
    for _ in range(2400):
        state = running.advance(hand)
    own = stick.own_force(np.array([state.position]), np.zeros((1, 3)))
    # The position is told in whole encoder counts.
    assert own[0] == pytest.approx(running.values(), abs=0.02)
    assert abs(own[0]).min() > 0.1


def test_a_device_without_motors_pushes_nothing() -> None:
    assert (DirectDevice().own_force(np.ones((2, 3)), np.ones((2, 3))) == 0.0).all()
