"""A mecanum base in PyBullet: a jointed base driven by force-limited velocity motors."""

from __future__ import annotations

from math import atan2, cos, hypot, nan, pi, sin

from omnistudy.channel import Channel
from omnistudy.errors.plants import StartsInWall
from omnistudy.geometry import PlanarPose, PlanarTwist, wrapped
from omnistudy.plants.bullet import pybullet
from omnistudy.plants.bullet_scene import DOOR, ROBOT, STATIC, UPRIGHT, add_scene
from omnistudy.plants.chassis_rays import Chassis
from omnistudy.plants.mecanum import (
    CHASSIS_HALF_HEIGHT,
    CHASSIS_HEIGHT,
    WHEEL_PROUD,
    WHEEL_WIDTH,
    WHEELS,
    MecanumBase,
    WheelSpeeds,
)
from omnistudy.plants.plant import RunningPlant
from omnistudy.scene import NO_CONTACT, Contacts, PlanarState, Scene

JOINTS = (0, 1, 2)
CHASSIS = 2
"""Links 0 and 1 slide along the world's x and y, link 2 turns and carries the chassis."""
CARRIAGE_MASS = 0.01
WHEEL_MASS = 0.1


class RunningMecanum(RunningPlant):
    """One base in one PyBullet client of its own; nobody else's client is touched.

    A subclass says how commands become wheel speeds, and calls `drive` with them.
    """

    channels: tuple[Channel, ...] = (
        Channel("x", "m", "robot's position in the world"),
        Channel("y", "m", "robot's position in the world"),
        Channel("theta", "rad", "robot's heading, counter-clockwise, not wrapped"),
        Channel("vx", "m/s", "forward velocity in the robot's frame"),
        Channel("vy", "m/s", "leftward velocity in the robot's frame"),
        Channel("omega", "rad/s", "turning rate"),
        *(Channel(name, "rad/s", "speed at which the wheel is driven") for name in WHEELS),
    )

    def __init__(self, base: MecanumBase, scene: Scene, start: PlanarPose, physics_hz: int) -> None:
        self._base = base
        self._client = pybullet.connect(pybullet.DIRECT)
        pybullet.resetSimulation(physicsClientId=self._client)
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=1.0 / physics_hz,
            deterministicOverlappingPairs=1,
            physicsClientId=self._client,
        )
        self._scene = add_scene(scene, self._client, physics_hz)
        self.channels = (*self.channels, *self._scene.doors.channels)
        self._robot = self._create(start)
        self._reach = base.circumradius
        self._forces = [base.drive_force, base.drive_force, base.drive_torque]
        self._wheels: WheelSpeeds = (0.0, 0.0, 0.0, 0.0)
        self._twist = PlanarTwist(0.0, 0.0, 0.0)
        self._touched: set[int] = set()
        self._travelled = 0.0
        self._pose = start
        self._refuse_overlap(start)
        self._state = PlanarState(start, self._twist)

    def _create(self, start: PlanarPose) -> int:
        base, client = self._base, self._client
        chassis = pybullet.createCollisionShape(
            pybullet.GEOM_BOX,
            halfExtents=[
                base.half_length,
                base.half_width - WHEEL_PROUD,
                CHASSIS_HALF_HEIGHT,
            ],
            physicsClientId=client,
        )
        wheel = pybullet.createCollisionShape(
            pybullet.GEOM_CYLINDER,
            radius=base.wheel_radius,
            height=WHEEL_WIDTH,
            physicsClientId=client,
        )
        axle = pybullet.getQuaternionFromEuler([0.5 * pi, 0.0, 0.0])
        wheels = [[x, y, base.wheel_radius - CHASSIS_HEIGHT] for x, y in base.axles]
        slide, turn, fixed = (
            pybullet.JOINT_PRISMATIC,
            pybullet.JOINT_REVOLUTE,
            pybullet.JOINT_FIXED,
        )
        links = 3 + len(wheels)
        robot = pybullet.createMultiBody(
            baseMass=0.0,
            basePosition=[0.0, 0.0, 0.0],
            linkMasses=[CARRIAGE_MASS, CARRIAGE_MASS, base.mass] + [WHEEL_MASS] * len(wheels),
            linkCollisionShapeIndices=[-1, -1, chassis] + [wheel] * len(wheels),
            linkVisualShapeIndices=[-1] * links,
            linkPositions=[[0.0] * 3, [0.0] * 3, [0.0, 0.0, CHASSIS_HEIGHT], *wheels],
            linkOrientations=[UPRIGHT] * 3 + [axle] * len(wheels),
            linkInertialFramePositions=[[0.0] * 3] * links,
            linkInertialFrameOrientations=[UPRIGHT] * links,
            linkParentIndices=[0, 1, 2] + [3] * len(wheels),
            linkJointTypes=[slide, slide, turn] + [fixed] * len(wheels),
            linkJointAxis=[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] + [[0.0, 0.0, 1.0]] * (links - 2),
            physicsClientId=client,
        )
        for link in range(links):
            pybullet.changeDynamics(
                robot,
                link,
                linearDamping=0.0,
                angularDamping=0.0,
                jointDamping=0.0,
                lateralFriction=0.0,
                physicsClientId=client,
            )
            pybullet.setCollisionFilterGroupMask(
                robot, link, ROBOT, STATIC | DOOR, physicsClientId=client
            )
        for joint, value in zip(JOINTS, start, strict=True):
            pybullet.resetJointState(robot, joint, value, 0.0, physicsClientId=client)
        return int(robot)

    def _refuse_overlap(self, start: PlanarPose) -> None:
        inside = tuple(
            sorted({name for uid, name in self._scene.walls.items() if self._gap(uid) <= 0.0})
        )
        if inside:
            self.close()
            raise StartsInWall(self._base.kind, start.x, start.y, inside)

    def _gap(self, uid: int) -> float:
        """Distance in m to a body, or the release gap when it is further off."""
        limit = self._base.release_gap
        points = pybullet.getClosestPoints(self._robot, uid, limit, physicsClientId=self._client)
        return min((point[8] for point in points), default=limit)

    @property
    def chassis(self) -> Chassis:
        """What carries sensors."""
        return Chassis(self._client, self._robot, CHASSIS, CHASSIS_HEIGHT)

    @property
    def state(self) -> PlanarState:
        """Pose, twist and contacts after the last step."""
        return self._state

    @property
    def travelled(self) -> float:
        """Way gone so far, m."""
        return self._travelled

    def values(self) -> tuple[float, ...]:
        """Give pose, twist, wheel speeds and angles of doors, as `channels` names them."""
        return (*self._pose, *self._state.twist, *self._wheels, *self._scene.doors.angles())

    def drive(self, wheels: WheelSpeeds) -> None:
        """Let the wheels turn at these speeds through the coming step."""
        self._wheels = wheels
        vx, vy, omega = self._base.twist(wheels)
        c, s = cos(self._pose.theta), sin(self._pose.theta)
        pybullet.setJointMotorControlArray(
            self._robot,
            JOINTS,
            pybullet.VELOCITY_CONTROL,
            targetVelocities=(c * vx - s * vy, s * vx + c * vy, omega),
            forces=self._forces,
            physicsClientId=self._client,
        )

    def step(self) -> None:
        """Let PyBullet step once and look at the joints and contacts."""
        client = self._client
        self._scene.moving.step(self._robot)
        pybullet.stepSimulation(physicsClientId=client)
        (x, wx, _, _), (y, wy, _, _), (theta, omega, _, _) = pybullet.getJointStates(
            self._robot, JOINTS, physicsClientId=client
        )
        last = self._pose
        self._travelled += hypot(x - last.x, y - last.y)
        self._pose = pose = PlanarPose(x, y, theta)
        c, s = cos(theta), sin(theta)
        twist = PlanarTwist(c * wx + s * wy, c * wy - s * wx, omega)
        self._state = PlanarState(pose, twist, self._contacts())

    def _contacts(self) -> Contacts:
        points = pybullet.getContactPoints(self._robot, physicsClientId=self._client)
        others = self._markers_touched()
        if not points and not self._touched:
            return NO_CONTACT if not others else Contacts(others=others)
        walls: dict[str, None] = {}
        base = wheels = False
        deepest, bearing = self._base.contact_tolerance, nan
        names, solids = self._scene.walls, self._scene.others
        for point in points:
            if point[8] > self._base.contact_tolerance:
                continue
            uid = point[2]
            if uid in names:
                walls[names[uid]] = None
                self._touched.add(uid)
                base = base or point[3] == CHASSIS
                wheels = wheels or point[3] > CHASSIS
                if point[8] <= deepest:
                    deepest = point[8]
                    away_x, away_y, _ = point[7]
                    bearing = wrapped(atan2(-away_y, -away_x) - self._pose.theta)
            elif uid in solids and solids[uid] not in others:
                others = (*others, solids[uid])
        if not walls and self._touched:
            limit = self._base.release_gap
            self._touched = {uid for uid in self._touched if self._gap(uid) < limit}
        return Contacts(tuple(walls), others, not self._touched, base, wheels, bearing)

    def _markers_touched(self) -> tuple[str, ...]:
        x, y, _ = self._pose
        touched: tuple[str, ...] = ()
        for marker in self._scene.markers:
            if hypot(marker.x - x, marker.y - y) < self._reach + marker.radius and (
                pybullet.getClosestPoints(
                    self._robot, marker.uid, 0.0, physicsClientId=self._client
                )
            ):
                touched = (*touched, marker.name)
        return touched

    def close(self) -> None:
        """Disconnect the PyBullet client."""
        pybullet.disconnect(physicsClientId=self._client)
