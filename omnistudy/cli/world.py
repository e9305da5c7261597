"""`omnistudy world`: worlds to drive through, drawn, checked and imported."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from omnistudy.geometry import PlanarPose
    from omnistudy.worlds import World
    from omnistudy.worlds.check import WorldCheck

app = typer.Typer(no_args_is_help=True, help="Worlds to drive through.")


def _names() -> list[str]:
    from omnistudy.worlds import world_names

    return list(world_names())


def _plants() -> list[str]:
    from omnistudy.registry import kinds

    return list(kinds("plants"))


WorldArgument = Annotated[
    str, typer.Argument(help="A world's name or its YAML file.", autocompletion=_names)
]
Force = Annotated[bool, typer.Option("--force", help="Replace an existing file.")]
Pair = tuple[float, float]
Triple = tuple[float, float, float]


@app.command("list")
def list_worlds(json: AsJson = False) -> None:
    """List the worlds that can be given by name.

    Example: omnistudy world list
    """
    from omnistudy.worlds import load_world, world_file, world_names

    worlds = [(name, load_world(name).title, str(world_file(name))) for name in world_names()]
    if json:
        print_json([{"name": n, "title": title, "file": file} for n, title, file in worlds])
    else:
        print_table("Worlds", ("name", "title", "file"), worlds)


@app.command()
def show(world: WorldArgument, json: AsJson = False) -> None:
    """Show what stands in a world, and its routes.

    Example: omnistudy world show utah2017
    """
    from omnistudy.worlds import load_world

    shown = load_world(world)
    if json:
        print_json(shown)
        return
    print_line(shown.title or shown.name)
    bodies = shown.scene.bodies
    roles = Counter("moving" if body.motion else body.role for body in bodies).items()
    print_table("What stands in it", ("role", "number"), roles)
    if shown.regions:
        rows = [(region.name, region.group) for region in shown.regions]
        print_table("Regions", ("name", "part"), rows)
    routes = [
        (route.name, round(route.length, 2), " > ".join(leg.target for leg in route.legs))
        for route in shown.routes
    ]
    if routes:
        print_table("Routes", ("name", "length in m", "to be touched"), routes)
    else:
        print_line("It has no route yet.")


@app.command()
def draw(
    world: WorldArgument,
    output: Annotated[Path, typer.Option("--output", "-o", help="Picture: .svg or .png.")],
    grid: Annotated[
        bool, typer.Option("--grid", help="With lines of round coordinates, to write a way by.")
    ] = False,
    force: Force = False,
) -> None:
    """Draw a world's plan with its routes and the paths of what moves.

    Example: omnistudy world draw utah2017 -o plan.svg
    """
    from omnistudy.worlds import load_world
    from omnistudy.worlds.plan_file import write_plan

    write_plan(load_world(world), output, replace=force, grid=grid)
    print_line(f"drawn: {output}")


@app.command()
def check(
    world: WorldArgument,
    plant: Annotated[
        str, typer.Option(help="Kind of robot whose size is checked.", autocompletion=_plants)
    ] = "youbot",
    json: AsJson = False,
) -> None:
    """Check that a robot can drive every route; exit 1 on a fault.

    Example: omnistudy world check utah2017
    """
    from omnistudy.registry import load_kind
    from omnistudy.worlds import load_world
    from omnistudy.worlds.check import check_world

    robot = load_kind("plants", plant)()
    found = check_world(load_world(world), robot.width, robot.circumradius)
    if json:
        print_json(found)
    else:
        _print_check(found)
    if found.faults:
        raise typer.Exit(1)


def _print_check(found: WorldCheck) -> None:
    rows = [
        (
            route.name,
            round(route.length, 2),
            route.turns,
            route.reversals,
            None if route.narrowest is None else round(route.narrowest, 2),
        )
        for route in found.routes
    ]
    columns = ("route", "length in m", "turns", "ways back", "narrowest in m")
    print_table(f"{found.world}, robot {found.plant_width:.2f} m wide", columns, rows)
    for fault in found.faults:
        print_line(f"fault: {fault}")
    for warning in found.warnings:
        print_line(f"warning: {warning}")
    for note in found.notes:
        print_line(f"note: {note}")
    if not found.faults:
        print_line(f"{found.world}: no faults")


@app.command("import")
def import_(
    file: Annotated[
        Path,
        typer.Argument(help="A Gazebo world (SDF), or a ROS map (its YAML page).", dir_okay=False),
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="YAML page to write.")],
    start: Annotated[
        Triple | None,
        typer.Option(
            metavar="X Y THETA",
            help="Where the robot starts, m, m and rad; in a map else its widest place.",
        ),
    ] = None,
    goal: Annotated[
        Pair | None,
        typer.Option(metavar="X Y", help="Where the finish lies, m; a map may do without."),
    ] = None,
    path: Annotated[
        Path | None, typer.Option(help="Points on the way: .npy or .csv, rows x, y.")
    ] = None,
    path_grid: Annotated[
        Triple,
        typer.Option(metavar="STEP X Y", help="Rows are cells: x = STEP·i + X, y = STEP·j + Y."),
    ] = (1.0, 0.0, 0.0),
    force: Force = False,
) -> None:
    """Read a Gazebo world (boxes, cylinders, planes, actors) or a map of ROS's map_server.

    Example: omnistudy world import maze.sdf -o maze.yaml --start 0 0 1.57 --goal 0 5

    Example: omnistudy world import office_map.yaml -o office.yaml
    """
    from omnistudy.geometry import PlanarPose
    from omnistudy.worlds.path_file import read_path

    step, x, y = path_grid
    points = read_path(path, step, (x, y)) if path else ()
    begin = PlanarPose(*start) if start else None
    if file.suffix in (".yaml", ".yml"):
        if path and not goal:
            raise typer.BadParameter("a way needs its end: give --goal X Y", param_hint="--path")
        _import_map(file, output, begin, goal, points, force)
        return
    if begin is None or goal is None:
        raise typer.BadParameter("a Gazebo world needs both", param_hint="--start and --goal")
    _import_sdf(file, output, begin, goal, points, force)


def _import_sdf(
    file: Path, output: Path, start: PlanarPose, goal: Pair, path: Sequence[Pair], force: bool
) -> None:
    from omnistudy.worlds.page import write_world
    from omnistudy.worlds.sdf import import_sdf

    imported = import_sdf(file, start, goal, path, name=output.stem)
    write_world(imported.world, output, replace=force)
    for line in imported.left_out:
        print_line(f"left out: {line}")
    walls = len(imported.world.bodies) - 1
    length = imported.world.routes[0].length
    print_line(f"wrote {output}: {walls} obstacles, a route of {length:.1f} m")


def _import_map(
    file: Path,
    output: Path,
    start: PlanarPose | None,
    goal: Pair | None,
    path: Sequence[Pair],
    force: bool,
) -> None:
    from omnistudy.worlds.map_world import import_map
    from omnistudy.worlds.page import write_world

    imported = import_map(file, start, goal, path, name=output.stem)
    write_world(imported.world, output, replace=force)
    world, cells = imported.world, imported.columns * imported.rows
    boxes = len(world.grid.blocks) if world.grid else 0
    print_line(f"{imported.columns} x {imported.rows} cells, {imported.occupied} occupied")
    print_line(f"{imported.unknown} unknown cells ({imported.unknown / cells:.0%}) stay open")
    if imported.partly:
        print_line(f"{imported.partly} partly occupied cells stay open")
    if start is None:
        at = world.start
        print_line(f"the robot starts at the widest place, ({at.x:.2f}, {at.y:.2f})")
    print_line(f"wrote {output}: {boxes} boxes, {_routes_told(world)}")


def _routes_told(world: World) -> str:
    if world.routes:
        return f"a route of {world.routes[0].length:.1f} m"
    return (
        "no route: add one under `routes`, with a finish body under `bodies`, or import again "
        "with --goal X Y; `omnistudy world draw --grid` shows the coordinates"
    )
