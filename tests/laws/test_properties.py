"""What holds for laws in any scene: symmetry, centres, the order of rays, stiffness, zeros."""

from __future__ import annotations

from math import cos, pi, sin
from typing import Literal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from omnistudy.geometry import Matrix3, PlanarTwist, PlanarWrench, Scan
from omnistudy.laws import Sensed, WrenchLaw
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.laws.zero_torque import ZeroTorqueLaw

MAX_RANGE = 0.6


class Viscous(WrenchLaw):
    """A law that writes only its wrench; every part of the twist joins every part of that."""

    kind: Literal["viscous"] = "viscous"

    def wrench(self, scan: Scan, twist: PlanarTwist) -> PlanarWrench:
        vx, vy, omega = twist
        return PlanarWrench(
            1.0 - 2.0 * vx + 3.0 * vy - 5.0 * omega,
            7.0 * vx - 11.0 * vy + 13.0 * omega,
            float(scan.angles.size) - 17.0 * vx + 19.0 * vy - 23.0 * omega,
        )


LAWS = [ComponentLaw(), ComponentLaw(compliance_centre=0.2), ZeroTorqueLaw()]
NAMES = ["component", "moved_centre", "zero_torque"]
TORQUE_STIFFNESS = 2100 * 0.15 * 100 * 4.4 / 255
"""N·m/m², appendix B: gainQ = 2100·0.15 PWM per cm·m."""

any_law = pytest.mark.parametrize("law", LAWS, ids=NAMES)
angles = st.floats(-pi, pi, allow_subnormal=False)
centres = st.floats(-0.3, 0.3)
twists = st.builds(
    PlanarTwist, st.floats(-0.36, 0.36), st.floats(-0.36, 0.36), st.floats(-1.2, 1.2)
)
gradients = st.tuples(*[st.tuples(*[st.floats(-20.0, 20.0)] * 3)] * 3)


@st.composite
def scans(draw: st.DrawFn) -> Scan:
    """Any scene: rays at any angles, some of which meet something."""
    rays = draw(st.lists(st.tuples(angles, st.floats(0.05, 0.7)), max_size=24))
    return Scan(
        np.array([angle for angle, _ in rays]),
        np.array([min(distance, MAX_RANGE) for _, distance in rays]),
        MAX_RANGE,
    )


@any_law
@given(scan=scans(), twist=twists)
def test_what_is_mirrored_is_felt_mirrored(law: WrenchLaw, scan: Scan, twist: PlanarTwist) -> None:
    fx, fy, tau = law.wrench(scan, twist)
    other = law.wrench(scan.mirrored(), PlanarTwist(twist.vx, -twist.vy, -twist.omega))
    assert other == pytest.approx((fx, -fy, -tau), rel=1e-9, abs=1e-9)


@any_law
@given(scan=scans(), twist=twists, data=st.data())
def test_the_order_of_rays_is_nothing(
    law: WrenchLaw, scan: Scan, twist: PlanarTwist, data: st.DataObject
) -> None:
    order = data.draw(st.permutations(range(scan.angles.size)))
    turned = Scan(
        np.array([scan.angles[i] for i in order]),
        np.array([scan.ranges[i] for i in order]),
        MAX_RANGE,
    )
    assert law.wrench(turned, twist) == pytest.approx(law.wrench(scan, twist), rel=1e-9, abs=1e-9)


@given(scan=scans(), centre=centres)
def test_a_centre_ahead_adds_its_arm_times_the_sideways_mean(scan: Scan, centre: float) -> None:
    """tau(c) - tau(0) = ktheta·c·mean(py): moving ahead, what lies left turns less clockwise."""
    still = PlanarTwist(0.0, 0.0, 0.0)
    moved = ComponentLaw(compliance_centre=centre).wrench(scan, still)
    middle = ComponentLaw().wrench(scan, still)
    sideways = [
        (reach - distance) * sin(angle)
        for angle, distance in zip(scan.angles, scan.ranges, strict=True)
        if distance < (reach := _reach(angle)) and distance < MAX_RANGE
    ]
    mean = sum(sideways) / len(sideways) if sideways else 0.0
    assert moved.tau - middle.tau == pytest.approx(TORQUE_STIFFNESS * centre * mean, abs=1e-8)
    assert (moved.fx, moved.fy) == (middle.fx, middle.fy)


def _reach(angle: float) -> float:
    ahead = 0.44 / abs(cos(angle))
    return min(ahead, 0.31 / abs(sin(angle))) if sin(angle) else ahead


@pytest.mark.parametrize("law", [*LAWS, Viscous()], ids=[*NAMES, "viscous"])
@given(scan=scans(), twist=twists, gradient=gradients)
def test_stiffness_is_what_the_wrench_loses_as_the_stick_moves(
    law: WrenchLaw, scan: Scan, twist: PlanarTwist, gradient: Matrix3
) -> None:
    """Central differences over 1 mm or 1 mrad of stick."""
    per_stick = np.array(gradient)
    stick = (0.01, -0.02, 0.03)
    field = law.field(Sensed(scan, twist, gradient, stick))
    measured = np.column_stack(
        [
            (_wrench(law, scan, twist, -change) - _wrench(law, scan, twist, change)) / 2e-3
            for change in (per_stick * 1e-3).T
        ]
    )
    assert field.about == stick
    assert field.wrench == law.wrench(scan, twist)
    assert np.array(field.stiffness) == pytest.approx(measured, rel=1e-6, abs=1e-6)


def _wrench(
    law: WrenchLaw, scan: Scan, twist: PlanarTwist, change: NDArray[np.float64]
) -> NDArray[np.float64]:
    return np.array(law.wrench(scan, PlanarTwist(*(np.array(twist) + change))))


@given(scan=scans(), twist=twists, gradient=gradients)
def test_none_is_zero_bit_for_bit(scan: Scan, twist: PlanarTwist, gradient: Matrix3) -> None:
    field = NoLaw().field(Sensed(scan, twist, gradient))
    given_bits = np.array([field.wrench, *field.stiffness, *field.damping]).tobytes()
    assert given_bits == np.zeros(21).tobytes()


@given(scan=scans(), twist=twists)
def test_zero_torque_pushes_as_the_component_law_and_never_turns(
    scan: Scan, twist: PlanarTwist
) -> None:
    full = ComponentLaw().wrench(scan, twist)
    assert ZeroTorqueLaw().wrench(scan, twist) == PlanarWrench(full.fx, full.fy, 0.0)
