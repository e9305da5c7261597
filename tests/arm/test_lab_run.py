"""The recorded run of the lab's program, reproduced to the printed digit.

Numbers: 775 steps recorded with CARRTUSF/Master_Program; after each step the hand in mm, the arm's
base in mm, the heading and the joints in degrees, the weighted measure in mm^3, and k.
"""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.arm import ArmBody, Configuration, load_arm
from omnistudy.arm.find import load_task
from omnistudy.arm.run import ArmRun, summaries
from omnistudy.session.solve_arm import solve_task

RECORDED = {
    100: (
        (788.522, -76.814, 909.834),
        (24.133, -33.896),
        -4.2941,
        (101.615, 84.108, 16.075, 71.702, 97.661, 74.172, 30.748),
        1.5062e8,
        0.0,
    ),
    600: (
        (2061.526, 263.738, 977.947),
        (1339.012, -208.499),
        2.8116,
        (103.545, 64.350, 0.475, 0.399, 81.081, 79.006, 187.453),
        3.3956e7,
        2e-5,
    ),
}


@pytest.fixture(scope="module")
def run() -> ArmRun:
    return solve_task(load_task("lab_run"))


@pytest.mark.parametrize("row", sorted(RECORDED))
def test_every_row_given(run: ArmRun, row: int) -> None:
    hand, base, heading, joints, measure, k = RECORDED[row]
    step = run.steps[row]
    assert step.step == row
    assert 1000.0 * np.array(step.hand) == pytest.approx(hand, abs=0.01)
    assert 1000.0 * np.array(step.chair[:2]) == pytest.approx(base, abs=0.01)
    assert np.degrees(step.chair.theta) == pytest.approx(heading, abs=0.001)
    assert np.degrees(step.joints) == pytest.approx(joints, abs=0.001)
    assert 1e9 * step.manipulability == pytest.approx(measure, rel=1e-4)
    assert step.damping == pytest.approx(k, abs=5e-6)


def test_its_length_and_its_worst_error(run: ArmRun) -> None:
    assert len(run.steps) == 776
    assert run.steps[1].t == pytest.approx(0.0499949, abs=1e-6)
    (summary,) = summaries(run)
    assert 1000.0 * summary.worst_error == pytest.approx(0.057, abs=0.001)
    assert summary.held_back == 0
    assert summary.damped == sum(step.manipulability < 0.034 for step in run.steps)


def test_the_smallest_singular_value_counts_a_radian_as_half_a_metre(run: ArmRun) -> None:
    step = run.steps[300]
    body = ArmBody(load_arm(run.arm))
    rows = Configuration(body, np.array(step.joints), step.chair).arm_jacobian
    metres = rows * np.array([1.0, 1.0, 1.0, 0.5, 0.5, 0.5])[:, None]
    least = np.linalg.eigvalsh(metres @ metres.T)[0]
    assert step.smallest == pytest.approx(np.sqrt(least))


def test_the_arm_ends_stretched_and_its_damping_never_sees_it(run: ArmRun) -> None:
    first, last = run.steps[0], run.steps[-1]
    assert max(abs(np.degrees(last.joints[2:4]))) < 1.0
    assert 1e9 * first.arm_manipulability == pytest.approx(1.2e8, rel=0.01)
    assert first.arm_manipulability / last.arm_manipulability > 150.0
    assert last.manipulability / first.manipulability > 0.2
    assert last.damping < 0.02
