"""`omnistudy law` as a person types it."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

from omnistudy.cli.app import main
from omnistudy.registry import kinds, load_kind

NEWTONS = 13.5 / 255
STICK_METRES_PER_COUNT = 0.095 * 3.141592653589793 / 180 / 12
TWIST_PER_METRE = 0.003 * 0.4 / STICK_METRES_PER_COUNT
"""(m/s)/m of the published stick: 0.003 m/s a count, times 0.4."""


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", "law", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


@pytest.fixture
def post_ahead(tmp_path: Path) -> Path:
    """Something 10 cm deep dead ahead and nothing else."""
    path = tmp_path / "post.json"
    path.write_text('{"angles": [0, 1.5708], "ranges": [0.34, 0.6], "max_range": 0.6}')
    return path


def test_laws_are_listed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "list", "--json") == 0
    rows = {row["kind"]: row for row in json.loads(capsys.readouterr().out)["kinds"]}
    assert {"component", "none", "zero_torque"} <= set(rows)
    assert rows["component"]["package"] == "omnistudy"
    assert all(row["summary"].endswith(".") for row in rows.values())
    assert run(monkeypatch, "list") == 0
    assert "zero_torque" in capsys.readouterr().out


def test_parameters_are_shown_with_units(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", "component", "--json") == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)["parameters"]}
    assert rows["boundary.layer_y"]["default"] == 0.12
    assert rows["damping.y"]["unit"] == "N·s/m"
    assert run(monkeypatch, "show", "none") == 0
    assert "No feedback" in capsys.readouterr().out


def test_a_probe_gives_wrench_and_stiffness(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], post_ahead: Path
) -> None:
    found = _probed(
        monkeypatch, capsys, post_ahead, "--twist", "-0.2", "0.1", "-0.5", "--stick", "-0.02",
        "0", "0.1", "--stick-rate", "0", "-0.1", "0",
    )  # fmt: skip
    assert found["fx"] == pytest.approx((-375 + 15 * 0.2) * NEWTONS)
    assert (found["fy"], found["tau"]) == (0.0, 0.0)
    assert found["stiffness"][0] == pytest.approx([15 * NEWTONS * TWIST_PER_METRE, 0, 0])
    assert found["stiffness"][1:] == [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
    assert found["about"] == [-0.02, 0.0, 0.1]
    assert (found["kind"], found["n"]) == ("component", 1)


def test_a_probe_is_not_clipped_and_takes_settings(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], post_ahead: Path
) -> None:
    found = _probed(
        monkeypatch, capsys, post_ahead, "--set", "boundary.layer_x=0.25", "--set",
        "stiffness.x=1000",
    )  # fmt: skip
    assert found["fx"] == pytest.approx(-1000 * 0.2)


def test_a_circle_is_asked_for_by_its_kind(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], post_ahead: Path
) -> None:
    found = _probed(
        monkeypatch, capsys, post_ahead, "--set", "boundary.radius=0.4", "--set",
        "boundary.kind=circular",
    )  # fmt: skip
    assert found["fx"] == pytest.approx(-37.5 * 6 * NEWTONS)


@pytest.mark.parametrize("kind", kinds("laws"))
def test_every_kind_is_shown_and_probed_over_every_boundary_that_it_takes(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], post_ahead: Path, kind: str
) -> None:
    assert run(monkeypatch, "show", kind) == 0
    assert load_kind("laws", kind).__doc__.splitlines()[0][:20] in capsys.readouterr().out
    assert run(monkeypatch, "probe", kind, "--scan", post_ahead) == 0
    bounded = "boundary" in load_kind("laws", kind).model_fields
    for boundary in ("circular", "rectangular"):
        chosen = f"boundary.kind={boundary}"
        status = run(monkeypatch, "probe", kind, "--scan", post_ahead, "--set", chosen)
        said = capsys.readouterr()
        assert status == (0 if bounded else 1)
        assert bounded or "has no parameter 'boundary.kind'" in said.err


def _probed(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    scan: Path,
    *arguments: str,
) -> dict[str, Any]:
    assert run(monkeypatch, "probe", "component", "--scan", scan, *arguments, "--json") == 0
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return found


def test_none_gives_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], post_ahead: Path
) -> None:
    assert run(monkeypatch, "probe", "none", "--scan", post_ahead, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["fx"], found["fy"], found["tau"], found["n"]) == (0.0, 0.0, 0.0, None)


def test_a_probe_is_read_by_people_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], post_ahead: Path
) -> None:
    assert run(monkeypatch, "probe", "component", "--scan", post_ahead) == 0
    printed = capsys.readouterr().out
    assert "-19.8529" in printed
    assert "rays that touch the boundary: 1" in printed


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (["--twist", "0", "nan", "0"], 2, "three finite numbers"),
        (["--stick", "inf", "0", "0"], 2, "three finite numbers"),
        (["--twist", "0", "1"], 2, "requires 3 arguments"),
        (["--set", "boundary.layr_x=0.2"], 1, "did you mean 'boundary.layer_x'"),
        (["--set", "boundary.layer_x=-1"], 1, "boundary.layer_x = -1"),
        (["--set", "layer"], 1, "write name=value"),
        (["--set", "boundary.radius=0.4"], 1, "boundary.radius: unknown key; the keys here are"),
        (["--set", "boundary.kind=round"], 1, "unknown kind 'round': it is one of rectangular, c"),
    ],
)
def test_a_wrong_word_gets_one_sentence(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    post_ahead: Path,
    arguments: list[str],
    status: int,
    said: str,
) -> None:
    assert run(monkeypatch, "probe", "component", "--scan", post_ahead, *arguments) == status
    assert said in capsys.readouterr().err


def test_a_wrong_kind_gets_the_nearest(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", "compnent") == 1
    assert "did you mean 'component'" in capsys.readouterr().err


@pytest.mark.parametrize("suffix", [".svg", ".png"])
@pytest.mark.parametrize("one_scene", [False, True], ids=["field", "scene"])
def test_a_law_is_drawn_twice_alike_and_never_over_a_file(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    post_ahead: Path,
    suffix: str,
    one_scene: bool,
) -> None:
    scene = ["--scan", post_ahead] if one_scene else []
    first, second = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    for picture in (first, second):
        assert run(monkeypatch, "draw", "component", "-o", picture, *scene) == 0
    assert first.read_bytes() == second.read_bytes()
    assert len(first.read_bytes()) > 5000
    assert run(monkeypatch, "draw", "none", "-o", first, *scene) == 1
    assert "--force" in capsys.readouterr().err
    assert first.read_bytes() == second.read_bytes()
    assert run(monkeypatch, "draw", "none", "-o", first, "--force", *scene) == 0
    assert first.read_bytes() != second.read_bytes()


def test_several_laws_are_drawn_in_one_picture(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert run(monkeypatch, "draw", "component", "quadrant", "-o", tmp_path / "both.svg") == 0
    assert "<!-- quadrant -->" in (tmp_path / "both.svg").read_text()
    wrong = ["--set", "compliance_centre=0.1"]
    assert run(monkeypatch, "draw", "component", "quadrant", "-o", tmp_path / "c.svg", *wrong) == 1
    assert "'quadrant' has no parameter 'compliance_centre'" in capsys.readouterr().err
    assert not (tmp_path / "c.svg").exists()


def test_a_picture_needs_a_known_suffix(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert run(monkeypatch, "draw", "component", "-o", tmp_path / "a.gif") == 1
    assert ".svg or .png" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
