"""How long one control step of an arm takes, kinematics and both Jacobians included."""

from __future__ import annotations

import json
import statistics
import time
from typing import Any

import numpy as np

from omnistudy.arm import ArmBody, ArmState, Configuration, load_arm
from omnistudy.devices import DeviceState
from omnistudy.geometry import PlanarPose
from omnistudy.registry import load_kind

STEPS = 3000
DT = 0.05
KINDS = ("sri_wln", "pi_wln", "sri_ene", "pi_ene")
ASKED = DeviceState((0.02, 0.0, 0.01, 0.0, 0.01, 0.0), (0.0,) * 6)


def step_microseconds(kind: str, **parameters: Any) -> float:
    """Give the median us of one step near the ready posture, every step from a new state."""
    controller = load_kind("controllers", kind)(**parameters)
    body = ArmBody(load_arm("wmra1"))
    joints = np.array(body.profile.ready) - 0.05
    memory = controller.initial_state()
    took = []
    for _ in range(STEPS):
        began = time.perf_counter()
        at = Configuration(body, joints, PlanarPose(0.0, 0.0, 0.0))
        control = controller.control(ASKED, ArmState(at), None, memory, DT)
        took.append(time.perf_counter() - began)
        memory = control.state
    return 1e6 * statistics.median(took)


def main() -> None:
    """Print the medians as JSON, with the zones looked at and without."""
    measured = {
        kind: {
            "us": round(step_microseconds(kind), 1),
            "us_without_zones": round(step_microseconds(kind, zones="none"), 1),
        }
        for kind in KINDS
    }
    print(json.dumps({"arm_step": measured, "wanted_us": 150.0}, indent=2))


if __name__ == "__main__":
    main()
