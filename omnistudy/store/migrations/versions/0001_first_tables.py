"""The first tables."""

import sqlalchemy as sa
from alembic import op

revision = "0001"
down_revision = None


def upgrade() -> None:
    """Make every table of the first revision."""
    _make_design()
    _make_people()
    _make_trials()
    _make_samples()
    _make_streams()


def _make_design() -> None:
    op.create_table(
        "study",
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("title", sa.Text(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("protocol", sa.Text(), nullable=False),
        sa.Column("protocol_version", sa.Integer(), nullable=False),
        sa.Column("design_hash", sa.String(64), nullable=False),
        sa.Column("site_hash", sa.String(64), nullable=False),
        sa.Column("created_at", sa.String(24), nullable=False),
        sa.Column("omnistudy_version", sa.Text(), nullable=False),
        sa.CheckConstraint("kind IN ('virtual', 'human')", name=op.f("ck_study_kind")),
        sa.CheckConstraint("length(design_hash) = 64", name=op.f("ck_study_design_hash")),
        sa.CheckConstraint("length(site_hash) = 64", name=op.f("ck_study_site_hash")),
        sa.CheckConstraint("protocol_version >= 1", name=op.f("ck_study_protocol_version")),
        sa.PrimaryKeyConstraint("name", name=op.f("pk_study")),
    )
    op.create_table(
        "condition",
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("masked_label", sa.Text(), nullable=False),
        sa.PrimaryKeyConstraint("name", name=op.f("pk_condition")),
        sa.UniqueConstraint("masked_label", name=op.f("uq_condition_masked_label")),
    )
    op.create_table(
        "condition_level",
        sa.Column("condition", sa.Text(), nullable=False),
        sa.Column("factor", sa.Text(), nullable=False),
        sa.Column("level", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(
            ["condition"], ["condition.name"], name=op.f("fk_condition_level_condition")
        ),
        sa.PrimaryKeyConstraint("condition", "factor", name=op.f("pk_condition_level")),
    )


def _make_people() -> None:
    op.create_table(
        "participant",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("code", sa.Text(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("group_name", sa.Text()),
        sa.Column("sequence", sa.Text()),
        sa.Column("status", sa.Text(), nullable=False),
        sa.Column("seed", sa.String(64), nullable=False),
        sa.CheckConstraint("kind IN ('virtual', 'human')", name=op.f("ck_participant_kind")),
        sa.CheckConstraint(
            "status IN ('enrolled', 'active', 'completed', 'withdrawn')",
            name=op.f("ck_participant_status"),
        ),
        sa.CheckConstraint("length(seed) = 64", name=op.f("ck_participant_seed")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_participant")),
        sa.UniqueConstraint("code", name=op.f("uq_participant_code")),
    )
    op.create_table(
        "session",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("participant_id", sa.Integer(), nullable=False),
        sa.Column("visit", sa.Integer(), nullable=False),
        sa.Column("status", sa.Text(), nullable=False),
        sa.Column("reason", sa.Text(), nullable=False),
        sa.Column("started_at", sa.String(24)),
        sa.Column("finished_at", sa.String(24)),
        sa.CheckConstraint(
            "status IN ('planned', 'running', 'completed', 'aborted')",
            name=op.f("ck_session_status"),
        ),
        sa.CheckConstraint("visit >= 1", name=op.f("ck_session_visit")),
        sa.ForeignKeyConstraint(
            ["participant_id"], ["participant.id"], name=op.f("fk_session_participant_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_session")),
        sa.UniqueConstraint("participant_id", "visit", name=op.f("uq_session_participant_id")),
    )


def _make_trials() -> None:
    op.create_table(
        "trial",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("session_id", sa.Integer(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("attempt", sa.Integer(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("condition", sa.Text()),
        sa.Column("repetition", sa.Integer(), nullable=False),
        sa.Column("task", sa.Text(), nullable=False),
        sa.Column("route", sa.Text(), nullable=False),
        sa.Column("status", sa.Text(), nullable=False),
        sa.Column("reason", sa.Text(), nullable=False),
        sa.Column("protocol_version", sa.Integer(), nullable=False),
        sa.Column("seed", sa.String(64), nullable=False),
        sa.Column("duration_s", sa.Double()),
        sa.Column("path_length_m", sa.Double()),
        sa.Column("collisions", sa.Integer()),
        sa.Column("collisions_legacy", sa.Integer()),
        sa.Column("contact_time_s", sa.Double()),
        sa.Column("started_at", sa.String(24)),
        sa.Column("finished_at", sa.String(24)),
        sa.CheckConstraint(
            "status IN ('planned', 'running', 'completed', 'timed_out', 'void', 'aborted')",
            name=op.f("ck_trial_status"),
        ),
        sa.CheckConstraint("attempt >= 1", name=op.f("ck_trial_attempt")),
        sa.CheckConstraint("collisions >= 0", name=op.f("ck_trial_collisions")),
        sa.CheckConstraint("collisions_legacy >= 0", name=op.f("ck_trial_collisions_legacy")),
        sa.CheckConstraint("contact_time_s >= 0", name=op.f("ck_trial_contact_time_s")),
        sa.CheckConstraint("duration_s >= 0", name=op.f("ck_trial_duration_s")),
        sa.CheckConstraint("length(seed) = 64", name=op.f("ck_trial_seed")),
        sa.CheckConstraint("path_length_m >= 0", name=op.f("ck_trial_path_length_m")),
        sa.CheckConstraint("position >= 1", name=op.f("ck_trial_position")),
        sa.CheckConstraint("protocol_version >= 1", name=op.f("ck_trial_protocol_version")),
        sa.CheckConstraint("repetition >= 1", name=op.f("ck_trial_repetition")),
        sa.ForeignKeyConstraint(["condition"], ["condition.name"], name=op.f("fk_trial_condition")),
        sa.ForeignKeyConstraint(["session_id"], ["session.id"], name=op.f("fk_trial_session_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_trial")),
        sa.UniqueConstraint("session_id", "position", "attempt", name=op.f("uq_trial_session_id")),
    )
    op.create_table(
        "event",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("trial_id", sa.Integer(), nullable=False),
        sa.Column("t", sa.Double(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("detail", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(["trial_id"], ["trial.id"], name=op.f("fk_event_trial_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_event")),
    )
    op.create_index(op.f("ix_event_trial_id"), "event", ["trial_id"])


def _make_samples() -> None:
    op.create_table(
        "sample",
        sa.Column("trial_id", sa.Integer(), nullable=False),
        sa.Column("t", sa.Double(), nullable=False),
        sa.Column("x", sa.Double()),
        sa.Column("y", sa.Double()),
        sa.Column("theta", sa.Double()),
        sa.Column("vx", sa.Double()),
        sa.Column("vy", sa.Double()),
        sa.Column("omega", sa.Double()),
        sa.Column("stick_x", sa.Double()),
        sa.Column("stick_y", sa.Double()),
        sa.Column("stick_theta", sa.Double()),
        sa.Column("fx", sa.Double()),
        sa.Column("fy", sa.Double()),
        sa.Column("tau", sa.Double()),
        sa.ForeignKeyConstraint(["trial_id"], ["trial.id"], name=op.f("fk_sample_trial_id")),
        sa.PrimaryKeyConstraint("trial_id", "t", name=op.f("pk_sample")),
        sqlite_with_rowid=False,
    )


def _make_streams() -> None:
    op.create_table(
        "stream",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("trial_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("rate_hz", sa.Double(), nullable=False),
        sa.Column("columns", sa.Text(), nullable=False),
        sa.CheckConstraint("rate_hz > 0", name=op.f("ck_stream_rate_hz")),
        sa.ForeignKeyConstraint(["trial_id"], ["trial.id"], name=op.f("fk_stream_trial_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_stream")),
        sa.UniqueConstraint("trial_id", "name", name=op.f("uq_stream_trial_id")),
    )
    op.create_table(
        "chunk",
        sa.Column("stream_id", sa.Integer(), nullable=False),
        sa.Column("t0", sa.Double(), nullable=False),
        sa.Column("rows", sa.Integer(), nullable=False),
        sa.Column("sha256", sa.String(64), nullable=False),
        sa.Column("data", sa.LargeBinary(), nullable=False),
        sa.CheckConstraint("length(sha256) = 64", name=op.f("ck_chunk_sha256")),
        sa.CheckConstraint("rows >= 1", name=op.f("ck_chunk_rows")),
        sa.ForeignKeyConstraint(["stream_id"], ["stream.id"], name=op.f("fk_chunk_stream_id")),
        sa.PrimaryKeyConstraint("stream_id", "t0", name=op.f("pk_chunk")),
    )
