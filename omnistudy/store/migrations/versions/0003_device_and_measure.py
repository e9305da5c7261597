"""Which device an attempt was driven with, and how well it was run."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"


def upgrade() -> None:
    """Make both tables; of older attempts nothing is known."""
    op.create_table(
        "device",
        sa.Column("trial_id", sa.Integer(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("model", sa.Text(), nullable=False),
        sa.Column("serial", sa.Text(), nullable=False),
        sa.Column("firmware", sa.Text(), nullable=False),
        sa.Column("calibration", sa.Text(), nullable=False),
        sa.Column("pushes", sa.Text(), nullable=False),
        sa.Column("wrench", sa.Text(), nullable=False),
        sa.Column("scale", sa.Text(), nullable=False),
        sa.CheckConstraint(
            "wrench IN ('none', 'commanded', 'clipped', 'measured')",
            name=op.f("ck_device_wrench"),
        ),
        sa.CheckConstraint("scale IN ('nominal', 'calibrated')", name=op.f("ck_device_scale")),
        sa.ForeignKeyConstraint(["trial_id"], ["trial.id"], name=op.f("fk_device_trial_id")),
        sa.PrimaryKeyConstraint("trial_id", name=op.f("pk_device")),
    )
    op.create_table(
        "measure",
        sa.Column("trial_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("value", sa.Double(), nullable=False),
        sa.Column("unit", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(["trial_id"], ["trial.id"], name=op.f("fk_measure_trial_id")),
        sa.PrimaryKeyConstraint("trial_id", "name", name=op.f("pk_measure")),
    )
