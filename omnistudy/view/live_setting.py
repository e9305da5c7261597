"""What the pages of a live trial must know of it before its states arrive."""

from __future__ import annotations

import numpy as np
from pandas import DataFrame

from omnistudy.errors.store import NoSuchTrial
from omnistudy.laws.boundary import boundary_of
from omnistudy.protocol import Protocol, Setup
from omnistudy.protocol.schedule import expected_duration
from omnistudy.registry import Model
from omnistudy.store.study_file import StudyFile
from omnistudy.study.frozen import frozen_protocol
from omnistudy.view.film import Setting, setting_of
from omnistudy.view.labels import Labels

OUTLINE_POINTS = 128
"""As many as the thesis's lidar has rays."""


class Coming(Model):
    """A trial that is still to come in the same visit.

    label : of its condition; "" while that is still to be chosen. expected_s : likely to last.
    """

    place: int
    kind: str
    label: str
    route: str
    expected_s: float


class LiveSetting(Setting):
    """A trial that is being driven; who drives it is known by a code, and the condition masked.

    boundary : line in m in the robot's frame inside which walls push; empty without one.
    label : of the condition, its name where `masked` is False.
    visit, place, places : of the trial in its participant's order.
    expected_s : how long it is likely to take. coming : what follows in the visit.
    pause_s : planned between two trials.
    """

    trial: int
    participant: str
    label: str
    masked: bool
    kind: str
    route: str
    visit: int
    place: int
    places: int
    expected_s: float
    coming: tuple[Coming, ...]
    pause_s: float
    boundary: tuple[tuple[float, float], ...]


def live_setting(study: StudyFile, trial: int, *, unmask: bool = False) -> LiveSetting:
    """Read what a trial is shown in; raises NoSuchTrial. `unmask` names conditions."""
    protocol = frozen_protocol(study.study)
    table = study.trials()
    mine = table[table["trial"] == trial]
    if mine.empty:
        raise NoSuchTrial(study.path, trial)
    row = mine.iloc[0]
    own = table[(table["participant"] == row["participant"]) & (table["visit"] == row["visit"])]
    after = own[(own["position"] > row["position"]) & (own["status"] == "planned")]
    labels = Labels(study, unmask=unmask)
    setup = protocol.setup_for(row["condition"])
    return LiveSetting(
        **dict(setting_of(setup, row["route"])),
        trial=trial,
        participant=row["participant"],
        label=labels.of(row["condition"]),
        masked=not unmask,
        kind=row["kind"],
        route=row["route"],
        visit=int(row["visit"]),
        place=int(row["position"]),
        places=int(own["position"].nunique()),
        expected_s=expected_duration(protocol, row["condition"], row["route"]),
        coming=_coming(protocol, after, labels),
        pause_s=protocol.session.pause,
        boundary=_outline(setup),
    )


def _coming(protocol: Protocol, trials: DataFrame, labels: Labels) -> tuple[Coming, ...]:
    shown = trials[["position", "kind", "condition", "route"]].astype(object)
    rows = shown.where(shown.notna(), None).itertuples(index=False, name=None)
    return tuple(
        Coming(
            place=place,
            kind=kind,
            label=labels.of(condition),
            route=route,
            expected_s=expected_duration(protocol, condition, route),
        )
        for place, kind, condition, route in rows
    )


def _outline(setup: Setup) -> tuple[tuple[float, float], ...]:
    """Give the line inside which walls push, (x, y) in m in the robot's frame."""
    line = boundary_of(setup.law)
    if line is None:
        return ()
    angles = np.linspace(-np.pi, np.pi, OUTLINE_POINTS, endpoint=False)
    towards = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    return tuple((float(x), float(y)) for x, y in line.reach(angles)[:, np.newaxis] * towards)
