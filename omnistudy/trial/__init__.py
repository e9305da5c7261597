"""One trial: the loop that couples operator, device, controller, law, plant and task."""

from omnistudy.trial.companion import Companion, Glimpse
from omnistudy.trial.loop import resimulate, run_trial
from omnistudy.trial.result import TrialResult
from omnistudy.trial.spec import TrialSpec

__all__ = ["Companion", "Glimpse", "TrialResult", "TrialSpec", "resimulate", "run_trial"]
