"""What is to be run, as pure data: models, composition, orders, freeze and hashes."""

from omnistudy.protocol.condition import Condition, Factor, Level
from omnistudy.protocol.freeze import FrozenProtocol, freeze, thaw
from omnistudy.protocol.plan import PlannedTrial, StudyPlan, plan
from omnistudy.protocol.protocol import Protocol, Setup

__all__ = [
    "Condition",
    "Factor",
    "FrozenProtocol",
    "Level",
    "PlannedTrial",
    "Protocol",
    "Setup",
    "StudyPlan",
    "freeze",
    "plan",
    "thaw",
]
