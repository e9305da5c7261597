"""How study databases grow from one revision to the next."""
