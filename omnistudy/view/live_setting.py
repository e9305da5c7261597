"""What the pages of a live trial must know of it before its states arrive."""

from __future__ import annotations

import numpy as np

from omnistudy.errors.store import NoSuchTrial
from omnistudy.laws.boundary import boundary_of
from omnistudy.protocol.schedule import expected_duration
from omnistudy.store.study_file import StudyFile
from omnistudy.study.frozen import frozen_protocol
from omnistudy.view.film import Setting, setting_of

OUTLINE_POINTS = 128
"""As many as the thesis's lidar has rays."""


class LiveSetting(Setting):
    """A trial that is being driven; who drives it is known by a code, and the condition masked.

    boundary : line in m in the robot's frame inside which walls push; empty without one.
    place, places : of the trial in its participant's order.
    expected_s : how long it is likely to take. following : label of the next trial, "" at the end.
    """

    trial: int
    participant: str
    label: str
    route: str
    place: int
    places: int
    expected_s: float
    following: str
    boundary: tuple[tuple[float, float], ...]


def live_setting(study: StudyFile, trial: int) -> LiveSetting:
    """Read what a trial is shown in; raises NoSuchTrial."""
    protocol = frozen_protocol(study.study)
    table = study.trials()
    mine = table[table["trial"] == trial]
    if mine.empty:
        raise NoSuchTrial(study.path, trial)
    row = mine.iloc[0]
    own = table[(table["participant"] == row["participant"]) & (table["visit"] == row["visit"])]
    own = own[own["status"] != "void"]
    after = own[own["position"] > row["position"]]["condition"]
    masked = {condition.name: condition.masked_label for condition in protocol.conditions}
    setup = protocol.setup_for(row["condition"])
    line = boundary_of(setup.law)
    angles = np.linspace(-np.pi, np.pi, OUTLINE_POINTS, endpoint=False)
    towards = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    outline = line.reach(angles)[:, np.newaxis] * towards if line else np.empty((0, 2))
    return LiveSetting(
        **dict(setting_of(setup, row["route"])),
        trial=trial,
        participant=row["participant"],
        label=masked[row["condition"]],
        route=row["route"],
        place=int(row["position"]),
        places=len(own),
        expected_s=expected_duration(protocol, row["condition"], row["route"]),
        following=masked.get(after.iloc[0], "") if len(after) else "",
        boundary=tuple(outline.tolist()),
    )
