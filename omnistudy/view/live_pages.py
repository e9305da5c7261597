"""The pages of a live trial: the participant's screen, the experimenter's monitor, their data."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from omnistudy.channel import LatestValue
from omnistudy.devices.handheld.keyboard import keys_file
from omnistudy.errors.view import NoScreenSentences
from omnistudy.store import open_study
from omnistudy.study.frozen import frozen_protocol
from omnistudy.view.answer import Answer, Lag, Said
from omnistudy.view.guard import HEADERS
from omnistudy.view.held_keys import HeldKeys
from omnistudy.view.live_files import answer_file, state_file
from omnistudy.view.live_setting import live_setting
from omnistudy.view.page import live_page
from omnistudy.view.screen_lag import ScreenLag
from omnistudy.view.state_source import StateSource

PERIOD_S = 1 / 60
SILENCE_S = 0.5
"""After so long without news a page is told that there is none."""


class LivePages:
    """Routes of live pages. Each connection takes the latest state when it is ready for one."""

    def __init__(self, study: Path, *, answering: bool, unmask: bool) -> None:
        self._study = study
        self._answering = answering
        self._unmask = unmask
        self._answer = Answer()
        self._screen_lag = ScreenLag()
        self._told_at = 0.0
        self._keys = HeldKeys()

    @property
    def routes(self) -> list[BaseRoute]:
        """What is to be had, and where."""
        return [
            Route("/participant", self._participant),
            Route("/monitor", self._monitor),
            Route("/setting/{trial:int}", self._setting),
            WebSocketRoute("/live", self._live),
        ]

    def _participant(self, request: Request) -> HTMLResponse:
        with open_study(self._study) as opened:
            protocol = frozen_protocol(opened.study)
        messages = protocol.messages
        if messages.screen is None or messages.pages is None:
            raise NoScreenSentences(self._study, messages.language)
        content = {
            "language": messages.language,
            "screen": messages.screen.model_dump(),
            "pages": messages.pages.model_dump(),
            "blocks": {block.name: block.word for block in messages.blocks},
            "eye": protocol.site.first_person.model_dump(),
            "scanning": protocol.site.scanning.model_dump(),
        }
        page = live_page("participant", messages.screen.scene, content)
        return HTMLResponse(page, headers=HEADERS)

    def _monitor(self, request: Request) -> HTMLResponse:
        with open_study(self._study) as opened:
            name = opened.study.name
        return HTMLResponse(live_page("monitor", f"Monitor of {name}", {}), headers=HEADERS)

    def _setting(self, request: Request) -> Response:
        with open_study(self._study) as opened:
            found = live_setting(opened, request.path_params["trial"], unmask=self._unmask)
        return Response(found.model_dump_json(), headers=HEADERS, media_type="application/json")

    async def _live(self, socket: WebSocket) -> None:
        await socket.accept()
        ready = asyncio.Event()
        ready.set()
        hearing = asyncio.create_task(self._hear(socket, ready))
        with suppress(WebSocketDisconnect, RuntimeError):
            await self._tell(socket, hearing, ready)
        hearing.cancel()
        self._hold(id(socket), ())

    async def _tell(
        self, socket: WebSocket, hearing: asyncio.Task[None], ready: asyncio.Event
    ) -> None:
        """Send the latest state once the page has taken the one before.

        A slow page so misses some; without being asked, it would get old ones out of a queue.
        """
        source = StateSource(state_file(self._study))
        sent, at = 0, 0.0
        while not hearing.done():
            found = source.latest()
            now = time.monotonic()
            newer = found is not None and found.number != sent
            if found and newer and ready.is_set():
                ready.clear()
                sent, at = found.number, now
                lag = self._answer.lag
                told = lag.model_dump_json() if lag else "null"
                await socket.send_text(f'{{"state":{found.data.decode()},"lag":{told}}}')
            elif not newer and now - at > SILENCE_S:
                at = now
                await socket.send_text('{"state":null,"lag":null}')
            await asyncio.sleep(PERIOD_S)
        source.close()

    async def _hear(self, socket: WebSocket, ready: asyncio.Event) -> None:
        """Take what a page answers until it is gone."""
        with suppress(WebSocketDisconnect):
            while True:
                said = json.loads(await socket.receive_text())
                if "stop" in said:
                    self._say(stop=int(said["stop"]))
                if "said" in said:
                    self._say(said=Said.model_validate(said["said"]))
                if "keys" in said:
                    self._hold(id(socket), tuple(map(str, said["keys"])))
                if "took" in said:
                    ready.set()
                if "clock" in said:
                    told = {"clock": said["clock"], "at": time.monotonic()}
                    await socket.send_text(json.dumps(told))
                if "drawn" in said:
                    self._drew(said)

    def _drew(self, said: Mapping[str, float]) -> None:
        """Count a frame of the participant's screen, and tell the session now and then."""
        self._screen_lag.drew(int(said["trial"]), said["drawn"], said["at"], said["within"])
        if time.monotonic() - self._told_at > SILENCE_S:
            self._told_at = time.monotonic()
            self._say(lag=self._screen_lag.lag())

    def _hold(self, page: int, codes: tuple[str, ...]) -> None:
        """Tell the device which keys are held; a session without pages yet has no such file."""
        held = self._keys.hold(page, codes)
        if self._answering and keys_file(self._study).exists():
            with LatestValue(keys_file(self._study)) as keys:
                keys.write(held)

    def _say(
        self, stop: int | None = None, lag: Lag | None = None, said: Said | None = None
    ) -> None:
        """Tell the session."""
        if not self._answering:
            return
        self._answer = Answer(
            stop=self._answer.stop if stop is None else stop,
            lag=lag or self._answer.lag,
            said=said or self._answer.said,
        )
        with LatestValue(answer_file(self._study)) as answer:
            answer.write(self._answer.model_dump_json().encode())
