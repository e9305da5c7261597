"""A sweep's folder: the question, one results file a point, the errors of those that failed."""

from __future__ import annotations

import json
import os
import traceback
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

import pandas as pd
from pydantic import ValidationError

from omnistudy.errors.sweep import AnotherQuestion, BrokenSweep, UnknownSweep, WhichSweep
from omnistudy.session.sweep.driven import TrialRow
from omnistudy.session.sweep.question import Point, Sweep
from omnistudy.study import studies_folder

QUESTION = "sweep.json"


class Finished(NamedTuple):
    """A point that was driven; seconds : wall time of its trials."""

    design: int
    nuisance: int
    values: tuple[Any, ...]
    seconds: float
    rows: tuple[dict[str, Any], ...]


class Failed(NamedTuple):
    """A point that could not be driven: the error in one line, and its trace."""

    design: int
    nuisance: int
    error: str
    trace: str


class SweepFolder:
    """Reads and writes one sweep; every file appears whole or not at all."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.results = path / "results"
        self.failures = path / "failed"

    @property
    def name(self) -> str:
        """The sweep's name."""
        return self.path.name

    def open(self, sweep: Sweep) -> None:
        """Write the question, or check that it is the one that stands there.

        Raises AnotherQuestion, BrokenSweep.
        """
        if not (self.path / QUESTION).exists():
            self.results.mkdir(parents=True, exist_ok=True)
            self.failures.mkdir(exist_ok=True)
            _write(self.path / QUESTION, sweep.model_dump_json(indent=1))
            return
        stored, given = (json.loads(one.model_dump_json()) for one in (self.question(), sweep))
        differing = [key for key in given if given[key] != stored[key]]
        if differing:
            raise AnotherQuestion(self.name, differing)

    def question(self) -> Sweep:
        """Give the question; raises BrokenSweep."""
        path = self.path / QUESTION
        try:
            return Sweep.model_validate_json(path.read_text(encoding="utf-8"))
        except (OSError, ValidationError) as cause:
            raise BrokenSweep(path, str(cause).splitlines()[0]) from cause

    def keep(self, point: Point, rows: Sequence[TrialRow], seconds: float) -> None:
        """Write a point's rows."""
        content = {
            "design": point.design,
            "nuisance": point.nuisance,
            "values": point.values,
            "seconds": seconds,
            "rows": [asdict(row) for row in rows],
        }
        _write(self.results / _file(point.design, point.nuisance), json.dumps(content))

    def keep_failure(self, point: Point, error: Exception) -> None:
        """Write down why a point could not be driven."""
        content = {
            "design": point.design,
            "nuisance": point.nuisance,
            "error": f"{type(error).__name__}: {' '.join(str(error).split())}",
            "trace": "".join(traceback.format_exception(error)),
        }
        _write(self.failures / _file(point.design, point.nuisance), json.dumps(content))

    def done(self) -> set[tuple[int, int]]:
        """Name the finished points by design and nuisance."""
        return _numbers(self.results)

    def failed(self) -> set[tuple[int, int]]:
        """Name the failed points by design and nuisance."""
        return _numbers(self.failures)

    def kept(self, design: int, nuisance: int) -> Finished | None:
        """Read one finished point, None unless it is finished; raises BrokenSweep."""
        path = self.results / _file(design, nuisance)
        return _finished(path) if path.exists() else None

    def drop(self, design: int, nuisance: int) -> None:
        """Forget a point, so that it is driven again."""
        (self.results / _file(design, nuisance)).unlink(missing_ok=True)

    def finished(self) -> tuple[Finished, ...]:
        """Read every finished point, in order; raises BrokenSweep."""
        return tuple(_finished(path) for path in _files(self.results))

    def errors(self) -> tuple[Failed, ...]:
        """Read why points failed, in order; raises BrokenSweep."""
        return tuple(Failed(**_content(path)) for path in _files(self.failures))

    def forget_errors(self) -> None:
        """Take the errors of earlier runs away: what failed is tried again."""
        for path in _files(self.failures):
            path.unlink()


def table(sweep: Sweep, finished: Sequence[Finished]) -> pd.DataFrame:
    """Give one row a trial: point, values, who drove what, what came of it.

    The columns of the values are called like the keys.
    """
    keys = [variable.key for variable in sweep.variables]
    rows = [
        {
            "design": point.design,
            "nuisance": point.nuisance,
            **dict(zip(keys, point.values, strict=True)),
            **row,
        }
        for point in finished
        for row in point.rows
    ]
    return pd.DataFrame(rows)


def sweeps_folder() -> Path:
    """Give the folder of sweeps, inside that of studies."""
    return studies_folder() / "sweeps"


def sweep_names() -> tuple[str, ...]:
    """Name every sweep."""
    return tuple(sorted(path.parent.name for path in sweeps_folder().glob(f"*/{QUESTION}")))


def find_sweep(name: str | None) -> SweepFolder:
    """Give a sweep by name, the only one without a name; raises UnknownSweep, WhichSweep."""
    names = sweep_names()
    if name is None and len(names) != 1:
        raise WhichSweep(sweeps_folder(), names)
    if name is not None and name not in names:
        raise UnknownSweep(name, sweeps_folder(), names)
    return SweepFolder(sweeps_folder() / (name or names[0]))


def _file(design: int, nuisance: int) -> str:
    return f"{design:05d}-{nuisance:05d}.json"


def _files(folder: Path) -> list[Path]:
    return sorted(folder.glob("[0-9]*.json"))


def _numbers(folder: Path) -> set[tuple[int, int]]:
    pairs = (path.stem.split("-") for path in _files(folder))
    return {(int(design), int(nuisance)) for design, nuisance in pairs}


def _finished(path: Path) -> Finished:
    content = _content(path)
    return Finished(**{**content, "values": tuple(content["values"])})


def _content(path: Path) -> dict[str, Any]:
    try:
        content: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as cause:
        raise BrokenSweep(path, str(cause)) from cause
    return content


def _write(path: Path, text: str) -> None:
    """Write beside the file and rename, so that a kill leaves the old file or the new one."""
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    beside.write_text(text, encoding="utf-8")
    beside.replace(path)
