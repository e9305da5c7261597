"""The largest stiffness that is stable: in the board, and over a host loop of 8 ms.

The mechanism is a bare mass of 0.3 kg with 2 N·s/m, 0.1 mm a count and 13.5 N at full duty, let go
100 counts from its centre; what is within 30 counts after 0.7 s is stable. The host's wrench comes
in a ramp of its period, as any law's does; without the ramp 212 N/m were measured over 8 ms.
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, log

import pytest
from stick_bench import Bench, diagonal, field

from omnistudy.devices.stick.emulator import Mechanism
from omnistudy.devices.stick.messages import State

PLANT = Mechanism(mass=0.3, damping=2.0, per_count=1e-4, per_duty=13.5 / 255, travel=0.05)
NEWTONS_PER_METRE = PLANT.per_duty / PLANT.per_count
"""Of one PWM step a count."""
STIFFEST = 31.9
"""PWM a count: what a field can carry."""
HAND = (200.0, 10.0, 0.3)
"""N/m, N·s/m, kg (ours): a relaxed grip."""
THESIS_DAMPING = 10.5
"""PWM·ms/count: 42 PWM·ms/degree (Tyagi 2017, App. B)."""
HOST_PERIOD = 0.008
"""s, the thesis's loop."""
Loop = Callable[[Bench, float], float]


def board_loop(damping: float) -> Loop:
    """The board renders the spring; the host only renews the field."""

    def pass_time(bench: Bench, stiffness: float) -> float:
        bench.line.send(field(stiffness=diagonal(stiffness), damping=diagonal(damping)))
        heard = bench.line.listen(0.02)
        return max(abs(one.position[0]) for one in heard)

    return pass_time


def host_loop(bench: Bench, stiffness: float) -> float:
    """The host computes the spring's force from the last telemetry."""
    heard = bench.line.listen(HOST_PERIOD)
    force = max(-1000.0, min(1000.0, -stiffness * heard[-1].position[0]))
    bench.line.send(field(wrench=(force, 0, 0)))
    return max(abs(one.position[0]) for one in heard)


def is_stable(loop: Loop, stiffness: float, hand: tuple[float, float, float] | None) -> bool:
    bench = Bench((PLANT, PLANT, PLANT))
    free = (8191,) * 3
    bench.bare(travel=(2000,) * 3, velocity_trip=free, slew_limit=(255,) * 3)
    if hand:
        bench.board.hold(0, *hand)
    bench.board.set(0, "moving", 1.0)
    bench.board.set(0, "position", -100 * PLANT.per_count)
    farthest = 0.0
    began = bench.board.now()
    while bench.board.now() < began + 1.0:
        far = loop(bench, stiffness)
        if bench.board.now() > began + 0.7:
            farthest = max(farthest, far)
    still_forcing = bench.line.listen(0.002)[-1].state == State.FORCE
    bench.board.close()
    return farthest < 30 and still_forcing


def largest_stable(loop: Loop, hand: tuple[float, float, float] | None = None) -> float:
    """Give N/m, found within 3 %."""
    if is_stable(loop, STIFFEST, hand):
        return STIFFEST * NEWTONS_PER_METRE
    low, high = log(0.02), log(STIFFEST)
    while high - low > 0.03:
        middle = (low + high) / 2
        if is_stable(loop, exp(middle), hand):
            low = middle
        else:
            high = middle
    return exp(low) * NEWTONS_PER_METRE


@pytest.mark.slow
@pytest.mark.usefixtures("toolchain")
@pytest.mark.parametrize(
    ("hand", "undamped", "damped", "host"),
    [(None, 1_947, 13_030, 85), (HAND, 16_888, 16_888, 870)],
    ids=["bare", "hand"],
)
def test_the_board_holds_ten_times_the_stiffness_of_a_host_loop(
    hand: tuple[float, float, float] | None, undamped: float, damped: float, host: float
) -> None:
    measured = [
        largest_stable(loop, hand)
        for loop in (board_loop(0), board_loop(THESIS_DAMPING), host_loop)
    ]
    assert measured == pytest.approx([undamped, damped, host], rel=0.1)
    assert min(measured[:2]) >= 10 * measured[2]
