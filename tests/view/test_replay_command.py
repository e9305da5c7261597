"""`omnistudy replay`: a page, pictures, a video."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image

from omnistudy.cli.app import main
from omnistudy.view.filming import Filming


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_the_page_is_named_after_study_and_trials(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    driven_study: Path,
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(monkeypatch, "replay", driven_study, 1, 2, "--json") == 0
    told = json.loads(capsys.readouterr().out)
    assert told["page"] == "seen_trial_1_2.html"
    assert [trial["trial"] for trial in told["trials"]] == [1, 2]
    assert (tmp_path / "seen_trial_1_2.html").is_file()


def test_names_of_conditions_are_told_to_those_who_ask(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    driven_study: Path,
    tmp_path: Path,
) -> None:
    """The first trial's condition is `none`, masked A."""
    monkeypatch.chdir(tmp_path)
    assert run(monkeypatch, "replay", driven_study, 1, "--json") == 0
    masked = json.loads(capsys.readouterr().out)["trials"][0]
    assert masked["label"] == "A"
    assert "condition" not in masked
    assert run(monkeypatch, "replay", driven_study, 1, "--json", "--unmask") == 0
    named = json.loads(capsys.readouterr().out)["trials"][0]
    assert named["condition"] == "none"
    assert "label" not in named


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("1", "2", "1"), "3 trials were given: a page shows one, or two side by side"),
        (("99",), "has no trial 99"),
        (("3",), "is planned and has no samples to show"),
        (("1", "--frames", "pictures", "--from", "5", "--to", "4"), "give a --from below --to"),
        (("1", "-o", "nowhere/page.html"), "there is no folder"),
    ],
)
def test_what_cannot_be_shown_is_said(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    driven_study: Path,
    tmp_path: Path,
    arguments: tuple[str, ...],
    told: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(monkeypatch, "replay", driven_study, *arguments) == 1
    assert told in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_pictures_are_taken_at_equal_steps_up_to_the_end() -> None:
    assert Filming(2.0, 3.0, rate=4.0).times == (2.0, 2.25, 2.5, 2.75, 3.0)
    assert Filming(2.0, 2.1, rate=4.0).times == (2.0,)
    assert Filming(3.0, 2.0).times == ()


@pytest.mark.slow
def test_pictures_and_video_show_the_trial_and_replace_nothing(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    driven_study: Path,
    tmp_path: Path,
    requires_program: Callable[[str, str], str],
) -> None:
    requires_program("chromium", "chromium")
    requires_program("ffmpeg", "ffmpeg")
    monkeypatch.chdir(tmp_path)
    film = ("replay", driven_study, 1, "--from", "2", "--to", "6", "--rate", "0.5")
    made = ("--frames", "pictures", "--video", "trial.mp4")
    assert run(monkeypatch, *film, *made) == 0
    pictures = sorted((tmp_path / "pictures").iterdir())
    assert [file.name for file in pictures] == [f"frame_0000{n}.png" for n in (1, 2, 3)]
    with Image.open(pictures[0]) as first, Image.open(pictures[2]) as last:
        assert first.size == (1280, 720)
        assert first.tobytes() != last.tobytes()
    probe = ["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames"]
    counted = subprocess.run([*probe, "trial.mp4"], capture_output=True, text=True, check=True)
    assert "nb_read_frames=3" in counted.stdout
    capsys.readouterr()
    assert run(monkeypatch, *film, *made[:2]) == 1
    assert "'pictures' is not empty" in capsys.readouterr().err
    assert run(monkeypatch, *film, *made[2:]) == 1
    assert "trial.mp4 exists already" in capsys.readouterr().err
