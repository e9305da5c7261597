"""A person's recorded drive, driven again by a simulated robot."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from omnistudy.channel import SAMPLE_COLUMNS, Recording
from omnistudy.controllers import Controller
from omnistudy.errors.drive import NothingMapped
from omnistudy.operators import Person
from omnistudy.operators.command_log import Between
from omnistudy.operators.recorded import RecordedOperator
from omnistudy.session.odometry import Comparison, Odometry, compare
from omnistudy.session.parts import part
from omnistudy.trial import TrialSpec, run_trial
from omnistudy.worlds import Leg, Route, Start, World

EMPTY_FLOOR = World(
    name="empty floor",
    start=Start(x=0.0, y=0.0),
    routes=(Route(name="anywhere", legs=(Leg(target="nothing", path=((0, 0), (1, 0))),)),),
)
"""Nothing to run into; the way leads nowhere, because a free drive follows none."""

NOBODY = Person("recorded", "recorded", 1)
"""A recording draws nothing, so its seeds do not matter."""

POSE = tuple(SAMPLE_COLUMNS.index(name) for name in ("x", "y", "theta"))


@dataclass(frozen=True, slots=True)
class Replay:
    """How a recorded drive went in simulation.

    file : the recording that was driven.
    duration_s : of the recording as it was driven, its idle parts cut.
    path_length_m, turned_rad : what the simulated robot drove and turned, left turns positive.
    end : x, y in m and heading in rad, seen from where it started.
    odometry : None when there was none to compare with.
    """

    file: Path
    controller: str
    world: str
    duration_s: float
    path_length_m: float
    turned_rad: float
    end: tuple[float, float, float]
    collisions: int
    odometry: Comparison | None


def recorded_twists(
    file: Path,
    columns: tuple[str | None, ...],
    *,
    between: Between = "hold",
    longest_gap: float | None = None,
    cut_idle: bool = True,
) -> RecordedOperator:
    """Give the person who drives logged twists again; columns are those of time, x, y and theta.

    Raises NothingMapped when time or every axis is without a column.
    """
    time, *axes = columns
    if time is None or not any(axes):
        raise NothingMapped("a recording", "time and one of x, y and theta", "--column")
    return RecordedOperator(
        file=file,
        time=time,
        axes=tuple(axes),
        between=between,
        longest_gap=longest_gap,
        cut_idle=cut_idle,
    )


def replay(
    operator: RecordedOperator,
    controller: str,
    world: World = EMPTY_FLOOR,
    odometry: Odometry | None = None,
    lab: Path | None = None,
) -> Replay:
    """Drive logged twists again with the youBot base; the names are pages of `conf`.

    Raises what `RecordedOperator.log`, `part` and `compare` raise.
    """
    chosen: Controller = part("controller", controller, lab)
    log = operator.log()
    plant = part("plant", "youbot", lab)
    recording = Recording(sample_hz=Recording().physics_hz)
    spec = TrialSpec(
        world=world,
        route=world.first_route.name,
        plant=plant,
        device=part("device", "direct", lab),
        controller=chosen,
        law=part("law", "none", lab),
        operator=operator,
        task=part("task", "free", lab),
        recording=recording,
        messages=part("messages", "en", lab),
        person=NOBODY,
    )
    result = run_trial(spec)
    samples = result.samples
    poses = samples[:, POSE]
    start = world.start.pose
    x, y, theta = (float(value) for value in poses[-1])
    return Replay(
        file=operator.file,
        controller=controller,
        world=world.name,
        duration_s=float(samples[-1, 0]),
        path_length_m=result.path_length_m,
        turned_rad=theta - start.theta,
        end=(*start.to_local(x, y), theta - start.theta),
        collisions=result.collisions,
        odometry=compare(odometry, float(log.times[0]), samples[:, 0], poses) if odometry else None,
    )
