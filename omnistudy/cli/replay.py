"""`omnistudy replay`: a stored trial seen again."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, StudyArgument, Unmask
from omnistudy.cli.output import print_json, print_line, progress

if TYPE_CHECKING:
    from omnistudy.view.film import Film
    from omnistudy.view.filming import Filming

app = typer.Typer(add_completion=False)


class Camera(StrEnum):
    """From where the world is seen."""

    follow = "follow"
    plan = "plan"
    first = "first"


def _trials_run(context: typer.Context) -> list[str]:
    """Complete the number of a trial that was run, in the study before it on the line."""
    from omnistudy.errors import OmnistudyError
    from omnistudy.store import open_study
    from omnistudy.study import resolve_study

    try:
        with open_study(resolve_study(context.params["study"])) as study:
            trials = study.trials()
    except OmnistudyError:
        return []  # a half-typed line names no study yet
    return [str(number) for number in trials["trial"][trials["finished_at"].notna()]]


@app.command()
def replay(
    study: StudyArgument,
    trials: Annotated[
        list[int],
        typer.Argument(
            metavar="TRIAL...",
            help="Number of a trial, or of two to see side by side.",
            autocompletion=_trials_run,
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="The page; STUDY_trial_N.html unless given."),
    ] = None,
    frames: Annotated[
        Path | None, typer.Option(help="Write pictures into this folder, and no page.")
    ] = None,
    video: Annotated[
        Path | None, typer.Option(help="Write this video with ffmpeg, and no page.")
    ] = None,
    begin: Annotated[float, typer.Option("--from", min=0, help="Film from here, s.")] = 0.0,
    end: Annotated[
        float | None,
        typer.Option("--to", min=0, help="Film up to here, s; else the end."),
    ] = None,
    rate: Annotated[float, typer.Option(min=0.1, max=60, help="Pictures a second.")] = 25.0,
    camera: Annotated[Camera, typer.Option(help="Where a film is seen from.")] = Camera.follow,
    unmask: Unmask = False,
    force: Annotated[bool, typer.Option("--force", help="Replace pictures or a video.")] = False,
    json: AsJson = False,
) -> None:
    """Write a trial as one HTML file that any browser shows, or as pictures or a video.

    Example: omnistudy replay first 7 -o trial_7.html
    """
    from omnistudy.errors.view import TooManyTrials
    from omnistudy.store import open_study
    from omnistudy.study import resolve_study
    from omnistudy.view.film import film
    from omnistudy.view.filming import Filming
    from omnistudy.view.page import replay_page, write_page

    if len(trials) > 2:
        raise TooManyTrials(len(trials))
    path = resolve_study(study)
    with open_study(path) as opened:
        films = [film(opened, number, unmask=unmask) for number in trials]
    text = replay_page(films)
    if frames or video:
        last = max(film.end for film in films)
        filming = Filming(begin, min(end if end is not None else last, last), rate, camera.value)
        _film(text, filming, frames, video, force, json)
        return
    name = "_".join(str(number) for number in trials)
    page = output or Path(f"{path.stem}_trial_{name}.html")
    write_page(text, page)
    if json:
        print_json({"page": page, "trials": [_told(film) for film in films]})
        return
    print_line(str(page))


def _film(
    text: str, filming: Filming, frames: Path | None, video: Path | None, force: bool, json: bool
) -> None:
    from omnistudy.view.filming import film_frames, film_video

    count = len(filming.times)
    for made, film in ((frames, film_frames), (video, film_video)):
        if made is None:
            continue
        with progress(f"filming {made}", max(count, 1)) as advance:
            pictures = film(text, filming, made, replace=force, done=advance)
        if json:
            print_json({"file": made, "pictures": pictures, "rate": filming.rate})
        else:
            print_line(f"{made}: {pictures} pictures")


def _told(film: Film) -> dict[str, object]:
    return {
        "trial": film.trial,
        "participant": film.participant,
        "label" if film.masked else "condition": film.condition,
        "status": film.status,
        "end_s": film.end,
    }
