"""A whole force calibration of the emulated stick on load cells, whose truth is known."""

from __future__ import annotations

from collections.abc import Callable
from datetime import date
from functools import partial

import pytest
from stick_bench import Bench

from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.record import record_of
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick import force_steps
from omnistudy.devices.stick.conversion import handle_scale
from omnistudy.devices.stick.emulator import mechanisms
from omnistudy.devices.stick.force_calibration import ForceCalibration
from omnistudy.devices.stick.force_fit import Reading, fit
from omnistudy.devices.stick.force_steps import AXES, Instrument, Plan, measure
from omnistudy.errors.devices import Refused
from omnistudy.errors.force_calibration import ForceWithdrawn, HandleMoved, NothingRead
from omnistudy.geometry import ForceField, PlanarWrench
from omnistudy.seeds import generator

PLAN = Plan(greatest=160, levels=2)
NOMINAL = handle_scale(SimulatedStick()).per_duty
FOUND = (0.8 * NOMINAL[0], 1.1 * NOMINAL[1], 0.29 * NOMINAL[2])
"""N and N·m a PWM step of the stick on the bench: not what the thesis says."""
DEAD_BAND = (12.0, 0.0, 20.0)
NOISE = (0.05, 0.05, 0.01)
"""Standard deviation of a reading, N, N, N·m."""


@pytest.fixture
def clamped(toolchain: None) -> Bench:
    made = tuple(
        mechanism.__class__(**{**vars(mechanism), "per_duty": per_duty, "dead_band": band})
        for mechanism, per_duty, band in zip(
            mechanisms(SimulatedStick()), FOUND, DEAD_BAND, strict=True
        )
    )
    bench = Bench(made)
    for axis in range(3):
        bench.board.clamp(axis)
    bench.board.release()
    return bench


def cells(bench: Bench) -> list[Instrument]:
    """Give a load cell for each axis, noisy and with a zero that is off by 0.1."""
    random = generator("load cells", "noise")

    def read(axis: int) -> float:
        return 0.1 + bench.board.cell_force(axis) + float(random.normal(0.0, NOISE[axis]))

    return [partial(read, axis) for axis in range(3)]


def nothing(axis: int, duty: int) -> None:
    """Tell nobody."""


@pytest.mark.slow
def test_what_the_stick_is_comes_out_within_its_uncertainty(clamped: Bench) -> None:
    read = measure(clamped.line, cells(clamped), PLAN, nothing)
    for axis, name in enumerate(AXES):
        found = fit(name, [one for one in read if one.axis == axis])
        assert abs(found.per_duty - FOUND[axis]) < found.per_duty_95
        assert found.per_duty_95 < 0.05 * FOUND[axis]
        assert found.dead_band == pytest.approx(DEAD_BAND[axis], abs=4)
        assert found.offset == pytest.approx(0.1, abs=0.05)
        assert found.greatest == 160


def test_steps_go_both_ways_up_and_down() -> None:
    assert PLAN.duties() == (0, 80, -80, 160, -160, 160, -160, 80, -80, 0)
    assert PLAN.total() == 30


@pytest.mark.slow
def test_each_step_is_told_before_it_is_felt_and_nothing_is_left(clamped: Bench) -> None:
    before = clamped.line.configuration()
    told: list[tuple[int, int]] = []

    def tell(axis: int, duty: int) -> None:
        assert not clamped.board.enabled
        told.append((axis, duty))

    measure(clamped.line, cells(clamped), PLAN, tell)
    assert told == [(axis, duty) for axis in range(3) for duty in PLAN.duties()]
    assert not clamped.board.enabled
    assert clamped.line.configuration() == before


def interrupted(bench: Bench, act: Callable[[], None]) -> None:
    """Measure, and let something happen at the fourth step."""
    told: list[int] = []

    def tell(axis: int, duty: int) -> None:
        told.append(duty)
        if len(told) == 4:
            act()

    measure(bench.line, cells(bench), PLAN, tell)


def test_a_handle_that_is_not_held_ends_it_without_force(clamped: Bench) -> None:
    before = clamped.line.configuration()
    with pytest.raises((HandleMoved, ForceWithdrawn), match="x: at"):
        interrupted(clamped, lambda: clamped.board.hold(0, 0.0, 20.0, 0.0))
    assert clamped.board.duties == (0,) * 6
    assert clamped.line.configuration() == before


def test_a_dead_man_s_switch_that_is_let_go_ends_it(clamped: Bench) -> None:
    with pytest.raises(Refused, match="dead-man"):
        interrupted(clamped, lambda: clamped.board.hold_dead_man(False))


def test_an_emergency_stop_while_a_reading_is_awaited_ends_it(clamped: Bench) -> None:
    def press() -> None:
        clamped.board.press_estop(True)

    with pytest.raises(ForceWithdrawn, match="FAULT, ESTOP"):
        measure(clamped.line, [press, press, press], PLAN, nothing)
    assert not clamped.board.enabled


def test_a_step_that_the_settings_clip_is_no_reading(clamped: Bench) -> None:
    clamped.line.configure(clamped.line.configuration()._replace(force_limit=(100, 255, 255)))
    with pytest.raises(ForceWithdrawn, match=r"its settings allow \+100"):
        measure(clamped.line, cells(clamped), PLAN, nothing)


def test_a_motor_is_not_kept_hot_for_a_reading_that_does_not_come(
    clamped: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(force_steps, "LONGEST", 2.0)
    with pytest.raises(NothingRead, match="within 2 s"):
        measure(clamped.line, [lambda: None] * 3, PLAN, nothing)
    assert not clamped.board.enabled


def page(serial: str = "") -> ForceCalibration:
    """Give a page of noiseless readings of a stick that is as FOUND."""
    duties = (0, 50, -50, 100, -100, 200, -200)
    x, y, theta = (
        fit(name, [Reading(0, duty, duty * per_duty) for duty in duties])
        for name, per_duty in zip(AXES, FOUND, strict=True)
    )
    return ForceCalibration(
        date=date(2026, 11, 22), instrument="scale", serial=serial, x=x, y=y, theta=theta
    )


def test_a_calibration_says_when_it_was_made_and_what_it_is() -> None:
    assert page().name.startswith("2026-11-22 ")
    assert page().name != page().model_copy(update={"instrument": "load cell"}).name
    assert ForceCalibration.model_validate_json(page().model_dump_json()) == page()


def test_a_calibrated_stick_converts_by_what_was_found() -> None:
    assert handle_scale(SimulatedStick()).per_duty == NOMINAL
    assert handle_scale(SimulatedStick(), page()).per_duty == pytest.approx(FOUND)


def test_what_the_dead_band_takes_is_not_said_to_be_felt(clamped: Bench) -> None:
    scale = handle_scale(SimulatedStick())._replace(per_duty=FOUND, dead_band=DEAD_BAND)
    clamped.arm()
    told = clamped.line.listen(0.01)[-1]._replace(motor=(112, -8, -20))
    assert scale.force(told) == pytest.approx((100 * FOUND[0], -8 * FOUND[1], 0.0))


@pytest.mark.usefixtures("toolchain")
def test_a_device_says_which_calibration_its_forces_are_of() -> None:
    nominal = EmulatedStickDevice().connect(240)
    assert record_of("emulated_stick", nominal).scale == "nominal"
    nominal.close()
    calibrated = EmulatedStickDevice(calibration=page(serial="0")).connect(240)
    record = record_of("emulated_stick", calibrated)
    assert record.scale == "calibrated"
    assert record.identity.calibration == page(serial="0").name
    calibrated.close()


@pytest.mark.usefixtures("toolchain")
def test_another_stick_s_calibration_gives_no_force() -> None:
    running = EmulatedStickDevice(calibration=page(serial="4711")).connect(240)
    running.render(ForceField(PlanarWrench(1.0, 0.0, 0.0)))
    assert "made with the stick of serial number 4711, but this one's is 0" in running.trouble()
    running.close()
