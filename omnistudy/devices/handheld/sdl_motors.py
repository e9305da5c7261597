"""The motors of a joystick through SDL2's haptics: at most three effects, renewed in place."""

from __future__ import annotations

from ctypes import byref
from typing import Any

from omnistudy.devices.handheld.effect_shape import (
    FULL_SATURATION,
    Condition,
    EffectShape,
    shape_of,
)
from omnistudy.devices.handheld.force_effects import ForceEffects
from omnistudy.devices.handheld.hardware import Motors


def sdl_motors(library: Any, joystick: Any, turned: bool) -> SdlMotors | None:
    """Give the motors of a joystick; None for one without, or one that can only rumble."""
    haptic = library.SDL_HapticOpenFromJoystick(joystick)
    if not haptic:
        return None
    if not library.SDL_HapticQuery(haptic) & library.SDL_HAPTIC_CONSTANT:
        library.SDL_HapticClose(haptic)
        return None
    return SdlMotors(library, haptic, turned)


class SdlMotors(Motors):
    """Effects are made when first needed, then updated; each dies by itself after its length."""

    def __init__(self, library: Any, haptic: Any, turned: bool) -> None:
        self._turned = turned
        self._sdl = library
        self._haptic = haptic
        can = library.SDL_HapticQuery(haptic)
        self.springs = bool(can & library.SDL_HAPTIC_SPRING)
        self.dampers = bool(can & library.SDL_HAPTIC_DAMPER)
        if can & library.SDL_HAPTIC_GAIN:
            library.SDL_HapticSetGain(haptic, 100)
        if can & library.SDL_HAPTIC_AUTOCENTER:
            library.SDL_HapticSetAutocenter(haptic, 0)
        self._numbers: dict[int, int] = {}
        self._shapes: dict[int, object] = {}

    def apply(self, effects: ForceEffects) -> None:
        """Make or update the effects, and start each anew so that it lasts its whole length."""
        shape, sdl = shape_of(effects, self._turned), self._sdl
        self._run(sdl.SDL_HAPTIC_CONSTANT, self._push(shape), (shape.push, shape.valid_ms))
        if self.springs:
            self._conditions(sdl.SDL_HAPTIC_SPRING, shape.spring, shape.valid_ms)
        if self.dampers:
            self._conditions(sdl.SDL_HAPTIC_DAMPER, shape.damper, shape.valid_ms)

    def stop(self) -> None:
        """Stop and remove every effect."""
        for number in self._numbers.values():
            self._sdl.SDL_HapticDestroyEffect(self._haptic, number)
        self._numbers.clear()
        self._shapes.clear()

    def close(self) -> None:
        """Let go of the motors."""
        self.stop()
        self._sdl.SDL_HapticClose(self._haptic)

    def _push(self, shape: EffectShape) -> Any:
        effect = self._sdl.SDL_HapticEffect()
        effect.type = self._sdl.SDL_HAPTIC_CONSTANT
        constant = effect.constant
        constant.direction.type = self._sdl.SDL_HAPTIC_POLAR
        constant.direction.dir[0] = round(100.0 * shape.push.pulls_to)
        constant.length = 2 * shape.valid_ms
        constant.fade_length = shape.valid_ms
        constant.level = shape.push.level
        return effect

    def _conditions(self, kind: int, two: tuple[Condition, Condition], valid_ms: int) -> None:
        effect = self._sdl.SDL_HapticEffect()
        effect.type = kind
        condition = effect.condition
        condition.direction.type = self._sdl.SDL_HAPTIC_CARTESIAN
        condition.length = valid_ms
        for axis, one in enumerate(two):
            condition.right_sat[axis] = condition.left_sat[axis] = FULL_SATURATION
            condition.right_coeff[axis] = condition.left_coeff[axis] = one.coefficient
            condition.center[axis] = one.centre
        self._run(kind, effect, (two, valid_ms))

    def _run(self, kind: int, effect: Any, shape: object) -> None:
        number = self._numbers.get(kind)
        if number is None:
            number = self._sdl.SDL_HapticNewEffect(self._haptic, byref(effect))
            if number < 0:
                return  # unplugged: `SdlHardware.read` tells
            self._numbers[kind] = number
        elif self._shapes.get(kind) != shape:
            self._sdl.SDL_HapticUpdateEffect(self._haptic, number, byref(effect))
        self._shapes[kind] = shape
        self._sdl.SDL_HapticRunEffect(self._haptic, number, 1)
