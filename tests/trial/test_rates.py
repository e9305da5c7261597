"""Which rates fit together."""

import pytest
from pydantic import ValidationError

from omnistudy.channel import Recording


def test_samples_are_taken_every_whole_number_of_steps() -> None:
    with pytest.raises(ValidationError, match="sample_hz 50 must divide physics_hz 240"):
        Recording(sample_hz=50)
    assert Recording(sample_hz=60).sample_hz == 60


def test_a_scan_is_never_more_frequent_than_a_step() -> None:
    with pytest.raises(ValidationError, match="scan_hz 120 is above physics_hz 100"):
        Recording(physics_hz=100, scan_hz=120)
    assert Recording(physics_hz=100, scan_hz=40).scan_hz == 40
