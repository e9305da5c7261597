"""Rows as records: what one attempt leaves behind, trials to be run, the study itself."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import Connection, CursorResult, insert, select

from omnistudy.channel import SAMPLE_COLUMNS, Event, Measure, Stream
from omnistudy.devices import DeviceRecord
from omnistudy.protocol.limit import Limit
from omnistudy.store.chunks import chunks_of, columns_text
from omnistudy.store.records import ProtocolVersion, StoredTrial, StudyRecord, TrialStatus
from omnistudy.store.tables import (
    AllocationRow,
    ChunkRow,
    DeviceRow,
    EventRow,
    MeasureRow,
    ParticipantRow,
    ProtocolVersionRow,
    SampleRow,
    SessionRow,
    StreamRow,
    StudyRow,
    TrialRow,
)


def inserted_id(inserted: CursorResult[Any]) -> int:
    """Give the id of the row that was just inserted."""
    key = inserted.inserted_primary_key
    assert key is not None
    return int(key[0])


def insert_events(connection: Connection, trial_id: int, events: Sequence[Event]) -> None:
    """Write a trial's events in their order."""
    if events:
        connection.execute(
            insert(EventRow),
            [{"trial_id": trial_id, **happened._asdict()} for happened in events],
        )


def insert_samples(connection: Connection, trial_id: int, samples: NDArray[np.float64]) -> None:
    """Write (n, 13) samples, columns SAMPLE_COLUMNS; SQLite itself turns NaN into NULL.

    Raises ValueError for another shape.
    """
    if samples.ndim != 2 or samples.shape[1] != len(SAMPLE_COLUMNS):
        raise ValueError(f"samples have shape {samples.shape}, not (n, {len(SAMPLE_COLUMNS)})")
    if not len(samples):
        return
    connection.execute(
        insert(SampleRow),
        [
            {"trial_id": trial_id, **dict(zip(SAMPLE_COLUMNS, row, strict=True))}
            for row in samples.tolist()
        ],
    )


def insert_device(connection: Connection, trial_id: int, device: DeviceRecord | None) -> None:
    """Write which device a trial was driven with; nothing when there was none."""
    if device is not None:
        connection.execute(
            insert(DeviceRow).values(
                trial_id=trial_id,
                kind=device.kind,
                pushes=" ".join(device.pushes),
                wrench=device.wrench,
                scale=device.scale,
                **device.identity._asdict(),
            )
        )


def insert_measures(connection: Connection, trial_id: int, measures: Sequence[Measure]) -> None:
    """Write how well a trial was run."""
    if measures:
        connection.execute(
            insert(MeasureRow), [{"trial_id": trial_id, **one._asdict()} for one in measures]
        )


def insert_streams(connection: Connection, trial_id: int, streams: Sequence[Stream]) -> None:
    """Write a trial's streams, cut into packed chunks."""
    for stream in streams:
        inserted = connection.execute(
            insert(StreamRow).values(
                trial_id=trial_id,
                name=stream.name,
                rate_hz=stream.rate_hz,
                columns=columns_text(stream.channels),
            )
        )
        stream_id = inserted_id(inserted)
        rows = [{"stream_id": stream_id, **chunk._asdict()} for chunk in chunks_of(stream)]
        if rows:
            connection.execute(insert(ChunkRow), rows)


def stored_trials(
    connection: Connection,
    *,
    status: TrialStatus | None = None,
    participant: str | None = None,
    trial_id: int | None = None,
) -> tuple[StoredTrial, ...]:
    """Give the trials that match, in the order in which they are to be run."""
    query = (
        select(
            TrialRow.id,
            TrialRow.session_id,
            TrialRow.position,
            TrialRow.attempt,
            TrialRow.kind,
            TrialRow.condition,
            TrialRow.repetition,
            TrialRow.task,
            TrialRow.route,
            TrialRow.status,
            TrialRow.reason,
            TrialRow.protocol_version,
            TrialRow.seed,
            SessionRow.visit,
            SessionRow.participant_id,
            ParticipantRow.code.label("participant_code"),
            ParticipantRow.kind.label("participant_kind"),
            ParticipantRow.seed.label("participant_seed"),
            AllocationRow.slot,
            TrialRow.duration_s,
            TrialRow.collisions,
        )
        .join(SessionRow, SessionRow.id == TrialRow.session_id)
        .join(ParticipantRow, ParticipantRow.id == SessionRow.participant_id)
        .join(AllocationRow, AllocationRow.participant_id == ParticipantRow.id)
        .order_by(ParticipantRow.id, SessionRow.visit, TrialRow.position, TrialRow.attempt)
    )
    if status is not None:
        query = query.where(TrialRow.status == status)
    if participant is not None:
        query = query.where(ParticipantRow.code == participant)
    if trial_id is not None:
        query = query.where(TrialRow.id == trial_id)
    return tuple(StoredTrial(**row) for row in connection.execute(query).mappings())


def stored_study(connection: Connection) -> StudyRecord:
    """Give the study."""
    row = connection.execute(select(StudyRow)).one()
    return StudyRecord(
        name=row.name,
        title=row.title,
        kind=row.kind,
        protocol_json=row.protocol,
        protocol_version=row.protocol_version,
        design_hash=row.design_hash,
        site_hash=row.site_hash,
        created_at=row.created_at,
        omnistudy_version=row.omnistudy_version,
    )


def stored_limits(study: StudyRecord) -> tuple[Limit, ...]:
    """Give the limits that a study's protocol states; other parts of it need not be installed."""
    stated = json.loads(study.protocol_json).get("limits", ())
    return tuple(Limit.model_validate(limit) for limit in stated)


def stored_versions(connection: Connection) -> tuple[ProtocolVersion, ...]:
    """Give every version of the protocol, the first one first."""
    rows = connection.execute(select(ProtocolVersionRow).order_by(ProtocolVersionRow.version))
    return tuple(
        ProtocolVersion(
            version=row.version,
            protocol_json=row.protocol,
            design_hash=row.design_hash,
            site_hash=row.site_hash,
            reason=row.reason,
            frozen_at=row.frozen_at,
            omnistudy_version=row.omnistudy_version,
        )
        for row in rows
    )
