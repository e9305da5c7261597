"""The numbers of docs/first-robot.md: a pass by a corner, and trials that were driven."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import SAMPLE_COLUMNS
from omnistudy.geometry import PlanarPose, PlanarTwist, Scan
from omnistudy.laws.law import WrenchLaw
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.nexus import LidarAtCentre, Nexus
from omnistudy.protocol import Protocol
from omnistudy.protocol.compose import compose_protocol
from omnistudy.scene import Body, Box, Scene
from omnistudy.session.rehearsal import Rehearsed, rehearse

Floats = NDArray[np.float64]

PROTOCOL = "utah2017_sensors"
CONDITIONS = ("six_rays", "circular", "rectangular")
NAMES = {
    "six_rays": "six rays",
    "circular": "128 rays, circular",
    "rectangular": "128 rays, rectangular",
}
COLOURS = {"six_rays": "#d55e00", "circular": "#0072b2", "rectangular": "#009e73"}
"""Okabe and Ito's, as in every report."""

PHYSICS_HZ, STEPS_PER_SCAN = 250, 5
"""50 scans a second exactly."""
PASSING = PlanarTwist(0.1, 0.0, 0.0)
GAPS = (0.04, 0.06, 0.08, 0.10)
"""m between the robot's side and the wall."""
DRAWN_GAP = 0.06
BESIDE = -0.5
"""m: up to here the robot is well beside the wall, whatever the field."""
BIG = 0.1
"""A change of more than this part of the force beside the wall is counted."""

SENSORS: dict[str, dict[str, float | str]] = {
    "faultless": {"noise": 0.0, "interference": 0.0, "cutoff": 1e6},
    "as they are, without interference": {"interference": 0.0},
    "interference in one scan of 200": {"interference": 0.005},
    "as they are: in one scan of 50": {},
    "in one scan of 20": {"interference": 0.05},
    "rates from ranges, without interference": {"rates_from": "ranges", "interference": 0.0},
    "rates from ranges": {"rates_from": "ranges"},
}
"""What is changed in the six sensors, one after the other."""

FAULTLESS = InfraredRing.model_validate(SENSORS["faultless"])
RATES_FROM_RANGES = InfraredRing(rates_from="ranges")
UNSTEADY_FROM = 5.0
"""Hz: faster than anybody steers (the thesis's own band for steering ends at 2 Hz)."""


@dataclass(frozen=True)
class Field:
    """One way of feeling walls: sensors and a law."""

    name: str
    sensors: InfraredRing | LidarAtCentre
    law: WrenchLaw
    colour: str


@dataclass(frozen=True)
class Jumps:
    """How a force changes from scan to scan.

    beside, greatest : N, the force beside the wall (median) and the greatest one.
    largest : N, the greatest change in one scan. big : changes above BIG of `beside`.
    """

    beside: float
    greatest: float
    largest: float
    big: int

    @property
    def share(self) -> float:
        """Give the greatest change as a part of the force beside the wall."""
        return self.largest / self.beside


@cache
def fields() -> tuple[Field, ...]:
    """Give the protocol's three fields, and the six rays without faults and with other rates."""
    six, circular, rectangular = (_field(name) for name in CONDITIONS)
    return (
        Field("six rays, faultless", FAULTLESS, six.law, "#343a40"),
        six,
        Field("six rays, rates from ranges", RATES_FROM_RANGES, six.law, "#cc79a7"),
        circular,
        rectangular,
    )


@cache
def _protocol() -> Protocol:
    return compose_protocol(PROTOCOL)


def _field(name: str) -> Field:
    protocol = _protocol()
    condition = next(one for one in protocol.conditions if one.name == name)
    law, plant = condition.law or protocol.law, condition.plant or protocol.plant
    assert isinstance(law, WrenchLaw)
    assert isinstance(plant, Nexus)
    return Field(NAMES[name], plant.sensors, law, COLOURS[name])


def pass_corner(sensors: InfraredRing | LidarAtCentre, gap: float) -> tuple[Floats, list[Scan]]:
    """Drive straight past a corner on the left, from beside the wall to beyond it.

    Gives the robot's x in m (the corner is at 0) at every scan, and the scans.
    """
    nexus = Nexus(sensors=sensors)
    block = Body(
        name="block",
        role="wall",
        geometry=Box(x=3.0, y=1.0, z=0.8),
        x=-1.5,
        y=nexus.half_width + gap + 0.5,
        z=0.4,
    )
    plant = nexus.build(Scene(bodies=(block,)), PlanarPose(-0.8, 0.0, 0.0), PHYSICS_HZ, "corner")
    x, scans = [], []
    while plant.state.pose.x < 0.6:
        scan = plant.scan()
        assert scan is not None
        x.append(plant.state.pose.x)
        scans.append(scan)
        for _ in range(STEPS_PER_SCAN):
            plant.command(PASSING)
            plant.step()
    plant.close()
    return np.array(x), scans


def forces(law: WrenchLaw, scans: Sequence[Scan]) -> Floats:
    """Give (n, 2) N: what the hand feels at each scan."""
    return np.array([law.wrench(scan, PASSING)[:2] for scan in scans])


def jumps(x: Floats, force: Floats) -> Jumps:
    """Give how a force (n, 2) in N changes from scan to scan, x (n,) in m from the corner."""
    strength = np.hypot(*force.T)
    beside = float(np.median(strength[x < BESIDE]))
    changes = np.hypot(*np.diff(force, axis=0).T)
    return Jumps(
        beside, float(strength.max()), float(changes.max()), int((changes > BIG * beside).sum())
    )


def corner_table() -> list[str]:
    """Give the rows of the table of the corner pass."""
    head = (
        "field",
        "force beside the wall",
        "greatest force",
        "greatest change in one scan",
        "of the force beside",
        "changes over a tenth of it",
        f"with gaps of {min(GAPS):g} to {max(GAPS):g} m",
    )
    rows = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    for field in fields():
        found = {gap: look(field, gap) for gap in GAPS}
        drawn, shares = found[DRAWN_GAP], [100 * one.share for one in found.values()]
        rows.append(
            f"| {field.name} | {drawn.beside:.2f} N | {drawn.greatest:.2f} N | "
            f"{drawn.largest:.2f} N | {100 * drawn.share:.0f} % | {drawn.big} | "
            f"{min(shares):.0f} to {max(shares):.0f} % |"
        )
    return rows


def look(field: Field, gap: float) -> Jumps:
    """Pass the corner with one field."""
    x, scans = pass_corner(field.sensors, gap)
    return jumps(x, forces(field.law, scans))


@dataclass(frozen=True)
class Steadiness:
    """What a trial's force came to.

    rms : N, of all of it. unsteady : part of the power above UNSTEADY_FROM. felt : part of the
    time. stick : mm, RMS of the stick's movement above UNSTEADY_FROM.
    """

    rms: float
    unsteady: float
    felt: float
    stick: float
    collisions: int
    duration: float


def force_of(driven: Rehearsed) -> tuple[Floats, Floats]:
    """Give t (n,) in s and the force (n, 2) in N of a trial."""
    return driven.result.samples[:, 0], _columns(driven, "fx", "fy")


def steadiness(driven: Rehearsed, hz: float) -> Steadiness:
    """Look at the samples of one trial."""
    _, force = force_of(driven)
    total, fast = _power(force, hz)
    return Steadiness(
        rms=float(np.sqrt((force**2).sum(axis=1).mean())),
        unsteady=fast / total,
        felt=float((force != 0.0).any(axis=1).mean()),
        stick=1000 * float(np.sqrt(_power(_columns(driven, "stick_x", "stick_y"), hz)[1])),
        collisions=driven.result.collisions,
        duration=driven.result.duration_s,
    )


def _columns(driven: Rehearsed, *names: str) -> Floats:
    return driven.result.samples[:, [SAMPLE_COLUMNS.index(name) for name in names]]


def _power(signal: Floats, hz: float) -> tuple[float, float]:
    """Give the mean square about the mean, and of that what lies above UNSTEADY_FROM."""
    spectrum = np.fft.fft(signal - signal.mean(axis=0), axis=0)
    power = (np.abs(spectrum) ** 2).sum(axis=1) / len(signal) ** 2
    fast = np.abs(np.fft.fftfreq(len(signal), 1.0 / hz)) >= UNSTEADY_FROM
    return float(power.sum()), float(power[fast].sum())


def drive() -> dict[str, list[Rehearsed]]:
    """Let every participant of the protocol drive once in each condition."""
    driven: dict[str, list[Rehearsed]] = {name: [] for name in CONDITIONS}
    for slot in range(_protocol().participants.count):
        for one in rehearse(_protocol(), CONDITIONS, slot):
            driven[one.condition].append(one)
    return driven


def sensors_table() -> list[str]:
    """Give the rows of the table of six rays driven with other sensors."""
    rows = [f"| six sensors | power above {UNSTEADY_FROM:g} Hz |", "| --- | --- |"]
    for name, changes in SENSORS.items():
        protocol = compose_protocol(
            PROTOCOL, [f"+plant.sensors.{key}={value}" for key, value in changes.items()]
        )
        fast = [
            100 * steadiness(one, protocol.recording.sample_hz).unsteady
            for slot in range(protocol.participants.count)
            for one in rehearse(protocol, CONDITIONS[:1], slot)
        ]
        rows.append(f"| {name} | {np.mean(fast):.2f} % ({min(fast):.2f} to {max(fast):.2f}) |")
    return rows


def driven_table(driven: dict[str, list[Rehearsed]]) -> list[str]:
    """Give the rows of the table of driven trials: means over participants, least to most."""
    hz = _protocol().recording.sample_hz
    head = (
        "condition",
        "force (RMS)",
        f"its power above {UNSTEADY_FROM:g} Hz",
        "felt",
        f"stick above {UNSTEADY_FROM:g} Hz",
        "collisions",
        "time",
    )
    rows = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    for name, trials in driven.items():
        found = [steadiness(one, hz) for one in trials]
        fast = [100 * one.unsteady for one in found]
        rows.append(
            f"| `{name}` | {np.mean([one.rms for one in found]):.2f} N | {np.mean(fast):.2f} % "
            f"({min(fast):.2f} to {max(fast):.2f}) | "
            f"{100 * np.mean([one.felt for one in found]):.0f} % | "
            f"{np.mean([one.stick for one in found]):.2f} mm | "
            f"{np.mean([one.collisions for one in found]):.1f} | "
            f"{np.mean([one.duration for one in found]):.1f} s |"
        )
    return rows
