"""What happens: running, calibrating; speaks to people only through what cli passes in."""

from omnistudy.session.run import RunSummary, run_trials

__all__ = ["RunSummary", "run_trials"]
