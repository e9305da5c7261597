"""Feedback laws, one file each: what the stick makes the hand feel."""

from omnistudy.laws.law import Law, Sensed, WrenchLaw

__all__ = ["Law", "Sensed", "WrenchLaw"]
