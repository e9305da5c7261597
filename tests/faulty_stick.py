"""The emulated stick with faults to inject, in lockstep or in the process of a live trial."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from math import inf
from pathlib import Path
from typing import Any, Literal

from omnistudy.channel import Measure
from omnistudy.devices import DeviceState, Hand, Identity, RunningDevice
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.emulated_stick_in_motion import EmulatedStickInMotion
from omnistudy.devices.stick.attendant import Attendant
from omnistudy.devices.stick.before_force import checked
from omnistudy.devices.stick.emulator import EmulatedStick
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.transport import Transport

FAULTS = (
    "unplug",
    "frozen_encoder",
    "lost_counts",
    "dead_motor",
    "inverted_motor",
    "inverted_encoder",
    "slow_telemetry",
    "brown_out",
    "other_stick",
    "estop",
    "dead_man",
)
"""Every fault is of x, where it is of an axis."""


SHORT = 10
"""Bytes: a frame without a payload is shorter, a field is longer."""
SOFT_BY_ITSELF = 0.31
"""s of silence after which a stick has no force."""
TICKS_OF_A_TRIAL = 300
"""Before the next fault of the file happens."""


class FaultyLine:
    """Carries bytes between the host and a board that may be cut off or exchanged.

    swallowed : so many of the next frames without a payload never arrive.
    """

    def __init__(self, board: EmulatedStick) -> None:
        self.board = board
        self.cut = False
        self.swallowed = 0
        self.written = 0
        self.kept_of_ten = 10
        self.last_duties: tuple[int, ...] = ()
        self._ahead = 0.0
        self._begun = b""
        self._frames = 0

    def exchange(self, board: EmulatedStick) -> None:
        """Put another board in, at the same moment."""
        self._ahead = self.now() - board.now()
        self.board = board

    def write(self, data: bytes) -> None:
        self.written += 1
        if self.swallowed and len(data) < SHORT:
            self.swallowed -= 1
        elif not self.cut:
            self.board.write(data)

    def read(self, seconds: float) -> bytes:
        told = self.board.read(seconds)
        if self.cut:
            return b""
        return told if self.kept_of_ten == 10 else self._thinned(told)

    def _thinned(self, told: bytes) -> bytes:
        *whole, self._begun = (self._begun + told).split(b"\0")
        kept = b""
        for frame in whole:
            self._frames += 1
            if self._frames % 10 < self.kept_of_ten:
                kept += frame + b"\0"
        return kept

    def now(self) -> float:
        return self.board.now() + self._ahead

    def close(self) -> None:
        self.board.run(SOFT_BY_ITSELF)
        self.last_duties = self.board.duties
        self.board.close()


class FaultyStickInMotion(EmulatedStickInMotion):
    """Takes a fault by its name, from `inject` or from a file."""

    control: Path | None = None
    after = inf

    @cached_property
    def line(self) -> FaultyLine:
        return FaultyLine(self.board)

    def _open(self) -> Transport:
        return self.line

    def wake(self) -> None:
        super().wake()
        self.after = TICKS_OF_A_TRIAL

    def advance(self, hand: Hand) -> DeviceState:
        if self.control is not None:
            self.after -= 1
            if self.after <= 0 and self.control.exists():
                fault, _, rest = self.control.read_text().partition("\n")
                self.control.unlink()
                if rest:
                    self.control.write_text(rest)
                self.after = inf
                self.inject(fault)
        return super().advance(hand)

    def close(self) -> None:
        """Let the board live on for a moment, as a real one does; note what its motors then do."""
        super().close()
        if self.control is not None:
            with self.control.with_suffix(".duties").open("a") as file:
                print(*self.line.last_duties, file=file)

    def inject(self, fault: str) -> None:
        """Let a fault happen now."""
        board = self.board
        match fault:
            case "unplug":
                self.line.cut = True
            case "frozen_encoder":
                board.set(0, "encoder", 0.0)
            case "lost_counts":
                board.jump(0)
            case "dead_motor":
                board.set(0, "motor", 0.0)
            case "inverted_motor":
                board.set(0, "motor", -1.0)
            case "inverted_encoder":
                board.set(0, "encoder", -1.0)
            case "slow_telemetry":
                self.line.kept_of_ten = 6
            case "brown_out":
                board.brown_out()
            case "other_stick":
                self.line.exchange(other_stick())
            case "estop":
                board.press_estop(True)
            case "dead_man":
                board.hold_dead_man(False)
            case _:
                raise ValueError(fault)


def other_stick() -> EmulatedStick:
    """A board with a serial number of its own, armed and longer awake than any in these tests."""
    board = EmulatedStick()
    board.press_estop(False)
    board.hold_dead_man(True)
    line = StickLine(board)
    line.listen(0.05)
    line.configure(line.configuration()._replace(serial=7, soft_start=10, silence=1000))
    line.arm()
    line.listen(0.05)
    return board


class FaultyStick(EmulatedStickDevice):
    """The emulated stick; it takes the next line of the file `control` for the name of a fault."""

    kind: Literal["faulty_stick"] = "faulty_stick"  # type: ignore[assignment]
    control: Path | None = None
    broken_before: str = ""
    """Fault that the stick has when it is checked."""

    def before_force(
        self, tell: Callable[[str], None], expected: Identity | None = None
    ) -> tuple[Measure, ...]:
        running = FaultyStickInMotion(self, 1000)
        running.board.release()
        if self.broken_before:
            running.inject(self.broken_before)
        attendant = Attendant(running.board)

        def told(sentence: str) -> None:
            tell(sentence)
            attendant(sentence)

        return checked(running.line, self.stick, told, expected)

    def connect(self, physics_hz: int) -> RunningDevice:
        running = FaultyStickInMotion(self, physics_hz)
        running.control = self.control
        return running


def connected(physics_hz: int = 1000, **settings: Any) -> FaultyStickInMotion:
    """A stick to inject faults into, in lockstep."""
    running = FaultyStick(**settings).connect(physics_hz)
    assert isinstance(running, FaultyStickInMotion)
    return running
