"""A study is run whole, by any number of workers, and goes on where it was stopped."""

from __future__ import annotations

import multiprocessing
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.errors.session import HumanParticipants, WorkerDied
from omnistudy.errors.study import ProtocolChanged, UnknownParticipant
from omnistudy.protocol import Protocol
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import run_trials
from omnistudy.session.specs import trial_spec
from omnistudy.session.workers import run_all
from omnistudy.store import StudyWriter, sample_digest
from omnistudy.study import create_study
from omnistudy.trial import TrialSpec, resimulate

TRIALS = 12


@pytest.mark.slow
def test_every_planned_trial_is_run_and_sessions_are_closed(short_study: Path) -> None:
    told: list[int] = []
    summary = run_trials(short_study, finished=lambda trial, result: told.append(trial.id))

    assert summary.completed + summary.timed_out == TRIALS
    assert (summary.aborted, summary.remaining) == (0, 0)
    with omnistudy.open(short_study) as study:
        trials = study.trials()
        assert list(trials["trial"]) == told
        assert set(study.sessions()["status"]) == {"completed"}
        assert set(study.participants()["status"]) == {"completed"}
        assert set(study.participants()["kind"]) == {"virtual"}
        for row in trials.itertuples():
            samples = study.samples(row.trial)
            assert samples["t"].iloc[1] == pytest.approx(1 / 20)
            driven = np.hypot(samples["x"].diff(), samples["y"].diff()).sum()
            assert row.path_length_m == pytest.approx(driven, rel=0.02)


@pytest.mark.slow
def test_conditions_without_a_law_have_no_force_at_all(short_study: Path) -> None:
    run_trials(short_study, participants=("P01",))
    with omnistudy.open(short_study) as study:
        trials = study.trials()
        for row in trials[trials["participant"] == "P01"].itertuples():
            forces = study.samples(row.trial)[["fx", "fy", "tau"]].to_numpy()
            assert (forces == 0.0).all() == (row.condition == "none")


@pytest.mark.slow
def test_order_that_ran_is_the_order_that_was_planned(short_study: Path) -> None:
    with StudyWriter.open(short_study) as writer:
        planned = [(t.participant_code, t.position, t.condition, t.route) for t in writer.trials()]
    ran: list[tuple[str, int, str | None, str]] = []
    run_trials(
        short_study,
        workers=2,
        finished=lambda t, _: ran.append((t.participant_code, t.position, t.condition, t.route)),
    )
    assert ran == planned


@pytest.mark.slow
def test_one_worker_two_workers_and_another_process_give_the_same_sample_bytes(
    short_protocol: Protocol, tmp_path: Path
) -> None:
    digests = []
    for workers in (1, 2):
        path = tmp_path / f"workers_{workers}.db"
        create_study(short_protocol, path, "same")
        run_trials(path, workers=workers)
        digests.append(sample_digest(path))
    path = tmp_path / "elsewhere.db"
    create_study(short_protocol, path, "same")
    code = "import sys, pathlib; from omnistudy.session import run_trials; "
    code += "run_trials(pathlib.Path(sys.argv[1]))"
    subprocess.run([sys.executable, "-c", code, str(path)], check=True)
    digests.append(sample_digest(path))
    assert len(set(digests)) == 1


@pytest.mark.slow
def test_run_that_was_killed_goes_on_and_ends_like_an_unbroken_one(
    short_protocol: Protocol, tmp_path: Path
) -> None:
    broken, whole = tmp_path / "broken.db", tmp_path / "whole.db"
    for path in (broken, whole):
        create_study(short_protocol, path, "study")
    code = (
        "import os, pathlib, signal, sys\n"
        "from omnistudy.session import run_trials\n"
        "done = []\n"
        "def kill_after_three(trial, result):\n"
        "    done.append(trial)\n"
        "    if len(done) == 3:\n"
        "        os.kill(os.getpid(), signal.SIGKILL)\n"
        "run_trials(pathlib.Path(sys.argv[1]), finished=kill_after_three)\n"
    )
    killed = subprocess.run([sys.executable, "-c", code, str(broken)], check=False)
    assert killed.returncode == -signal.SIGKILL
    with omnistudy.open(broken) as study:
        assert list(study.trials()["status"]).count("planned") == TRIALS - 3

    run_trials(broken)
    run_trials(whole)
    assert sample_digest(broken) == sample_digest(whole)


def test_trial_that_a_killed_run_left_running_is_run_again(short_study: Path) -> None:
    with StudyWriter.open(short_study) as writer:
        first = writer.planned_trials()[0]
        writer.start_trial(first.id)
    ran: list[int] = []
    summary = run_trials(short_study, limit=1, finished=lambda trial, _: ran.append(trial.id))
    assert ran == [first.id]
    assert summary.remaining == TRIALS - 1


def test_trial_of_the_database_re_simulates_to_the_same_samples(
    short_study: Path, short_protocol: Protocol
) -> None:
    run_trials(short_study, limit=2)
    with StudyWriter.open(short_study) as writer:
        stored = writer.trials()[:2]
    with omnistudy.open(short_study) as study:
        for trial in stored:
            recorded = study.stream_record(trial.id, "input").data
            again = resimulate(trial_spec(short_protocol, trial), recorded)
            assert np.array_equal(study.sample_array(trial.id), again.samples, equal_nan=True)


def test_limit_leaves_the_rest_planned(short_study: Path) -> None:
    summary = run_trials(short_study, limit=1)
    assert summary.completed + summary.timed_out == 1
    assert summary.remaining == TRIALS - 1


def test_changed_protocol_is_refused_with_what_differs(short_study: Path) -> None:
    changed = compose_protocol("utah2017_component", ("law.stiffness.y=100",))
    with pytest.raises(ProtocolChanged, match=r"law\.stiffness\.y"):
        run_trials(short_study, protocol=changed)
    with omnistudy.open(short_study) as study:
        assert set(study.trials()["status"]) == {"planned"}


def test_unknown_participant_is_named_with_the_known_ones(short_study: Path) -> None:
    with pytest.raises(UnknownParticipant, match="P01"):
        run_trials(short_study, participants=("P1",))


def test_people_are_not_run_by_themselves(short_protocol: Protocol, tmp_path: Path) -> None:
    people = short_protocol.participants.model_copy(update={"kind": "human"})
    path = tmp_path / "people.db"
    create_study(short_protocol.model_copy(update={"participants": people}), path, "people")
    with pytest.raises(HumanParticipants, match="human participants"):
        run_trials(path)


def test_worker_that_is_killed_is_said_in_one_sentence(
    short_protocol: Protocol, short_study: Path
) -> None:
    with StudyWriter.open(short_study) as writer:
        specs = [trial_spec(short_protocol, trial) for trial in writer.trials()]

    def specs_that_kill() -> object:
        for number, spec in enumerate(specs):
            if number == 2:
                _kill_children()
            yield spec

    with pytest.raises(WorkerDied, match="run the command again"):
        list(run_all(specs_that_kill(), workers=2))  # type: ignore[arg-type]


def _kill_children() -> None:
    for child in multiprocessing.active_children():
        child.kill()


def test_specs_carry_the_condition_of_the_trial(
    short_protocol: Protocol, short_study: Path
) -> None:
    with StudyWriter.open(short_study) as writer:
        trials = writer.trials()
    specs: dict[str | None, TrialSpec] = {
        t.condition: trial_spec(short_protocol, t) for t in trials
    }
    assert specs["none"].law.kind == "none"
    assert specs["zero_torque"].law.kind == "zero_torque"
    moved = specs["centre_front_20"]
    assert moved.law.model_dump()["compliance_centre"] == 0.20
    assert moved.controller.model_dump()["compliance_centre"] == 0.20
