"""A scene as PyBullet bodies."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, sin
from typing import NamedTuple

from omnistudy.channel import Channel
from omnistudy.plants.bullet import pybullet
from omnistudy.plants.bullet_motion import MovingBodies, MovingBody
from omnistudy.scene import HINGE, Body, Box, Scene

ROBOT, STATIC, DOOR = 1, 2, 4
"""Collision groups: robots meet walls and doors; doors meet only robots; walls only robots."""
UPRIGHT = (0.0, 0.0, 0.0, 1.0)
DOOR_LINK = 0
BOXES_IN_ONE = 16
"""Boxes of one map that are joined to one PyBullet body: a step costs time for every body."""


class Marker(NamedTuple):
    """A body that is noticed when touched but stops nothing."""

    name: str
    uid: int
    x: float
    y: float
    radius: float


class Doors(NamedTuple):
    """The bodies that turn on a hinge, by their names."""

    uids: dict[str, int]
    client: int

    @property
    def channels(self) -> tuple[Channel, ...]:
        """One angle a door: how far it is turned from where its body says."""
        return tuple(
            Channel(f"{HINGE}{name}", "rad", "how far the door is open, counter-clockwise")
            for name in self.uids
        )

    def angles(self) -> tuple[float, ...]:
        """Give the present angles in rad."""
        return tuple(
            pybullet.getJointState(uid, DOOR_LINK, physicsClientId=self.client)[0]
            for uid in self.uids.values()
        )


class BulletScene(NamedTuple):
    """Names of the PyBullet bodies by their unique number; those that stop nothing, that move."""

    walls: dict[int, str]
    others: dict[int, str]
    markers: tuple[Marker, ...]
    moving: MovingBodies
    doors: Doors


def add_scene(scene: Scene, client: int, physics_hz: int) -> BulletScene:
    """Create every body of the scene in a PyBullet client; call `moving.step` before each step."""
    walls: dict[int, str] = {}
    others: dict[int, str] = {}
    markers: list[Marker] = []
    moving: list[MovingBody] = []
    doors = Doors({}, client)
    parts: dict[str, list[Body]] = {}
    for body in scene.bodies:
        if body.role == "floor":
            continue
        if body.part_of:
            parts.setdefault(body.part_of, []).append(body)
            continue
        uid = _hinged(body, client) if body.hinge else _standing(body, client)
        if body.hinge:
            doors.uids[body.name] = uid
        if not body.solid:
            markers.append(Marker(body.name, uid, body.x, body.y, _radius(body)))
        elif body.role == "wall":
            walls[uid] = body.name
            if body.track:
                moving.append(MovingBody(uid, body.track, body.z, _turned(body.yaw)))
        else:
            others[uid] = body.name
    for name, boxes in parts.items():
        for first in range(0, len(boxes), BOXES_IN_ONE):
            walls[_joined(boxes[first : first + BOXES_IN_ONE], client)] = name
    bodies = MovingBodies(tuple(moving), client, physics_hz)
    return BulletScene(walls, others, tuple(markers), bodies, doors)


def _radius(body: Body) -> float:
    shape = body.geometry
    return 0.5 * hypot(shape.x, shape.y) if isinstance(shape, Box) else shape.radius


def _turned(yaw: float) -> tuple[float, float, float, float]:
    x, y, z, w = pybullet.getQuaternionFromEuler([0.0, 0.0, yaw])
    return x, y, z, w


def _shape(body: Body, client: int) -> int:
    shape = body.geometry
    if isinstance(shape, Box):
        return int(
            pybullet.createCollisionShape(
                pybullet.GEOM_BOX,
                halfExtents=[0.5 * shape.x, 0.5 * shape.y, 0.5 * shape.z],
                physicsClientId=client,
            )
        )
    return int(
        pybullet.createCollisionShape(
            pybullet.GEOM_CYLINDER,
            radius=shape.radius,
            height=shape.length,
            physicsClientId=client,
        )
    )


def _joined(boxes: Sequence[Body], client: int) -> int:
    """Make one body of several; their shapes are what takes part in it."""
    halves = [[0.5 * s.x, 0.5 * s.y, 0.5 * s.z] for b in boxes if isinstance(s := b.geometry, Box)]
    shape = pybullet.createCollisionShapeArray(
        shapeTypes=[pybullet.GEOM_BOX] * len(boxes),
        halfExtents=halves,
        collisionFramePositions=[[body.x, body.y, body.z] for body in boxes],
        collisionFrameOrientations=[_turned(body.yaw) for body in boxes],
        physicsClientId=client,
    )
    uid = pybullet.createMultiBody(0.0, shape, physicsClientId=client)
    pybullet.setCollisionFilterGroupMask(uid, -1, STATIC, ROBOT, physicsClientId=client)
    return int(uid)


def _standing(body: Body, client: int) -> int:
    uid = pybullet.createMultiBody(
        baseMass=0.0,
        baseCollisionShapeIndex=_shape(body, client),
        basePosition=[body.x, body.y, body.z],
        baseOrientation=_turned(body.yaw),
        physicsClientId=client,
    )
    mask = ROBOT if body.solid else 0
    pybullet.setCollisionFilterGroupMask(
        uid, -1, STATIC if body.solid else 0, mask, physicsClientId=client
    )
    return int(uid)


def _hinged(body: Body, client: int) -> int:
    hinge = body.hinge
    assert hinge is not None
    c, s = cos(body.yaw), sin(body.yaw)
    uid = pybullet.createMultiBody(
        baseMass=0.0,
        basePosition=[
            body.x + c * hinge.x - s * hinge.y,
            body.y + s * hinge.x + c * hinge.y,
            body.z,
        ],
        baseOrientation=_turned(body.yaw),
        linkMasses=[body.mass],
        linkCollisionShapeIndices=[_shape(body, client)],
        linkVisualShapeIndices=[-1],
        linkPositions=[[0.0, 0.0, 0.0]],
        linkOrientations=[UPRIGHT],
        linkInertialFramePositions=[[-hinge.x, -hinge.y, 0.0]],
        linkInertialFrameOrientations=[UPRIGHT],
        linkParentIndices=[0],
        linkJointTypes=[pybullet.JOINT_REVOLUTE],
        linkJointAxis=[[0.0, 0.0, 1.0]],
        physicsClientId=client,
    )
    pybullet.changeDynamics(
        uid,
        DOOR_LINK,
        jointLowerLimit=hinge.lower,
        jointUpperLimit=hinge.upper,
        linearDamping=0.0,
        angularDamping=0.0,
        jointDamping=0.0,
        physicsClientId=client,
    )
    pybullet.setJointMotorControl2(
        uid,
        DOOR_LINK,
        pybullet.VELOCITY_CONTROL,
        targetVelocity=0.0,
        force=hinge.friction,
        physicsClientId=client,
    )
    pybullet.setCollisionFilterGroupMask(uid, DOOR_LINK, DOOR, ROBOT, physicsClientId=client)
    return int(uid)
