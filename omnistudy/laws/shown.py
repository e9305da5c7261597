"""How a law is asked for its picture: at rest, or with the stick held if rest shows nothing."""

from __future__ import annotations

from omnistudy.geometry import ZERO_MATRIX, PlanarTwist, Scan, Vector3
from omnistudy.laws.impedance import ImpedanceLaw
from omnistudy.laws.law import Law, Sensed
from omnistudy.laws.probe import Probe, probe

_AT_REST = PlanarTwist(0.0, 0.0, 0.0), (0.0, 0.0, 0.0)

_FULL_AHEAD: tuple[PlanarTwist, Vector3] = PlanarTwist(0.36, 0.0, 0.0), (0.0414, 0.0, 0.0)
"""The published stick at its limit of 300 counts, and what it asks for (appendix B)."""


def shown(law: Law, scan: Scan) -> Probe:
    """Give what a picture of a law shows for a scan; raises NoForce."""
    twist, stick = _FULL_AHEAD if isinstance(law, ImpedanceLaw) else _AT_REST
    return probe(law, Sensed(scan, twist, ZERO_MATRIX, stick))


def stick_shown(law: Law) -> str:
    """Say how the stick is held in pictures of a law, "" for one at rest."""
    return ", stick held full ahead" if isinstance(law, ImpedanceLaw) else ""
