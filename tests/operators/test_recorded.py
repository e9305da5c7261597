"""A person's recording: read, trimmed, looked up, and driven through plant and world."""

from __future__ import annotations

from math import cos, inf, pi, sin
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from core_world import corner_world, trial, wall_ahead
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from omnistudy.controllers.differential import DifferentialController
from omnistudy.controllers.direct import DirectController
from omnistudy.devices.direct import DirectDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.errors import OmnistudyError
from omnistudy.errors.operators import (
    NoMotion,
    NoRecording,
    NoRows,
    NoSuchColumn,
    NotANumber,
    TimeRunsBackwards,
    WrongAxes,
)
from omnistudy.operators import Person
from omnistudy.operators.command_log import CommandLog, read_log
from omnistudy.operators.recorded import RecordedOperator
from omnistudy.registry import load_kind
from omnistudy.tasks.free import FreeTask
from omnistudy.trial import TrialResult, resimulate, run_trial
from omnistudy.worlds import Leg, Route, Situation, Start, World

PERSON = Person("a", "b", 1)
WAY = (Route(name="way", legs=(Leg(target="nothing", path=((0, 0), (1, 0))),)),)
FLOOR = World(name="floor", start=Start(x=0.0, y=0.0), routes=WAY)


@pytest.fixture
def recording(tmp_path: Path) -> Any:
    """Write a CSV of text and give its path."""

    def write(text: str) -> Path:
        path = tmp_path / "recording.csv"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def drive(file: Path, world: World = FLOOR, controller: Any = None, **changes: Any) -> TrialResult:
    return run_trial(
        trial(
            world,
            device=DirectDevice(),
            controller=controller or DirectController(),
            operator=RecordedOperator(file=file, **changes),
            task=FreeTask(),
        )
    )


def references(operator: RecordedOperator, physics_hz: int) -> list[tuple[float, ...]]:
    """What the hand does at every step until it is finished."""
    running = operator.begin(PERSON, physics_hz)
    asked: list[tuple[float, ...]] = []
    while not running.finished:
        asked.append(running.hand(len(asked) / physics_hz, None, Situation()).reference)
    return asked


# Looking up


def slow_lookup(
    times: list[float], values: list[float], t: float, between: str, longest_gap: float | None
) -> float:
    """Walk through the rows as a person with a pencil would."""
    if t < times[0]:
        return 0.0
    last = max(i for i, stamp in enumerate(times) if stamp <= t)
    age = t - times[last]
    gap = inf if longest_gap is None else longest_gap
    if between == "linear" and last + 1 < len(times):
        span = times[last + 1] - times[last]
        if span <= gap:
            return values[last] + (values[last + 1] - values[last]) * age / span
    return values[last] if age <= gap else 0.0


rows = st.lists(st.tuples(st.integers(1, 400), st.integers(-100, 100)), min_size=1, max_size=12)


@given(
    rows=rows,
    asked=st.lists(st.integers(-50, 5000), min_size=1, max_size=20),
    between=st.sampled_from(["hold", "linear"]),
    gap=st.one_of(st.none(), st.integers(1, 600)),
)
def test_lookup_agrees_with_a_pencil(
    rows: list[tuple[int, int]], asked: list[int], between: Any, gap: int | None
) -> None:
    """Whole hundredths of a second, so that nothing hangs on the last digit."""
    times = (np.cumsum([step for step, _ in rows]) / 100.0).tolist()
    values = [value / 10.0 for _, value in rows]
    longest = None if gap is None else gap / 100.0 + 0.001
    log = CommandLog(np.array(times), np.array(values)[:, None])
    instants = [t / 100.0 for t in asked]
    found = log.at(np.array(instants), between, longest)[:, 0]
    expected = [slow_lookup(times, values, t, between, longest) for t in instants]
    assert found == pytest.approx(expected, abs=1e-9)


@given(rows=rows, hz=st.sampled_from([60, 240, 500]))
def test_every_step_holds_what_was_last_said(
    rows: list[tuple[int, int]], hz: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    times = (1.6e9 + np.cumsum([step for step, _ in rows]) / 100.0).tolist()
    values = [float(value) for _, value in rows]
    if not any(values):
        return
    file = tmp_path_factory.mktemp("rows") / "log.csv"
    lines = [f"{t:.6f},{v}" for t, v in zip(times, values, strict=True)]
    file.write_text("\n".join(["time,v", *lines]), encoding="utf-8")
    asked = references(RecordedOperator(file=file, axes=("v",), cut_idle=False), hz)
    assert len(asked) == max(1, round(np.ceil((times[-1] - times[0]) * hz - 1e-3)))
    for step, (value,) in enumerate(asked):
        instant = times[0] + step / hz + 1e-6
        assert value == values[max(i for i, t in enumerate(times) if t <= instant)]


# Reading


def test_columns_are_found_by_name_and_null_is_zero(recording: Any) -> None:
    file = recording("omega, time ,note,v\n0.5,10,a,1\n-0.0,11,b,2\n")
    log = read_log(file, "time", ("v", None, "omega"))
    assert log.times.tolist() == [10.0, 11.0]
    assert log.values.tolist() == [[1.0, 0.0, 0.5], [2.0, 0.0, 0.0]]
    assert not np.signbit(log.values).any()


def test_byte_order_mark_blank_lines_and_spaces_are_no_matter(recording: Any) -> None:
    file = recording("\ufefftime,v\n\n0, 1\n\n1, 2\n\n")
    assert read_log(file, "time", ("v",)).values.tolist() == [[1.0], [2.0]]


def test_of_equal_stamps_the_last_counts(recording: Any) -> None:
    file = recording("time,v\n0,1\n1,2\n1,3\n1,4\n2,5\n2,6\n")
    log = read_log(file, "time", ("v",))
    assert log.times.tolist() == [0.0, 1.0, 2.0]
    assert log.values[:, 0].tolist() == [1.0, 4.0, 6.0]


@pytest.mark.parametrize(
    ("text", "error", "said"),
    [
        ("", NoRecording, "it is empty"),
        ("time,v,omega\n", NoRows, "no rows"),
        ("time,vel,omega\n0,1,0\n", NoSuchColumn, "no column 'v': its columns are time, vel"),
        ("time,v,omega\n0,1,0\n1,fast,0\n", NotANumber, "line 3: 'fast' in column 'v'"),
        ("time,v,omega\n0,1,0\n\n1,,0\n", NotANumber, "line 4: '' in column 'v'"),
        ("time,v,omega\n0,1\n", NotANumber, "line 2: '' in column 'omega'"),
        ("time,v,omega\n0,1,nan\n", NotANumber, "line 2: 'nan' in column 'omega'"),
        ("time,v,omega\ninf,1,0\n", NotANumber, "line 2: 'inf' in column 'time'"),
        ("time,v,omega\n5,1,0\n6,1,0\n5.5,1,0\n", TimeRunsBackwards, "line 4: time runs back"),
        ("time,v,omega\n0,0,0\n1,0,-0.0\n", NoMotion, "v and omega are zero in every row"),
    ],
)
def test_mistake_is_told_with_its_place(
    recording: Any, text: str, error: type[OmnistudyError], said: str
) -> None:
    file = recording(text)
    with pytest.raises(error) as raised:
        RecordedOperator(file=file).begin(PERSON, 240)
    assert said in str(raised.value)
    assert str(file) in str(raised.value)
    assert "\n" not in str(raised.value)


def test_misspelt_column_offers_the_nearest(recording: Any) -> None:
    with pytest.raises(NoSuchColumn, match="did you mean 'omega'"):
        RecordedOperator(file=recording("time,v,omega\n0,1,0\n"), axes=("v", None, "omga")).log()


def test_file_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    with pytest.raises(NoRecording, match="there is no such file"):
        RecordedOperator(file=tmp_path / "none.csv").log()
    with pytest.raises(NoRecording, match="it cannot be read"):
        RecordedOperator(file=tmp_path).log()
    binary = tmp_path / "binary.csv"
    binary.write_bytes(b"time,v,omega\n\xff\xfe\x00\n")
    with pytest.raises(NoRecording, match="it cannot be read"):
        RecordedOperator(file=binary).log()


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"axes": ()}, "at least 1 item"),
        ({"axes": (None, None)}, "at least one axis needs a column"),
        ({"scale": (1.0, 2.0)}, "2 numbers for 3 axes"),
        ({"longest_gap": 0.0}, "greater than 0"),
    ],
)
def test_parameters_are_checked(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(ValidationError, match=said):
        RecordedOperator(file=Path("x.csv"), **changes)


# Idle parts

IDLE = "time,v,omega\n0,0,0\n7,0,0\n10,1,0\n11,0,0\n12,0,2\n13,0,0\n14,0,0\n90,0,0\n"


def test_idle_head_and_tail_are_cut_but_not_the_pause_between(recording: Any) -> None:
    log = RecordedOperator(file=recording(IDLE)).log()
    assert log.times.tolist() == [10.0, 11.0, 12.0, 13.0]
    assert log.values.tolist() == [[1, 0, 0], [0, 0, 0], [0, 0, 2], [0, 0, 0]]
    assert len(references(RecordedOperator(file=recording(IDLE)), 100)) == 300


def test_idle_parts_can_be_kept(recording: Any) -> None:
    operator = RecordedOperator(file=recording(IDLE), cut_idle=False)
    assert len(references(operator, 100)) == 9000


def test_recording_that_ends_in_motion_ends_with_its_last_row(recording: Any) -> None:
    asked = references(RecordedOperator(file=recording("time,v\n0,1\n2,3\n"), axes=("v",)), 60)
    assert asked == [(1.0,)] * 120


def test_one_row_of_motion_is_one_step(recording: Any) -> None:
    operator = RecordedOperator(file=recording("time,v\n5,1\n"), axes=("v",))
    assert references(operator, 60) == [(1.0,)]


# Driving


def test_kind_is_registered() -> None:
    assert load_kind("operators", "recorded") is RecordedOperator
    assert load_kind("tasks", "free") is FreeTask


def test_constant_twist_ends_on_the_circle(recording: Any) -> None:
    """v = 0.2 m/s and omega = 0.5 rad/s for 3 s: a circle of 0.4 m, 1.5 rad round."""
    result = drive(recording("time,v,omega\n100,0.2,0.5\n103,0,0\n104,0,0\n"))
    assert result.status == "completed"
    x, y, theta = result.samples[-1, 1:4]
    assert theta == pytest.approx(1.5, abs=0.01)
    assert x == pytest.approx(0.4 * sin(1.5), abs=0.004)
    assert y == pytest.approx(0.4 * (1 - cos(1.5)), abs=0.004)
    assert result.path_length_m == pytest.approx(0.6, abs=0.004)


def test_sideways_column_drives_sideways(recording: Any) -> None:
    file = recording("time,left\n0,0.25\n2,0\n")
    result = drive(file, axes=(None, "left", None))
    assert result.samples[-1, 1:4] == pytest.approx([0.0, 0.5, 0.0], abs=0.004)


def test_scale_brings_the_log_to_the_axis_s_unit(recording: Any) -> None:
    file = recording("time,percent\n0,50\n2,0\n")
    result = drive(file, axes=("percent", None, None), scale=(0.01, 1.0, 1.0))
    assert result.samples[20, 4] == pytest.approx(0.5, abs=1e-3)


def test_command_that_nothing_follows_stops_after_the_longest_gap(recording: Any) -> None:
    file = recording("time,v,omega\n0,0.2,0\n10,0,0\n")
    assert drive(file).path_length_m == pytest.approx(2.0, abs=0.01)
    assert drive(file, longest_gap=0.5).path_length_m == pytest.approx(0.1, abs=0.01)


@pytest.mark.parametrize("device", [DirectDevice(), SimulatedStick()])
def test_axes_that_do_not_fit_the_device_are_told(recording: Any, device: Any) -> None:
    operator = RecordedOperator(file=recording("time,v\n0,1\n1,0\n"), axes=("v", None))
    with pytest.raises(WrongAxes, match=r"moves 2 axes, but the device has 3 \(stick_x, "):
        run_trial(trial(FLOOR, operator=operator, device=device, task=FreeTask()))


def test_linear_ramp_covers_half_the_way(recording: Any) -> None:
    file = recording("time,v,omega\n0,0.4,0\n5,0,0\n")
    assert drive(file, between="linear").path_length_m == pytest.approx(1.0, abs=0.01)


def test_walls_stop_a_recording_and_count_once(recording: Any) -> None:
    world = World(name="wall", start=Start(x=0.0, y=0.0), bodies=(wall_ahead(1.0),), routes=WAY)
    result = drive(recording("time,v,omega\n0,0.3,0\n10,0,0\n"), world)
    assert result.status == "completed"
    assert (result.collisions, result.collisions_legacy) == (1, 1)
    assert result.samples[-1, 1] == pytest.approx(1.0 - 0.29, abs=0.005)


def test_stick_positions_drive_the_stick_s_controller(recording: Any) -> None:
    """Full forward stick is 0.36 m/s; the hand prescribes, so that centring changes nothing."""
    file = recording("time,x,twist\n0,0.04145,0\n2,0.04145,0\n2.0,0,0\n2.5,0,0\n")
    operator = RecordedOperator(file=file, axes=("x", None, "twist"))
    result = run_trial(trial(FLOOR, operator=operator, task=FreeTask()))
    assert result.samples[10, 7] == pytest.approx(0.04145, abs=1e-4)
    assert result.samples[10, 4] == pytest.approx(0.36, abs=0.002)


def test_recording_that_stops_half_way_round_a_route_is_aborted(recording: Any) -> None:
    file = recording("time,v,omega\n0,0.3,0\n1,0,0\n")
    spec = trial(
        corner_world(),
        device=DirectDevice(),
        controller=DirectController(),
        operator=RecordedOperator(file=file),
    )
    result = run_trial(spec)
    assert (result.status, result.reason) == ("aborted", "the input ended")


def test_free_drive_ends_by_itself_too(recording: Any) -> None:
    spec = trial(FLOOR, task=FreeTask(duration=1.5))
    result = run_trial(spec)
    assert result.status == "completed"
    assert result.samples[-1, 0] == pytest.approx(1.5, abs=0.06)


def test_resimulation_needs_the_input_alone(recording: Any) -> None:
    file = recording("time,v,omega\n0,0.2,0.5\n1,0.1,-1\n2,0,0\n")
    spec = trial(
        FLOOR,
        device=DirectDevice(),
        controller=DirectController(),
        operator=RecordedOperator(file=file),
        task=FreeTask(),
    )
    result = run_trial(spec)
    file.unlink()
    again = resimulate(spec, result.streams[0].data)
    assert again.samples.tobytes() == result.samples.tobytes()
    assert (again.status, again.events) == (result.status, result.events)


def test_two_wheels_slow_down_to_turn(recording: Any) -> None:
    """Asked for more than it has, the outer wheel stays at its top and the inner one gives way.

    1 m/s becomes 0.2 m/s; half a track of turning is 0.04 m/s; the wheels then run at 0.16 and
    0.2 (not 0.24) m/s: 0.18 m/s and 0.2 rad/s in place of 0.4.
    """
    controller = DifferentialController(top_wheel_speed=0.2, track=0.2)
    result = drive(recording("time,v,omega\n0,1,0.4\n2,0,0\n"), controller=controller)
    assert result.samples[20, 4:7] == pytest.approx([0.18, 0.0, 0.2], abs=1e-3)


@pytest.mark.parametrize(("asked", "turn"), [((0.1, 0.5), 0.5), ((0.0, 40.0), 2.0)])
def test_two_wheels_follow_what_they_can(
    recording: Any, asked: tuple[float, float], turn: float
) -> None:
    controller = DifferentialController(top_wheel_speed=0.2, track=0.2)
    v, omega = asked
    result = drive(recording(f"time,v,omega\n0,{v},{omega}\n1,0,0\n"), controller=controller)
    assert result.samples[15, 4:7] == pytest.approx([v, 0.0, turn], abs=1e-3)
    assert abs(result.samples[-1, 3]) < 2 * pi
