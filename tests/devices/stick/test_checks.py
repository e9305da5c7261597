"""What must pass before force passes on a sound stick, and finds each thing that is wrong."""

from __future__ import annotations

import pytest
from faulty_stick import FaultyLine
from stick_bench import Bench

from omnistudy.devices.stick.attendant import Attendant
from omnistudy.devices.stick.checks import (
    HOLD_SWITCH,
    LEAVE_SWITCH,
    PRESS_STOP,
    RELEASE_STOP,
    Checks,
    check_before_force,
    findings,
    insist,
)
from omnistudy.devices.stick.emulator import EmulatedStick
from omnistudy.devices.stick.frames import Deframer, encode
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Fault, Identity, Sign, State, Telemetry, Three
from omnistudy.errors.devices import NoAnswer
from omnistudy.errors.stick_checks import ChecksFailed

STOPS: Three = (300, 300, 1440)


def check(bench: Bench, refused: str = "", expected: Identity | None = None) -> Checks:
    bench.board.release()
    bench.board.greatest_duty()
    attendant = Attendant(bench.board, refused)
    return check_before_force(bench.line, STOPS, attendant, expected, patience=0.3)


def failed(checks: Checks) -> list[str]:
    return [finding.what for finding in checks.findings if not finding.sound]


@pytest.mark.slow
def test_a_sound_stick_passes_with_little_force(bench: Bench) -> None:
    before = bench.line.configuration()
    checks = insist(check(bench))
    assert [finding.what for finding in checks.findings[:6]] == [
        "same stick",
        "enable line on with force",
        "emergency stop pressed",
        "emergency stop released",
        "dead-man's switch let go",
        "dead-man's switch held",
    ]
    assert len(checks.findings) == 6 + 3 + 6 + 1 + 3
    assert checks.shifts == (0, 0, 0)
    assert not checks.drifted
    assert 0 < bench.board.greatest_duty() <= 96
    assert bench.line.configuration() == before
    last = bench.line.listen(0.01)[-1]
    assert last.state == State.IDLE
    assert not bench.board.enabled


def test_findings_are_numbers_to_be_stored(bench: Bench) -> None:
    told = {one.name: one.value for one in findings(check(bench, refused=PRESS_STOP))}
    assert told["check_same_stick"] == 1.0
    assert told["check_emergency_stop_pressed"] == 0.0
    assert told["zero_shift_x"] == 0.0


@pytest.mark.parametrize(
    ("refused", "what"),
    [
        (PRESS_STOP, "emergency stop pressed"),
        (RELEASE_STOP, "emergency stop released"),
        (LEAVE_SWITCH, "dead-man's switch let go"),
    ],
)
def test_a_switch_that_is_not_felt_ends_the_checks(bench: Bench, refused: str, what: str) -> None:
    checks = check(bench, refused)
    assert failed(checks) == [what]
    assert checks.findings[-1].what == what
    assert bench.board.greatest_duty() == 0
    with pytest.raises(ChecksFailed, match=f"no force: {what}: not noticed within 0.3 s"):
        insist(checks)


def test_nobody_at_the_stick_ends_the_checks(bench: Bench) -> None:
    bench.board.hold_dead_man(False)
    checks = check(bench, refused=HOLD_SWITCH)
    assert failed(checks) == ["dead-man's switch held"]
    assert not bench.board.enabled


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize(
    ("part", "value", "found"),
    [
        ("motor", 0.0, "did not move"),
        ("encoder", 0.0, "did not move"),
        ("motor", -1.0, "moved the wrong way"),
        ("encoder", -1.0, "moved the wrong way"),
    ],
)
def test_a_dead_or_inverted_axis_gets_no_force(
    bench: Bench, axis: int, part: str, value: float, found: str
) -> None:
    bench.board.set(axis, part, value)
    checks = check(bench)
    name = ("x", "y", "theta")[axis]
    assert failed(checks) == [f"sign of {name}"]
    assert any(found in one.found for one in checks.findings if not one.sound)
    assert bench.board.duties == (0,) * 6
    assert bench.board.greatest_duty() <= 96
    assert not bench.board.enabled


@pytest.mark.slow
@pytest.mark.parametrize("offset", [24, -24])
def test_a_drifted_zero_is_told_and_set_anew(bench: Bench, offset: int) -> None:
    bench.board.set(0, "position", offset * bench.board.get(0, "per_count"))
    bench.board.release()
    bench.board.run(0.005)
    bench.board.hold(0, 5000.0, 100.0, 0.5, offset * bench.board.get(0, "per_count"))
    bench.line.listen(0.1)
    bench.line.zero()
    checks = insist(check(bench))
    assert checks.drifted
    assert checks.shifts[0] == pytest.approx(-offset, abs=2)
    told = next(one.found for one in checks.findings if one.what == "zero of x")
    assert "set anew" in told
    # The true zero is where the mechanism has it.
    assert not check(bench).drifted


@pytest.mark.slow
@pytest.mark.parametrize("side", [1, -1])
def test_a_stick_that_leans_on_its_stop_passes_wherever_its_zero_is(
    bench: Bench, side: int
) -> None:
    for axis in (0, 1):
        bench.board.set(axis, "position", side * bench.board.get(axis, "travel"))
    bench.board.release()
    bench.line.listen(0.1)
    bench.line.zero()  # as a stick that is reset there counts
    checks = insist(check(bench))
    assert checks.shifts[:2] == pytest.approx((-300 * side, -300 * side), abs=2)
    assert not check(bench).drifted


@pytest.mark.slow
def test_lost_counts_are_a_drifted_zero(bench: Bench) -> None:
    bench.board.release()
    for _ in range(8):
        bench.board.jump(1)
        bench.board.run(0.1)
    checks = check(bench)
    assert checks.drifted
    assert abs(checks.shifts[1]) == pytest.approx(16, abs=2)


@pytest.mark.slow
def test_a_shorter_travel_than_is_said_gets_no_force(bench: Bench) -> None:
    bench.board.set(1, "travel", 0.7 * bench.board.get(1, "travel"))
    assert failed(check(bench)) == ["travel of y"]


def test_another_stick_gets_no_force(bench: Bench) -> None:
    expected = bench.line.identify()._replace(serial=12)
    checks = check(bench, expected=expected)
    assert failed(checks) == ["same stick"]
    assert len(checks.findings) == 1


def test_a_stick_that_is_held_does_not_pass(bench: Bench) -> None:
    class Clinging(Attendant):
        def let_go(self) -> None:
            for axis in range(3):
                self.board.hold(axis, 8000.0, 300.0, 0.5)

    bench.board.release()
    checks = check_before_force(bench.line, STOPS, Clinging(bench.board), patience=0.3)
    assert failed(checks) == ["sign of x", "sign of y", "sign of theta"]


def test_an_emergency_stop_in_the_middle_ends_the_checks(bench: Bench) -> None:
    class Frightened(Attendant):
        def let_go(self) -> None:
            self.board.press_estop(True)

    bench.board.release()
    checks = check_before_force(bench.line, STOPS, Frightened(bench.board), patience=0.3)
    assert failed(checks) == ["force"]
    assert bench.board.greatest_duty() == 0


def test_a_stick_that_is_unplugged_in_the_middle_goes_soft_by_itself(bench: Bench) -> None:
    wire = FaultyLine(bench.board)

    class Clumsy(Attendant):
        def let_go(self) -> None:
            wire.cut = True

    bench.board.release()
    with pytest.raises(NoAnswer):
        check_before_force(StickLine(wire), STOPS, Clumsy(bench.board), patience=0.3)
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled


class Boastful:
    """A line whose stick says that it pushes, whatever becomes of its switches."""

    def __init__(self, board: EmulatedStick) -> None:
        self._board = board
        self._deframer = Deframer()
        self.write, self.now, self.close = board.write, board.now, board.close

    def read(self, seconds: float) -> bytes:
        told = b""
        for message, sequence in self._deframer.feed(self._board.read(seconds)):
            if isinstance(message, Telemetry) and message.faults & Fault.ESTOP:
                signs = message.signs | Sign.ENABLED
                message = message._replace(state=State.FORCE, signs=signs)
            told += encode(message, sequence)
        return told


def test_a_switch_that_is_felt_but_takes_no_force_away_ends_the_checks(bench: Bench) -> None:
    line = StickLine(Boastful(bench.board))
    checks = check_before_force(line, STOPS, Attendant(bench.board), patience=0.3)
    assert failed(checks) == ["emergency stop pressed"]
    assert "noticed, but force and enable line stay on" in checks.findings[-1].found


@pytest.mark.slow
def test_a_stick_that_does_not_come_to_rest_in_its_centre_gets_no_force(bench: Bench) -> None:
    # Its own settings carry half of the handle's weight only, and do not centre x.
    falling = {"centring_stiffness": (0, 179, 340), "gravity": (50, 70, 0)}
    bench.line.configure(bench.line.configuration()._replace(**falling))
    assert failed(check(bench)) == ["rest of x"]
