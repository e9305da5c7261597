"""Bodies on scripted paths in PyBullet: nothing stops them, nothing pushes them."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.plants.bullet import pybullet
from omnistudy.scene import Track

CAUGHT = 0.002
"""Overlap in m, with a moving body or with the wall behind, from which a robot that a body touches
counts as caught: one that can give way overlaps by hundredths of a millimetre."""

STANDING = (0.0, 0.0, 0.0)


class MovingBody(NamedTuple):
    """A PyBullet body, its path, and what stays: height in m and orientation as a quaternion."""

    uid: int
    track: Track
    z: float
    orientation: tuple[float, float, float, float]


class MovingBodies:
    """All moving bodies of one scene; each step takes them one step of physics further.

    A body is put where its path says at every step, so that it never drifts, and given the
    velocity that takes it to its next place, so that contacts know it: put there alone, it would
    sink about 14 mm into a robot at 0.3 m/s before the solver drives them apart.

    Its path does not wait for a robot that is caught against a wall, and a solver that cannot
    win throws the robot metres away; so a body passes through a robot that it has caught, until
    they are apart again.
    """

    def __init__(self, bodies: tuple[MovingBody, ...], client: int, physics_hz: int) -> None:
        self._bodies = bodies
        self._client = client
        self._physics_hz = physics_hz
        self._steps = 0
        self._passing: set[int] = set()
        for body in bodies:
            self._place(body, 0.0)

    def step(self, robot: int) -> None:
        """Make ready for the next physics step, before it is taken."""
        if not self._bodies:
            return
        hz, client = self._physics_hz, self._client
        now, then = self._steps / hz, (self._steps + 1) / hz
        for body in self._bodies:
            x, y = self._place(body, now)
            ahead = body.track.at(then)
            velocity = ((ahead.x - x) * hz, (ahead.y - y) * hz, 0.0)
            pybullet.resetBaseVelocity(body.uid, velocity, STANDING, physicsClientId=client)
        self._release(robot)
        self._steps += 1

    def _place(self, body: MovingBody, t: float) -> tuple[float, float]:
        x, y, _, _ = body.track.at(t)
        pybullet.resetBasePositionAndOrientation(
            body.uid, (x, y, body.z), body.orientation, physicsClientId=self._client
        )
        return x, y

    def _release(self, robot: int) -> None:
        """Let bodies pass through a robot that they have caught, and collide again once apart."""
        contacts = pybullet.getContactPoints(robot, physicsClientId=self._client)
        caught = any(-contact[8] > CAUGHT for contact in contacts)
        touching = {contact[2] for contact in contacts}
        for uid in [body.uid for body in self._bodies]:
            if uid in self._passing:
                if not pybullet.getClosestPoints(robot, uid, 0.0, physicsClientId=self._client):
                    self._passing.remove(uid)
                    self._collide(uid, robot, True)
            elif caught and uid in touching:
                self._passing.add(uid)
                self._collide(uid, robot, False)

    def _collide(self, uid: int, robot: int, collide: bool) -> None:
        links = pybullet.getNumJoints(robot, physicsClientId=self._client)
        for link in range(-1, links):
            pybullet.setCollisionFilterPair(
                robot, uid, link, -1, int(collide), physicsClientId=self._client
            )
