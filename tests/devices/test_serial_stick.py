"""A stick on a serial port, against the emulated board behind a pseudo-terminal."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from carried_port import CarriedPort
from stick_bench import Bench

from omnistudy.devices import NO_HAND
from omnistudy.devices.serial_stick import SerialStickDevice
from omnistudy.devices.serial_stick_in_motion import SerialStickInMotion
from omnistudy.devices.stick.ceiling import Ceiling
from omnistudy.devices.stick.pseudo_terminal import PseudoTerminal
from omnistudy.devices.stick.transport import Transport
from omnistudy.errors.devices import OnlyLive
from omnistudy.geometry import ForceField, PlanarWrench

PUSH = ForceField(PlanarWrench(2.0, 0.0, 0.0))


class CarriedStick(SerialStickInMotion):
    """A stick on a port whose time passes while it is read: a millisecond a turn."""

    terminal: PseudoTerminal

    def _open(self) -> Transport:
        return CarriedPort(self.terminal)


@pytest.fixture
def terminal(bench: Bench) -> Iterator[PseudoTerminal]:
    bench.line.configure(bench.line.configuration()._replace(serial=41, soft_start=10))
    made = PseudoTerminal(bench.board)
    yield made
    made.close()


@pytest.fixture
def stick(terminal: PseudoTerminal) -> CarriedStick:
    connected = CarriedStick(SerialStickDevice())
    connected.terminal = terminal
    return connected


def driven(stick: CarriedStick, turns: int) -> list[tuple[float, ...]]:
    rows: list[tuple[float, ...]] = []
    for turn in range(turns):
        if turn % 20 == 0:
            stick.render(PUSH)
        stick.advance(NO_HAND)
        rows += stick.rows()
    return rows


def test_the_port_is_not_opened_to_be_described() -> None:
    running = SerialStickDevice(port="/dev/nowhere").connect(1000)
    assert [axis.name for axis in running.axes] == ["stick_x", "stick_y", "stick_theta"]


def test_every_tick_comes_and_the_force_is_what_was_asked(
    stick: CarriedStick, bench: Bench
) -> None:
    rows = driven(stick, 300)
    assert not stick.trouble()
    place = 6 + [channel.name for channel in stick.channels].index("stick_tick")
    ticks = [row[place] for row in rows]
    assert ticks == [ticks[0] + i for i in range(len(ticks))]
    assert len(ticks) >= 295
    # 2 N of 13.5 N in 255 steps.
    assert bench.board.duties[0] == 38
    assert rows[-1][6] == pytest.approx(38 * 13.5 / 255)
    assert stick.health().ticks == len(ticks)


def test_its_own_settings_stay_but_for_the_ceiling(terminal: PseudoTerminal, bench: Bench) -> None:
    before = bench.line.configuration()
    stick = CarriedStick(SerialStickDevice(ceiling=Ceiling(x=5.0)))
    stick.terminal = terminal
    driven(stick, 50)
    assert stick.identity()[:2] == ("serial_stick", "41")
    assert stick._line.configuration() == before._replace(force_limit=(94, 255, 255))


def test_an_unplugged_port_is_trouble_at_once(bench: Bench) -> None:
    terminal = PseudoTerminal(bench.board)
    stick = CarriedStick(SerialStickDevice())
    stick.terminal = terminal
    driven(stick, 100)
    assert not stick.trouble()
    port = stick._line.transport
    assert isinstance(port, CarriedPort)
    port._terminal = _Gone(terminal)  # type: ignore[assignment]
    terminal.close()
    state = stick.advance(NO_HAND)
    assert "was unplugged" in stick.trouble()
    assert state.position == (0.0, 0.0, 0.0)
    stick.render(PUSH)
    stick.advance(NO_HAND)
    stick.close()


class _Gone:
    """A terminal that carries nothing any more, on a board whose time stands still."""

    def __init__(self, terminal: PseudoTerminal) -> None:
        self.board = terminal.board

    def carry(self, seconds: float) -> None:
        return


def test_closing_disarms(stick: CarriedStick, terminal: PseudoTerminal, bench: Bench) -> None:
    driven(stick, 100)
    assert bench.board.enabled
    stick.close()
    for _ in range(10):
        terminal.carry(0.001)
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled


def test_it_waits_for_nothing_when_nothing_came(stick: CarriedStick) -> None:
    driven(stick, 50)
    port = stick._line.transport
    asked: list[float] = []

    class Silent:
        def write(self, data: bytes) -> None:
            return

        def read(self, seconds: float) -> bytes:
            asked.append(seconds)
            return b""

        def now(self) -> float:
            return port.now()

        def close(self) -> None:
            return

    stick._line.transport = Silent()
    stick.advance(NO_HAND)
    assert asked == [0.0]
    assert stick.rows() == []


def test_it_serves_live_trials_only() -> None:
    from core_world import trial

    from omnistudy.trial import run_trial

    with pytest.raises(OnlyLive, match="serial_stick"):
        run_trial(trial(device=SerialStickDevice()))
