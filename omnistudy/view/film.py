"""A film: everything a page needs to show a stored trial again."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import SAMPLE_CHANNELS, Channel, Event
from omnistudy.errors.view import NothingToShow
from omnistudy.metrics.clearance import clearance
from omnistudy.protocol import Setup
from omnistudy.registry import Model
from omnistudy.scene import Link, Scene, Sight
from omnistudy.store.study_file import StudyFile
from omnistudy.study.frozen import frozen_protocol
from omnistudy.view.captions import Caption, captions
from omnistudy.view.labels import Labels
from omnistudy.worlds import Leg

Floats = NDArray[np.float64]

CLEARANCE = Channel("clearance", "m", "gap between the robot's outline and the nearest wall")


class Series(Model):
    """One quantity over time: little-endian 32-bit floats in base64, one a sample."""

    name: str
    unit: str
    description: str
    data: str


class Setting(Model):
    """What a robot is shown in: the world, the way, the robot's looks; lengths in m.

    sight : rays of its range sensor; None without one.
    start : x, y, theta where it stands unless its place is recorded, as that of an arm is not.
    """

    scene: Scene
    legs: tuple[Leg, ...]
    links: tuple[Link, ...]
    footprint: tuple[float, float]
    sight: Sight | None
    start: tuple[float, float, float]


class Film(Setting):
    """One trial to be looked at; times in s since it opened, lengths in m.

    condition : its masked label where `masked`, else its name.
    `series` has "t" and every channel that was recorded at the sample rate.
    """

    study: str
    virtual: bool
    trial: int
    participant: str
    condition: str
    masked: bool
    route: str
    status: str
    end: float
    duration_s: float | None
    collisions: int | None
    series: tuple[Series, ...]
    events: tuple[Event, ...]
    captions: tuple[Caption, ...]


def film(study: StudyFile, trial: int, *, unmask: bool = False) -> Film:
    """Read a trial of a study; raises NoSuchTrial, NothingToShow, and what reading raises.

    unmask : name the condition; otherwise the film holds nothing but its masked label.
    """
    samples = study.sample_array(trial)
    row = _row(study, trial)
    if len(samples) == 0:
        raise NothingToShow(study.study.name, trial, str(row["status"]))
    protocol = frozen_protocol(study.study)
    setup = protocol.setup_for(row["condition"])
    times, end = samples[:, 0], float(samples[-1, 0])
    gap = clearance(times, samples[:, 1:4], setup.plant.footprint, setup.world.scene.bodies)
    recorded = dict(zip(SAMPLE_CHANNELS, samples[:, 1:].T, strict=True))
    recorded |= dict(_streamed(study, trial, len(times))) | {CLEARANCE: gap}
    found = study.events(trial)[["t", "kind", "detail"]]
    events = tuple(Event(*row) for row in found.itertuples(index=False, name=None))
    return Film(
        study=study.study.name,
        virtual=study.study.kind == "virtual" and setup.operator.in_lockstep,
        trial=trial,
        participant=row["participant"],
        condition=Labels(study, unmask=unmask).of(row["condition"]),
        masked=not unmask,
        route=row["route"],
        status=row["status"],
        end=end,
        duration_s=_number(row["duration_s"]),
        collisions=_count(row["collisions"]),
        **dict(setting_of(setup, row["route"])),
        series=(
            _series(Channel("t", "s", "since the trial opened"), times),
            *(_series(channel, values) for channel, values in recorded.items()),
        ),
        events=events,
        captions=captions(events, end),
    )


def setting_of(setup: Setup, route: str) -> Setting:
    """Give what the trials of a set-up on a route are shown in."""
    start = setup.world.start.pose
    routes = (one.legs for one in setup.world.routes if one.name == route)
    return Setting(
        scene=setup.world.scene,
        legs=next(routes, ()),
        links=setup.plant.links,
        footprint=setup.plant.footprint,
        sight=setup.plant.sight,
        start=(start.x, start.y, start.theta),
    )


def _row(study: StudyFile, trial: int) -> Mapping[str, Any]:
    trials = study.trials()
    found = trials[trials["trial"] == trial].to_dict("records")
    return {str(name): value for name, value in found[0].items()}


def _streamed(study: StudyFile, trial: int, rows: int) -> Iterator[tuple[Channel, Floats]]:
    """Give the channels of streams that have a row a sample; the input's are far more."""
    for name, count in study.streams(trial)[["name", "rows"]].itertuples(index=False, name=None):
        if count == rows:
            stream = study.stream_record(trial, name)
            yield from zip(stream.channels, stream.data.T, strict=True)


def _series(channel: Channel, values: Floats) -> Series:
    data = b64encode(values.astype("<f4").tobytes()).decode()
    return Series(name=channel.name, unit=channel.unit, description=channel.description, data=data)


def _number(value: float) -> float | None:
    return None if value != value else float(value)


def _count(value: float) -> int | None:
    return None if value != value else int(value)
