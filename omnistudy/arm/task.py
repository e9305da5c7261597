"""A task of an arm as a page: which arm, where it starts, what the hand does, who controls it."""

from __future__ import annotations

from math import sqrt
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, field_validator

from omnistudy.arm.paths import ArcPath, LinePath, Path
from omnistudy.arm.timing import Timing
from omnistudy.geometry import PlanarPose
from omnistudy.geometry.rigid_motion import rotation, transform
from omnistudy.registry import Model, kind_validator
from omnistudy.units import (
    Metres,
    MetresPerSecond,
    Positive,
    Radians,
    RadiansPerSecond,
    Ratio,
    Seconds,
)

Floats = NDArray[np.float64]
Place = tuple[Metres, Metres, Metres]
Row = tuple[Ratio, Ratio, Ratio]
Frame = Literal["ground", "wheelchair", "gripper"]

ROTATION_TOLERANCE = 1e-6
"""How far a matrix on a page may be from a rotation."""

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


class Turn(Model):
    """A turn about one of the hand's own axes."""

    axis: Literal["x", "y", "z"]
    angle: Radians


class ChairPose(Model):
    """Where the wheelchair stands: the point of the floor below the arm's base, and its heading."""

    x: Metres = 0.0
    y: Metres = 0.0
    theta: Radians = 0.0

    @property
    def pose(self) -> PlanarPose:
        """The same as a pose."""
        return PlanarPose(self.x, self.y, self.theta)


class ArmStart(Model):
    """Joints and chair at the beginning."""

    joints: Literal["ready", "park"] | tuple[Radians, ...] = "ready"
    """A posture of the profile by name, or the angles."""
    chair: ChairPose = ChairPose()


class Goal(Model):
    """Where the hand is to be, from the ground, or from chair or hand when the motion begins."""

    frame: Frame = "ground"
    position: Place | None = None
    """None stays where the hand is."""
    rotation: tuple[Row, Row, Row] | None = None
    """Rows of a matrix whose columns are the hand's axes; None keeps the hand's rotation."""
    turns: tuple[Turn, ...] = ()
    """Done after that, each about the hand's own axis."""

    @field_validator("rotation")
    @classmethod
    def _is_a_rotation(cls, rows: Any) -> Any:
        if rows is None:
            return None
        matrix = np.array(rows)
        off = float(np.abs(matrix @ matrix.T - np.eye(3)).max())
        if off > ROTATION_TOLERANCE or np.linalg.det(matrix) < 0.0:
            raise ValueError(
                "the rows must make a rotation: each of length 1, square to the others, and "
                "right handed"
            )
        return rows

    def pose(self, hand: Floats, base: Floats) -> Floats:
        """Give the goal (4, 4) as seen from the ground, for where hand and arm's base are now."""
        frame = {"ground": np.eye(4), "wheelchair": base, "gripper": hand}[self.frame]
        turned, place = hand[:3, :3], hand[:3, 3]
        if self.rotation is not None:
            turned = frame[:3, :3] @ np.array(self.rotation)
        if self.position is not None:
            place = frame[:3, :3] @ np.array(self.position) + frame[:3, 3]
        for turn in self.turns:
            turned = turned @ rotation(np.array(_AXES[turn.axis]), turn.angle)
        return transform(turned, place)


class Hinge(Model):
    """A door's hinge, from where the hand is when the motion begins, and how far it opens."""

    from_hand: Place
    """From the hand to the hinge's axis, in ground axes."""
    axis: Row = (0.0, 0.0, 1.0)
    """Direction of the hinge's axis, in ground axes; any length but 0."""
    angle: Radians
    """Right handed about the axis."""
    hand: Literal["constant", "following"] = "following"
    """Whether the hand keeps its rotation or turns with the door."""

    @field_validator("axis")
    @classmethod
    def _has_a_direction(cls, axis: Any) -> Any:
        if not any(axis):
            raise ValueError("an axis needs a direction, it cannot be 0, 0, 0")
        return axis


class Motion(Model):
    """One motion of the hand: to a goal in a straight line, or round a hinge."""

    name: str
    goal: Goal | None = None
    hinge: Annotated[Hinge | None, Field(validate_default=True)] = None
    speed: Annotated[MetresPerSecond, Positive] = 0.05
    """Mean speed of the hand (Farelo 2009, sec. 6: 50 mm/s)."""
    turning: Annotated[RadiansPerSecond, Positive] = 0.15
    """Mean speed of the hand's turn; that of the lab's touch screen."""
    timing: Timing = Timing()
    pace: Literal["hand", "all"] = "all"
    """Takes as long as the hand's speed asks, as published; or longer where chair or joints could
    not follow."""
    chair_goal: ChairPose | None = None
    """Where the chair should end; the published weights do not bring it there."""
    carried: bool = False
    """Whether the hand may go straight as the chair sees it instead of over the ground: in free
    space only, and only with a controller that leads the chair too."""
    controller: Annotated[Any, kind_validator("controllers")] | None = None
    """Another controller for this motion."""

    @field_validator("hinge")
    @classmethod
    def _one_of_two(cls, hinge: Any, info: Any) -> Any:
        if (hinge is None) == (info.data.get("goal") is None):
            raise ValueError("give either a goal or a hinge")
        return hinge

    def path(self, hand: Floats, base: Floats) -> Path:
        """Give the hand's path from where it is, (4, 4), with the arm's base at `base`."""
        if self.hinge is not None:
            axis = np.array(self.hinge.axis)
            return ArcPath(
                start=hand,
                hinge=hand[:3, 3] + np.array(self.hinge.from_hand),
                axis=axis / sqrt(float(axis @ axis)),
                turn=self.hinge.angle,
                following=self.hinge.hand == "following",
            )
        goal = self.goal or Goal()
        return LinePath(hand, goal.pose(hand, base))

    def hand_duration(self, path: Path) -> float:
        """Give the seconds that the hand's two speeds ask for; 0 for a path that leads nowhere."""
        return max(path.length / self.speed, path.angle / self.turning)


class ArmTask(Model):
    """A task: motions of the hand, one after the other."""

    title: str = ""
    arm: str = "wmra1"
    """An arm's name or file."""
    start: ArmStart = ArmStart()
    step: Annotated[Seconds, Positive] = 0.05
    """Of control (Farelo 2009: 50 ms); rounded so that a motion takes a whole number of steps."""
    error: Literal["logarithm", "legacy"] = "logarithm"
    """`legacy` takes the sine of what is left to turn for the angle, as published."""
    controller: Annotated[Any, kind_validator("controllers")]
    """A kind and what differs from its defaults."""
    motions: Annotated[tuple[Motion, ...], Field(min_length=1)]
