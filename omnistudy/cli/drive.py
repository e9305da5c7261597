"""`omnistudy drive`: driving without a study."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, Workers
from omnistudy.cli.free_drive import DEFAULT_VERB, WorldOrVerb, free
from omnistudy.cli.output import print_json, print_line, print_table, progress

if TYPE_CHECKING:
    from omnistudy.session.drive import Drive
    from omnistudy.session.replay import Replay
    from omnistudy.worlds import World

app = typer.Typer(no_args_is_help=True, cls=WorldOrVerb)
app.command(name=DEFAULT_VERB)(free)

FOLLOWED = 0.8
"""A robot that drove less than this share of what was asked did not follow its commands."""


def _pages(group: str) -> list[str]:
    from omnistudy.session.parts import part_names

    return list(part_names(group))


def _laws() -> list[str]:
    return _pages("law")


def _worlds() -> list[str]:
    return _pages("world")


CONTROLLERS = ["direct", "differential"]
LAWS = ["component", "none"]

Laws = Annotated[
    list[str],
    typer.Option("--law", help="Law to drive under; may be repeated.", autocompletion=_laws),
]
Seed = Annotated[int, typer.Option(help="Another number is another person with other noise.")]


Commands = Annotated[Path, typer.Argument(help="CSV of logged twists, columns named.")]
OdometryFile = Annotated[
    Path | None, typer.Option(help="CSV of where that robot was, to compare with.")
]
WorldName = Annotated[str, typer.Option(help="World, by name or file; none is an empty floor.")]
Controllers = Annotated[
    list[str],
    typer.Option(
        help="direct drives what was asked; differential what the two wheels of a TurtleBot3 "
        "Burger make of it. May be repeated."
    ),
]
Columns = Annotated[
    list[str] | None,
    typer.Option(
        metavar="WHAT=NAME",
        help="Column of time, x, y or theta in the commands (else time, v, none, omega).",
    ),
]
OdometryColumns = Annotated[
    list[str] | None,
    typer.Option(
        metavar="WHAT=NAME",
        help="Column of time, x, y, yaw, v or omega in the odometry (else of these names).",
    ),
]
Linear = Annotated[
    bool, typer.Option("--linear", help="Join rows by lines; else a row holds until the next.")
]
LongestGap = Annotated[
    float | None, typer.Option(min=0.001, help="Seconds after which a command counts no more.")
]
KeepIdle = Annotated[
    bool, typer.Option("--keep-idle", help="Keep what is at rest before and after the drive.")
]
Measured = Annotated[
    bool, typer.Option("--measured", help="Also drive what the odometry measured as v and omega.")
]


@app.command()
def replay(
    commands: Commands,
    odometry: OdometryFile = None,
    world: WorldName = "none",
    controller: Controllers = CONTROLLERS,
    column: Columns = None,
    odometry_column: OdometryColumns = None,
    linear: Linear = False,
    longest_gap: LongestGap = None,
    keep_idle: KeepIdle = False,
    measured: Measured = False,
    as_json: AsJson = False,
) -> None:
    """Drive a person's recorded commands again and tell how far that ends from the odometry.

    Example: omnistudy drive replay twist_cmd_vel.csv --odometry odom.csv --measured
    """
    from omnistudy.session.columns import mapped
    from omnistudy.session.odometry import read_odometry
    from omnistudy.session.replay import EMPTY_FLOOR, recorded_twists
    from omnistudy.session.replay import replay as drive_again
    from omnistudy.worlds import load_world

    operator = recorded_twists(
        commands,
        mapped(column or (), {"time": "time", "x": "v", "y": None, "theta": "omega"}),
        between="linear" if linear else "hold",
        longest_gap=longest_gap,
        cut_idle=not keep_idle,
    )
    names = {name: name for name in ("time", "x", "y", "yaw", "v", "omega")}
    time, x, y, yaw, v, omega = mapped(odometry_column or (), names)
    own = read_odometry(odometry, (time, x, y, yaw)) if odometry else None
    drives = [(operator, name) for name in controller]
    if odometry and measured:
        drives.append((recorded_twists(odometry, (time, v, None, omega)), "direct"))
    floor = EMPTY_FLOOR if world == "none" else load_world(world)
    replays = []
    with progress("drives", len(drives)) as advance:
        for recording, name in drives:
            replays.append(drive_again(recording, name, floor, own))
            advance()
    if as_json:
        print_json(replays)
    else:
        _print_replays(replays)


def _print_replays(replays: list[Replay]) -> None:
    columns = ["recording", "controller", "s", "path m", "hits"]
    compared = ["own path m", "end error m", "% of path", "heading rad", "largest m"]
    rows = []
    for done in replays:
        row: list[object] = [
            done.file.name, done.controller, f"{done.duration_s:.1f}",
            f"{done.path_length_m:.2f}", done.collisions,
        ]  # fmt: skip
        own = done.odometry
        if own is not None:
            row += [
                f"{own.path_length_m:.2f}", f"{own.end_error_m:.2f}",
                f"{100 * own.end_error_share:.1f}", f"{own.heading_error_rad:+.2f}",
                f"{own.largest_error_m:.2f}",
            ]  # fmt: skip
        rows.append(row)
    title = f"{replays[0].file.parent}, {replays[0].world}"
    print_table(title, columns + compared * (replays[0].odometry is not None), rows)
    for done in replays:
        own = done.odometry
        if (
            done.controller == "direct"
            and own
            and own.path_length_m < FOLLOWED * done.path_length_m
        ):
            print_line(
                f"The recorded robot drove {own.path_length_m:.2f} m where its commands ask for "
                f"{done.path_length_m:.2f} m: it could not follow them, so 'direct' tells little."
            )


@app.command()
def worlds(
    world: Annotated[
        list[str], typer.Argument(help="Worlds, by name or file.", autocompletion=_worlds)
    ],
    law: Laws = LAWS,
    seed: Seed = 1,
    workers: Workers = None,
    as_json: AsJson = False,
) -> None:
    """Let the virtual driver drive worlds along their first routes, with and without feedback.

    Who does not reach the end within 3 x route length / 0.36 m/s is stuck, and it is told where.

    Example: omnistudy drive worlds primitive_a primitive_b --law component --law none
    """
    from omnistudy.worlds import load_world

    _drive([load_world(name) for name in world], law, seed, workers, as_json)


@app.command()
def barn(
    folder: Annotated[Path, typer.Argument(help="Folder with world_N.world and path_N.npy.")],
    law: Laws = LAWS,
    seed: Seed = 1,
    workers: Workers = None,
    as_json: AsJson = False,
) -> None:
    """Let the virtual driver drive worlds of the BARN benchmark along their reference paths.

    Example: omnistudy drive barn ../shared/data/barn
    """
    from omnistudy.session.barn import barn_worlds

    _drive(barn_worlds(folder), law, seed, workers, as_json)


def _drive(
    chosen: list[World], laws: list[str], seed: int, workers: int | None, as_json: bool
) -> None:
    import os

    from omnistudy.session.drive import drive_worlds

    with progress("drives", len(chosen) * len(laws)) as advance:
        drives = drive_worlds(
            chosen,
            laws,
            seed=seed,
            workers=workers or os.cpu_count() or 1,
            driven=lambda drive: advance(),
        )
    if as_json:
        print_json(drives)
    else:
        _print_drives(drives)


def _print_drives(drives: tuple[Drive, ...]) -> None:
    columns = (
        "world", "law", "outcome", "time s", "limit s", "collisions", "legacy", "contact s",
        "driven m", "route m", "got to m",
    )  # fmt: skip
    rows = [
        (
            drive.world, drive.law, drive.outcome, f"{drive.time_s:.1f}", f"{drive.limit_s:.0f}",
            drive.collisions, drive.collisions_legacy, f"{drive.contact_time_s:.1f}",
            f"{drive.path_length_m:.2f}", f"{drive.route_length_m:.2f}",
            f"{drive.along_m:.2f}",
        )
        for drive in drives
    ]  # fmt: skip
    print_table("virtual driver", columns, rows)
    for drive in drives:
        if drive.outcome == "stuck":
            touched = f", last against {drive.wall}" if drive.wall else ""
            print_line(
                f"{drive.world} under {drive.law}: stuck {drive.along_m:.2f} m along the route at "
                f"x = {drive.x:.2f} m, y = {drive.y:.2f} m, no further after "
                f"{drive.along_at_s:.0f} s{touched}"
            )
