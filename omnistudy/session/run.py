"""Running the planned trials of a study's virtual participants."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from omnistudy.errors.session import AlwaysVoid, HumanParticipants
from omnistudy.errors.study import UnknownParticipant
from omnistudy.protocol import Protocol
from omnistudy.session.attempts import next_attempt
from omnistudy.session.specs import trial_spec
from omnistudy.session.workers import run_all
from omnistudy.store import StoredTrial, StudyWriter, TrialOutcome
from omnistudy.study.frozen import check_unchanged, frozen_protocol
from omnistudy.study.order_check import ENDED, OrderCheck
from omnistudy.trial import TrialResult, TrialSpec

Run = Callable[[Sequence[StoredTrial], Iterator[TrialSpec]], Iterator[TrialResult]]
"""Drives trials one after the other, each result in the place of its spec."""


MOST_ATTEMPTS = 3
"""At one trial in a row before the session ends (ours)."""
INTERRUPTED = "the session ended in the middle of it"
"""Reason of an attempt of which something was recorded, but not its end."""


@dataclass(frozen=True, slots=True)
class RunSummary:
    """What a run did: attempts by how they ended, and how many trials are still planned."""

    completed: int
    timed_out: int
    void: int
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

    A void attempt is followed by the next one at the same trial.

    participants : codes; none means all. limit : run at most so many trials.
    protocol : when given, it must be the frozen one.
    run : drives one trial after the other instead of `workers` processes, such as `run_live`.
    finished : told of every attempt that was written.

    Raises ProtocolChanged, OrderDiffers, UnknownParticipant, HumanParticipants, AlwaysVoid, and
    what the store raises.
    """
    with StudyWriter.open(path) as writer:
        study = writer.study
        if protocol is not None:
            check_unchanged(study, protocol)
        if study.kind != "virtual":
            raise HumanParticipants(study.name)
        frozen = frozen_protocol(study)
        _recover(writer, frozen)
        _require_participants(study.name, participants, writer.trials())
        planned = [t for t in writer.planned_trials() if _wanted(t, participants)]
        chosen = planned if limit is None else planned[:limit]
        order = OrderCheck(study.name, frozen, study.design_hash)
        order.check(writer.trials())
        drive = run or (lambda ready, specs: run_all(specs, workers))
        ended = Counter[str]()
        for wave in _waves(chosen, alone=run is not None):
            waiting = [_with_condition(writer, order, trial) for trial in wave]
            while waiting:
                again = []
                specs = _started(writer, frozen, waiting)
                for trial, result in zip(waiting, drive(waiting, specs), strict=True):
                    _write(writer, trial, result)
                    ended[result.status] += 1
                    finished(trial, result)
                    if result.status == "void":
                        again.append(next_attempt(writer, frozen, trial, result.reason))
                        _insist_on_sense(trial, result.reason)
                waiting = again
            _close_sessions(writer, {trial.session_id for trial in wave})
        return RunSummary(
            completed=ended["completed"],
            timed_out=ended["timed_out"],
            void=ended["void"],
            aborted=ended["aborted"],
            remaining=len(writer.planned_trials()),
        )


def _insist_on_sense(trial: StoredTrial, cause: str) -> None:
    """Raise AlwaysVoid when so many attempts failed that another one mends nothing."""
    if trial.attempt % MOST_ATTEMPTS == 0:
        raise AlwaysVoid(trial.participant_code, trial.position, MOST_ATTEMPTS, cause)


def _recover(writer: StudyWriter, protocol: Protocol) -> None:
    """Put trials that nobody runs any more back in their places, as new attempts if need be."""
    for trial in writer.interrupted_trials():
        if writer.has_streams(trial.id):
            writer.void_trial(trial.id, INTERRUPTED)
            next_attempt(writer, protocol, trial, INTERRUPTED)
        else:
            writer.release_trial(trial.id)


def _waves(trials: Sequence[StoredTrial], *, alone: bool) -> Iterator[list[StoredTrial]]:
    """Give trials that may run at once, in order; one at a time when each runs alone.

    Where an order adapts that is one trial of each participant, since the next one depends on it.
    """
    if alone:
        yield from ([trial] for trial in trials)
        return
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
    writer.finish_trial(
        trial.id,
        outcome,
        result.events,
        result.samples,
        result.streams,
        result.device,
        result.measures,
    )


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
