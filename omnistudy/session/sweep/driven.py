"""One point, driven: the rows that its trials leave."""

from __future__ import annotations

from dataclasses import dataclass
from math import nan

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import SAMPLE_COLUMNS, Stream
from omnistudy.metrics import work_against
from omnistudy.operators import Person
from omnistudy.protocol import Protocol
from omnistudy.session.specs import coupled
from omnistudy.session.sweep.effects import changed
from omnistudy.session.sweep.question import Point, Sweep, SweptTrial
from omnistudy.trial import TrialResult, TrialSpec, run_trial

MOTOR = {"stick_x": "motor_x", "stick_y": "motor_y", "stick_theta": "motor_theta"}
"""Axis -> channel of the device that holds the force which its motor really gave."""


@dataclass(frozen=True, slots=True)
class TrialRow:
    """What the table keeps of a trial; units stand in the names, NaN for what it does not have."""

    participant: str
    position: int
    kind: str
    condition: str
    repetition: int
    route: str
    status: str
    duration_s: float
    collisions: int
    collisions_legacy: int
    contact_time_s: float
    path_length_m: float
    work_against_j: float


def drive_point(sweep: Sweep, point: Point) -> tuple[TrialRow, ...]:
    """Drive every trial of a point; raises whatever a trial raises."""
    protocol = changed(sweep.base, point.changes)
    rows = []
    for trial in sweep.trials:
        spec = spec_of(protocol, trial)
        rows.append(row_of(trial, spec, run_trial(spec)))
    return tuple(rows)


def spec_of(protocol: Protocol, trial: SweptTrial) -> TrialSpec:
    """Give the spec of a trial at a point; raises UnknownCondition or UnknownRoute."""
    person = Person(trial.participant_seed, trial.seed, trial.position)
    return coupled(protocol, trial.condition, trial.route, person)


def row_of(trial: SweptTrial, spec: TrialSpec, result: TrialResult) -> TrialRow:
    """Give the row of a trial that was driven."""
    return TrialRow(
        participant=trial.participant,
        position=trial.position,
        kind=trial.kind,
        condition=trial.condition,
        repetition=trial.repetition,
        route=trial.route,
        status=result.status,
        duration_s=result.duration_s,
        collisions=result.collisions,
        collisions_legacy=result.collisions_legacy,
        contact_time_s=result.contact_time_s,
        path_length_m=result.path_length_m,
        work_against_j=feedback_work(spec, result),
    )


def feedback_work(spec: TrialSpec, result: TrialResult) -> float:
    """Give the work in J that the hand did against the feedback; NaN without motor channels.

    The force is the one that the motors really gave, after clipping, less the device's own
    (centring), both at the sample rate; between samples it is interpolated to the steps of the
    recorded stick rates. The law's columns fx, fy, tau are unclipped and leave out the field's
    stiffness and damping, so they would not do.
    """
    streams = {stream.name: stream for stream in result.streams}
    moved, device = streams["input"], streams.get("device")
    axes = [channel.name for channel in moved.channels[: len(moved.channels) // 2]]
    motors = [MOTOR.get(axis, "") for axis in axes]
    if device is None or not {*motors} <= {channel.name for channel in device.channels}:
        return nan
    rates = moved.data[:, len(axes) :]
    force = _columns(device, motors) - _own_force(spec, result, axes, moved, rates)
    taken = result.samples[:, SAMPLE_COLUMNS.index("t")]
    ends = (np.arange(len(rates)) + 1.0) / moved.rate_hz
    at_steps = np.column_stack([np.interp(ends, taken, column) for column in force.T])
    return work_against(at_steps, rates, 1.0 / moved.rate_hz)


def _columns(stream: Stream, names: list[str]) -> NDArray[np.float64]:
    place = {channel.name: index for index, channel in enumerate(stream.channels)}
    columns: NDArray[np.float64] = stream.data[:, [place[name] for name in names]]
    return columns


def _own_force(
    spec: TrialSpec,
    result: TrialResult,
    axes: list[str],
    moved: Stream,
    rates: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Give what the device itself pushed at each sample."""
    samples = result.samples
    position = samples[:, [SAMPLE_COLUMNS.index(axis) for axis in axes]]
    steps = np.round(samples[:, SAMPLE_COLUMNS.index("t")] * moved.rate_hz).astype(int)
    rate = np.vstack((np.zeros(len(axes)), rates))[steps]
    own: NDArray[np.float64] = spec.device.own_force(position, rate)
    return own
