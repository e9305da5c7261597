"""`omnistudy law`: what laws there are, and what each does alone."""

from __future__ import annotations

from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.kind_verbs import add_list_and_show, kinds_of
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from omnistudy.geometry import Matrix3
    from omnistudy.laws.probe import Probe

app = typer.Typer(no_args_is_help=True)
add_list_and_show(app, "law", "component")

Kind = Annotated[
    str,
    typer.Argument(
        help="Kind of law; `omnistudy law list` names them.", autocompletion=kinds_of("laws")
    ),
]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Change a parameter; may be repeated."),
]
Triple = tuple[float, float, float]


def _finite(values: Triple) -> Triple:
    if not all(map(isfinite, values)):
        raise typer.BadParameter("three finite numbers are needed")
    return values


@app.command()
def probe(
    kind: Kind,
    scan: Annotated[
        Path,
        typer.Option(
            help="JSON file: angles (rad), ranges (m), max_range (m); for rays from elsewhere x "
            "and y (m), for a sensor that tells them rates (m/s)."
        ),
    ],
    twist: Annotated[
        Triple,
        typer.Option(
            metavar="VX VY OMEGA", help="What the stick asks for, m/s and rad/s.", callback=_finite
        ),
    ] = (0.0, 0.0, 0.0),
    settings: Settings = None,
    stick: Annotated[
        Triple,
        typer.Option(
            metavar="X Y THETA", help="Where the stick is, m, m and rad.", callback=_finite
        ),
    ] = (0.0, 0.0, 0.0),
    stick_rate: Annotated[
        Triple,
        typer.Option(
            metavar="X Y THETA", help="How fast the stick moves, m/s and rad/s.", callback=_finite
        ),
    ] = (0.0, 0.0, 0.0),
    as_json: AsJson = False,
) -> None:
    """Print the wrench that a law puts on the hand in one scene, unclipped.

    The stiffness is per movement of the stick under the published `rate` controller.

    Example: omnistudy law probe component --scan wall.json --twist 0.2 0 -0.5
    """
    from omnistudy.geometry import PlanarTwist
    from omnistudy.laws import Sensed
    from omnistudy.laws.probe import probe
    from omnistudy.laws.scan_file import read_scan
    from omnistudy.registry import load_kind
    from omnistudy.registry.parameters import make_kind

    per_stick: Matrix3 = load_kind("controllers", "rate")().twist_per_stick
    law = make_kind("laws", kind, settings or ())
    found = probe(law, Sensed(read_scan(scan), PlanarTwist(*twist), per_stick, stick, stick_rate))
    if as_json:
        print_json(found)
    else:
        _print_probe(found)


def _print_probe(found: Probe) -> None:
    forces = (("fx", found.fx, "N"), ("fy", found.fy, "N"), ("tau", found.tau, "N·m"))
    print_table(f"'{found.kind}' on the hand", ("part", "value", "unit"), forces)
    _print_matrix("stiffness (per m, m, rad)", found.stiffness)
    if any(map(any, found.damping)):
        _print_matrix("damping (per m/s, m/s, rad/s)", found.damping)
    if found.n is not None:
        print_line(f"rays that touch the boundary: {found.n}")


def _print_matrix(title: str, matrix: Matrix3) -> None:
    rows = [(part, *row) for part, row in zip(("fx", "fy", "tau"), matrix, strict=True)]
    print_table(title, ("part", "x", "y", "theta"), rows)


@app.command()
def draw(
    kinds: Annotated[
        list[str],
        typer.Argument(
            metavar="KIND...",
            help="Kind of law, or several to set side by side; `omnistudy law list` names them.",
            autocompletion=kinds_of("laws"),
        ),
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="Picture: .svg or .png.")],
    scan: Annotated[
        Path | None, typer.Option(help="Draw this one scene instead of the four standard ones.")
    ] = None,
    settings: Settings = None,
    force: Annotated[bool, typer.Option("--force", help="Replace an existing file.")] = False,
) -> None:
    """Draw what laws do: beside walls, or in one scene.

    Example: omnistudy law draw component quadrant -o laws.svg
    """
    from omnistudy.laws.drawing import draw_field
    from omnistudy.laws.scan_file import read_scan
    from omnistudy.laws.scene_drawing import draw_scene
    from omnistudy.registry.parameters import make_kind

    laws = [make_kind("laws", kind, settings or ()) for kind in kinds]
    if scan is None:
        draw_field(laws, output, replace=force)
    else:
        draw_scene(laws, read_scan(scan), output, replace=force)
    print_line(f"drawn: {output}")
