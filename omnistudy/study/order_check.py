"""That what is stored to be run is what the protocol plans, trial by trial."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from omnistudy.errors.study import OrderDiffers
from omnistudy.protocol import PlannedTrial, Protocol, StudyPlan
from omnistudy.protocol.ordering.order import PastTrial
from omnistudy.store import StoredTrial

ENDED = ("completed", "timed_out")
"""Statuses of trials that have a result."""


class OrderCheck:
    """Holds a study's trials against the plan that its first freeze decided.

    design_hash : of the first freeze.
    """

    def __init__(self, study: str, protocol: Protocol, design_hash: str) -> None:
        self._study = study
        self._plan = StudyPlan(protocol, design_hash)
        self._planned: dict[int, tuple[PlannedTrial, ...]] = {}

    def check(self, trials: Iterable[StoredTrial]) -> None:
        """Raise OrderDiffers for the first trial that is not the planned one of its place."""
        for trial in trials:
            planned = self.planned(trial)
            place = (trial.visit, trial.kind, trial.route)
            same = place == (planned.visit, planned.kind, planned.route)
            fixed = planned.condition is not None
            if not same or (fixed and planned[3:5] != (trial.condition, trial.repetition)):
                raise OrderDiffers(self._study, trial.participant_code, trial.position)

    def planned(self, trial: StoredTrial) -> PlannedTrial:
        """Give what is planned in a trial's place; raises OrderDiffers where nothing is."""
        if trial.slot not in self._planned:
            self._planned[trial.slot] = self._plan.trials(trial.slot)
        trials = self._planned[trial.slot]
        if trial.position > len(trials):
            raise OrderDiffers(self._study, trial.participant_code, trial.position)
        return trials[trial.position - 1]

    def chosen(self, trial: StoredTrial, own: Sequence[StoredTrial]) -> str:
        """Ask the order of a trial that adapts for its condition.

        own : all trials of the participant, in order. Raises OrderDiffers when the order has no
        more.
        """
        block = self.planned(trial).block
        history = [
            PastTrial(
                past.condition or "", past.status, past.duration_s or 0.0, past.collisions or 0
            )
            for past in own
            if past.status in ENDED
            and past.position < trial.position
            and self.planned(past).block == block
            and past.kind == trial.kind
        ]
        condition = self._plan.next_condition(trial.slot, block, history)
        if condition is None:
            raise OrderDiffers(self._study, trial.participant_code, trial.position)
        return condition
