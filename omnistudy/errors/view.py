"""Mistakes with what is to be seen in a browser."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError


class NothingToShow(OmnistudyError):
    """A trial that holds no samples."""

    def __init__(self, study: str, trial: int, status: str) -> None:
        super().__init__(
            f"trial {trial} of study '{study}' is {status} and has no samples to show: run it "
            f"first with `omnistudy session run {study}`, or choose one that was run"
        )


class PageExists(OmnistudyError):
    """A page that would overwrite a file which is none of ours."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"'{path}' exists and is no page of `omnistudy replay`: give another name with -o"
        )


class NoFolderForPage(OmnistudyError):
    """A page for a folder that does not exist."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"there is no folder '{path.parent}' for '{path.name}': make it first")


class NoBrowser(OmnistudyError):
    """Pictures are wanted and there is no browser to make them."""

    def __init__(self, programs: Sequence[str]) -> None:
        super().__init__(
            f"pictures are made with Chromium, and there is none here (looked for "
            f"{', '.join(programs)}): install it, or make a page with -o and open that"
        )


class BrowserFailed(OmnistudyError):
    """The browser does not do what it is asked."""

    def __init__(self, cause: str) -> None:
        super().__init__(f"the browser failed ({cause}): run the command again with --debug")


class FramesExist(OmnistudyError):
    """A folder for pictures that holds something already."""

    def __init__(self, folder: Path) -> None:
        super().__init__(
            f"'{folder}' is not empty: give another folder, or --force to write into it"
        )


class NothingInInterval(OmnistudyError):
    """An interval of a trial without a picture in it."""

    def __init__(self, begin: float, end: float) -> None:
        super().__init__(
            f"nothing lies between {begin:g} s and {end:g} s of the trial: give a --from below "
            "--to, both within the trial"
        )


class NoVideoProgram(OmnistudyError):
    """A video is wanted and there is nothing to make it with."""

    def __init__(self) -> None:
        super().__init__(
            "a video is made with the program ffmpeg, and there is none here: install it, or write "
            "pictures with --frames"
        )


class VideoFailed(OmnistudyError):
    """Ffmpeg refused."""

    def __init__(self, file: Path, cause: str) -> None:
        super().__init__(
            f"ffmpeg could not make '{file}' ({cause}): give a name such as trial.mp4 in a folder "
            "that is yours"
        )


class TooManyTrials(OmnistudyError):
    """More trials than fit side by side."""

    def __init__(self, given: int) -> None:
        super().__init__(f"{given} trials were given: a page shows one, or two side by side")


class AddressTaken(OmnistudyError):
    """A server that may not listen where it was told to."""

    def __init__(self, host: str, port: int, cause: str) -> None:
        super().__init__(
            f"nothing can be served at {host}, port {port} ({cause}): give another --port, or 0 "
            "for a free one, and a --host that is this machine's"
        )


class ServerFailed(OmnistudyError):
    """The server of a live session's pages did not start."""

    def __init__(self) -> None:
        super().__init__(
            "the server of the pages did not start: try `omnistudy view STUDY`, which says why"
        )


class NoScreenSentences(OmnistudyError):
    """A participant's screen in a language whose sentences the study does not hold."""

    def __init__(self, study: Path, language: str) -> None:
        super().__init__(
            f"the protocol of '{study}' holds no sentences for the participant's screen in "
            f"language '{language}': create the study anew with messages.screen and "
            "messages.pages, as conf/messages/en.yaml has them"
        )
