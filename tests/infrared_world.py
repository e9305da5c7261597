"""A Nexus with sensors whose faults are taken out one by one."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from core_world import scene

from omnistudy.geometry import PlanarPose, PlanarTwist, Scan
from omnistudy.plants import RunningPlant
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.nexus import Nexus
from omnistudy.scene import Body

HZ = 240
ORIGIN = PlanarPose(0.0, 0.0, 0.0)
UNFILTERED = 1e6
"""Hz: a low-pass that passes all."""


def ring(**changes: Any) -> InfraredRing:
    """Sensors that see exactly what is there, but for the changes."""
    exact = {"noise": 0.0, "interference": 0.0, "cutoff": UNFILTERED}
    return InfraredRing.model_validate({**exact, **changes})


@contextmanager
def nexus(
    *bodies: Body, start: PlanarPose = ORIGIN, seed: str = "seed", **sensors: Any
) -> Iterator[RunningPlant]:
    """A running Nexus between bodies, with `ring(**sensors)`."""
    plant = Nexus(sensors=ring(**sensors)).build(scene(*bodies), start, HZ, seed)
    try:
        yield plant
    finally:
        plant.close()


def scanned(plant: RunningPlant) -> Scan:
    """One scan, which such a robot always has."""
    scan = plant.scan()
    assert scan is not None
    return scan


def drive(plant: RunningPlant, twist: PlanarTwist, scans: int, every: int = 5) -> list[Scan]:
    """Drive on and scan after every few steps."""
    seen = []
    for _ in range(scans):
        for _ in range(every):
            plant.command(twist)
            plant.step()
        seen.append(scanned(plant))
    return seen
