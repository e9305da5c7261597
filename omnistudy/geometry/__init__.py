"""Mathematics of rigid motion, SI units, no physics and no files."""

from omnistudy.geometry.force_field import NO_FORCE, ZERO_MATRIX, ForceField, Matrix3, Vector3
from omnistudy.geometry.planar import PlanarPose, PlanarTwist, PlanarWrench, wrapped
from omnistudy.geometry.scan import Scan
from omnistudy.geometry.space import Pose, Twist, Wrench

__all__ = [
    "NO_FORCE",
    "ZERO_MATRIX",
    "ForceField",
    "Matrix3",
    "PlanarPose",
    "PlanarTwist",
    "PlanarWrench",
    "Pose",
    "Scan",
    "Twist",
    "Vector3",
    "Wrench",
    "wrapped",
]
