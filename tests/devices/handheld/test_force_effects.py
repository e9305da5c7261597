"""A force field as push, springs and dampers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.handheld.axes import Travel
from omnistudy.devices.handheld.effect_shape import FULL_LEVEL, shape_of
from omnistudy.devices.handheld.force_effects import (
    Lever,
    Strength,
    effects_of,
    force_of,
)
from omnistudy.geometry import ForceField, PlanarWrench

FULL = Travel()
# A stick as Linux has it: X to the right is y the other way, Y to the user is x the other way.
LEVERS = (Lever(1, -1, FULL.y), Lever(0, -1, FULL.x))
STRONG = Strength(force=1e6, speed=1.0)
REST = (0.0, 0.0, 0.0)

entry = st.floats(-1e3, 1e3)
stiff = st.floats(0.0, 1e3)
places = st.tuples(st.floats(-0.04, 0.04), st.floats(-0.04, 0.04), st.floats(-1.0, 1.0))


@given(st.tuples(entry, entry), stiff, stiff, entry, places, places)
def test_a_strong_stick_renders_the_field_itself(
    wrench: tuple[float, float],
    along: float,
    across: float,
    coupling: float,
    about: tuple[float, float, float],
    position: tuple[float, float, float],
) -> None:
    stiffness = ((along, coupling, 1.0), (-coupling, across, 2.0), (0.0, 0.0, 0.0))
    field = ForceField(PlanarWrench(*wrench, 0.0), about, stiffness)
    effects = effects_of(field, position, LEVERS, STRONG)
    wanted = np.array([*wrench, 0.0]) - np.array(stiffness) @ np.subtract(position, about)
    assert force_of(effects, position, REST, 0.0, LEVERS, STRONG) == pytest.approx(
        tuple(wanted[:2]), abs=1e-6
    )


def test_between_two_fields_the_stick_s_own_spring_and_damper_go_on() -> None:
    field = ForceField(
        PlanarWrench(1.0, 0.0, 0.0),
        REST,
        ((50.0, 0, 0), (0, 20.0, 0), (0, 0, 0)),
        ((3.0, 0, 0), (0, 2.0, 0), (0, 0, 0)),
    )
    effects = effects_of(field, REST, LEVERS, STRONG)
    felt = force_of(effects, (0.02, -0.01, 0.0), (0.1, 0.2, 0.0), 0.05, LEVERS, STRONG)
    assert felt == pytest.approx((1.0 - 50 * 0.02 - 3 * 0.1, 20 * 0.01 - 2 * 0.2))


@given(st.tuples(entry, entry), st.floats(-1e4, 1e4), places, st.floats(0.0, 1.0))
def test_never_more_than_all_that_it_has(
    wrench: tuple[float, float], k: float, position: tuple[float, float, float], age: float
) -> None:
    stick = Strength(force=5.0)
    field = ForceField(PlanarWrench(*wrench, 0.0), REST, ((k, k, 0), (k, k, 0), (0, 0, 0)))
    effects = effects_of(field, position, LEVERS, stick)
    assert max(map(abs, force_of(effects, position, REST, age, LEVERS, stick))) <= 5.0
    shape = shape_of(effects)
    assert 0 <= shape.push.level <= FULL_LEVEL
    assert all(0 <= one.coefficient <= FULL_LEVEL for one in (*shape.spring, *shape.damper))


def test_a_push_that_is_too_strong_keeps_its_direction() -> None:
    effects = effects_of(
        ForceField(PlanarWrench(30.0, 40.0, 0.0)), REST, LEVERS, Strength(force=5.0)
    )
    felt = force_of(effects, REST, REST, 0.0, LEVERS, Strength(force=5.0))
    assert felt == pytest.approx((3.0, 4.0))


def test_gain_weakens_the_whole_field() -> None:
    stick = Strength(force=5.0, gain=0.5)
    field = ForceField(PlanarWrench(2.0, 0.0, 0.0), REST, ((40.0, 0, 0), (0, 0, 0), (0, 0, 0)))
    effects = effects_of(field, REST, LEVERS, stick)
    felt = force_of(effects, (0.01, 0.0, 0.0), REST, 0.0, LEVERS, stick)
    assert felt == pytest.approx((0.5 * (2.0 - 0.4), 0.0))
    silent = effects_of(field, REST, LEVERS, Strength(gain=0.0))
    assert force_of(silent, REST, REST, 0.0, LEVERS, stick) == (0.0, 0.0)


def test_negative_damping_is_left_out() -> None:
    field = ForceField(PlanarWrench(0, 0, 0), damping=((-9.0, 0, 0), (0, -9.0, 0), (0, 0, 0)))
    effects = effects_of(field, REST, LEVERS, STRONG)
    assert (effects.x.damper, effects.y.damper) == (0.0, 0.0)


def test_what_is_stale_fades() -> None:
    spring = ((10.0, 0, 0), (0, 0, 0), (0, 0, 0))
    field = ForceField(PlanarWrench(2.0, 0.0, 0.0), REST, spring, valid_for=0.1)
    effects = effects_of(field, REST, LEVERS, STRONG)
    away = (0.02, 0.0, 0.0)
    felt = [force_of(effects, away, REST, age, LEVERS, STRONG)[0] for age in (0.1, 0.15, 0.2, 9.0)]
    assert felt == pytest.approx([1.8, 1.0, 0.0, 0.0])


def test_for_a_driver_that_pushes_the_other_way_only_the_push_is_turned() -> None:
    field = ForceField(PlanarWrench(2.0, 1.0, 0.0), REST, ((10.0, 0, 0), (0, 5.0, 0), (0, 0, 0)))
    effects = effects_of(field, REST, LEVERS, Strength())
    straight, turned = shape_of(effects), shape_of(effects, turned=True)
    assert abs(straight.push.pulls_to - turned.push.pulls_to) == pytest.approx(180.0)
    assert turned._replace(push=straight.push) == straight
