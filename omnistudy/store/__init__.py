"""The study database: tables, migrations, writer, readers."""
