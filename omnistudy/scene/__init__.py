"""One description of what stands in a world and of what touches what."""

from omnistudy.scene.motion import Moment, Motion, Patrol, Timetable, Track
from omnistudy.scene.scene import Body, Box, Colour, Cylinder, Hinge, Region, Role, Scene
from omnistudy.scene.state import NO_CONTACT, Contacts, PlanarState

__all__ = [
    "NO_CONTACT",
    "Body",
    "Box",
    "Colour",
    "Contacts",
    "Cylinder",
    "Hinge",
    "Moment",
    "Motion",
    "Patrol",
    "PlanarState",
    "Region",
    "Role",
    "Scene",
    "Timetable",
    "Track",
]
