"""How long one control step of an arm takes, kinematics included: each kind, and Pink beside it."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm import ArmBody, ArmState, Configuration, load_arm
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.urdf import HAND_LINK, urdf
from omnistudy.devices import DeviceState
from omnistudy.geometry import PlanarPose
from omnistudy.registry import load_kind
from omnistudy.seeds import generator

Floats = NDArray[np.float64]
Step = Callable[[Floats], object]

STEPS, ROUNDS = 500, 6
DT = 0.05
SPREAD = 0.15
"""rad round the ready posture, so that zones are near at some steps and not at others."""

CLASSIC = ("sri_wln", "pi_wln", "sri_ene", "pi_ene")
WANTED = {**dict.fromkeys(CLASSIC, 150.0), "dual_qp": 300.0}
PINK = "pink"
TWIST = np.array((0.05, 0.02, 0.01, 0.01, 0.0, 0.05))
HERE = PlanarPose(0.0, 0.0, 0.3)


def step_microseconds() -> dict[str, float]:
    """Give the median us of a step by kind, all in turns over the same postures.

    Pink is left out when it is not installed.
    """
    body = ArmBody(load_arm("wmra1"))
    steps: dict[str, Step] = {kind: _ours(kind, body) for kind in WANTED}
    pink = _pink(body)
    if pink is not None:
        steps[PINK] = pink
    draw = generator("arm step", "postures")
    ready = np.array(body.profile.ready)
    took: dict[str, list[float]] = {kind: [] for kind in steps}
    for _ in range(ROUNDS):
        postures = ready + draw.uniform(-SPREAD, SPREAD, (STEPS, body.count))
        for kind, step in steps.items():
            took[kind].extend(_timed(step, joints) for joints in postures)
    return {kind: 1e6 * statistics.median(times) for kind, times in took.items()}


def _timed(step: Step, joints: Floats) -> float:
    began = time.perf_counter()
    step(joints)
    return time.perf_counter() - began


def _ours(kind: str, body: ArmBody) -> Step:
    controller = load_kind("controllers", kind)()
    guidance = Guidance(TWIST, 0.3, PlanarPose(1.0, 0.5, 0.0))
    if kind == "dual_qp":
        nothing, still = np.zeros(6), np.zeros(body.count)
        guidance = guidance._replace(chair_rates=(0.05, 0.01), correction=nothing, posture=still)
    device = DeviceState(guidance.numbers, (0.0,) * len(guidance.numbers))
    memory = controller.initial_state()

    def step(joints: Floats) -> None:
        at = ArmState(Configuration(body, joints, HERE))
        controller.control(device, at, None, memory, DT)

    return step


def _pink(body: ArmBody) -> Step | None:
    """Give a step of Pink on our URDF: hand and posture, limits, the same solver.

    Its chair slides sideways too, and it knows no zones: it has less to do.
    """
    try:
        import pinocchio
        from pink import Configuration as PinkConfiguration
        from pink import solve_ik
        from pink.tasks import FrameTask, PostureTask
    except ImportError:
        return None
    # Pinocchio finds frames by name alone, and ours has a joint and a link of one name
    text = urdf(body.profile).replace(f'<joint name="{HAND_LINK}"', '<joint name="hand_mount"')
    model = pinocchio.buildModelFromXML(text)
    data = model.createData()
    hand = FrameTask(HAND_LINK, position_cost=1.0, orientation_cost=0.5)
    posture = PostureTask(cost=1e-3)
    start = _pink_joints(np.array(body.profile.ready))
    ahead = PinkConfiguration(model, data, start)
    target = ahead.get_transform_frame_to_world(HAND_LINK).copy()
    target.translation += TWIST[:3]
    hand.set_target(target)
    posture.set_target(start)
    solve = partial(solve_ik, tasks=(hand, posture), dt=DT, solver="daqp")

    def step(joints: Floats) -> None:
        at = PinkConfiguration(model, data, _pink_joints(joints), copy_data=False)
        solve(at)

    return step


def _pink_joints(joints: Floats) -> Floats:
    """Give Pinocchio's vector: the chair's x, y, cosine and sine of its heading, the joints."""
    return np.concatenate(((HERE.x, HERE.y, np.cos(HERE.theta), np.sin(HERE.theta)), joints))
