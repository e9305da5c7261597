"""A small study on disk, and one trial's worth of numbers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from omnistudy.channel import SAMPLE_COLUMNS, Channel, Event, Stream
from omnistudy.store import (
    Level,
    NewAllocation,
    NewCondition,
    NewParticipant,
    NewStudy,
    NewTrial,
    StudyWriter,
    TrialOutcome,
)

INPUT_CHANNELS = tuple(Channel(f"axis_{i}", "m", f"axis {i} of the stick") for i in range(6))

MakeStudy = Callable[[Path], Path]
FinishTrial = Callable[[StudyWriter, int], None]


@pytest.fixture
def new_study() -> NewStudy:
    return NewStudy(
        name="small",
        title="A small study",
        kind="virtual",
        protocol_json='{"title":"A small study"}',
        protocol_version=1,
        design_hash="d" * 64,
        site_hash="e" * 64,
    )


@pytest.fixture
def make_study(new_study: NewStudy) -> MakeStudy:
    """Make a study of two participants who have three planned trials each (ids 1-3 and 4-6)."""

    def make(path: Path) -> Path:
        with StudyWriter.create(path, new_study) as writer:
            writer.add_conditions(
                [
                    NewCondition(
                        name="with",
                        masked_label="A",
                        levels=(Level("law", "component"), Level("route", "long")),
                    ),
                    NewCondition(
                        name="without",
                        masked_label="B",
                        levels=(Level("law", "none"), Level("route", "long")),
                    ),
                ]
            )
            writer.add_allocations(NewAllocation(slot, "", "", slot) for slot in range(4))
            for number, kind in ((1, "virtual"), (2, "human")):
                participant = writer.add_participant(
                    NewParticipant(code=f"P{number:02}", kind=kind, seed=str(number) * 64),
                    slot=number - 1,
                )
                session = writer.add_session(participant)
                for position in (1, 2, 3):
                    writer.add_trial(
                        NewTrial(
                            session_id=session,
                            position=position,
                            kind="main",
                            task="route",
                            route="b",
                            seed=f"{number}{position}" * 32,
                            condition="with" if position % 2 else "without",
                            repetition=position,
                        )
                    )
        return path

    return make


@pytest.fixture
def study(make_study: MakeStudy, tmp_path: Path) -> Path:
    return make_study(tmp_path / "small.db")


@pytest.fixture
def outcome() -> TrialOutcome:
    return TrialOutcome(
        status="completed",
        reason="",
        duration_s=12.5,
        path_length_m=4.25,
        collisions=2,
        collisions_legacy=5,
        contact_time_s=0.75,
    )


@pytest.fixture
def events() -> tuple[Event, ...]:
    return (Event(0.5, "start"), Event(3.0, "collision", "wall"), Event(13.0, "finish"))


@pytest.fixture
def samples() -> NDArray[np.float64]:
    """Give (200, 13) at 20 Hz, with a column that the plant does not know."""
    table = np.random.default_rng(3).normal(size=(200, len(SAMPLE_COLUMNS)))
    table[:, 0] = np.arange(200) / 20
    table[:, SAMPLE_COLUMNS.index("omega")] = np.nan
    return table


@pytest.fixture
def stream() -> Stream:
    """Give 10 000 rows at 240 Hz, more than two chunks."""
    data = np.cumsum(np.random.default_rng(4).normal(size=(10_000, 6)), axis=0) * 1e-4
    return Stream("input", 240.0, INPUT_CHANNELS, data)


@pytest.fixture
def finish(
    outcome: TrialOutcome,
    events: tuple[Event, ...],
    samples: NDArray[np.float64],
    stream: Stream,
) -> FinishTrial:
    """Start a trial and write all that it leaves behind."""

    def finish_trial(writer: StudyWriter, trial: int) -> None:
        writer.start_trial(trial)
        writer.finish_trial(trial, outcome, events, samples, [stream])

    return finish_trial


@pytest.fixture
def driven(study: Path, finish: FinishTrial) -> Path:
    """Give the study with trials 1 and 2 completed."""
    with StudyWriter.open(study) as writer:
        finish(writer, 1)
        finish(writer, 2)
    return study
