"""The emulated board on a bench, as tests use it."""

from __future__ import annotations

from omnistudy.devices.stick.emulator import EmulatedStick
from omnistudy.devices.stick.line import StickLine


class Bench:
    """A board on the bench: contacts closed, its line, and short ways to get it going."""

    def __init__(self) -> None:
        self.board = EmulatedStick()
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
