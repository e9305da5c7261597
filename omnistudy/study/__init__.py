"""What may happen: create, freeze, enrol, allocate."""
