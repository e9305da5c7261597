"""The class under every mistake that a user can meet."""


class OmnistudyError(Exception):
    """A mistake with its remedy in the message; the command line prints it and exits 1."""
