"""The tables of a study database; docs/database.md explains every column to outsiders."""

from __future__ import annotations

from datetime import datetime
from typing import Any, ClassVar, get_args

from sqlalchemy import (
    CheckConstraint,
    Double,
    ForeignKey,
    MetaData,
    String,
    Text,
    UniqueConstraint,
)
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column

from omnistudy.devices import Scale, Wrench
from omnistudy.store.column_types import UtcDateTime
from omnistudy.store.records import (
    ParticipantKind,
    ParticipantStatus,
    SessionStatus,
    TrialStatus,
)


class Base(DeclarativeBase):
    """Gives every constraint a name, so that later migrations can find it."""

    metadata = MetaData(
        naming_convention={
            "ix": "ix_%(table_name)s_%(column_0_name)s",
            "uq": "uq_%(table_name)s_%(column_0_name)s",
            "ck": "ck_%(table_name)s_%(constraint_name)s",
            "fk": "fk_%(table_name)s_%(column_0_name)s",
            "pk": "pk_%(table_name)s",
        }
    )
    type_annotation_map: ClassVar[dict[Any, Any]] = {
        datetime: UtcDateTime,
        str: Text,
        float: Double,
    }


def _one_of(column: str, literal: Any) -> CheckConstraint:
    allowed = ", ".join(f"'{value}'" for value in get_args(literal))
    return CheckConstraint(f"{column} IN ({allowed})", name=column)


def _sha256(column: str) -> CheckConstraint:
    return CheckConstraint(f"length({column}) = 64", name=column)


def _at_least(column: str, least: int) -> CheckConstraint:
    return CheckConstraint(f"{column} >= {least}", name=column)


class StudyRow(Base):
    """The study itself: one row, with the frozen protocol."""

    __tablename__ = "study"
    __table_args__ = (
        _one_of("kind", ParticipantKind),
        _sha256("design_hash"),
        _sha256("site_hash"),
        _at_least("protocol_version", 1),
    )

    name: Mapped[str] = mapped_column(primary_key=True)
    title: Mapped[str]
    kind: Mapped[str]
    protocol: Mapped[str]
    protocol_version: Mapped[int]
    design_hash: Mapped[str] = mapped_column(String(64))
    site_hash: Mapped[str] = mapped_column(String(64))
    created_at: Mapped[datetime]
    omnistudy_version: Mapped[str]


class ParticipantRow(Base):
    """Somebody who takes part, by code; names of people are never here."""

    __tablename__ = "participant"
    __table_args__ = (
        UniqueConstraint("code"),
        _one_of("kind", ParticipantKind),
        _one_of("status", ParticipantStatus),
        _sha256("seed"),
    )

    id: Mapped[int] = mapped_column(primary_key=True)
    code: Mapped[str]
    kind: Mapped[str]
    group_name: Mapped[str | None]
    sequence: Mapped[str | None]
    status: Mapped[str]
    seed: Mapped[str] = mapped_column(String(64))


class AllocationRow(Base):
    """A slot of the design, drawn at the first freeze; whoever takes part sits in one."""

    __tablename__ = "allocation"
    __table_args__ = (
        UniqueConstraint("stratum", "group_name", "row"),
        _at_least("slot", 0),
        _at_least("row", 0),
    )

    slot: Mapped[int] = mapped_column(primary_key=True)
    stratum: Mapped[str]
    group_name: Mapped[str]
    row: Mapped[int]
    participant_id: Mapped[int | None] = mapped_column(ForeignKey("participant.id"))


class ProtocolVersionRow(Base):
    """A protocol as it was frozen: the first, and every amendment with its reason."""

    __tablename__ = "protocol_version"
    __table_args__ = (
        _sha256("design_hash"),
        _sha256("site_hash"),
        _at_least("version", 1),
    )

    version: Mapped[int] = mapped_column(primary_key=True)
    protocol: Mapped[str]
    design_hash: Mapped[str] = mapped_column(String(64))
    site_hash: Mapped[str] = mapped_column(String(64))
    reason: Mapped[str]
    frozen_at: Mapped[datetime]
    omnistudy_version: Mapped[str]


class SessionRow(Base):
    """One visit of a participant."""

    __tablename__ = "session"
    __table_args__ = (
        UniqueConstraint("participant_id", "visit"),
        _one_of("status", SessionStatus),
        _at_least("visit", 1),
    )

    id: Mapped[int] = mapped_column(primary_key=True)
    participant_id: Mapped[int] = mapped_column(ForeignKey("participant.id"))
    visit: Mapped[int]
    status: Mapped[str]
    reason: Mapped[str]
    started_at: Mapped[datetime | None]
    finished_at: Mapped[datetime | None]


class ConditionRow(Base):
    """One condition of the design."""

    __tablename__ = "condition"
    __table_args__ = (UniqueConstraint("masked_label"),)

    name: Mapped[str] = mapped_column(primary_key=True)
    masked_label: Mapped[str]


class ConditionLevelRow(Base):
    """The level of a condition on one factor."""

    __tablename__ = "condition_level"

    condition: Mapped[str] = mapped_column(ForeignKey("condition.name"), primary_key=True)
    factor: Mapped[str] = mapped_column(primary_key=True)
    level: Mapped[str]


class TrialRow(Base):
    """One attempt at one trial, written as planned long before it is run."""

    __tablename__ = "trial"
    __table_args__ = (
        UniqueConstraint("session_id", "position", "attempt"),
        _one_of("status", TrialStatus),
        _sha256("seed"),
        _at_least("position", 1),
        _at_least("attempt", 1),
        _at_least("repetition", 1),
        _at_least("protocol_version", 1),
        _at_least("duration_s", 0),
        _at_least("path_length_m", 0),
        _at_least("collisions", 0),
        _at_least("collisions_legacy", 0),
        _at_least("contact_time_s", 0),
    )

    id: Mapped[int] = mapped_column(primary_key=True)
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"))
    position: Mapped[int]
    attempt: Mapped[int]
    kind: Mapped[str]
    condition: Mapped[str | None] = mapped_column(ForeignKey("condition.name"))
    repetition: Mapped[int]
    task: Mapped[str]
    route: Mapped[str]
    status: Mapped[str]
    reason: Mapped[str]
    protocol_version: Mapped[int]
    seed: Mapped[str] = mapped_column(String(64))
    duration_s: Mapped[float | None]
    path_length_m: Mapped[float | None]
    collisions: Mapped[int | None]
    collisions_legacy: Mapped[int | None]
    contact_time_s: Mapped[float | None]
    started_at: Mapped[datetime | None]
    finished_at: Mapped[datetime | None]


class EventRow(Base):
    """Something that happened in a trial."""

    __tablename__ = "event"

    id: Mapped[int] = mapped_column(primary_key=True)
    trial_id: Mapped[int] = mapped_column(ForeignKey("trial.id"), index=True)
    t: Mapped[float]
    kind: Mapped[str]
    detail: Mapped[str]


class SampleRow(Base):
    """Robot, stick and feedback at one instant; the columns are omnistudy.channel's."""

    __tablename__ = "sample"
    __table_args__ = ({"sqlite_with_rowid": False},)

    trial_id: Mapped[int] = mapped_column(ForeignKey("trial.id"), primary_key=True)
    t: Mapped[float] = mapped_column(primary_key=True)
    x: Mapped[float | None]
    y: Mapped[float | None]
    theta: Mapped[float | None]
    vx: Mapped[float | None]
    vy: Mapped[float | None]
    omega: Mapped[float | None]
    stick_x: Mapped[float | None]
    stick_y: Mapped[float | None]
    stick_theta: Mapped[float | None]
    fx: Mapped[float | None]
    fy: Mapped[float | None]
    tau: Mapped[float | None]


class DeviceRow(Base):
    """Which device an attempt was driven with."""

    __tablename__ = "device"
    __table_args__ = (_one_of("wrench", Wrench), _one_of("scale", Scale))

    trial_id: Mapped[int] = mapped_column(ForeignKey("trial.id"), primary_key=True)
    kind: Mapped[str]
    model: Mapped[str]
    serial: Mapped[str]
    firmware: Mapped[str]
    calibration: Mapped[str]
    pushes: Mapped[str]
    wrench: Mapped[str]
    scale: Mapped[str]


class MeasureRow(Base):
    """One number about how well an attempt was run."""

    __tablename__ = "measure"

    trial_id: Mapped[int] = mapped_column(ForeignKey("trial.id"), primary_key=True)
    name: Mapped[str] = mapped_column(primary_key=True)
    value: Mapped[float]
    unit: Mapped[str]


class StreamRow(Base):
    """A recording of further channels at one rate; its numbers lie in chunks."""

    __tablename__ = "stream"
    __table_args__ = (
        UniqueConstraint("trial_id", "name"),
        CheckConstraint("rate_hz > 0", name="rate_hz"),
    )

    id: Mapped[int] = mapped_column(primary_key=True)
    trial_id: Mapped[int] = mapped_column(ForeignKey("trial.id"))
    name: Mapped[str]
    rate_hz: Mapped[float]
    columns: Mapped[str]


class ChunkRow(Base):
    """Some thousand rows of a stream, packed."""

    __tablename__ = "chunk"
    __table_args__ = (_at_least("rows", 1), _sha256("sha256"))

    stream_id: Mapped[int] = mapped_column(ForeignKey("stream.id"), primary_key=True)
    t0: Mapped[float] = mapped_column(primary_key=True)
    rows: Mapped[int]
    sha256: Mapped[str] = mapped_column(String(64))
    data: Mapped[bytes]
