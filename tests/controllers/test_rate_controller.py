"""From stick to twist as the published firmware does it, and about which point the robot turns."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.controllers import Control
from omnistudy.controllers.direct import DirectController
from omnistudy.controllers.rate import RateController
from omnistudy.devices import DeviceState
from omnistudy.geometry import PlanarTwist

COUNT = 0.095 * pi / 180 / 12
TURN_COUNT = pi / 180 / 4
NO_RATE = (0.0, 0.0, 0.0)


def asked(x: float = 0.0, y: float = 0.0, theta: float = 0.0) -> PlanarTwist:
    """The twist that a stick at so many encoder counts asks for."""
    return RateController().intent((x * COUNT, y * COUNT, theta * TURN_COUNT))


def command(controller: RateController, x: float, y: float, theta: float) -> Control:
    state = DeviceState((x * COUNT, y * COUNT, theta * TURN_COUNT), NO_RATE)
    return controller.control(state, None, None, None, 1 / 240)


@pytest.mark.parametrize(
    ("counts", "metres_per_second"),
    [(0, 0.0), (66, 0.0), (67, 0.0804), (100, 0.12), (300, 0.36), (301, 0.36), (5000, 0.36)],
)
def test_dead_zone_jumps_and_the_limit_holds(counts: int, metres_per_second: float) -> None:
    # 0.003 a count, nothing below 0.2, times 0.4: from 0.08 m/s at once to 0.36 m/s
    assert asked(x=counts).vx == pytest.approx(metres_per_second)
    assert asked(x=-counts).vx == pytest.approx(-metres_per_second)
    assert asked(y=counts).vy == pytest.approx(metres_per_second)
    assert asked(y=-counts).vy == pytest.approx(-metres_per_second)


@pytest.mark.parametrize(
    ("counts", "radians_per_second"),
    [(41, 0.0), (42, 0.2016), (100, 0.48), (250, 1.2), (251, 1.2), (1440, 1.2), (9000, 1.2)],
)
def test_turning_has_its_own_dead_zone_and_limit(counts: int, radians_per_second: float) -> None:
    # 0.012 a count, nothing below 0.5, clipped to 3, times 0.4: 0.2 to 1.2 rad/s
    assert asked(theta=counts).omega == pytest.approx(radians_per_second)
    assert asked(theta=-counts).omega == pytest.approx(-radians_per_second)


positions = st.tuples(st.floats(-0.1, 0.1), st.floats(-0.1, 0.1), st.floats(-7.0, 7.0))


@given(positions)
def test_either_nothing_or_between_the_published_extremes(
    position: tuple[float, float, float],
) -> None:
    vx, vy, omega = RateController().intent(position)
    for speed, least, most in ((vx, 0.08, 0.36), (vy, 0.08, 0.36), (omega, 0.2, 1.2)):
        assert speed == 0 or least - 1e-12 <= abs(speed) <= most + 1e-12


@given(positions)
def test_a_mirrored_stick_asks_for_the_mirrored_twist(
    position: tuple[float, float, float],
) -> None:
    x, y, theta = position
    vx, vy, omega = RateController().intent((x, y, theta))
    assert RateController().intent((x, -y, -theta)) == (vx, -vy, -omega)


@pytest.mark.parametrize("centre", [-0.10, 0.10, 0.20])
def test_the_compliance_centre_is_where_a_pure_twist_turns_the_robot(centre: float) -> None:
    result = command(RateController(compliance_centre=centre), 0, 0, 200)
    vx, vy, omega = result.command
    assert omega == pytest.approx(0.96)
    # the point (x, 0) of the robot moves with (vx, vy + omega·x): at rest at the centre
    assert (vx, vy + omega * centre) == pytest.approx((0.0, 0.0))


def test_the_compliance_centre_shifts_the_command_but_not_what_laws_damp() -> None:
    # vy -= omega·c
    result = command(RateController(compliance_centre=0.2), 100, 200, -250)
    assert result.intent == pytest.approx((0.12, 0.24, -1.2))
    assert result.command == pytest.approx((0.12, 0.24 + 1.2 * 0.2, -1.2))


def test_twist_per_stick_is_the_slope_between_dead_zone_and_limit() -> None:
    controller = RateController()
    slope = controller.twist_per_stick
    middle = (150 * COUNT, 150 * COUNT, 150 * TURN_COUNT)
    here = controller.intent(middle)
    for axis, step in enumerate((10 * COUNT, 10 * COUNT, 10 * TURN_COUNT)):
        moved = [value + (step if i == axis else 0.0) for i, value in enumerate(middle)]
        there = controller.intent(tuple(moved))
        for row in range(3):
            assert (there[row] - here[row]) / step == pytest.approx(slope[row][axis])
    assert slope[0][0] == pytest.approx(0.36 / 0.04145, rel=1e-3)


def test_direct_controller_hands_a_logged_twist_through() -> None:
    result = DirectController().control(DeviceState((0.2, -0.1, 0.4), NO_RATE), None, None, None, 1)
    assert result.command == result.intent == PlanarTwist(0.2, -0.1, 0.4)
    assert DirectController().twist_per_stick == ((1, 0, 0), (0, 1, 0), (0, 0, 1))
