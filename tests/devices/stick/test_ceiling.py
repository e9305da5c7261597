"""A personal ceiling: never above the protocol's, never exceeded, whatever a law asks."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices import DeviceState
from omnistudy.devices.stick.ceiling import NO_CEILING, Ceiling
from omnistudy.geometry import ForceField, PlanarWrench

numbers = st.floats(-50.0, 50.0)
triples = st.tuples(numbers, numbers, numbers)
matrices = st.tuples(triples, triples, triples)
places = st.tuples(*[st.floats(-0.05, 0.05)] * 3)
heights = st.floats(0.1, 13.0)


def felt(field: ForceField, state: DeviceState) -> list[float]:
    return [
        field.wrench[i]
        - sum(field.stiffness[i][j] * (state.position[j] - field.about[j]) for j in range(3))
        - sum(field.damping[i][j] * state.rate[j] for j in range(3))
        for i in range(3)
    ]


@given(triples, places, matrices, matrices, places, places, st.tuples(heights, heights, heights))
def test_no_axis_exceeds_it_and_none_changes_its_way(
    wrench: tuple[float, float, float],
    about: tuple[float, float, float],
    stiffness: tuple[tuple[float, float, float], ...],
    damping: tuple[tuple[float, float, float], ...],
    position: tuple[float, float, float],
    rate: tuple[float, float, float],
    most: tuple[float, float, float],
) -> None:
    ceiling = Ceiling(x=most[0], y=most[1], theta=min(most[2], 4.4))
    state = DeviceState(position, rate)
    field = ForceField(PlanarWrench(*wrench), about, stiffness, damping)  # type: ignore[arg-type]
    for before, after, limit in zip(
        felt(field, state), felt(ceiling.bound(field, state), state), ceiling.forces, strict=True
    ):
        assert abs(after) <= limit * (1 + 1e-9)
        assert after == pytest.approx(max(-limit, min(limit, before)), abs=1e-9)


def test_what_is_below_it_stays_as_it_is() -> None:
    field = ForceField(PlanarWrench(3.0, 0.0, 0.0))
    assert Ceiling(x=4.0).bound(field, DeviceState((0.0,) * 3, (0.0,) * 3)) is field


def test_a_person_s_ceiling_never_rises_above_the_protocol_s() -> None:
    protocol, person = Ceiling(x=8.0, y=8.0, theta=2.0), Ceiling(x=5.0, y=12.0, theta=2.5)
    assert person.under(protocol) == Ceiling(x=5.0, y=8.0, theta=2.0)


def test_pwm_steps_stay_below_it() -> None:
    # 13.5 N are 255 steps: 5 N are 94.4 of them.
    per_duty = (13.5 / 255, 13.5 / 255, 4.4 / 255)
    assert Ceiling(x=5.0, y=13.5, theta=1.0).duties(per_duty) == (94, 255, 57)
    assert NO_CEILING.duties(per_duty) == (255, 255, 255)
