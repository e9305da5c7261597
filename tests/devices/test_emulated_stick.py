"""The stick with its real firmware behaves as the simulated one, in a hand and in a whole trial."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from core_world import trial

from omnistudy.devices import Hand, RunningDevice
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.conversion import configuration, handle_scale
from omnistudy.devices.stick.layouts import DEFAULT_CONFIGURATION
from omnistudy.errors.devices import CannotBePrescribed
from omnistudy.geometry import ForceField, PlanarWrench
from omnistudy.laws.component import ComponentLaw
from omnistudy.trial import resimulate, run_trial

PHYSICS_HZ = 240
GRIP = Hand((0.01, -0.008, 0.3), (400.0, 400.0, 20.0), (20.0, 20.0, 0.5), (0.8, 0.8, 0.003))
SPRING = ((300.0, 50.0, 0.0), (50.0, 200.0, 0.0), (0.0, 0.0, 2.0))


def driven(device: RunningDevice, steps: int = 240) -> np.ndarray:
    """Grip the stick and push it off its centre under a field that comes 48 times a second."""
    positions = []
    for step in range(steps):
        if step % 5 == 0:
            push = 3.0 if step >= 120 else 0.0
            device.render(ForceField(PlanarWrench(-push, push, 0.2), (0.0, 0.0, 0.0), SPRING))
        positions.append(device.advance(GRIP).position)
    return np.array(positions)


def test_default_settings_are_the_simulated_stick_s() -> None:
    # But for y's gravity lever, which the simulated stick has as x's, theta's margin and its trip.
    wanted = DEFAULT_CONFIGURATION._replace(
        counts_per_degree=(3072, 3072, 1024),
        travel=(360, 360, 1728),
        velocity_trip=(2560, 2560, 3840),
    )
    assert configuration(SimulatedStick()) == wanted


def test_a_field_in_device_units() -> None:
    field = ForceField(PlanarWrench(13.5, -13.5, 4.4), (0.0, 0.0, 0.0), SPRING, valid_for=0.1)
    sent = handle_scale(SimulatedStick()).wire(field)
    assert [value / 32 for value in sent.wrench] == [255, -255, 255]
    # 300 N/m of 13.5 N in 255 steps and 0.095 m·pi/180/12 a count.
    assert sent.stiffness[0] / 1024 == pytest.approx(
        300 * 255 / 13.5 * 0.095 * np.pi / 2160, abs=1e-3
    )
    assert sent.valid_for == 100


def test_nothing_is_powered_up_to_be_described() -> None:
    running = EmulatedStickDevice().connect(PHYSICS_HZ)
    assert [axis.name for axis in running.axes] == ["stick_x", "stick_y", "stick_theta"]
    assert len(running.values()) == len(running.channels)


@pytest.mark.usefixtures("toolchain")
def test_firmware_and_simulation_move_alike() -> None:
    emulated = driven(EmulatedStickDevice().connect(PHYSICS_HZ))
    simulated = driven(SimulatedStick().connect(PHYSICS_HZ))
    apart = np.abs(emulated - simulated)
    assert (apart.max(axis=0) < 0.08 * np.abs(simulated).max(axis=0)).all()
    # At rest they differ by a count at most.
    assert (apart[-1] < 1.01 * np.array(handle_scale(SimulatedStick()).per_count)).all()


@pytest.mark.usefixtures("toolchain")
def test_a_prescribed_hand_is_refused() -> None:
    running = EmulatedStickDevice().connect(PHYSICS_HZ)
    with pytest.raises(CannotBePrescribed, match="prescribes"):
        running.advance(Hand((0.0,) * 3, (inf,) * 3, (0.0,) * 3, (0.0,) * 3))


@pytest.mark.usefixtures("toolchain")
def test_a_stick_that_goes_soft_says_so_and_drives_nowhere() -> None:
    running = EmulatedStickDevice().connect(PHYSICS_HZ)

    for _ in range(PHYSICS_HZ // 2):
        state = running.advance(GRIP)
    assert "SILENT" in running.trouble()
    assert state.position == (0.0, 0.0, 0.0)  # drives nowhere


@pytest.mark.slow
@pytest.mark.usefixtures("toolchain")
def test_a_whole_trial_runs_through_the_firmware_and_repeats_to_the_byte() -> None:
    spec = trial(law=ComponentLaw(), device=EmulatedStickDevice())
    emulated = run_trial(spec)
    simulated = run_trial(trial(law=ComponentLaw()))
    assert emulated.status == simulated.status == "completed"
    assert emulated.duration_s == pytest.approx(simulated.duration_s, rel=0.1)
    assert run_trial(spec).samples.tobytes() == emulated.samples.tobytes()
    steps = next(stream for stream in emulated.streams if stream.name == "input").data
    assert resimulate(spec, steps).samples.tobytes() == emulated.samples.tobytes()
