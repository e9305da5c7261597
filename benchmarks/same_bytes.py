"""Whether the same seed gives the same bytes, however the work is spread."""

from __future__ import annotations

import hashlib
import sqlite3
from pathlib import Path
from tempfile import TemporaryDirectory

import published_trial

from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import run_trials
from omnistudy.study.create import create_study
from omnistudy.trial import run_trial

TRIALS = 4


def checks() -> dict[str, bool]:
    """Compare a trial within one process and over two, a study with one worker and with two."""
    spec = published_trial.published_trial()
    first = published_trial.digest(run_trial(spec))
    return {
        "one_process": published_trial.digest(run_trial(spec)) == first,
        "two_processes": published_trial.in_own_process().digest == first,
        "one_or_two_workers": _study_digest(workers=1) == _study_digest(workers=2),
    }


def _study_digest(workers: int) -> str:
    """Run the first trials of a study into a database; give SHA-256 over its sample table."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "study.db"
        create_study(compose_protocol("utah2017_component"), path, "study")
        run_trials(path, limit=TRIALS, workers=workers)
        with sqlite3.connect(path) as connection:
            rows = connection.execute("SELECT * FROM sample ORDER BY trial_id, t").fetchall()
    assert rows
    return hashlib.sha256(repr(rows).encode()).hexdigest()
