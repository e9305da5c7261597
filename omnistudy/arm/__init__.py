"""A jointed arm on a driven wheelchair: kinematics, trajectories and tasks, without physics."""

from omnistudy.arm.configuration import ArmBody, ArmState, Configuration
from omnistudy.arm.find import arm_names, load_arm
from omnistudy.arm.profile import ArmProfile

__all__ = ["ArmBody", "ArmProfile", "ArmState", "Configuration", "arm_names", "load_arm"]
