"""`list` and `show` of every noun whose things are kinds."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

from omnistudy.cli.app import main
from omnistudy.registry import kinds

NOUNS = ("law", "controller", "plant", "device", "task", "operator", "order")
EVERY_KIND = [(noun, kind) for noun in NOUNS for kind in kinds(f"{noun}s")]


@pytest.fixture(autouse=True)
def _no_lab(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str
) -> Any:
    assert run(monkeypatch, *arguments, "--json") == 0
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize("noun", NOUNS)
def test_a_list_names_every_kind_and_every_page(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], noun: str
) -> None:
    listed = told(monkeypatch, capsys, noun, "list")
    assert [row["kind"] for row in listed["kinds"]] == list(kinds(f"{noun}s"))
    assert all(Path(row["file"]).is_file() for row in listed["pages"])
    assert run(monkeypatch, noun, "list") == 0
    printed = capsys.readouterr().out
    assert all(kind in printed for kind in kinds(f"{noun}s"))
    assert "\x1b" not in printed


@pytest.mark.parametrize(("noun", "kind"), EVERY_KIND)
def test_every_kind_is_shown_to_people_and_to_programs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], noun: str, kind: str
) -> None:
    shown = told(monkeypatch, capsys, noun, "show", kind)
    assert shown["kind"] == kind
    assert all(row.keys() >= {"default", "unit", "meaning"} for row in shown["parameters"])
    assert run(monkeypatch, noun, "show", kind) == 0
    printed = capsys.readouterr().out
    assert shown["summary"] in printed
    assert all(row["name"] in printed for row in shown["parameters"])


def test_a_page_shows_what_it_sets_beside_its_kinds_defaults(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = told(monkeypatch, capsys, "operator", "show", "virtual_driver")
    defaults = {row["name"]: row["default"] for row in shown["parameters"]}
    sets = shown["page"]["sets"]
    assert set(sets) == {"skill_median", "skill_spread"}
    assert sets["skill_median"] != defaults["skill_median"]
    assert run(monkeypatch, "operator", "show", "virtual_driver") == 0
    assert str(sets["skill_median"]) in capsys.readouterr().out


def test_a_lab_page_of_another_name_is_shown_as_its_kind(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (tmp_path / "law").mkdir()
    (tmp_path / "law" / "stiff.yaml").write_text("kind: component\nstiffness: {x: 400}\n")
    shown = told(monkeypatch, capsys, "--conf", str(tmp_path), "law", "show", "stiff")
    assert shown["kind"] == "component"
    assert shown["page"] == {
        "file": str(tmp_path / "law" / "stiff.yaml"),
        "sets": {"stiffness.x": 400},
    }


def test_what_has_no_default_must_be_given(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = told(monkeypatch, capsys, "operator", "show", "recorded")
    required = [row["name"] for row in shown["parameters"] if row["required"]]
    assert required == ["file"]
    assert run(monkeypatch, "operator", "show", "recorded") == 0
    # once as a parameter, once in our page, which leaves it open
    assert capsys.readouterr().out.count("must be given") == 2


@pytest.mark.parametrize(
    ("noun", "kind", "channel"),
    [
        ("plant", "youbot", {"name": "omega", "unit": "rad/s", "meaning": "turning rate"}),
        (
            "device",
            "simulated_stick",
            {"name": "stick_x", "unit": "m", "meaning": "handle's travel, forward"},
        ),
    ],
)
def test_plants_and_devices_name_their_channels(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    noun: str,
    kind: str,
    channel: dict[str, str],
) -> None:
    assert channel in told(monkeypatch, capsys, noun, "show", kind)["channels"]
    assert run(monkeypatch, noun, "show", kind) == 0
    assert channel["meaning"] in capsys.readouterr().out


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        ("law show zero", ["zero_torque"]),
        ("law probe zero", ["zero_torque"]),
        ("operator show virt", ["virtual_driver"]),
        ("order show lat", ["latin"]),
        ("plant show you", ["youbot"]),
        ("survey show ut", ["utah2017"]),
    ],
)
def test_the_shell_completes_names(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    typed: str,
    offered: list[str],
) -> None:
    words = f"omnistudy {typed}"
    monkeypatch.setenv("_OMNISTUDY_COMPLETE", "complete_bash")
    monkeypatch.setenv("COMP_WORDS", words)
    monkeypatch.setenv("COMP_CWORD", str(words.count(" ")))
    run(monkeypatch)
    assert capsys.readouterr().out.split() == offered


@pytest.mark.parametrize("noun", NOUNS)
def test_an_unknown_name_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], noun: str
) -> None:
    kind = kinds(f"{noun}s")[0]
    assert run(monkeypatch, noun, "show", f"{kind}x") == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert f"did you mean '{kind}'" in said
