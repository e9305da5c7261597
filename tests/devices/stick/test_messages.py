"""The generated files follow their description."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

from omnistudy.devices.stick import messages

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def generator() -> ModuleType:
    path = ROOT / "firmware" / "make_protocol.py"
    spec = importlib.util.spec_from_file_location("make_protocol", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_generated_files_are_fresh(generator: ModuleType) -> None:
    stale = [
        str(path.relative_to(ROOT))
        for path, text in generator.generated().items()
        if path.read_text(encoding="utf-8") != text
    ]
    assert stale == [], "run `make -C firmware protocol`"


def test_default_configuration_is_the_thesis_firmware_in_wire_steps() -> None:
    default = messages.DEFAULT_CONFIGURATION
    # 0.7 PWM/degree of the motor is 0.175 PWM a count (1440 counts a turn), times 1024.
    assert default.centring_stiffness[:2] == (179, 179)
    # 42 PWM·ms/degree is 10.5 PWM·ms a count, times 32.
    assert default.centring_damping[:2] == (336, 336)
    assert [value / 256 for value in default.counts_per_degree] == [12.0, 15.0, 4.0]


def test_telemetry_of_every_tick_fits_the_line() -> None:
    frame = messages.LAYOUTS[messages.Telemetry].size + 4 + 2
    assert frame * messages.TICK_HZ * 10 <= messages.BAUD
