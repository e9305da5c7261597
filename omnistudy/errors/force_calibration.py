"""Mistakes in measuring what a stick's PWM steps are in newtons."""

from __future__ import annotations

from omnistudy.errors.base import OmnistudyError


class TooFewReadings(OmnistudyError):
    """Readings that do not tell slope, dead band and offset apart."""

    def __init__(self, axis: str, count: int, least: int) -> None:
        super().__init__(
            f"{axis}: {count} readings do not tell slope, dead band and offset: give at least "
            f"{least}, of two sizes to either side beyond the dead band and some without force"
        )


class NoForceRead(OmnistudyError):
    """Readings that do not grow with the PWM steps."""

    def __init__(self, axis: str, slope: float, half_width: float) -> None:
        super().__init__(
            f"{axis}: the readings do not grow with the PWM steps (slope {slope:.3g} ± "
            f"{half_width:.2g} a step): is the motor on, the instrument in the way of the handle, "
            "and is a push forward, to the left or counter-clockwise read as positive?"
        )


class HandleMoved(OmnistudyError):
    """A handle that the instrument does not hold."""

    def __init__(self, axis: str, duty: int, moved: int, most: int) -> None:
        super().__init__(
            f"{axis}: at {duty:+d} PWM steps the handle moved by {moved} counts, more than {most}: "
            "fix it to the instrument so that it cannot move, and begin again"
        )


class ForceWithdrawn(OmnistudyError):
    """A stick that does not push as it was told while an instrument is read."""

    def __init__(self, axis: str, duty: int, why: str) -> None:
        super().__init__(
            f"{axis}: at {duty:+d} PWM steps the stick does not push ({why}): hold the dead-man's "
            "switch, release the emergency stop, and begin again"
        )


class NothingRead(OmnistudyError):
    """An instrument whose reading does not come."""

    def __init__(self, axis: str, duty: int, seconds: float) -> None:
        super().__init__(
            f"{axis}: no reading came for {duty:+d} PWM steps within {seconds:g} s, and motors "
            "must not heat up: begin again, and read quicker or wait less"
        )


class BrokenReadings(OmnistudyError):
    """A file of readings that cannot be used."""

    def __init__(self, where: str, fault: str) -> None:
        super().__init__(
            f"{where}: {fault}; a file of readings has the columns axis (x, y, theta), duty "
            "(PWM steps) and force (N; N·m for theta)"
        )


class CalibrationOfAnother(OmnistudyError):
    """A force calibration that was made with another stick."""

    def __init__(self, wanted: str, found: str) -> None:
        super().__init__(
            f"calibration: it was made with the stick of serial number {wanted}, but this one's is "
            f"{found}: name this stick's own calibration, or none to use nominal forces"
        )


class NoForceToCalibrate(OmnistudyError):
    """A device whose motors do not follow our firmware."""

    def __init__(self, device: str) -> None:
        super().__init__(
            f"device '{device}' has no motors behind our firmware, so there are no PWM steps to "
            "calibrate: give a page of kind serial_stick, or a stick's serial port"
        )


class PortNeeded(OmnistudyError):
    """A stick that is on no port, and no readings either."""

    def __init__(self, device: str) -> None:
        super().__init__(
            f"device '{device}' is at no serial port where it could be measured: give a page of "
            "kind serial_stick or a port, or readings with --readings FILE"
        )
