"""Running the planned trials of a study's virtual participants."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from omnistudy.errors.session import HumanParticipants
from omnistudy.errors.study import UnknownParticipant
from omnistudy.protocol import Protocol
from omnistudy.session.specs import trial_spec
from omnistudy.session.workers import run_all
from omnistudy.store import StoredTrial, StudyWriter, TrialOutcome
from omnistudy.study.frozen import check_unchanged, frozen_protocol
from omnistudy.study.order_check import ENDED, OrderCheck
from omnistudy.trial import TrialResult, TrialSpec

Run = Callable[[Sequence[StoredTrial], Iterator[TrialSpec]], Iterator[TrialResult]]
"""Drives trials one after the other, each result in the place of its spec."""


@dataclass(frozen=True, slots=True)
class RunSummary:
    """What a run did: trials by how they ended, and how many are still planned."""

    completed: int
    timed_out: int
    aborted: int
    remaining: int


def run_trials(
    path: Path,
    *,
    participants: tuple[str, ...] = (),
    limit: int | None = None,
    workers: int = 1,
    protocol: Protocol | None = None,
    run: Run | None = None,
    finished: Callable[[StoredTrial, TrialResult], None] = lambda trial, result: None,
) -> RunSummary:
    """Run what is planned, in order, each trial written whole as it ends; a stop loses none.

    participants : codes; none means all. limit : run at most so many trials.
    protocol : when given, it must be the frozen one.
    run : drives the trials instead of `workers` processes, such as `run_live`.
    finished : told of every trial that was written.

    Raises ProtocolChanged, OrderDiffers, UnknownParticipant, HumanParticipants, and what the store
    raises.
    """
    with StudyWriter.open(path) as writer:
        study = writer.study
        if protocol is not None:
            check_unchanged(study, protocol)
        if study.kind != "virtual":
            raise HumanParticipants(study.name)
        for trial in writer.interrupted_trials():
            writer.release_trial(trial.id)
        _require_participants(study.name, participants, writer.trials())
        planned = [t for t in writer.planned_trials() if _wanted(t, participants)]
        chosen = planned if limit is None else planned[:limit]
        frozen = frozen_protocol(study)
        order = OrderCheck(study.name, frozen, study.design_hash)
        order.check(writer.trials())
        ended = {"completed": 0, "timed_out": 0, "aborted": 0}
        for wave in _waves(chosen):
            ready = [_with_condition(writer, order, trial) for trial in wave]
            specs = _started(writer, frozen, ready)
            results = run(ready, specs) if run else run_all(specs, workers)
            for trial, result in zip(ready, results, strict=True):
                _write(writer, trial, result)
                ended[result.status] += 1
                finished(trial, result)
            _close_sessions(writer, {trial.session_id for trial in wave})
        return RunSummary(**ended, remaining=len(writer.planned_trials()))


def _waves(trials: Sequence[StoredTrial]) -> Iterator[list[StoredTrial]]:
    """Give trials that may run at once, in order.

    Where an order adapts that is one trial of each participant, since the next one depends on it.
    """
    if all(trial.condition is not None for trial in trials):
        yield list(trials)
        return
    places: Counter[int] = Counter()
    waves: dict[int, list[StoredTrial]] = {}
    for trial in trials:
        waves.setdefault(places[trial.participant_id], []).append(trial)
        places[trial.participant_id] += 1
    yield from waves.values()


def _with_condition(writer: StudyWriter, order: OrderCheck, trial: StoredTrial) -> StoredTrial:
    """Let an order that adapts choose a trial's condition from what its participant did so far."""
    if trial.condition is not None:
        return trial
    own = writer.trials(trial.participant_code)
    condition = order.chosen(trial, own)
    before = (past for past in own if past.position < trial.position and past.status in ENDED)
    same = [past for past in before if (past.condition, past.kind) == (condition, trial.kind)]
    chosen = replace(trial, condition=condition, repetition=len(same) + 1)
    writer.choose_condition(trial.id, condition, chosen.repetition)
    return chosen


def _wanted(trial: StoredTrial, participants: tuple[str, ...]) -> bool:
    return not participants or trial.participant_code in participants


def _require_participants(
    study: str, participants: tuple[str, ...], trials: tuple[StoredTrial, ...]
) -> None:
    known = list(dict.fromkeys(trial.participant_code for trial in trials))
    for code in participants:
        if code not in known:
            raise UnknownParticipant(study, code, known)


def _started(
    writer: StudyWriter, protocol: Protocol, trials: Sequence[StoredTrial]
) -> Iterator[TrialSpec]:
    """Mark each trial and its session as running when its spec is taken."""
    sessions: set[int] = set()
    for trial in trials:
        spec = trial_spec(protocol, trial)
        with writer.transaction():
            if trial.session_id not in sessions:
                sessions.add(trial.session_id)
                writer.set_session_status(trial.session_id, "running")
                writer.set_participant_status(trial.participant_id, "active")
            writer.start_trial(trial.id)
        yield spec


def _write(writer: StudyWriter, trial: StoredTrial, result: TrialResult) -> None:
    outcome = TrialOutcome(
        status=result.status,
        reason=result.reason,
        duration_s=result.duration_s,
        path_length_m=result.path_length_m,
        collisions=result.collisions,
        collisions_legacy=result.collisions_legacy,
        contact_time_s=result.contact_time_s,
    )
    writer.finish_trial(trial.id, outcome, result.events, result.samples, result.streams)


def _close_sessions(writer: StudyWriter, sessions: set[int]) -> None:
    """Complete the sessions that have nothing left to run, and whoever has no session left."""
    trials = writer.trials()
    waiting = [trial for trial in trials if trial.status in ("planned", "running")]
    done = sessions - {trial.session_id for trial in waiting}
    came = {trial.participant_id for trial in trials if trial.session_id in done}
    with writer.transaction():
        for session_id in sorted(done):
            writer.set_session_status(session_id, "completed")
        for participant_id in sorted(came - {trial.participant_id for trial in waiting}):
            writer.set_participant_status(participant_id, "completed")
