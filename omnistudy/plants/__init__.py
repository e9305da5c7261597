"""Robots in their physics; the only room that imports pybullet."""

from omnistudy.plants.plant import Plant, RunningPlant

__all__ = ["Plant", "RunningPlant"]
