"""The stick's board, emulated instruction by instruction, with the mechanism behind it.

A `Transport` in lockstep: emulated time passes only while somebody reads.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from functools import cache
from math import ceil, sqrt
from weakref import finalize

from omnistudy.devices.simulated_stick import DEGREES_PER_COUNT, Axis, SimulatedStick
from omnistudy.devices.stick import toolchain
from omnistudy.devices.stick.conversion import handle_scale
from omnistudy.errors.devices import ProcessorCrashed

HERTZ = 16_000_000
QUANTUM = 1e-3
"""s that pass at most before what came is given: the telemetry's period."""

AXIS_FIELDS = (
    "mass", "damping", "weight", "lever", "per_count", "per_duty", "travel", "dead_band",
    "hand_stiffness", "hand_damping", "hand_mass", "hand_reference",
    "motor", "encoder", "position", "rate", "moving",
)  # fmt: skip
"""The struct `axis` of firmware/emulator/emulator.h, in its order."""


@dataclass(frozen=True)
class Mechanism:
    """One axis of the emulated stick, SI at the handle; twist: N·m, rad, kg·m²."""

    mass: float
    damping: float
    per_count: float
    per_duty: float
    travel: float
    weight: float = 0.0
    lever: float = 1.0
    dead_band: float = 0.0


RELAXED_HAND = ((200.0, 10.0, 0.3), (200.0, 10.0, 0.3), (5.0, 0.1, 0.0015))
"""Stiffness, damping and mass of each axis, SI (ours)."""
CELL_STIFFNESS = (200_000.0, 200_000.0, 5_000.0)
"""Of a load cell, N/m, N/m, N·m/rad: it gives way by less than an encoder count (ours)."""


def mechanisms(stick: SimulatedStick) -> tuple[Mechanism, Mechanism, Mechanism]:
    """Give the axes of a stick described as the simulated one is (Tyagi 2017, eq. 3.2)."""
    scale = handle_scale(stick)

    def axis(number: int, told: Axis, lever: float) -> Mechanism:
        count, duty = scale.per_count[number], scale.per_duty[number]
        mass = duty / (told.gain * count / DEGREES_PER_COUNT)
        weight = told.gravity * duty
        return Mechanism(mass, told.pole * mass, count, duty, told.travel * count, weight, lever)

    lever = stick.scale.lever
    return axis(0, stick.x, lever), axis(1, stick.y, lever), axis(2, stick.theta, 1.0)


@cache
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(toolchain.build().emulator))
    this, number, real = ctypes.c_void_p, ctypes.c_int, ctypes.c_double
    signatures: dict[str, tuple[object, tuple[object, ...]]] = {
        "new": (this, (ctypes.c_char_p,)),
        "free": (None, (this,)),
        "run": (ctypes.c_bool, (this, ctypes.c_uint64)),
        "cycle": (ctypes.c_uint64, (this,)),
        "write": (None, (this, ctypes.c_char_p, ctypes.c_uint32)),
        "read": (ctypes.c_uint32, (this, ctypes.c_char_p, ctypes.c_uint32)),
        "waiting": (ctypes.c_uint32, (this,)),
        "set": (None, (this, number, number, real)),
        "get": (real, (this, number, number)),
        "turn": (None, (this, number, ctypes.c_int32, real)),
        "is_turning": (ctypes.c_bool, (this, number)),
        "count": (ctypes.c_int32, (this, number)),
        "glitch": (None, (this, number, number, ctypes.c_uint32)),
        "jump": (None, (this, number)),
        "estop": (None, (this, ctypes.c_bool)),
        "dead_man": (None, (this, ctypes.c_bool)),
        "enabled": (ctypes.c_bool, (this,)),
        "duty": (number, (this, number)),
        "greatest_duty": (number, (this,)),
        "overlaps": (ctypes.c_uint32, (this,)),
        "brown_out": (None, (this,)),
        "hang": (None, (this, ctypes.c_bool)),
        "hang_at_start": (None, (this,)),
        "heal": (None, (this,)),
        "eeprom": (None, (this, ctypes.c_uint16, ctypes.c_char_p, ctypes.c_uint16, ctypes.c_bool)),
    }
    for name, (result, arguments) in signatures.items():
        function = getattr(library, f"emulator_{name}")
        function.restype, function.argtypes = result, arguments
    return library


class EmulatedStick:
    """The board with firmware and mechanism; the mechanism stands still until `release`."""

    def __init__(self, axes: tuple[Mechanism, ...] | None = None) -> None:
        """Power the board up; raises NoToolchain where the emulator cannot be compiled.

        axes : the mechanism behind it; the published stick unless given.
        """
        self._library = _library()
        self._board = self._library.emulator_new(str(toolchain.build().firmware).encode())
        self._end = finalize(self, self._library.emulator_free, self._board)
        self._buffer = ctypes.create_string_buffer(1 << 16)
        for axis, mechanism in enumerate(axes or mechanisms(SimulatedStick())):
            for name, value in vars(mechanism).items():
                self.set(axis, name, value)
            self.set(axis, "motor", 1.0)
            self.set(axis, "encoder", 1.0)

    def write(self, data: bytes) -> None:
        """Put bytes on the line, which carries them in its own time."""
        self._library.emulator_write(self._board, data, len(data))

    def read(self, seconds: float) -> bytes:
        """Let at most a millisecond of `seconds` pass; give what came."""
        self.run(min(seconds, QUANTUM))
        return self.received()

    def now(self) -> float:
        """Give the emulated time since power-up, s."""
        return self.cycle / HERTZ

    def close(self) -> None:
        """Take the board away."""
        self._end()

    @property
    def cycle(self) -> int:
        """Processor cycles since power-up."""
        return int(self._library.emulator_cycle(self._board))

    def run(self, seconds: float) -> None:
        """Let emulated time pass; raises ProcessorCrashed."""
        if not self._library.emulator_run(self._board, ceil(seconds * HERTZ)):
            raise ProcessorCrashed(self.cycle)

    def received(self) -> bytes:
        """Give the bytes that the board has sent."""
        length = self._library.emulator_read(self._board, self._buffer, len(self._buffer))
        return self._buffer.raw[:length]

    @property
    def waiting(self) -> int:
        """Bytes that the line has yet to carry to the board."""
        return int(self._library.emulator_waiting(self._board))

    def set(self, axis: int, name: str, value: float) -> None:
        """Set one of AXIS_FIELDS."""
        self._library.emulator_set(self._board, axis, AXIS_FIELDS.index(name), value)

    def get(self, axis: int, name: str) -> float:
        """Give one of AXIS_FIELDS."""
        return float(self._library.emulator_get(self._board, axis, AXIS_FIELDS.index(name)))

    def release(self) -> None:
        """Let the mechanism move."""
        for axis in range(3):
            self.set(axis, "moving", 1.0)

    def hold(
        self, axis: int, stiffness: float, damping: float, mass: float, reference: float = 0.0
    ) -> None:
        """Put a hand on an axis: a spring, damper and mass, SI, pulled to `reference`."""
        given = (stiffness, damping, mass, reference)
        for name, value in zip(("stiffness", "damping", "mass", "reference"), given, strict=True):
            self.set(axis, f"hand_{name}", value)

    def clamp(self, axis: int) -> None:
        """Fix the handle to a load cell, a spring of CELL_STIFFNESS, where it stands."""
        stiffness = CELL_STIFFNESS[axis]
        damping = 2.0 * sqrt(stiffness * self.get(axis, "mass"))
        self.hold(axis, stiffness, damping, 0.0, self.get(axis, "position"))

    def cell_force(self, axis: int) -> float:
        """Give what the load cell of `clamp` feels: the stick's push, N; N·m for theta."""
        given = self.get(axis, "position") - self.get(axis, "hand_reference")
        return self.get(axis, "hand_stiffness") * given

    def turn(self, axis: int, count: int, edges_per_second: float) -> None:
        """Turn an encoder's shaft to `count`, edge by edge, whatever the mechanism does."""
        self._library.emulator_turn(self._board, axis, count, edges_per_second)

    def is_turning(self, axis: int) -> bool:
        """Tell whether `turn` is still under way."""
        return bool(self._library.emulator_is_turning(self._board, axis))

    def count(self, axis: int) -> int:
        """Give the encoder's true count."""
        return int(self._library.emulator_count(self._board, axis))

    def glitch(self, axis: int, line: int, seconds: float) -> None:
        """Flip line A (0) or B (1) of an encoder for so long."""
        self._library.emulator_glitch(self._board, axis, line, max(1, round(seconds * HERTZ)))

    def jump(self, axis: int) -> None:
        """Turn an encoder by two counts at once, as when a step was lost."""
        self._library.emulator_jump(self._board, axis)

    def press_estop(self, pressed: bool) -> None:
        """Press or release the emergency stop."""
        self._library.emulator_estop(self._board, pressed)

    def hold_dead_man(self, held: bool) -> None:
        """Hold the dead-man's switch or let it go."""
        self._library.emulator_dead_man(self._board, held)

    @property
    def enabled(self) -> bool:
        """Whether the amplifiers' enable line is driven high."""
        return bool(self._library.emulator_enabled(self._board))

    @property
    def duties(self) -> tuple[int, ...]:
        """Duty of the pins D6 .. D11, 0 .. 255."""
        return tuple(self._library.emulator_duty(self._board, pin) for pin in range(6))

    def greatest_duty(self) -> int:
        """Give the greatest duty that any pin had since the last asking."""
        return int(self._library.emulator_greatest_duty(self._board))

    def overlaps(self) -> int:
        """Tell how often both pins of a pair were on since the last asking."""
        return int(self._library.emulator_overlaps(self._board))

    def brown_out(self) -> None:
        """Reset the processor as a dip of its supply does."""
        self._library.emulator_brown_out(self._board)

    def hang(self, interrupts: bool) -> None:
        """Let the program jump for ever to where it is, with interrupts or without."""
        self._library.emulator_hang(self._board, interrupts)

    def hang_at_start(self) -> None:
        """Let the program hang at its very start, too, whenever it is started anew."""
        self._library.emulator_hang_at_start(self._board)

    def heal(self) -> None:
        """Put the program right again after `hang` and `hang_at_start`."""
        self._library.emulator_heal(self._board)

    def eeprom(self, address: int, length: int) -> bytes:
        """Read EEPROM."""
        held = ctypes.create_string_buffer(length)
        self._library.emulator_eeprom(self._board, address, held, length, False)
        return held.raw

    def write_eeprom(self, address: int, data: bytes) -> None:
        """Write EEPROM behind the processor's back."""
        self._library.emulator_eeprom(self._board, address, data, len(data), True)
