"""What holds for every kind of law in any scene: symmetry, order of rays, stiffness, zeros."""

from __future__ import annotations

from typing import Literal

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from laws.any_scene import gradients, scans, scans_from_around, sticks, twists
from laws.straight_walls import RAYS
from numpy.typing import NDArray

from omnistudy.geometry import (
    ZERO_MATRIX,
    ForceField,
    Matrix3,
    PlanarTwist,
    PlanarWrench,
    Scan,
    Vector3,
)
from omnistudy.laws import Law, Sensed, WrenchLaw
from omnistudy.laws.boundary import CircularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.impedance_kondo import ImpedanceKondoLaw
from omnistudy.laws.impedance_urbano import ImpedanceUrbanoLaw
from omnistudy.laws.none import NoLaw
from omnistudy.laws.quadrant import QuadrantLaw
from omnistudy.laws.quadrant_smoothed import QuadrantSmoothedLaw
from omnistudy.laws.sector_sum import SectorSumLaw
from omnistudy.laws.spring_damper import MomentStiffness, SpringDamperLaw
from omnistudy.laws.springs import SpringLaw, Stiffness
from omnistudy.laws.zero_torque import ZeroTorqueLaw
from omnistudy.registry import kinds, load_kind

sometimes = settings(max_examples=40)
"""Of each of some twenty laws; enough for a wrong sign to show hundreds of times."""

STILL = PlanarTwist(0.0, 0.0, 0.0)
NOTHING = Scan(np.array(RAYS), np.full(128, 0.6), 0.6)

MIRROR = np.diag([1.0, -1.0, -1.0])
HALF_TURN = np.diag([-1.0, -1.0, 1.0])

LOOKS_AHEAD = {"infrared": "its sensors look ahead and aside, none behind"}
"""Kinds to which a scene behind is another than ahead, and why."""

HOLDS_THE_STICK = {
    "impedance_urbano": "its spring to the stick's zero has K0·(1 + alpha) left far from anything",
    "impedance_kondo": "its spring to the stick's zero has K0·(1 + alpha) left far from anything",
}
"""Kinds whose field is not zero where nothing is near, and why; none pushes a stick at zero."""

SECTOR = 8
"""Rays in a sector of the sector sum's 16."""


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


def _laws() -> dict[str, Law]:
    """Every kind as it comes, and over a circle where it has a boundary."""
    found: dict[str, Law] = {}
    for kind in kinds("laws"):
        law = load_kind("laws", kind)
        found[kind] = law()
        if "boundary" in law.model_fields:
            found[f"{kind}, circular"] = law(boundary=CircularBoundary())
    return found


LAWS = _laws()
MOVED = {
    "component, moved centre": ComponentLaw(compliance_centre=0.2),
    "spring_damper, moved centre": SpringDamperLaw(compliance_centre=0.2),
}
WRENCH_LAWS = {name: law for name, law in LAWS.items() if isinstance(law, WrenchLaw)}
OTHER_LAWS = {name: law for name, law in LAWS.items() if name not in WRENCH_LAWS}


def each(laws: dict[str, Law]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("law", laws.values(), ids=laws.keys())


def changed(sensed: Sensed, scan: Scan, change: NDArray[np.float64]) -> Sensed:
    """Give what is sensed of a scene seen through a mirror or from another side."""
    return Sensed(
        scan,
        PlanarTwist(*change @ sensed.twist),
        _matrix(change @ np.array(sensed.twist_per_stick) @ change.T),
        _vector(change @ sensed.stick),
        _vector(change @ sensed.stick_rate),
    )


def assert_changed(after: ForceField, before: ForceField, change: NDArray[np.float64]) -> None:
    """Assert that every part of a field is that of another, seen as `change` has it."""
    near = {"rel": 1e-9, "abs": 1e-9}
    assert after.wrench == pytest.approx(tuple(change @ before.wrench), **near)
    assert after.about == pytest.approx(tuple(change @ before.about), **near)
    for part in ("stiffness", "damping"):
        expected = change @ np.array(getattr(before, part)) @ change.T
        assert np.array(getattr(after, part)) == pytest.approx(expected, **near)
    assert after.valid_for == before.valid_for


@each(LAWS | MOVED)
@sometimes
@given(sensed=st.builds(Sensed, scans(), twists, gradients, sticks, sticks))
def test_what_is_mirrored_is_felt_mirrored(law: Law, sensed: Sensed) -> None:
    mirrored = changed(sensed, sensed.scan.mirrored(), MIRROR)
    assert_changed(law.field(mirrored), law.field(sensed), MIRROR)


@each(LAWS | MOVED)
@sometimes
@given(sensed=st.builds(Sensed, scans_from_around(), twists, gradients, sticks, sticks))
def test_what_sensors_round_the_robot_see_mirrored_is_felt_mirrored(
    law: Law, sensed: Sensed
) -> None:
    mirrored = changed(sensed, sensed.scan.mirrored(), MIRROR)
    assert_changed(law.field(mirrored), law.field(sensed), MIRROR)


@each({name: law for name, law in LAWS.items() if law.kind not in LOOKS_AHEAD})
@sometimes
@given(sensed=st.builds(Sensed, scans(), twists, gradients, sticks, sticks))
def test_what_is_turned_half_round_is_felt_half_round(law: Law, sensed: Sensed) -> None:
    """Rectangle and circle look the same from behind, with the compliance centre in the middle."""
    assume(not on_an_edge(law, sensed))
    behind = changed(sensed, turned(sensed.scan, np.pi), HALF_TURN)
    assert_changed(law.field(behind), law.field(sensed), HALF_TURN)


def turned(scan: Scan, angle: float) -> Scan:
    return Scan(scan.angles + angle, scan.ranges, scan.max_range)


def on_an_edge(law: Law, sensed: Sensed) -> bool:
    """Tell whether rounding an angle would put something in or out of what a law looks at."""
    sides = [law.field(sensed._replace(scan=turned(sensed.scan, by))) for by in (-1e-9, 1e-9)]
    return not np.allclose(_numbers(sides[0]), _numbers(sides[1]), rtol=1e-5, atol=1e-5)


@each(MOVED)
@sometimes
@given(scan=scans())
def test_half_round_a_centre_ahead_is_one_behind(
    law: ComponentLaw | SpringDamperLaw, scan: Scan
) -> None:
    fx, fy, tau = law.wrench(scan, STILL)
    behind = law.model_copy(update={"compliance_centre": -law.compliance_centre})
    assert behind.wrench(turned(scan, np.pi), STILL) == pytest.approx(
        (-fx, -fy, tau), rel=1e-9, abs=1e-9
    )


EQUAL = {"boundary": CircularBoundary(), "stiffness": Stiffness(x=150.0, y=150.0)}
ROUND: dict[str, Law] = {
    "zero_torque": ZeroTorqueLaw.model_validate(EQUAL),
    "spring_damper": SpringDamperLaw(
        boundary=CircularBoundary(),
        stiffness=MomentStiffness(x=150.0, y=150.0, theta_x=500.0, theta_y=500.0),
    ),
    "impedance_urbano": ImpedanceUrbanoLaw(boundary=CircularBoundary()),
    "impedance_kondo": ImpedanceKondoLaw(
        boundary=CircularBoundary(), half_length=0.3, half_width=0.3
    ),
}
"""Laws that know no front: a circle and equal gains."""

FOURFOLD: dict[str, Law] = {
    "component": ComponentLaw.model_validate(
        {"boundary": CircularBoundary(), "stiffness": {"x": 150.0, "y": 150.0}}
    ),
    "spring_damper": SpringDamperLaw(
        boundary=CircularBoundary(), stiffness=MomentStiffness(x=150.0, y=150.0)
    ),
    "quadrant": QuadrantLaw.model_validate(EQUAL),
    "quadrant_smoothed": QuadrantSmoothedLaw.model_validate(EQUAL),
}
"""Laws whose force knows no front there, but whose torque knows x from y."""


@each(ROUND)
@sometimes
@given(
    sensed=st.builds(Sensed, scans(), twists, gradients, sticks, sticks), rays=st.integers(0, 127)
)
def test_over_a_circle_with_equal_gains_the_field_turns_with_the_scene(
    law: Law, sensed: Sensed, rays: int
) -> None:
    if isinstance(law, SpringLaw):
        # Its dampers join axis by axis, which is a front.
        sensed = sensed._replace(twist=STILL, twist_per_stick=ZERO_MATRIX)
    assume(not on_an_edge(law, sensed))
    angle = rays * np.pi / 64
    there = changed(sensed, turned(sensed.scan, angle), _turn(angle))
    assert_changed(law.field(there), law.field(sensed), _turn(angle))


@given(sensed=st.builds(Sensed, scans(), twists, gradients), sectors=st.integers(0, 15))
def test_the_sector_sum_turns_with_the_scene_by_whole_sectors(sensed: Sensed, sectors: int) -> None:
    law = SectorSumLaw(boundary=CircularBoundary())
    assume(not on_an_edge(law, sensed))
    angle = sectors * SECTOR * np.pi / 64
    there = law.wrench(turned(sensed.scan, angle), sensed.twist)
    here = law.wrench(sensed.scan, sensed.twist)
    assert there == pytest.approx(tuple(_turn(angle) @ here), rel=1e-9, abs=1e-9)


@each(FOURFOLD)
@sometimes
@given(scan=scans(), quarters=st.integers(0, 3))
def test_a_quarter_turn_of_the_scene_reverses_a_torque_that_knows_x_from_y(
    law: SpringLaw, scan: Scan, quarters: int
) -> None:
    angle = quarters * np.pi / 2
    fx, fy, tau = _turn(angle) @ law.wrench(scan, STILL)
    there = law.wrench(turned(scan, angle), STILL)
    assert there == pytest.approx((fx, fy, tau * (-1) ** quarters), rel=1e-9, abs=1e-9)


def _turn(angle: float) -> NDArray[np.float64]:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])


@each(LAWS | MOVED)
@sometimes
@given(sensed=st.builds(Sensed, scans(), twists, gradients, sticks, sticks), data=st.data())
def test_the_order_of_rays_is_nothing(law: Law, sensed: Sensed, data: st.DataObject) -> None:
    scan = sensed.scan
    order = data.draw(st.permutations(range(scan.angles.size)))
    shuffled = Scan(scan.angles[order], scan.ranges[order], scan.max_range)
    assert_changed(law.field(sensed._replace(scan=shuffled)), law.field(sensed), np.eye(3))


@each(WRENCH_LAWS | MOVED | {"viscous": Viscous()})
@sometimes
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


@each(OTHER_LAWS)
@sometimes
@given(sensed=st.builds(Sensed, scans(), twists, gradients, sticks, sticks), moved=sticks)
def test_a_field_of_its_own_is_what_the_law_gives_where_the_stick_goes(
    law: Law, sensed: Sensed, moved: Vector3
) -> None:
    """With what the stick asks for held until the next scan, as these laws hold it."""
    field, there = law.field(sensed), law.field(sensed._replace(stick=moved))
    predicted = field.wrench - np.array(field.stiffness) @ np.subtract(moved, field.about)
    assert there.wrench == pytest.approx(tuple(predicted), rel=1e-9, abs=1e-9)
    assert np.linalg.eigvalsh(np.array(field.damping)).min() >= 0.0


@each({name: law for name, law in LAWS.items() if law.kind not in HOLDS_THE_STICK} | MOVED)
@sometimes
@given(twist=twists, gradient=gradients, stick=sticks, rate=sticks)
def test_where_nothing_is_near_a_law_gives_zeros_to_the_last_bit(
    law: Law, twist: PlanarTwist, gradient: Matrix3, stick: Vector3, rate: Vector3
) -> None:
    field = law.field(Sensed(NOTHING, twist, gradient, stick, rate))
    assert _numbers(field).tobytes() == np.zeros(21).tobytes()


@each({name: law for name, law in LAWS.items() if law.kind in HOLDS_THE_STICK})
@sometimes
@given(twist=twists, gradient=gradients, rate=sticks)
def test_where_nothing_is_near_no_law_pushes_a_stick_at_zero(
    law: Law, twist: PlanarTwist, gradient: Matrix3, rate: Vector3
) -> None:
    sensed = Sensed(NOTHING, twist, gradient, stick_rate=rate)
    assert np.array(law.field(sensed).wrench).tobytes() == np.zeros(3).tobytes()


@given(sensed=st.builds(Sensed, scans(), twists, gradients))
def test_none_gives_zeros_to_the_last_bit(sensed: Sensed) -> None:
    assert _numbers(NoLaw().field(sensed)).tobytes() == np.zeros(21).tobytes()


def _numbers(field: ForceField) -> NDArray[np.float64]:
    return np.array([field.wrench, *field.stiffness, *field.damping]).ravel()


@given(scan=scans(), twist=twists)
def test_zero_torque_pushes_as_the_component_law_and_never_turns(
    scan: Scan, twist: PlanarTwist
) -> None:
    full = ComponentLaw().wrench(scan, twist)
    assert ZeroTorqueLaw().wrench(scan, twist) == PlanarWrench(full.fx, full.fy, 0.0)


def _vector(values: NDArray[np.float64]) -> Vector3:
    x, y, theta = map(float, values)
    return x, y, theta


def _matrix(values: NDArray[np.float64]) -> Matrix3:
    x, y, theta = map(_vector, values)
    return x, y, theta
