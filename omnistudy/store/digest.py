"""A fingerprint of all samples, to prove that a study reproduces."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
from sqlalchemy import select

from omnistudy.store.study_file import open_study
from omnistudy.store.tables import SampleRow

ROWS_AT_ONCE = 20_000


def sample_digest(path: str | Path) -> str:
    """Give SHA-256 over all rows of `sample` in the order of trial and t.

    Each row counts as 14 little-endian float64: trial_id, t and the rest; NULL is NaN.
    Raises as `omnistudy.open` does.
    """
    table = SampleRow.__table__
    digest = hashlib.sha256()
    with open_study(path) as study, study.reading() as connection:
        rows = connection.execute(select(table).order_by(table.c.trial_id, table.c.t))
        for batch in rows.partitions(ROWS_AT_ONCE):
            digest.update(np.array([tuple(row) for row in batch], dtype="<f8").tobytes())
    return digest.hexdigest()
