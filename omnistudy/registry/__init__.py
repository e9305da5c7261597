"""Kinds and the frozen models that they select."""

from omnistudy.registry.kinds import kinds, load_kind
from omnistudy.registry.model import KindModel, Model, kind_validator

__all__ = ["KindModel", "Model", "kind_validator", "kinds", "load_kind"]
