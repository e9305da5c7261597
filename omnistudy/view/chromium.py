"""A headless Chromium that loads pages and makes pictures of them, by the DevTools protocol."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import time
from base64 import b64decode
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from websockets.sync.client import ClientConnection, connect

from omnistudy.errors.view import BrowserFailed, NoBrowser

PROGRAMS = ("chromium", "chromium-browser", "google-chrome", "chrome")
FLAGS = (
    "--headless=new",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-quic",
    "--disable-background-timer-throttling",
    "--disable-backgrounding-occluded-windows",
    "--disable-renderer-backgrounding",
    "--hide-scrollbars",
    "--remote-debugging-port=0",
)
"""A picture must not depend on the machine's graphics card, so drawing is done in software."""

PATIENCE_S = 60.0
"""How long a page may take for anything that is asked of it."""


class Tab:
    """One page of the browser."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection = connection
        self._number = 0
        self.faults: list[str] = []
        """What the page complained of: exceptions that nothing caught."""

    def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Send a command of the protocol and give its result; raises BrowserFailed."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        self._connection.send(json.dumps(message))
        while True:
            try:
                answer = json.loads(self._connection.recv(timeout=PATIENCE_S))
            except TimeoutError as late:
                raise BrowserFailed(f"{method}: no answer for {PATIENCE_S:.0f} s") from late
            if answer.get("method") == "Runtime.exceptionThrown":
                thrown = answer["params"]["exceptionDetails"]
                self.faults.append(thrown.get("exception", {}).get("description", thrown["text"]))
            if answer.get("id") == self._number:
                if "error" in answer:
                    raise BrowserFailed(f"{method}: {answer['error']['message']}")
                result: dict[str, Any] = answer["result"]
                return result

    def open(self, address: str) -> None:
        """Load a page and wait until it is there."""
        self.ask("Page.navigate", url=address)
        self.wait_for("document.readyState === 'complete' && location.href !== 'about:blank'")

    def value(self, expression: str) -> Any:
        """Give what a JavaScript expression comes to; a promise is awaited."""
        answer = self.ask(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise BrowserFailed(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def wait_for(self, expression: str, patience: float = PATIENCE_S) -> None:
        """Wait until an expression is true, at most `patience` s; raises BrowserFailed."""
        end = time.monotonic() + patience
        while not self.value(expression):
            if time.monotonic() > end:
                raise BrowserFailed(f"waited {patience:.0f} s in vain for {expression}")
            time.sleep(0.02)

    def resize(self, width: int, height: int) -> None:
        """Give the page a size in pixels."""
        self.ask(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )

    def picture(self) -> bytes:
        """Give what is to be seen as PNG."""
        shot = self.ask("Page.captureScreenshot", format="png")
        return b64decode(shot["data"])


class Browser:
    """A running Chromium with tabs."""

    def __init__(self, address: str, connections: ExitStack) -> None:
        self._address = address
        self._connections = connections
        self._control = Tab(self._connected(address))

    def tab(self, width: int = 1280, height: int = 800) -> Tab:
        """Open a page of a size in pixels in a window of its own: hidden ones draw nothing."""
        made = self._control.ask("Target.createTarget", url="about:blank", newWindow=True)
        host = self._address.split("/devtools/")[0]
        tab = Tab(self._connected(f"{host}/devtools/page/{made['targetId']}"))
        for domain in ("Page", "Runtime"):
            tab.ask(f"{domain}.enable")
        tab.ask("Emulation.setFocusEmulationEnabled", enabled=True)
        tab.resize(width, height)
        return tab

    def _connected(self, address: str) -> ClientConnection:
        line = connect(address, max_size=None, proxy=None, ping_interval=None)  # on this machine
        return self._connections.enter_context(line)


@contextmanager
def browser(flags: tuple[str, ...] = FLAGS) -> Iterator[Browser]:
    """Start a Chromium and end it again; raises NoBrowser, BrowserFailed."""
    program = next((path for name in PROGRAMS if (path := shutil.which(name))), None)
    if program is None:
        raise NoBrowser(PROGRAMS)
    with TemporaryDirectory(prefix="omnistudy-browser-", ignore_cleanup_errors=True) as folder:
        confined = () if os.name == "nt" or os.geteuid() else ("--no-sandbox",)
        command = [program, *flags, *confined, f"--user-data-dir={folder}", "about:blank"]
        log = Path(folder) / "log"
        with log.open("wb") as written:
            process = subprocess.Popen(command, stderr=written, stdout=subprocess.DEVNULL)
        try:
            with ExitStack() as connections:
                yield Browser(_address(process, log), connections)
        finally:
            process.terminate()
            process.wait()


def _address(process: subprocess.Popen[bytes], log: Path) -> str:
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end and process.poll() is None:
        text = log.read_text(encoding="utf-8", errors="replace")
        if found := re.search(r"DevTools listening on (ws://\S+)", text):
            return found[1]
        time.sleep(0.02)
    raise BrowserFailed("Chromium did not start: " + log.read_text(errors="replace")[-300:])
