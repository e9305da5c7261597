"""Energy into and out of the stick, against mechanics that is known."""

from __future__ import annotations

from math import pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.stick.passivity import AddedDamping, PassivityObserver

TICK = 1e-3


def test_work_of_a_constant_force_is_force_times_way() -> None:
    observer = PassivityObserver(axes=1)
    for step in range(11):
        observer.see((0.001 * step,), (3.0,))
    # The stick pushed with 3 N along 10 mm: it gave 30 mJ.
    assert observer.energy == pytest.approx([-0.030])


def test_a_force_is_held_until_the_next_tick() -> None:
    observer = PassivityObserver(axes=1)
    observer.see((0.0,), (1.0,))
    observer.see((0.001,), (5.0,))
    assert observer.energy == pytest.approx([-0.001])


def test_a_spring_pushed_in_and_out_keeps_nothing_and_a_damper_all() -> None:
    spring, damper = PassivityObserver(axes=1), PassivityObserver(axes=1)
    amplitude, omega = 0.01, 2 * pi
    greatest = 0.0
    # So finely that what holding the force adds is small.
    for step in range(100_001):
        t = step * 1e-5
        position = amplitude * sin(omega * t)
        rate = amplitude * omega * sin(omega * t + pi / 2)
        spring.see((position,), (-200.0 * position,))
        damper.see((position,), (-5.0 * rate,))
        greatest = max(greatest, spring.energy[0])
    assert greatest == pytest.approx(0.5 * 200.0 * amplitude**2, rel=1e-3)
    assert spring.energy[0] == pytest.approx(0.0, abs=1e-5)
    # pi·b·omega·A² a cycle.
    assert damper.energy[0] == pytest.approx(pi * 5.0 * omega * amplitude**2, rel=1e-3)


@given(
    stiffness=st.floats(0.0, 300.0),
    share=st.floats(1.0, 4.0),
    moves=st.lists(st.floats(-0.01, 0.01), min_size=1, max_size=60),
)
def test_a_spring_with_enough_damping_never_gives_more_than_it_took(
    stiffness: float, share: float, moves: list[float]
) -> None:
    # b >= K·T/2 makes a sampled spring passive (Colgate and Schenkel 1997), here with the damper in
    # the device: it works on the same motion as the spring.
    damping = share * stiffness * TICK / 2
    observer = PassivityObserver(axes=1)
    position, spent = 0.0, 0.0
    observer.see((position,), (-stiffness * position,))
    for move in moves:
        spent += damping * move**2 / TICK
        position += move
        observer.see((position,), (-stiffness * position,))
        assert observer.energy[0] + spent >= -1e-12


class Handle:
    """A 0.3 kg handle with a little friction on a host's spring that is some ticks late."""

    def __init__(self, late: int) -> None:
        self.position, self.rate = 0.005, 0.0
        self.seen = [0.005] * late
        self.before = 0.005
        self.observer = PassivityObserver(axes=1)
        self.damping = 0.0
        self.least = 0.0

    def turn(self, added: AddedDamping | None) -> None:
        self.seen.append(self.position)
        force = -800.0 * self.seen.pop(0) - self.damping * self.rate
        self.observer.see((self.position,), (force,))
        if added is not None:
            moved = self.position - self.before
            self.damping = added.against(
                (*self.observer.energy, 0.0, 0.0), (moved, 0.0, 0.0), TICK
            )[0]
        self.least = min(self.least, self.observer.energy[0])
        self.rate += (force - 1.0 * self.rate) / 0.3 * TICK
        self.before, self.position = self.position, self.position + self.rate * TICK

    def swing(self, ticks: int, added: AddedDamping | None = None) -> float:
        """Let go; give the greatest deflection of the last tenth."""
        greatest = 0.0
        for tick in range(ticks):
            self.turn(added)
            if tick > 0.9 * ticks:
                greatest = max(greatest, abs(self.position))
        return greatest


def test_a_late_stiff_spring_gives_energy_and_added_damping_takes_it_back() -> None:
    alone, damped = Handle(late=8), Handle(late=8)
    assert alone.swing(1000) > 0.05  # grows
    assert alone.least < -1.0
    greatest = damped.swing(1000, AddedDamping(bound=-0.001, x=100.0))
    assert greatest < 0.005
    assert damped.least > -0.01


def test_a_spring_in_time_gives_next_to_nothing() -> None:
    handle = Handle(late=0)
    assert handle.swing(1000) < 0.005
    # Half K·x² was in the spring; friction of 1 N·s/m against K·T/2 = 0.4 spends 1/(1 - 0.4) of it.
    assert handle.least > -0.01 / (1 - 0.4) - 1e-4


def test_damping_is_bounded_and_needs_a_motion_and_a_deficit() -> None:
    added = AddedDamping(bound=-0.02, x=10.0, y=10.0, theta=0.1)
    # 0.01 J missing over 1 mm in 1 ms: 0.01·0.001/1e-6 = 10 N·s/m.
    assert added.against((-0.025, -0.01, -1.0), (0.001, 0.001, 0.0), TICK) == pytest.approx(
        (5.0, 0.0, 0.1)
    )
