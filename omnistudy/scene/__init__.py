"""One description of what stands in a world and of what touches what."""

from omnistudy.scene.motion import Moment, Motion, Patrol, Timetable, Track
from omnistudy.scene.robot import Joint, Link
from omnistudy.scene.scene import HINGE, Body, Box, Colour, Cylinder, Hinge, Region, Role, Scene
from omnistudy.scene.sight import Sight
from omnistudy.scene.state import NO_CONTACT, Contacts, PlanarState

__all__ = [
    "HINGE",
    "NO_CONTACT",
    "Body",
    "Box",
    "Colour",
    "Contacts",
    "Cylinder",
    "Hinge",
    "Joint",
    "Link",
    "Moment",
    "Motion",
    "Patrol",
    "PlanarState",
    "Region",
    "Role",
    "Scene",
    "Sight",
    "Timetable",
    "Track",
]
