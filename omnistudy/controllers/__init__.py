"""How a device's position becomes a plant's command."""

from omnistudy.controllers.controller import Control, Controller

__all__ = ["Control", "Controller"]
