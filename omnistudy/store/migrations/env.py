"""What Alembic runs: migrate over the connection that omnistudy.store.schema hands over."""

from alembic import context

from omnistudy.store.tables import Base

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=Base.metadata,
    render_as_batch=True,
)
context.run_migrations()
