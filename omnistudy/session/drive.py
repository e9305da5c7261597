"""The virtual driver in given worlds, without a study: how far it gets and what it touches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from omnistudy.channel import Recording
from omnistudy.operators import Person
from omnistudy.operators.way import Way
from omnistudy.seeds import seed_text
from omnistudy.session.parts import part
from omnistudy.session.workers import run_all
from omnistudy.tasks.route import RouteTask
from omnistudy.trial import TrialResult, TrialSpec
from omnistudy.worlds import World

TASK = RouteTask()
"""Ends at the end of the route, or after 3 times its length at 0.36 m/s."""

Outcome = Literal["reached", "stuck"]


@dataclass(frozen=True, slots=True)
class Drive:
    """One drive of the virtual driver through a world along one of its routes.

    outcome : reached the end of the route within the time limit, or stuck on the way.
    time_s, limit_s : from the first command to the end; what was allowed.
    along_m : how far along the route it ever got.
    along_at_s : when it got so far, s since the first command.
    x, y : where it then was, m.
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
    along_m: float
    along_at_s: float
    x: float
    y: float
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
        route=world.first_route.name,
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
    row, along = _furthest(spec, result)
    began = next((event.t for event in result.events if event.kind == "start"), 0.0)
    walls = [event.detail for event in result.events if event.kind == "collision"]
    route = spec.world.route(spec.route)
    return Drive(
        world=spec.world.name,
        route=route.name,
        law=spec.law.kind,
        outcome="reached" if result.status == "completed" else "stuck",
        time_s=result.duration_s,
        limit_s=TASK.limit(spec.world, spec.route),
        collisions=result.collisions,
        collisions_legacy=result.collisions_legacy,
        contact_time_s=result.contact_time_s,
        path_length_m=result.path_length_m,
        route_length_m=route.length,
        along_m=along,
        along_at_s=max(0.0, float(result.samples[row, 0]) - began),
        x=float(result.samples[row, 1]),
        y=float(result.samples[row, 2]),
        wall=walls[-1] if walls else "",
    )


def _furthest(spec: TrialSpec, result: TrialResult) -> tuple[int, float]:
    """Give the row of the samples at which the robot had got furthest, and how far, m."""
    legs = list(spec.world.route(spec.route).legs)
    arrivals = [event.t for event in result.events if event.kind in ("block", "finish")]
    best, behind, way = (0, 0.0), 0.0, Way(legs.pop(0))
    for row, (t, x, y) in enumerate(result.samples[:, :3].tolist()):
        if legs and arrivals and t >= arrivals[0]:
            arrivals.pop(0)
            behind += way.length
            way = Way(legs.pop(0))
        along = behind + way.find(x, y)
        if along > best[1]:
            best = row, along
    return best
