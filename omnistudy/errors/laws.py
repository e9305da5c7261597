"""Mistakes in what laws are probed and drawn with."""

from pathlib import Path

from omnistudy.errors.base import OmnistudyError


class BadScanFile(OmnistudyError):
    """A scan file that cannot be read as one turn of a range sensor."""

    def __init__(self, path: Path, fault: str) -> None:
        super().__init__(
            f"scan file {path}: {fault}; it is JSON with 'angles' (rad), 'ranges' (m), "
            "'max_range' (m) and, where it matters, 'x', 'y' (m) and 'rates' (m/s) of each ray"
        )


class NoForce(OmnistudyError):
    """A law whose wrench is not a finite number."""

    def __init__(self, kind: str, wrench: tuple[float, float, float]) -> None:
        fx, fy, tau = wrench
        super().__init__(
            f"law '{kind}' gives fx = {fx:g} N, fy = {fy:g} N, tau = {tau:g} N·m: a law must give "
            "finite numbers whatever it senses, so mend it before it reaches a hand"
        )
