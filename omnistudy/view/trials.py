"""Which trials a study has, for the page that lists them."""

from __future__ import annotations

from omnistudy.registry import Model
from omnistudy.store.study_file import StudyFile
from omnistudy.study.frozen import frozen_protocol
from omnistudy.view.labels import Labels

SHOWN = ("trial", "participant", "position", "condition", "route", "status")


class ListedTrial(Model):
    """One row of the list; numbers are None until the trial was run.

    condition : as the list calls it, "" until it is chosen.
    """

    trial: int
    participant: str
    position: int
    condition: str
    route: str
    status: str
    duration_s: float | None
    collisions: int | None


class TrialList(Model):
    """A study's trials in their order.

    masked : whether conditions are called by their masked labels.
    """

    study: str
    title: str
    virtual: bool
    masked: bool
    trials: tuple[ListedTrial, ...]


def trial_list(study: StudyFile, *, unmask: bool = False) -> TrialList:
    """Read which trials there are; `unmask` gives the names of their conditions."""
    table = study.trials()
    protocol = frozen_protocol(study.study)
    rows = table[[*SHOWN, "duration_s", "collisions"]].astype(object)
    rows = rows.where(table[rows.columns].notna(), None)
    labels = Labels(study, unmask=unmask)
    rows["condition"] = [labels.of(condition) for condition in rows["condition"]]
    return TrialList(
        study=study.study.name,
        title=study.study.title,
        virtual=study.study.kind == "virtual" and not protocol.driven_by_people,
        masked=not unmask,
        trials=tuple(
            ListedTrial.model_validate({str(name): value for name, value in record.items()})
            for record in rows.to_dict("records")
        ),
    )
