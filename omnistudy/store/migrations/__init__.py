"""How study databases grow from one revision to the next; each is a file in `versions`.

Batch mode makes a table anew and forgets two things that it cannot see: CHECK constraints (pass
them as `table_args`) and WITHOUT ROWID (pass `table_kwargs={"sqlite_with_rowid": False}`). The test
that compares migrations with the declared tables notices both.
"""
