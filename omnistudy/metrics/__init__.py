"""Pure metric functions, one file each."""
