"""The server of a study's pages."""

from __future__ import annotations

import secrets
import socket
from collections.abc import Callable
from pathlib import Path

import uvicorn
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import HTMLResponse
from starlette.routing import Route

from omnistudy.errors import OmnistudyError
from omnistudy.errors.store import DatabaseTooOld, NoSuchTrial, StudyBusy
from omnistudy.errors.view import AddressTaken, NothingToShow
from omnistudy.store import open_study
from omnistudy.view.access import LOOPBACK, Access
from omnistudy.view.film import film
from omnistudy.view.guard import HEADERS, Guard
from omnistudy.view.live_pages import LivePages
from omnistudy.view.page import replay_page, saying_page, trials_page
from omnistudy.view.trials import trial_list

STATUSES: dict[type[OmnistudyError], int] = {
    NoSuchTrial: 404,
    NothingToShow: 404,
    StudyBusy: 503,
    DatabaseTooOld: 503,
}
"""What is not there is 404, what will be there later 503."""


def application(
    study: Path, access: Access, *, answering: bool = False, unmask: bool = False
) -> Starlette:
    """Give the pages of a study as an application.

    answering : what pages of a live trial answer is told to the session.
    unmask : conditions are called by name; otherwise by masked labels alone.
    """
    live = LivePages(study, answering=answering, unmask=unmask)

    def trials(request: Request) -> HTMLResponse:
        with open_study(study) as opened:
            return HTMLResponse(trials_page(trial_list(opened, unmask=unmask)), headers=HEADERS)

    def replay(request: Request) -> HTMLResponse:
        numbers = request.path_params.values()
        with open_study(study) as opened:
            films = [film(opened, number, unmask=unmask) for number in numbers]
        return HTMLResponse(replay_page(films), headers=HEADERS)

    return Starlette(
        routes=[
            Route("/", trials),
            Route("/trial/{trial:int}", replay),
            Route("/trial/{trial:int}/{beside:int}", replay),
            *live.routes,
        ],
        middleware=[Middleware(Guard, access=access)],
        exception_handlers={OmnistudyError: _told, 404: _nowhere},
    )


def serve(
    study: Path,
    *,
    host: str = LOOPBACK[0],
    port: int = 0,
    token: str | None = None,
    answering: bool = False,
    unmask: bool = False,
    ready: Callable[[str], object],
) -> None:
    """Serve a study's pages until interrupted; `ready` is told their address, with the token.

    port : 0 takes a free one. token : made up unless given. Raises AddressTaken.
    """
    with open_study(study):
        pass  # what is wrong with the file is said now, not by the first page
    chosen = token or secrets.token_urlsafe(24)
    try:
        listening = socket.create_server((host, port))
    except OSError as refused:
        raise AddressTaken(host, port, refused.strerror or str(refused)) from refused
    hosts = LOOPBACK if host in LOOPBACK else (*LOOPBACK, host)
    pages = application(study, Access(chosen, hosts), answering=answering, unmask=unmask)
    config = uvicorn.Config(pages, log_level="warning", access_log=False)
    with listening:
        ready(f"http://{host}:{listening.getsockname()[1]}/?token={chosen}")
        uvicorn.Server(config).run(sockets=[listening])


async def _told(request: Request, mistake: Exception) -> HTMLResponse:
    """Say what is wrong in the words of the command line."""
    status = next((code for kind, code in STATUSES.items() if isinstance(mistake, kind)), 500)
    return HTMLResponse(saying_page("This cannot be shown", str(mistake)), status, HEADERS)


async def _nowhere(request: Request, mistake: Exception) -> HTMLResponse:
    text = f"There is no page {request.url.path} here: the study's trials are listed on the first."
    return HTMLResponse(saying_page("No such page", text), 404, HEADERS)
