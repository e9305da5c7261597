"""A person's ceiling is found by letting go of the switch, and stays below the protocol's."""

from __future__ import annotations

import pytest
from stick_bench import Bench

from omnistudy.devices.stick.ceiling import NO_CEILING, Ceiling
from omnistudy.devices.stick.familiarise import find_ceiling
from omnistudy.devices.stick.messages import Telemetry
from omnistudy.errors.stick_checks import ForceGone, NobodyHeld

PER_DUTY = (13.5 / 255, 13.5 / 255, 4.4 / 255)


class Participant:
    """Holds the stick, and lets go of its switch when an axis pushes with more than wanted."""

    def __init__(self, bench: Bench, wanted: tuple[int, int, int]) -> None:
        self.board = bench.board
        self.line = bench.line
        self.wanted = wanted
        self.felt = [0, 0, 0]
        self.board.release()
        for axis, grip in enumerate(((800.0, 20.0, 0.5), (800.0, 20.0, 0.5), (10.0, 0.2, 0.002))):
            self.board.hold(axis, *grip)
        self._listen, self.line.listen = self.line.listen, self.feel  # type: ignore[method-assign]

    def __call__(self, sentence: str) -> None:
        self.board.hold_dead_man(True)

    def feel(self, seconds: float) -> list[Telemetry]:
        heard = self._listen(seconds)
        for told in heard:
            for axis, duty in enumerate(told.motor):
                self.felt[axis] = max(self.felt[axis], abs(duty))
                if abs(duty) > self.wanted[axis]:
                    self.board.hold_dead_man(False)
        return heard


def test_four_fifths_of_what_was_let_go_at(bench: Bench) -> None:
    before = bench.line.configuration()
    ceiling = find_ceiling(bench.line, PER_DUTY, NO_CEILING, Participant(bench, (50, 80, 40)))
    assert ceiling.x == pytest.approx(0.8 * 50 * PER_DUTY[0], rel=0.2)
    assert ceiling.y == pytest.approx(0.8 * 80 * PER_DUTY[1], rel=0.2)
    # Each new count of a moving stick is a blip of its damping: up to 10 steps.
    assert 0.8 * 30 * PER_DUTY[2] <= ceiling.theta <= 0.8 * 41 * PER_DUTY[2]
    assert bench.line.configuration() == before
    assert bench.board.duties == (0,) * 6


def test_it_is_never_above_the_protocol_s_nor_is_the_force(bench: Bench) -> None:
    protocol = Ceiling(x=1.5, y=1.0, theta=0.25)
    fearless = Participant(bench, (256, 256, 256))
    assert find_ceiling(bench.line, PER_DUTY, protocol, fearless) == protocol
    assert fearless.felt == [28, 18, 14]  # 1.5 N are 28.3 steps, 1 N 18.9, 0.25 N·m 14.5


def test_a_protocol_may_be_below_what_anybody_feels(bench: Bench) -> None:
    protocol = Ceiling(x=0.5, y=0.5, theta=0.1)
    assert find_ceiling(bench.line, PER_DUTY, protocol, Participant(bench, (3, 3, 3))) == protocol


def test_the_emergency_stop_ends_it(bench: Bench) -> None:
    class Frightened(Participant):
        def feel(self, seconds: float) -> list[Telemetry]:
            heard = super().feel(seconds)
            if self.felt[0] > 40:
                self.board.press_estop(True)
            return heard

    with pytest.raises(ForceGone, match="ESTOP"):
        find_ceiling(bench.line, PER_DUTY, NO_CEILING, Frightened(bench, (256,) * 3))
    assert bench.board.duties == (0,) * 6


def test_nobody_holds_it(bench: Bench) -> None:
    bench.board.hold_dead_man(False)
    with pytest.raises(NobodyHeld, match=r"within 0\.2 s"):
        find_ceiling(bench.line, PER_DUTY, NO_CEILING, lambda sentence: None, patience=0.2)
