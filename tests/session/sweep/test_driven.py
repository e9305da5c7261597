from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from core_world import corner_world, trial

from omnistudy.channel import SAMPLE_COLUMNS
from omnistudy.laws.component import ComponentLaw
from omnistudy.session.sweep.driven import feedback_work
from omnistudy.trial import TrialResult, TrialSpec, run_trial


@pytest.fixture(scope="module")
def felt() -> tuple[TrialSpec, TrialResult]:
    spec = trial(corner_world(), law=ComponentLaw())
    return spec, run_trial(spec)


def test_without_feedback_the_hand_does_next_to_no_work_against_it() -> None:
    """What is left is the step between the motor's tick and the recorded position."""
    spec = trial(corner_world())
    assert feedback_work(spec, run_trial(spec)) < 0.05


def test_with_feedback_the_hand_works_against_what_the_motors_gave(
    felt: tuple[TrialSpec, TrialResult],
) -> None:
    spec, result = felt
    assert 1.0 < feedback_work(spec, result) < 100.0


def test_a_constant_push_over_a_known_way(felt: tuple[TrialSpec, TrialResult]) -> None:
    """2 N back on a stick that goes 0.1 m forward in 1 s, beside what centring itself does."""
    spec, result = felt
    moved, device = result.streams[0], next(s for s in result.streams if s.name == "device")
    t = np.arange(21) / 20
    samples = np.zeros((21, len(SAMPLE_COLUMNS)))
    samples[:, SAMPLE_COLUMNS.index("t")] = t
    samples[:, SAMPLE_COLUMNS.index("stick_x")] = 0.1 * t
    steps = np.zeros((240, 6))
    steps[:, 0] = 0.1 * np.arange(1, 241) / 240
    steps[:, 3] = 0.1
    rates = np.zeros((21, 3))
    rates[1:, 0] = 0.1
    stick = samples[:, [SAMPLE_COLUMNS.index(name) for name in ("stick_x", "stick_y")]]
    own = spec.device.own_force(np.column_stack((stick, np.zeros(21))), rates)
    motors = own + np.array([-2.0, 0.0, 0.0])
    made = replace(
        result,
        samples=samples,
        streams=(moved._replace(data=steps), device._replace(data=motors)),
    )
    assert feedback_work(spec, made) == pytest.approx(0.2)


def test_a_device_without_motors_has_no_such_work(felt: tuple[TrialSpec, TrialResult]) -> None:
    spec, result = felt
    assert np.isnan(feedback_work(spec, replace(result, streams=result.streams[:1])))
