"""What PyBullet alone allows: the calls that no trial can do without, and nothing else."""

from __future__ import annotations

import time
from math import cos, pi, sin

from omnistudy.plants.bullet import pybullet
from omnistudy.trial import TrialSpec

SIMULATED_SECONDS = 20
JOINTS = (0, 1, 2)
CHASSIS = 2


def simulated_seconds_per_second(spec: TrialSpec) -> float:
    """Give how many simulated seconds pass in one, in the scene of a trial.

    Each physics step commands the motors, steps, and reads joints and contacts; each scan casts
    the lidar's rays. The robot swings to and fro where it starts.
    """
    physics_hz, scan_hz = spec.recording.physics_hz, spec.recording.scan_hz
    plant = spec.plant.build(
        spec.world.scene, spec.world.start.pose, physics_hz, spec.person.trial_seed
    )
    robot = pybullet.getBodyUniqueId(pybullet.getNumBodies() - 1)
    rays_from, rays_to = _rays(spec)
    scans = -1
    began = time.perf_counter()
    for step in range(SIMULATED_SECONDS * physics_hz):
        if step * scan_hz // physics_hz != scans:
            scans = step * scan_hz // physics_hz
            pybullet.rayTestBatch(
                rays_from, rays_to, parentObjectUniqueId=robot, parentLinkIndex=CHASSIS
            )
        swing = 0.05 if step // physics_hz % 2 else -0.05
        pybullet.setJointMotorControlArray(
            robot,
            JOINTS,
            pybullet.VELOCITY_CONTROL,
            targetVelocities=(swing, 0.0, 0.0),
            forces=(200.0, 200.0, 50.0),
        )
        pybullet.stepSimulation()
        pybullet.getJointStates(robot, JOINTS)
        pybullet.getContactPoints(robot)
    took = time.perf_counter() - began
    plant.close()
    return SIMULATED_SECONDS / took


def _rays(spec: TrialSpec) -> tuple[list[list[float]], list[list[float]]]:
    angles = [2.0 * pi * ray / 128 for ray in range(128)]
    return [[0.0, 0.0, 0.2]] * 128, [[0.6 * cos(a), 0.6 * sin(a), 0.2] for a in angles]
