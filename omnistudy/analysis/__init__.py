"""Numbers from the tables of a study; no SQL, no HTML."""
