from __future__ import annotations

from pathlib import Path

import pytest
from hydra.core.global_hydra import GlobalHydra

from omnistudy.controllers.rate import RateController
from omnistudy.errors.protocol import ProtocolFaults, UnknownProtocol
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.protocol import Protocol, freeze
from omnistudy.protocol.compose import compose_protocol, listed_protocols, protocol_pages


def law(protocol: Protocol, condition: str = "full") -> ComponentLaw:
    found = protocol.setup_for(condition).law
    assert isinstance(found, ComponentLaw)
    return found


def test_two_composes_in_one_process_agree_and_leave_nothing_behind(lab: Path) -> None:
    first = compose_protocol("utah2017_component")
    other = compose_protocol("utah2017_arm_stiffness")
    again = compose_protocol("utah2017_component")
    assert freeze(first) == freeze(again)
    assert other.name == "utah2017_arm_stiffness"
    assert not GlobalHydra.instance().is_initialized()
    assert list(Path.cwd().iterdir()) == []


def test_a_value_that_no_page_wrote_can_be_set() -> None:
    protocol = compose_protocol("utah2017_component", ["law.stiffness.x=100", "session.pause=10"])
    assert law(protocol).stiffness.x == 100.0
    assert law(protocol, "centre_rear_10").stiffness.x == 100.0
    assert protocol.session.pause == 10.0


def test_a_page_of_a_group_can_be_chosen() -> None:
    assert isinstance(compose_protocol("utah2017_arm_stiffness", ["law=none"]).law, NoLaw)


def test_a_condition_writes_only_what_differs(component: Protocol) -> None:
    changed = component.setup_for("centre_front_20")
    assert law(component, "centre_front_20").compliance_centre == 0.20
    assert isinstance(changed.controller, RateController)
    assert changed.controller.compliance_centre == 0.20
    assert law(component, "centre_front_20").stiffness == law(component).stiffness
    assert changed.plant == component.plant


def test_another_kind_replaces_a_part_whole(component: Protocol) -> None:
    assert component.setup_for("none").law == NoLaw()


def test_a_mapping_for_a_group_is_laid_over_its_page() -> None:
    protocol = compose_protocol("utah2017_component", ["law={compliance_centre: 0.3}"])
    assert law(protocol).compliance_centre == 0.3


def test_a_file_that_is_no_text_is_one_sentence(lab: Path) -> None:
    page = lab / "page.yaml"
    page.write_bytes(b"name: \xff\xfe")
    with pytest.raises(ProtocolFaults, match="cannot be read as text"):
        compose_protocol(page)


def test_the_labs_page_of_the_same_name_wins(lab: Path) -> None:
    (lab / "law").mkdir()
    (lab / "law" / "component.yaml").write_text(
        "kind: component\nstiffness: {x: 1, y: 2, theta: 3}"
    )
    protocol = compose_protocol("utah2017_component", lab=lab)
    assert tuple(law(protocol).stiffness.model_dump().values()) == (1.0, 2.0, 3.0)
    assert compose_protocol("utah2017_component") != protocol


def test_the_environment_names_the_lab_too(lab: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (lab / "recording").mkdir()
    (lab / "recording" / "default.yaml").write_text("sample_hz: 60\n")
    monkeypatch.setenv("OMNISTUDY_CONF", str(lab))
    assert compose_protocol("utah2017_component").recording.sample_hz == 60


def test_a_labs_protocol_may_build_on_ours(lab: Path) -> None:
    (lab / "protocols").mkdir()
    page = lab / "protocols" / "pilot.yaml"
    page.write_text(
        "defaults: [utah2017_component, _self_]\n"
        "name: pilot\n"
        "participants: {count: 2}\n"
        "conditions: {full: {law: {compliance_centre: 0.05}}}\n"
    )
    pilot = compose_protocol("pilot", lab=lab)
    assert (pilot.name, pilot.participants.count) == ("pilot", 2)
    assert law(pilot).compliance_centre == 0.05
    assert protocol_pages(lab)["pilot"] == page
    assert compose_protocol(page) == pilot


def test_an_installed_protocol_is_found_from_any_folder(lab: Path) -> None:
    assert {entry.name for entry in listed_protocols()} >= {
        "utah2017_component",
        "utah2017_arm_stiffness",
    }


def test_an_unknown_protocol_is_answered_with_the_nearest_name() -> None:
    with pytest.raises(UnknownProtocol, match="did you mean 'utah2017_component'"):
        compose_protocol("utah2017_componnt")


@pytest.mark.parametrize(
    ("page", "sentence"),
    [
        ("defaults: [law: componnt, _self_]", "'law' has no page 'componnt'.*mean 'component'"),
        ("defaults: [lw: component, _self_]", "there is no page 'lw/component'"),
        ("name: ${nme}", "name: Interpolation key 'nme' not found"),
        ("name: [a", "page.yaml, line 1: expected ',' or ']'"),
        ("name: a\nname: b", "page.yaml, line 2: found duplicate key name"),
        ("name: ???", "Missing mandatory value: name"),
        ("defaults: [law: component]\nname: a", "last line of the list must be '- _self_'"),
        ("- name", "must be a DictConfig"),
    ],
)
def test_what_hydra_refuses_is_one_sentence(lab: Path, page: str, sentence: str) -> None:
    file = lab / "page.yaml"
    file.write_text(page)
    with pytest.raises(ProtocolFaults, match=sentence) as caught:
        compose_protocol(file)
    assert str(caught.value).startswith(f"{file}: ")
    assert "\n" not in str(caught.value)
    assert not GlobalHydra.instance().is_initialized()


@pytest.mark.parametrize("override", ["law.stiffness.x", "law.boundary=[1"])
def test_a_bad_override_is_one_sentence(override: str) -> None:
    with pytest.raises(ProtocolFaults, match="is no override: write key=value"):
        compose_protocol("utah2017_component", [override])
