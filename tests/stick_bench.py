"""The emulated board on a bench, as tests use it."""

from __future__ import annotations

from omnistudy.devices.stick.emulator import EmulatedStick, Mechanism
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Field, Telemetry

NONE3 = (0, 0, 0)
NONE9 = (0,) * 9


def field(
    wrench: tuple[float, ...] = NONE3,
    about: tuple[float, ...] = NONE3,
    stiffness: tuple[float, ...] = NONE9,
    damping: tuple[float, ...] = NONE9,
    valid_for: int = 250,
) -> Field:
    """Give a field from PWM, counts, PWM/count and PWM·ms/count."""

    def steps(values: tuple[float, ...], scale: int) -> tuple[int, ...]:
        return tuple(round(value * scale) for value in values)

    return Field(
        steps(wrench, 32), steps(about, 8), steps(stiffness, 1024), steps(damping, 32), valid_for
    )  # type: ignore[arg-type]


def diagonal(value: float) -> tuple[float, ...]:
    return (value, 0, 0, 0, value, 0, 0, 0, value)


class Bench:
    """A board on the bench: contacts closed, its line, and short ways to get it going."""

    def __init__(self, mechanisms: tuple[Mechanism, ...] | None = None) -> None:
        self.board = EmulatedStick(mechanisms)
        self.line = StickLine(self.board)
        self.board.press_estop(False)
        self.board.hold_dead_man(True)
        self.line.listen(0.02)

    def arm(self, **settings: object) -> None:
        """Use these settings, arm, and wait for the end of the soft start."""
        quick = {"soft_start": 10, **settings}
        self.line.configure(self.line.configuration()._replace(**quick))
        self.line.arm()
        self.line.listen(0.02)

    def bare(self, **settings: object) -> None:
        """Arm without centring or gravity: only a field gives force."""
        none = (0, 0, 0)
        own = {"centring_stiffness": none, "centring_damping": none, "gravity": none}
        self.arm(**own, **settings)

    def settle(self, given: Field) -> Telemetry:
        """Send a field twice, so that its ramp is short, and give what is rendered at its end."""
        self.line.send(given)
        self.line.listen(0.02)
        self.line.send(given)
        return self.line.listen(0.03)[-1]
