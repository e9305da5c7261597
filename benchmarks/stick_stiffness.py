"""The largest stiffness that is stable: rendered by the board, and over a host's loop of 8 ms.

The mechanism is a mass of 0.3 kg with 2 N·s/m, 0.1 mm a count and 13.5 N at full duty, let go
100 counts from its centre; what is within 30 counts after 0.7 s is stable. All in emulated time,
and the same everywhere.
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, log
from typing import NamedTuple

from omnistudy.devices.stick.emulator import EmulatedStick, Mechanism
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Field, State

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
BOARD_PERIOD = 0.02
"""s between two fields of a law."""
BEGUN, NEAR_FROM, ENDED = 100, 0.7, 1.0
"""Counts from the centre at first; s from when on it must stay near; s that are looked at."""
NEAR = 30
"""Counts."""

Hand = tuple[float, float, float]
Loop = Callable[[StickLine, float], int]
"""Lets one period pass with a stiffness in PWM a count; gives the farthest count of x."""


class Stiffness(NamedTuple):
    """N/m; `hand` with a relaxed hand on the handle. `at_most`: what a field can carry."""

    loop: str
    bare: float
    hand: float
    at_most: float


def board_loop(damping: float) -> Loop:
    """Let the board render spring and damper; the host only renews the field."""

    def pass_time(line: StickLine, stiffness: float) -> int:
        line.send(field(stiffness=stiffness, damping=damping))
        heard = line.listen(BOARD_PERIOD)
        return max(abs(one.position[0]) for one in heard)

    return pass_time


def host_loop(damping: float, ramped: bool) -> Loop:
    """Let the host compute the force from the last telemetry.

    ramped : it comes in a ramp of one period, as any law's does; else it is sent twice, so that
        the second's ramp is as short as the time between the two, 1.3 ms.
    """

    def pass_time(line: StickLine, stiffness: float) -> int:
        heard = line.listen(HOST_PERIOD)
        last = heard[-1]
        wanted = -stiffness * last.position[0] - damping * last.rate[0] / 256
        for _ in range(1 if ramped else 2):
            line.send(field(wrench=max(-1000.0, min(1000.0, wanted))))
        return max(abs(one.position[0]) for one in heard)

    return pass_time


LOOPS: dict[str, Loop] = {
    "board, spring": board_loop(0.0),
    "board, spring and damper": board_loop(THESIS_DAMPING),
    "host, spring": host_loop(0.0, ramped=False),
    "host, spring, ramped": host_loop(0.0, ramped=True),
    "host, spring and damper": host_loop(THESIS_DAMPING, ramped=False),
    "host, spring and damper, ramped": host_loop(THESIS_DAMPING, ramped=True),
}
"""The damper is the thesis's."""


def field(wrench: float = 0.0, stiffness: float = 0.0, damping: float = 0.0) -> Field:
    """Give a field along x alone, of PWM, PWM/count and PWM·ms/count."""
    rest = (0,) * 8
    return Field(
        (round(32 * wrench), 0, 0),
        (0, 0, 0),
        (round(1024 * stiffness), *rest),
        (round(32 * damping), *rest),
        250,
    )


def is_stable(loop: Loop, stiffness: float, hand: Hand | None) -> bool:
    """Let the handle go and look; stiffness in PWM a count."""
    board = EmulatedStick((PLANT, PLANT, PLANT))
    line = _armed(board)
    if hand:
        board.hold(0, *hand)
    board.set(0, "moving", 1.0)
    board.set(0, "position", -BEGUN * PLANT.per_count)
    farthest = 0
    began = board.now()
    while board.now() < began + ENDED:
        far = loop(line, stiffness)
        if board.now() > began + NEAR_FROM:
            farthest = max(farthest, far)
    still_forcing = line.listen(0.002)[-1].state == State.FORCE
    board.close()
    return farthest < NEAR and still_forcing


def _armed(board: EmulatedStick) -> StickLine:
    line = StickLine(board)
    board.press_estop(False)
    board.hold_dead_man(True)
    line.listen(0.02)
    none, free = (0,) * 3, (8191,) * 3
    line.configure(
        line.configuration()._replace(
            centring_stiffness=none, centring_damping=none, gravity=none, soft_start=10,
            travel=(2000,) * 3, velocity_trip=free, slew_limit=(255,) * 3,
        )
    )  # fmt: skip
    line.arm()
    line.listen(0.02)
    return line


def largest_stable(loop: Loop, hand: Hand | None = None) -> float:
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


def table() -> list[Stiffness]:
    """Measure every loop, bare and with a hand."""
    most = STIFFEST * NEWTONS_PER_METRE
    return [
        Stiffness(name, largest_stable(loop), largest_stable(loop, HAND), most)
        for name, loop in LOOPS.items()
    ]


if __name__ == "__main__":
    for row in table():
        print(f"{row.loop:32} bare {row.bare:7.0f} N/m, in a hand {row.hand:7.0f} N/m")
