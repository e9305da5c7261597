"""What reaches a motor when feedback, centring and gravity compensation meet in it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.motor import motor_counts_as_published


def test_the_published_pins_lose_force_that_is_opposed() -> None:
    # plus pin 300 -> 255, minus pin 100: 155, where a signed sum would give 200
    assert motor_counts_as_published(300, -100, 0) == 155
    assert motor_counts_as_published(-300, 100, 0) == -155


@pytest.mark.parametrize(
    ("force", "centring", "gravity", "net"),
    [
        (0, -50, -40, -90),  # leaning forward: both pull back, on the minus pin
        (100, -50, -40, 10),  # and feedback pushes forward, on the plus pin
        (0, 10, -50, 0),  # the plus pin would be -40: the compensation is lost
        (0, -10, 50, 0),  # the minus pin would be -40: lost too
        (0, 0, -30, 0),  # no centring effort counts as plus, where a pull back is lost
        (0, 0, 30, 30),
        (200, 100, 0, 255),
    ],
)
def test_gravity_rides_on_the_pin_of_the_centring_effort(
    force: float, centring: float, gravity: float, net: float
) -> None:
    assert motor_counts_as_published(force, centring, gravity) == net


counts = st.floats(-1e4, 1e4)


@given(counts, counts, counts)
def test_no_motor_gets_more_than_full_duty(force: float, centring: float, gravity: float) -> None:
    assert abs(motor_counts_as_published(force, centring, gravity)) <= 255


small = st.floats(-100, 100)


@given(small, small)
def test_without_gravity_and_clipping_the_two_ways_agree(force: float, centring: float) -> None:
    published = motor_counts_as_published(force, centring, 0.0)
    assert published == pytest.approx(force + centring, abs=1e-12)
