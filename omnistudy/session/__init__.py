"""What happens: running, calibrating; speaks to people only through what cli passes in."""
