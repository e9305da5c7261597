"""Finding a virtual driver's skill from no-feedback trials alone.

Collisions are counted as the thesis's code does (`collisions_legacy`), for they are held against
its figures.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.session import NoFreeCondition, NotVirtualDriver
from omnistudy.operators import Person
from omnistudy.operators.virtual_driver import VirtualDriver
from omnistudy.protocol import Protocol
from omnistudy.seeds import seed_text
from omnistudy.session.population import Population, ResponsePoint, Targets
from omnistudy.session.specs import coupled
from omnistudy.session.workers import run_all
from omnistudy.trial import TrialSpec

POSITIONS = (1, 2, 3, 4, 5, 6)
"""Places of the no-feedback trials in the published order: half the people meet them first."""


@dataclass(frozen=True, slots=True)
class Calibration:
    """What was found, and the response on which it rests.

    skill_median, skill_spread : of VirtualDriver. expected_mean, expected_log_range : by the
    response curve. checked_mean : collisions of `checked_trials` fresh trials at the result.
    """

    skill_median: float
    skill_spread: float
    targets: Targets
    expected_mean: float
    expected_log_range: float
    checked_mean: float
    checked_trials: int
    response: tuple[ResponsePoint, ...]
    learning: float


def trials_needed(skills: Sequence[float], each: int, check: int) -> int:
    """Count the trials that a calibration will run, for the progress shown."""
    return len(skills) * each + check


def calibrate(
    protocol: Protocol,
    targets: Targets,
    *,
    skills: Sequence[float],
    each: int,
    check: int,
    seed: str,
    workers: int,
    driven: Callable[[], None] = lambda: None,
) -> Calibration:
    """Find median and spread of skill at which no-feedback trials meet the targets.

    First the response is measured: collisions at each of `skills`, `each` trials over the routes;
    then the population is found on that curve; then `check` fresh trials are driven with it.
    No trial with feedback is run. Raises NoFreeCondition, NotVirtualDriver, CannotCalibrate.
    """
    driver = protocol.operator
    if not isinstance(driver, VirtualDriver):
        raise NotVirtualDriver(protocol.name, driver.kind)
    condition = _free_condition(protocol)
    specs = [
        _spec(protocol, condition, _fixed(driver, skill), seed_text(seed, "response", i), i, 1)
        for skill in skills
        for i in range(each)
    ]
    counts = _collisions(specs, workers, driven).reshape(len(skills), each)
    response = tuple(
        ResponsePoint(skill, float(row.mean()), each)
        for skill, row in zip(skills, counts, strict=True)
    )
    population = Population(response, driver.learning, seed)
    median, spread = population.meeting(targets)
    found = driver.model_copy(update={"skill_median": median, "skill_spread": spread})
    people = [
        _spec(protocol, condition, found, seed_text(seed, "check", i), i, POSITIONS[i % 6])
        for i in range(check)
    ]
    checked = _collisions(people, workers, driven)
    return Calibration(
        skill_median=median,
        skill_spread=spread,
        targets=targets,
        expected_mean=population.mean(median, spread),
        expected_log_range=population.log_range(median, spread),
        checked_mean=float(checked.mean()),
        checked_trials=check,
        response=response,
        learning=driver.learning,
    )


def _free_condition(protocol: Protocol) -> str:
    for condition in protocol.conditions:
        if protocol.setup_for(condition.name).law.kind == "none":
            return condition.name
    raise NoFreeCondition(protocol.name)


def _fixed(driver: VirtualDriver, skill: float) -> VirtualDriver:
    """Give a driver without spread, whose first trial has exactly this skill."""
    return driver.model_copy(update={"skill_median": skill, "skill_spread": 0.0})


def _spec(
    protocol: Protocol, condition: str, driver: VirtualDriver, seed: str, index: int, position: int
) -> TrialSpec:
    route = protocol.routes[index % len(protocol.routes)]
    person = Person(seed_text(seed, "person"), seed_text(seed, "trial"), position)
    return coupled(protocol, condition, route, person, driver)


def _collisions(
    specs: Sequence[TrialSpec], workers: int, driven: Callable[[], None]
) -> NDArray[np.float64]:
    counts = []
    for result in run_all(specs, workers):
        counts.append(float(result.collisions_legacy))
        driven()
    return np.array(counts)
