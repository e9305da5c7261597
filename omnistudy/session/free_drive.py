"""Driving freely: a study of one participant, one condition and one trial, made on the spot."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Literal, NamedTuple

from omnistudy.protocol import Protocol
from omnistudy.protocol.condition import Condition
from omnistudy.protocol.ordering.permuted_blocks import PermutedBlocks
from omnistudy.protocol.participants import Participants
from omnistudy.protocol.site import Ethics, Site
from omnistudy.session.parts import part
from omnistudy.study import create_study
from omnistudy.study.find import studies_folder
from omnistudy.tasks import Task
from omnistudy.tasks.free import FreeTask
from omnistudy.tasks.route import RouteTask
from omnistudy.worlds import load_world

DRIVES = "drives"
"""Folder among the studies where drives are kept."""
WhoseHand = Literal["person", "virtual"]
OPERATORS: Mapping[WhoseHand, str] = {"person": "person", "virtual": "virtual_driver"}
"""Page of conf/operator of each hand."""


class DriveParts(NamedTuple):
    """What is to be coupled, each part by the name of its page.

    route : "" is no route for a person, who drives as it pleases, and the world's first for the
        virtual driver.
    hand : who holds the device.
    minutes : after which a drive without a route ends.
    """

    world: str
    device: str
    law: str
    controller: str = "rate"
    plant: str = "youbot"
    route: str = ""
    hand: WhoseHand = "person"
    minutes: float = 10.0
    seed: int = 1


def drive_file(world: str, now: datetime) -> Path:
    """Give the file that a drive begun at this moment is kept in."""
    stem = Path(world).stem
    return studies_folder() / DRIVES / f"{stem}_{now:%Y-%m-%d_%H%M%S}.db"


def make_drive(parts: DriveParts, path: Path, lab: Path | None = None) -> None:
    """Make the study file of a drive, its only trial planned.

    Raises UnknownPart, BrokenPart, UnknownWorld, UnknownRoute, NoRoute, NobodyHolds, StudyExists,
    NotWritable.
    """
    protocol = drive_protocol(parts, lab)
    protocol.operator.check_hold(protocol.device)
    path.parent.mkdir(parents=True, exist_ok=True)
    create_study(protocol, path, path.stem)


def drive_protocol(parts: DriveParts, lab: Path | None = None) -> Protocol:
    """Couple the parts of a drive; raises as `make_drive`."""
    world = load_world(parts.world, lab)
    route = (world.route(parts.route) if parts.route else world.first_route).name
    return Protocol(
        name=DRIVES,
        title=f"Free drive in {world.name} under {parts.law}",
        site=Site(ethics=Ethics(status="not_needed", note="A drive, not a study.")),
        messages=part("messages", "en", lab),
        conditions=(Condition(name="drive", masked_label="drive", levels=()),),
        world=world,
        plant=part("plant", parts.plant, lab),
        device=part("device", parts.device, lab),
        controller=part("controller", parts.controller, lab),
        law=part("law", parts.law, lab),
        operator=part("operator", OPERATORS[parts.hand], lab),
        task=_task(parts),
        order=PermutedBlocks(),
        routes=(route,),
        participants=Participants(
            kind="virtual", count=1, study_key=str(parts.seed), participant_key=str(parts.seed)
        ),
    )


def _task(parts: DriveParts) -> Task:
    """Give the route to whoever needs one, else nothing to do but drive."""
    if parts.route or parts.hand == "virtual":
        return RouteTask()
    return FreeTask(duration=60.0 * parts.minutes)
