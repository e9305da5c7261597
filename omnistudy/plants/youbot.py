"""The youBot-size mecanum base of the thesis."""

from __future__ import annotations

from typing import Annotated, Literal

from omnistudy.geometry import PlanarPose
from omnistudy.plants.lidar import Lidar
from omnistudy.plants.mecanum import MecanumBase
from omnistudy.plants.plant import RunningPlant
from omnistudy.scene import Scene, Sight
from omnistudy.units import Kilograms, Metres, NewtonMetres, Newtons, Positive


class Youbot(MecanumBase):
    """Mecanum base with a perfect speed loop (Tyagi 2017, sec. 2.4)."""

    kind: Literal["youbot"] = "youbot"
    half_length: Annotated[Metres, Positive] = 0.29
    half_width: Annotated[Metres, Positive] = 0.19
    wheel_radius: Annotated[Metres, Positive] = 0.05
    wheel_lever: Annotated[Metres, Positive] = 0.29
    """Half wheelbase plus half track in the Jacobian; the thesis's code has the half length."""
    mass: Annotated[Kilograms, Positive] = 24.0
    drive_force: Annotated[Newtons, Positive] = 200.0
    """What the drive can push with; a wall stops it."""
    drive_torque: Annotated[NewtonMetres, Positive] = 50.0
    lidar: Lidar = Lidar()

    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        """Put the base into the scene; it draws nothing. Raises StartsInWall."""
        from omnistudy.plants.youbot_physics import RunningYoubot

        return RunningYoubot(self, scene, start, physics_hz)

    @property
    def sight(self) -> Sight:
        """The rays of its range sensor."""
        return self.lidar.sight
