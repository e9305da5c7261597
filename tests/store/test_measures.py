"""Which device an attempt was driven with, how well it was run, and what limits leave out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import omnistudy
from omnistudy.channel import Event, Measure, measured
from omnistudy.devices import DeviceRecord, Identity
from omnistudy.errors.store import NoSuchTrial
from omnistudy.store import NewStudy, StudyWriter, TrialOutcome

STICK = DeviceRecord(
    "serial_stick",
    Identity("omnistudy stick", "A7", "1.2", "2026-11-22 9f3c"),
    ("stick_x", "stick_y"),
    "clipped",
)
LIMITED = '{"limits":[{"greatest":3.0,"measure":"late_steps"}]}'


class Finish:
    """Finishes trials, all alike but for device and measures."""

    def __init__(
        self, outcome: TrialOutcome, events: Sequence[Event], samples: NDArray[np.float64]
    ) -> None:
        self._left = outcome, events, samples, ()

    def __call__(self, path: Path, trial: int, *measures: Measure, device: object = STICK) -> None:
        assert device is None or isinstance(device, DeviceRecord)
        with StudyWriter.open(path) as writer:
            writer.start_trial(trial)
            writer.finish_trial(trial, *self._left, device, measures)


@pytest.fixture
def leave(outcome: TrialOutcome, events: tuple[Event, ...], samples: NDArray[np.float64]) -> Finish:
    return Finish(outcome, events, samples)


@pytest.fixture
def new_study(new_study: NewStudy) -> NewStudy:
    return replace(new_study, protocol_json=LIMITED)


def test_a_device_is_told_with_what_its_force_is(study: Path, leave: Finish) -> None:
    leave(study, 1)
    leave(study, 2, device=None)
    leave(study, 3, device=STICK._replace(identity=Identity("nameless")))
    with omnistudy.open(study) as opened:
        one, three = opened.devices().to_dict("records")
    assert one == {
        "trial": 1,
        "kind": "serial_stick",
        "model": "omnistudy stick",
        "serial": "A7",
        "firmware": "1.2",
        "calibration": "2026-11-22 9f3c",
        "pushes": "stick_x stick_y",
        "wrench": "clipped",
        "scale": "calibrated",
    }
    assert (three["trial"], three["model"], three["scale"]) == (3, "nameless", "nominal")


def test_measures_come_back_with_their_units(study: Path, leave: Finish) -> None:
    leave(study, 1, measured("late_steps", 2), measured("turn_lateness_max", 0.0035))
    with omnistudy.open(study) as opened:
        rows = opened.measures(1).values.tolist()
        assert rows == [[1, "late_steps", 2.0, "1"], [1, "turn_lateness_max", 0.0035, "s"]]
        assert len(opened.measures()) == 2
        with pytest.raises(NoSuchTrial):
            opened.measures(99)


def test_attempts_above_a_limit_are_listed_with_the_reason(study: Path, leave: Finish) -> None:
    leave(study, 1, measured("late_steps", 3), measured("late_turns", 50))
    leave(study, 2, measured("late_steps", 4), measured("late_turns", 0))
    leave(study, 3)
    with omnistudy.open(study) as opened:
        assert opened.exclusions().values.tolist() == [[2, "late_steps", 4.0, 3.0, "1"]]


def test_without_limits_nothing_is_left_out(driven: Path) -> None:
    with omnistudy.open(driven) as opened:
        assert opened.exclusions().empty
