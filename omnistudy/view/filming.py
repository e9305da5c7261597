"""Pictures of a replay, one after the other, as files or as a video."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import floor
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Literal

from omnistudy.errors.pictures import PictureExists, PictureNotWritten
from omnistudy.errors.view import FramesExist, NothingInInterval, NoVideoProgram, VideoFailed
from omnistudy.view.chromium import Tab, browser

Camera = Literal["follow", "plan", "first"]


@dataclass(frozen=True, slots=True)
class Filming:
    """How a replay is filmed: from `begin` to `end` s of the trial, `rate` pictures a second.

    width, height : of a picture in pixels; a video needs even ones.
    """

    begin: float
    end: float
    rate: float = 25.0
    camera: Camera = "follow"
    width: int = 1280
    height: int = 720

    @property
    def times(self) -> tuple[float, ...]:
        """When each picture is taken, s since the trial opened."""
        count = floor((self.end - self.begin) * self.rate + 1e-9) + 1
        return tuple(self.begin + place / self.rate for place in range(count))

    def check(self) -> None:
        """Raise NothingInInterval when no picture would be taken."""
        if not self.times:
            raise NothingInInterval(self.begin, self.end)


def film_frames(
    page: str, filming: Filming, folder: Path, *, replace: bool, done: Callable[[], object]
) -> int:
    """Write frame_00001.png and so on into a folder; gives their number.

    done : called after each picture. Raises FramesExist unless `replace`, NothingInInterval,
    PictureNotWritten, NoBrowser.
    """
    filming.check()
    if folder.exists() and any(folder.iterdir()) and not replace:
        raise FramesExist(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as refused:
        raise PictureNotWritten(folder, refused.strerror or str(refused)) from refused
    for place, picture in enumerate(_pictures(page, filming), start=1):
        (folder / f"frame_{place:05d}.png").write_bytes(picture)
        done()
    return len(filming.times)


def film_video(
    page: str, filming: Filming, file: Path, *, replace: bool, done: Callable[[], object]
) -> int:
    """Write a video; gives the number of its pictures.

    Raises NoVideoProgram, PictureExists unless `replace`, NothingInInterval, VideoFailed,
    NoBrowser.
    """
    filming.check()
    program = shutil.which("ffmpeg")
    if program is None:
        raise NoVideoProgram
    if file.exists() and not replace:
        raise PictureExists(file)
    command = [
        *(program, "-loglevel", "error", "-y"),
        *("-f", "image2pipe", "-framerate", str(filming.rate), "-i", "-"),
        *("-pix_fmt", "yuv420p", "-movflags", "+faststart", str(file)),
    ]
    with TemporaryDirectory(prefix="omnistudy-video-") as folder:
        log = Path(folder) / "log"
        with (
            log.open("wb") as written,
            subprocess.Popen(command, stdin=subprocess.PIPE, stderr=written) as process,
        ):
            assert process.stdin is not None
            try:
                for picture in _pictures(page, filming):
                    process.stdin.write(picture)
                    done()
                process.stdin.close()
            except BrokenPipeError:
                process.kill()
        if process.returncode:
            raise VideoFailed(file, log.read_text(errors="replace").strip())
    return len(filming.times)


def _pictures(page: str, filming: Filming) -> Iterator[bytes]:
    """Load the page once and let it show each time in turn."""
    with TemporaryDirectory(prefix="omnistudy-page-") as folder, browser() as running:
        file = Path(folder) / "page.html"
        file.write_text(page, encoding="utf-8")
        tab = running.tab(filming.width, filming.height)
        tab.open(f"{file.as_uri()}#bare=1&fine=1&camera={filming.camera}")
        tab.wait_for("window.replay !== undefined")
        for t in filming.times:
            yield _picture(tab, t)


def _picture(tab: Tab, t: float) -> bytes:
    tab.value(f"window.replay.seek({t!r})")
    return tab.picture()
