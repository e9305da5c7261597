"""A person's recorded drive, driven again."""

from __future__ import annotations

from math import ceil, inf
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from omnistudy.devices import Hand
from omnistudy.errors.operators import NoMotion
from omnistudy.operators.command_log import STAMP_RESOLUTION, Between, CommandLog, read_log
from omnistudy.operators.operator import Operator, Person, RunningOperator
from omnistudy.units import Positive, Ratio, Seconds
from omnistudy.worlds import Situation


class RecordedOperator(Operator):
    """Logged commands, or stick positions, from a CSV file whose first line names its columns.

    Logged twists go with the device `direct` and a controller for twists; logged stick positions
    (m, m, rad) with a stick and its controller. Feedback changes nothing: the hand prescribes.
    """

    kind: Literal["recorded"] = "recorded"
    file: Path
    """The CSV file; a relative path counts from the current folder."""
    time: str = "time"
    """Column of the stamps, in s of any clock."""
    axes: Annotated[tuple[str | None, ...], Field(min_length=1)] = ("v", None, "omega")
    """The column of each axis of the device; null for an axis that was not there and stays zero."""
    scale: tuple[Ratio, ...] = ()
    """What each axis is multiplied by to reach the device's unit; empty: all 1."""
    between: Between = "hold"
    """hold: a row stands until the next. linear: a straight line joins the rows."""
    longest_gap: Annotated[Seconds, Positive] | None = None
    """A row counts no longer than this without a next one, as robots stop when commands cease."""
    cut_idle: bool = True
    """Leave out what lies at rest before the first motion and after the last."""

    @model_validator(mode="after")
    def _columns_fit(self) -> Self:
        if not any(self.axes):
            raise ValueError("axes: at least one axis needs a column")
        if self.scale and len(self.scale) != len(self.axes):
            raise ValueError(
                f"scale: {len(self.scale)} numbers for {len(self.axes)} axes; give one for each"
            )
        return self

    def log(self) -> CommandLog:
        """Read the recording as it is driven: scaled, idle parts cut, on its own clock.

        Raises NoRecording, NoSuchColumn, NotANumber, TimeRunsBackwards, NoRows, NoMotion.
        """
        read = read_log(self.file, self.time, self.axes)
        if not read.moves:
            raise NoMotion(self.file, [name for name in self.axes if name])
        if self.scale:
            read = CommandLog(read.times, read.values * self.scale + 0.0)
        return read.without_idle() if self.cut_idle else read

    def begin(self, person: Person, physics_hz: int) -> RunningOperator:
        """Give the person before the first step; raises what `log` raises."""
        log = self.log()
        steps = max(1, ceil((log.duration - STAMP_RESOLUTION) * physics_hz))
        instants = log.times[0] + [step / physics_hz for step in range(steps)]
        asked = log.at(instants, self.between, self.longest_gap)
        return _Replaying([tuple(row) for row in asked.tolist()], physics_hz)


class _Replaying(RunningOperator):
    """Prescribes one row a physics step until the recording ends."""

    def __init__(self, references: list[tuple[float, ...]], physics_hz: int) -> None:
        self._references = references
        self._physics_hz = physics_hz
        axes = len(references[0])
        self._hand = Hand(references[0], (inf,) * axes, (0.0,) * axes, (0.0,) * axes)

    def hand(self, t: float, plant_state: Any, situation: Situation) -> Hand:
        """Give the recorded position as one that nothing can push away."""
        step = min(round(t * self._physics_hz), len(self._references) - 1)
        self.finished = step == len(self._references) - 1
        return self._hand._replace(reference=self._references[step])
