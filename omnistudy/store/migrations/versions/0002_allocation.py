"""Allocation drawn at the first freeze, and every version of the protocol."""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"


def upgrade() -> None:
    """Make both tables; an older study has one group, its slots are its participants'."""
    op.create_table(
        "allocation",
        sa.Column("slot", sa.Integer(), nullable=False),
        sa.Column("stratum", sa.Text(), nullable=False),
        sa.Column("group_name", sa.Text(), nullable=False),
        sa.Column("row", sa.Integer(), nullable=False),
        sa.Column("participant_id", sa.Integer()),
        sa.CheckConstraint("slot >= 0", name=op.f("ck_allocation_slot")),
        sa.CheckConstraint("row >= 0", name=op.f("ck_allocation_row")),
        sa.ForeignKeyConstraint(
            ["participant_id"], ["participant.id"], name=op.f("fk_allocation_participant_id")
        ),
        sa.PrimaryKeyConstraint("slot", name=op.f("pk_allocation")),
        sa.UniqueConstraint("stratum", "group_name", "row", name=op.f("uq_allocation_stratum")),
    )
    op.create_table(
        "protocol_version",
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("protocol", sa.Text(), nullable=False),
        sa.Column("design_hash", sa.String(64), nullable=False),
        sa.Column("site_hash", sa.String(64), nullable=False),
        sa.Column("reason", sa.Text(), nullable=False),
        sa.Column("frozen_at", sa.String(24), nullable=False),
        sa.Column("omnistudy_version", sa.Text(), nullable=False),
        sa.CheckConstraint(
            "length(design_hash) = 64", name=op.f("ck_protocol_version_design_hash")
        ),
        sa.CheckConstraint("length(site_hash) = 64", name=op.f("ck_protocol_version_site_hash")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_protocol_version_version")),
        sa.PrimaryKeyConstraint("version", name=op.f("pk_protocol_version")),
    )
    op.execute(
        "INSERT INTO allocation (slot, stratum, group_name, row, participant_id) "
        "SELECT id - 1, '', '', id - 1, id FROM participant"
    )
    op.execute(
        "INSERT INTO protocol_version (version, protocol, design_hash, site_hash, reason, "
        "frozen_at, omnistudy_version) SELECT protocol_version, protocol, design_hash, site_hash, "
        "'first freeze', created_at, omnistudy_version FROM study"
    )
