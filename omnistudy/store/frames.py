"""Tables as tidy pandas frames whose `attrs["units"]` name the unit of each column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from sqlalchemy import Connection, Executable, select

from omnistudy.channel import Channel
from omnistudy.protocol.limit import Limit
from omnistudy.store.tables import (
    AllocationRow,
    ConditionLevelRow,
    ConditionRow,
    DeviceRow,
    EventRow,
    MeasureRow,
    ParticipantRow,
    SessionRow,
    TrialRow,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from pandas import DataFrame

UNITS: Mapping[str, str] = {
    "t": "s",
    "duration_s": "s",
    "contact_time_s": "s",
    "path_length_m": "m",
    "collisions": "1",
    "collisions_legacy": "1",
    "rate_hz": "Hz",
}
"""Unit of every column that has one."""

NUMBERS = ("duration_s", "path_length_m", "collisions", "collisions_legacy", "contact_time_s")
"""Columns that hold NaN until a trial is run, so that counts are floats there too."""

MOMENTS = ("started_at", "finished_at")
"""Columns of moments in UTC, NaT until they have come."""


def frame(columns: Iterable[str], rows: Iterable[Any]) -> DataFrame:
    """Make a frame of rows whose columns have the names and units of the database."""
    from pandas import DataFrame, to_datetime

    made = DataFrame.from_records([tuple(row) for row in rows], columns=list(columns))
    for name in made.columns.intersection(list(NUMBERS)):
        made[name] = made[name].astype("float64")
    for name in made.columns.intersection(list(MOMENTS)):
        made[name] = to_datetime(made[name], utc=True)
    made.attrs["units"] = {name: UNITS[name] for name in made.columns if name in UNITS}
    return made


def channel_frame(
    times: NDArray[np.float64], channels: Sequence[Channel], values: NDArray[np.float64]
) -> DataFrame:
    """Make a frame of t in s (n,) and (n, channels) recorded values."""
    from pandas import DataFrame

    made = DataFrame(values, columns=[channel.name for channel in channels])
    made.insert(0, "t", times)
    made.attrs["units"] = {"t": "s"} | {channel.name: channel.unit for channel in channels}
    return made


def query_frame(connection: Connection, query: Executable) -> DataFrame:
    """Run a query and make a frame of it."""
    found = connection.execute(query)
    return frame(found.keys(), found)


def participants_frame(connection: Connection) -> DataFrame:
    """One row a participant."""
    return query_frame(
        connection,
        select(
            ParticipantRow.code.label("participant"),
            ParticipantRow.kind,
            ParticipantRow.group_name.label("group"),
            ParticipantRow.sequence,
            ParticipantRow.status,
            ParticipantRow.seed,
        ).order_by(ParticipantRow.id),
    )


def allocations_frame(connection: Connection) -> DataFrame:
    """One row a slot of the design."""
    return query_frame(
        connection,
        select(
            AllocationRow.slot,
            AllocationRow.stratum,
            AllocationRow.group_name.label("group"),
            AllocationRow.row,
            ParticipantRow.code.label("participant"),
        )
        .outerjoin(ParticipantRow, ParticipantRow.id == AllocationRow.participant_id)
        .order_by(AllocationRow.slot),
    )


def sessions_frame(connection: Connection) -> DataFrame:
    """One row a visit."""
    return query_frame(
        connection,
        select(
            SessionRow.id.label("session"),
            ParticipantRow.code.label("participant"),
            SessionRow.visit,
            SessionRow.status,
            SessionRow.reason,
            SessionRow.started_at,
            SessionRow.finished_at,
        )
        .join(ParticipantRow, ParticipantRow.id == SessionRow.participant_id)
        .order_by(SessionRow.id),
    )


def events_frame(connection: Connection, trial: int | None) -> DataFrame:
    """One row an event, of one trial or of all."""
    query = select(EventRow.trial_id.label("trial"), EventRow.t, EventRow.kind, EventRow.detail)
    if trial is not None:
        query = query.where(EventRow.trial_id == trial)
    return query_frame(connection, query.order_by(EventRow.trial_id, EventRow.id))


def devices_frame(connection: Connection) -> DataFrame:
    """One row an attempt that was driven with a device."""
    query = select(
        DeviceRow.trial_id.label("trial"),
        DeviceRow.kind,
        DeviceRow.model,
        DeviceRow.serial,
        DeviceRow.firmware,
        DeviceRow.calibration,
        DeviceRow.pushes,
        DeviceRow.wrench,
        DeviceRow.scale,
    )
    return query_frame(connection, query.order_by(DeviceRow.trial_id))


def measures_frame(connection: Connection, trial: int | None) -> DataFrame:
    """One row a measure, of one trial or of all."""
    query = select(
        MeasureRow.trial_id.label("trial"), MeasureRow.name, MeasureRow.value, MeasureRow.unit
    )
    if trial is not None:
        query = query.where(MeasureRow.trial_id == trial)
    return query_frame(connection, query.order_by(MeasureRow.trial_id, MeasureRow.name))


def exclusions_frame(connection: Connection, limits: Sequence[Limit]) -> DataFrame:
    """One row a limit that an attempt is above."""
    measures = measures_frame(connection, None)
    greatest = {limit.measure: limit.greatest for limit in limits}
    measures["greatest"] = measures["name"].map(greatest).astype("float64")
    above = measures[measures["value"] > measures["greatest"]]
    made = above[["trial", "name", "value", "greatest", "unit"]].reset_index(drop=True)
    return made.rename(columns={"name": "measure"})


def conditions_frame(connection: Connection) -> DataFrame:
    """One row a condition, with a column a factor."""
    conditions = query_frame(
        connection,
        select(ConditionRow.name.label("condition"), ConditionRow.masked_label).order_by(
            ConditionRow.name
        ),
    )
    return _with_factors(connection, conditions)


def trials_frame(connection: Connection) -> DataFrame:
    """One row an attempt at a trial, planned ones too, with a column a factor."""
    trials = query_frame(
        connection,
        select(
            TrialRow.id.label("trial"),
            ParticipantRow.code.label("participant"),
            ParticipantRow.kind.label("participant_kind"),
            ParticipantRow.group_name.label("group"),
            ParticipantRow.sequence,
            SessionRow.visit,
            TrialRow.position,
            TrialRow.attempt,
            TrialRow.kind,
            TrialRow.condition,
            TrialRow.repetition,
            TrialRow.task,
            TrialRow.route,
            TrialRow.status,
            TrialRow.reason,
            TrialRow.duration_s,
            TrialRow.path_length_m,
            TrialRow.collisions,
            TrialRow.collisions_legacy,
            TrialRow.contact_time_s,
            TrialRow.protocol_version,
            TrialRow.seed,
            TrialRow.started_at,
            TrialRow.finished_at,
        )
        .join(SessionRow, SessionRow.id == TrialRow.session_id)
        .join(ParticipantRow, ParticipantRow.id == SessionRow.participant_id)
        .order_by(ParticipantRow.id, SessionRow.visit, TrialRow.position, TrialRow.attempt),
    )
    return _with_factors(connection, trials)


def _with_factors(connection: Connection, table: DataFrame) -> DataFrame:
    """Add a column a factor after `condition`, and name those columns in `attrs["factors"]`.

    A factor named like a column gets `factor_` before its name.
    """
    levels = connection.execute(
        select(
            ConditionLevelRow.factor, ConditionLevelRow.condition, ConditionLevelRow.level
        ).order_by(ConditionLevelRow.factor)
    ).all()
    place = list(table.columns).index("condition") + 1
    factors: list[str] = []
    for factor in dict.fromkeys(row.factor for row in levels):
        level_of = {row.condition: row.level for row in levels if row.factor == factor}
        name = f"factor_{factor}" if factor in table.columns else factor
        table.insert(place + len(factors), name, table["condition"].map(level_of))
        factors.append(name)
    table.attrs["factors"] = tuple(factors)
    return table
