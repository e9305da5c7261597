"""A film holds what was recorded, and nothing of who drove."""

from __future__ import annotations

from base64 import b64decode
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import omnistudy
from omnistudy.errors.store import NoSuchTrial
from omnistudy.errors.view import NothingToShow
from omnistudy.view.film import Film, film


@pytest.fixture(scope="module")
def first(driven_study: Path) -> Film:
    with omnistudy.open(driven_study) as study:
        return film(study, 1)


def values(film: Film, name: str) -> NDArray[np.float32]:
    found = next(one for one in film.series if one.name == name)
    return np.frombuffer(b64decode(found.data), dtype="<f4")


def test_series_are_the_samples(first: Film, driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        samples = study.samples(1)
        wheels = study.stream(1, "plant")
    for name in ("t", "x", "y", "theta", "fx", "fy", "tau"):
        np.testing.assert_allclose(values(first, name), samples[name], atol=1e-4)
    np.testing.assert_allclose(
        values(first, "wheel_front_left"), wheels["wheel_front_left"], atol=1e-4
    )
    assert first.end == samples["t"].iloc[-1]


def test_input_of_every_step_stays_in_the_database(first: Film) -> None:
    assert {len(values(first, one.name)) for one in first.series} == {len(values(first, "t"))}


def test_clearance_is_nothing_while_colliding(first: Film) -> None:
    gap, t = values(first, "clearance"), values(first, "t")
    assert gap.min() >= 0.0
    hits = [event.t for event in first.events if event.kind == "collision"]
    assert hits, "the virtual driver without feedback touches walls"
    for hit in hits:
        assert gap[np.abs(t - hit).argmin()] < 0.02


def test_every_link_hangs_on_one_before_it_and_moves_by_a_recorded_channel(first: Film) -> None:
    known, names = {""}, {one.name for one in first.series}
    for link in first.links:
        assert link.parent in known
        known.add(link.name)
        assert link.joint is None or link.joint.channel in names


def test_a_film_says_nothing_of_seeds(first: Film, driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        secrets = [*study.trials()["seed"], *study.participants()["seed"]]
    text = first.model_dump_json()
    assert not [secret for secret in secrets if secret in text]


def test_trials_without_samples_and_unknown_ones_are_refused(driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        with pytest.raises(NothingToShow, match="trial 3 of study 'seen' is planned"):
            film(study, 3)
        with pytest.raises(NoSuchTrial, match="no trial 99"):
            film(study, 99)
