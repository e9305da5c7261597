"""Energy of the stick while it is driven: recorded every tick, and held down when wanted."""

from __future__ import annotations

from itertools import pairwise

import pytest
from faulty_stick import FaultyStickInMotion, connected

from omnistudy.devices import NO_HAND, Hand
from omnistudy.devices.stick.passivity import AddedDamping
from omnistudy.geometry import ForceField, PlanarWrench

pytestmark = pytest.mark.usefixtures("toolchain")

PUSHED = Hand((0.004, 0.0, 0.0), (200.0, 200.0, 5.0), (10.0, 10.0, 0.1), (0.3, 0.3, 0.0015))
NOT_PASSIVE = ((-15.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
"""N·s/m: a field that pushes the way the stick goes already."""


def swing(stick: FaultyStickInMotion, ticks: int) -> list[float]:
    """Push the stick off its centre and let go under that field; give where x goes."""
    places = []
    for tick in range(ticks):
        if tick % 20 == 0:
            stick.render(ForceField(PlanarWrench(0.0, 0.0, 0.0), (0.0,) * 3, damping=NOT_PASSIVE))
        state = stick.advance(PUSHED if tick < 100 else NO_HAND)
        places.append(abs(state.position[0]))
        if stick.trouble():
            break
    return places


def test_energy_is_the_sum_of_force_times_way() -> None:
    stick = connected()
    names = [channel.name for channel in stick.channels]
    force, energy = 6 + names.index("motor_x"), 6 + names.index("energy_x")
    rows: list[tuple[float, ...]] = []
    for tick in range(300):
        if tick % 20 == 0:
            stick.render(ForceField(PlanarWrench(3.0, 0.0, 0.0)))
        stick.advance(PUSHED)
        rows += stick.rows()
    worked = sum(before[force] * (after[0] - before[0]) for before, after in pairwise(rows))
    assert worked > 0.005
    assert rows[-1][energy] - rows[0][energy] == pytest.approx(-worked)


def test_what_is_not_passive_runs_away_unless_damping_is_added() -> None:
    alone = connected()
    swing(alone, 2000)
    assert "VELOCITY" in alone.trouble() or "zero of x" in alone.trouble()
    damped = connected(added_damping=AddedDamping(bound=-0.002, x=60.0))
    places = swing(damped, 2000)
    assert not damped.trouble()
    assert max(places[1500:]) < 0.010
