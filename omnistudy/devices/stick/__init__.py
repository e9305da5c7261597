"""The 3-DOF stick on its serial line."""
