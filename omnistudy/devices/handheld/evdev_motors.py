"""The motors of a stick through Linux's force-feedback effects: at most three, kept and updated."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from omnistudy.devices.handheld.effect_shape import (
    FULL_SATURATION,
    Condition,
    Push,
    shape_of,
)
from omnistudy.devices.handheld.force_effects import ForceEffects
from omnistudy.devices.handheld.hardware import Motors

if TYPE_CHECKING:
    import evdev
    from evdev import ff

NEW = -1
FULL_GAIN = 0xFFFF


class EvdevMotors(Motors):
    """Each effect has one slot of the device for good; what did not change is only played anew."""

    def __init__(self, library: Any, device: evdev.InputDevice[str], turned: bool) -> None:
        self._turned = turned
        self._device = device
        self._codes = codes = library.ecodes
        self._ff = library.ff
        can = device.capabilities()[codes.EV_FF]
        self.springs = codes.FF_SPRING in can
        self.dampers = codes.FF_DAMPER in can
        self._slots: dict[int, int] = {}
        self._shapes: dict[int, object] = {}
        # The stick's own centring spring would be felt beside the law's.
        for code, value in ((codes.FF_GAIN, FULL_GAIN), (codes.FF_AUTOCENTER, 0)):
            if code in can:
                self._write(code, value)

    def apply(self, effects: ForceEffects) -> None:
        """Upload what changed and play all anew, so that each lasts its whole length."""
        shape, codes = shape_of(effects, self._turned), self._codes
        length = shape.valid_ms
        with suppress(OSError):  # unplugged: reading tells
            self._play(codes.FF_CONSTANT, self._push(shape.push, length), (shape.push, length))
            if self.springs:
                both = self._conditions(codes.FF_SPRING, shape.spring, length)
                self._play(codes.FF_SPRING, both, (shape.spring, length))
            if self.dampers:
                both = self._conditions(codes.FF_DAMPER, shape.damper, length)
                self._play(codes.FF_DAMPER, both, (shape.damper, length))

    def stop(self) -> None:
        """Remove every effect, which stops it."""
        with suppress(OSError):  # unplugged: nothing pushes any more
            for slot in self._slots.values():
                self._device.erase_effect(slot)
        self._slots.clear()
        self._shapes.clear()

    def close(self) -> None:
        """Leave the stick without force."""
        self.stop()

    def _push(self, push: Push, valid_ms: int) -> ff.Effect:
        fading = self._ff.Envelope(0, 0, valid_ms, 0)
        constant = self._ff.Constant(push.level, fading)
        direction = round(push.pulls_to / 360.0 * 0x10000) % 0x10000
        body = self._ff.EffectType(ff_constant_effect=constant)
        return self._effect(self._codes.FF_CONSTANT, direction, 2 * valid_ms, body)

    def _conditions(self, kind: int, two: tuple[Condition, Condition], valid_ms: int) -> ff.Effect:
        both = (self._ff.Condition * 2)(
            *(
                self._ff.Condition(
                    FULL_SATURATION,
                    FULL_SATURATION,
                    one.coefficient,
                    one.coefficient,
                    0,
                    one.centre,
                )
                for one in two
            )
        )
        return self._effect(kind, 0, valid_ms, self._ff.EffectType(ff_condition_effect=both))

    def _effect(self, kind: int, direction: int, length: int, body: Any) -> ff.Effect:
        effect: ff.Effect = self._ff.Effect(
            kind,
            self._slots.get(kind, NEW),
            direction,
            self._ff.Trigger(0, 0),
            self._ff.Replay(length, 0),
            body,
        )
        return effect

    def _play(self, kind: int, effect: ff.Effect, shape: object) -> None:
        if self._shapes.get(kind) != shape:
            self._slots[kind] = self._device.upload_effect(effect)
            self._shapes[kind] = shape
        self._write(self._slots[kind], 1)

    def _write(self, code: int, value: int) -> None:
        self._device.write(self._codes.EV_FF, code, value)
