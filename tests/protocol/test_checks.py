"""Every line of bad input that a protocol can hold, and that all of them are told at once."""

from __future__ import annotations

import pytest
from protocol_page import changed_protocol

from omnistudy.errors.protocol import ProtocolFaults
from omnistudy.protocol.compose import compose_protocol


def faults(*changes: str) -> tuple[str, ...]:
    with pytest.raises(ProtocolFaults) as caught:
        changed_protocol(*changes)
    return caught.value.faults


def test_the_page_itself_has_no_faults() -> None:
    assert changed_protocol().name == "utah2017_component"


def test_one_fault_is_one_sentence_that_names_the_file() -> None:
    with pytest.raises(ProtocolFaults) as caught:
        compose_protocol("utah2017_component", ["law.stifness=3"])
    assert "utah2017_component.yaml: law.stifness: unknown key" in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("override", "beginning", "end"),
    [
        ("law.stifness=3", "law.stifness: unknown key", "did you mean 'stiffness'?"),
        ("plnt.mass=3", "plnt: unknown key", "did you mean 'plant'?"),
        ("law.boundary.layerx=1", "law.boundary.layerx: unknown key", "did you mean 'layer_x'?"),
        (
            "law.stiffness.x='10 N'",
            "law.stiffness.x: given '10 N', but a plain number in N/m is needed",
            "without a unit",
        ),
        ("law.boundary.layer_x=-1", "law.boundary.layer_x: given -1, but it should be", "(in m)"),
        ("participants.count=0", "participants.count: given 0, but it should be", "equal to 1"),
        (
            "session.longest=4000",
            "session.longest: given 4000",
            "less than or equal to 3600 (in s)",
        ),
        ("law.kind=componnt", "law: unknown kind 'componnt'", "did you mean 'component'?"),
        ("order.kind=latn", "order: unknown kind 'latn'", "did you mean 'latin'?"),
        ("~plant.kind", "plant: a mapping with 'kind' is needed", "youbot"),
        ("~participants", "participants: is missing", "no default"),
        ("recording.sample_hz=7", "recording: given", "must divide physics_hz 240"),
        ("world.start.x=0.9", "world: the robot starts in wall 'wall_05'", "m"),
        ("routes=[red-gren-blue]", "routes: world 'utah2017' has no route", "'red-green-blue'?"),
        (
            "~conditions.full.levels.torque",
            "conditions.full.levels: no level of factor 'torque'",
            "one of without, with",
        ),
        (
            "conditions.full.levels.torque=wth",
            "conditions.full.levels.torque: unknown level 'wth'",
            "did you mean 'with'?",
        ),
        (
            "conditions.full.levels.torq=with",
            "conditions.full.levels.torq: unknown factor",
            "did you mean 'torque'?",
        ),
        (
            "conditions.full.levels.torque=on",
            "conditions.full.levels.torque.level: given True",
            "YAML reads on, off, yes and no as truth",
        ),
        (
            "conditions.full.masked_label=A",
            "conditions: 2 conditions share the masked_label 'A'",
            "make it unique",
        ),
        ("order.last=[]", "order: condition 'centre_front_10' is never met", "take it out"),
        ("order.blocks=[nne,full]", "order: unknown condition 'nne'", "did you mean 'none'?"),
        ("session.longest=2000", "session.longest: a session is expected to last", "pauses"),
        ("participants.study_key=''", "participants.study_key: virtual", "any text that stays"),
        ("site.ethics.note=''", "site.ethics.note: say why", "needed"),
        ("site.ethics.status=approved", "site.ethics: an approval needs", "its number"),
    ],
)
def test_each_fault_says_where_what_and_what_is_allowed(
    override: str, beginning: str, end: str
) -> None:
    first = faults(override)[0]
    assert first.startswith(beginning)
    assert first.endswith(end)


def test_a_route_through_a_closed_wall_is_found() -> None:
    wall = "{name: barrier, ends: [[-0.6, 4.5], [0.6, 4.5]]}"
    found = faults(f"world.walls.lines=[{wall}]")
    assert any("leads through wall 'barrier'" in fault for fault in found)


def test_people_need_an_approval_and_have_no_key_in_the_protocol() -> None:
    assert [fault.split(":")[0] for fault in faults("participants.kind=human")] == [
        "participants.study_key",
        "participants.participant_key",
        "site.ethics.status",
    ]


def test_every_fault_is_told_in_one_run() -> None:
    found = faults(
        "law.stifness=3",
        "participants.count=0",
        "routes=[rgb]",
        "plnt.mass=3",
        "conditions.full.law={gain: 1}",
        "order.blocks=[nne,full]",
        "world.start.x=0.9",
    )
    for part in ("law.stifness", "participants.count", "plnt", "conditions.full.law.gain"):
        assert any(fault.startswith(part) for fault in found), part
    assert any("no route 'rgb'" in fault for fault in found)
    assert any("unknown condition 'nne'" in fault for fault in found)
    assert len(found) == len(set(found))


def test_a_fault_that_conditions_inherit_is_told_once() -> None:
    assert len(faults("law.stifness=3")) == 1


def test_a_fault_of_a_condition_alone_names_the_condition() -> None:
    (fault,) = faults("conditions.centre_rear_10.law.compliance_center=1")
    assert fault.startswith("conditions.centre_rear_10.law.compliance_center: unknown key")
    assert fault.endswith("did you mean 'compliance_centre'?")


def test_a_robot_that_is_too_wide_is_told_in_a_few_lines() -> None:
    found = faults("plant.half_width=0.6")
    assert len(found) == 6
    assert found[-1].endswith("`omnistudy world check utah2017` tells them all")


HUMAN = (
    "participants.kind=human",
    "participants.study_key=''",
    "participants.participant_key=''",
    "site.ethics.status=approved",
    "site.ethics.board=IRB",
    "site.ethics.number=A1",
)


@pytest.mark.parametrize(
    ("override", "fault"),
    [
        ("~messages.screen", "messages.screen: people look at a screen"),
        ("~messages.pages", "messages.pages: people look at a screen"),
        ("~messages.pages.consent.agree", "messages.pages.consent.agree: is missing"),
        ("~messages.pages.survey", "messages.pages.survey: is missing"),
        ("~messages.screen.stop", "messages.screen.stop: is missing"),
        (
            "messages.pages.survey.step='Item {number}'",
            "messages.pages.survey.step: given 'Item {number}', but the sentence must hold",
        ),
        ("~messages.blocks.green", "messages.blocks.green: world 'utah2017' has this block"),
    ],
)
def test_a_sentence_that_a_language_lacks_is_found(override: str, fault: str) -> None:
    (found,) = faults(*HUMAN, override)
    assert found.startswith(fault)
    if "is missing" not in fault and "given" not in fault:
        assert "language 'en'" in found


def test_a_complete_language_has_no_faults() -> None:
    protocol = compose_protocol("utah2017_component", ["messages=de", *HUMAN])
    assert protocol.messages.language == "de"
