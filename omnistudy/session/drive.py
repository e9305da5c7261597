"""The virtual driver in given worlds, without a study: how far it gets and what it touches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from omnistudy.channel import Recording
from omnistudy.operators import Person
from omnistudy.seeds import seed_text
from omnistudy.session.parts import part
from omnistudy.session.workers import run_all
from omnistudy.tasks.route import RouteTask
from omnistudy.trial import TrialResult, TrialSpec
from omnistudy.worlds import World

TASK = RouteTask()
"""Ends at the end of the route, or after 3 times its length at 0.36 m/s."""

STUCK_RADIUS = 0.5
"""m; who stays within this of where the time ran out, got no further (ours)."""
STUCK_TIME = 10.0
"""s; for at least this long (ours)."""

Outcome = Literal["reached", "stuck", "out of time"]


@dataclass(frozen=True, slots=True)
class Drive:
    """One drive of the virtual driver through a world along one of its routes.

    outcome : reached the end of the route, or not within the time limit; then stuck when the
        robot got no further for the last seconds, else out of time.
    time_s, limit_s : from the first command to the end; what was allowed.
    stuck_since_s : s since the first command from which it stayed where it was; None unless stuck.
    x, y : where the drive ended, m.
    wall : the wall of the last collision, "" without one.
    """

    world: str
    route: str
    law: str
    outcome: Outcome
    time_s: float
    limit_s: float
    collisions: int
    collisions_legacy: int
    contact_time_s: float
    path_length_m: float
    route_length_m: float
    x: float
    y: float
    stuck_since_s: float | None
    wall: str


def drive_worlds(
    worlds: Sequence[World],
    laws: Sequence[str],
    *,
    seed: int = 1,
    workers: int = 1,
    lab: Path | None = None,
    driven: Callable[[Drive], None] = lambda drive: None,
) -> tuple[Drive, ...]:
    """Drive each world along its first route under each law; the number of workers changes nothing.

    laws : pages of conf/law. The same person with the same noise drives under every law.
    driven : told of each drive as it ends, in order.

    Raises UnknownPart, BrokenPart, and what plants say of worlds in which they do not fit.
    """
    specs = [_spec(world, law, seed, lab) for world in worlds for law in laws]
    drives = []
    for spec, result in zip(specs, run_all(iter(specs), workers), strict=True):
        drive = _drive(spec, result)
        drives.append(drive)
        driven(drive)
    return tuple(drives)


def _spec(world: World, law: str, seed: int, lab: Path | None) -> TrialSpec:
    return TrialSpec(
        world=world,
        route=world.routes[0].name,
        plant=part("plant", "youbot", lab),
        device=part("device", "simulated_stick", lab),
        controller=part("controller", "rate", lab),
        law=part("law", law, lab),
        operator=part("operator", "virtual_driver", lab),
        task=TASK,
        recording=Recording(),
        messages=part("messages", "en", lab),
        person=Person(seed_text("drive", seed), seed_text("drive", seed, world.name), 1),
    )


def _drive(spec: TrialSpec, result: TrialResult) -> Drive:
    samples = result.samples
    x, y = float(samples[-1, 1]), float(samples[-1, 2])
    began = next((event.t for event in result.events if event.kind == "start"), 0.0)
    away = np.hypot(samples[:, 1] - x, samples[:, 2] - y) > STUCK_RADIUS
    since = float(samples[int(np.flatnonzero(away)[-1]), 0]) if away.any() else 0.0
    stuck = result.status != "completed" and samples[-1, 0] - since >= STUCK_TIME
    walls = [event.detail for event in result.events if event.kind == "collision"]
    route = spec.world.route(spec.route)
    return Drive(
        world=spec.world.name,
        route=route.name,
        law=spec.law.kind,
        outcome="reached"
        if result.status == "completed"
        else ("stuck" if stuck else "out of time"),
        time_s=result.duration_s,
        limit_s=TASK.limit(spec.world, spec.route),
        collisions=result.collisions,
        collisions_legacy=result.collisions_legacy,
        contact_time_s=result.contact_time_s,
        path_length_m=result.path_length_m,
        route_length_m=route.length,
        x=x,
        y=y,
        stuck_since_s=since - began if stuck else None,
        wall=walls[-1] if walls else "",
    )
