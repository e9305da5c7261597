"""Which trials a study has, for the page that lists them."""

from __future__ import annotations

from omnistudy.registry import Model
from omnistudy.store.study_file import StudyFile

SHOWN = ("trial", "participant", "position", "condition", "route", "status")


class ListedTrial(Model):
    """One row of the list; numbers are None until the trial was run."""

    trial: int
    participant: str
    position: int
    condition: str | None
    route: str
    status: str
    duration_s: float | None
    collisions: int | None


class TrialList(Model):
    """A study's trials in their order."""

    study: str
    title: str
    virtual: bool
    trials: tuple[ListedTrial, ...]


def trial_list(study: StudyFile) -> TrialList:
    """Read which trials there are."""
    table = study.trials()
    rows = table[[*SHOWN, "duration_s", "collisions"]].astype(object)
    records = rows.where(table[rows.columns].notna(), None).to_dict("records")
    return TrialList(
        study=study.study.name,
        title=study.study.title,
        virtual=study.study.kind == "virtual",
        trials=tuple(
            ListedTrial.model_validate({str(name): value for name, value in record.items()})
            for record in records
        ),
    )
