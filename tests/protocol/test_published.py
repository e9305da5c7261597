"""The two protocols that come with omnistudy say what the thesis says."""

from __future__ import annotations

from omnistudy.controllers.rate import RateController
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.laws.zero_torque import ZeroTorqueLaw
from omnistudy.operators.virtual_driver import VirtualDriver
from omnistudy.protocol import Protocol, plan
from omnistudy.protocol.compose import compose_protocol
from omnistudy.protocol.schedule import schedule, session_duration


def test_eight_people_drive_ten_trials_in_at_most_an_hour(component: Protocol) -> None:
    assert component.participants.count == 8
    assert component.session.longest == 3600.0
    assert session_duration(component) <= 3600.0
    for slot in range(8):
        assert len(plan(component, slot)) == 10


def test_six_conditions_have_the_laws_of_the_thesis(component: Protocol) -> None:
    laws = {own.name: component.setup_for(own.name).law for own in component.conditions}
    assert isinstance(laws["none"], NoLaw)
    assert isinstance(laws["zero_torque"], ZeroTorqueLaw)
    centres = {
        name: law.compliance_centre for name, law in laws.items() if type(law) is ComponentLaw
    }
    assert centres == {
        "full": 0.0,
        "centre_front_10": 0.10,
        "centre_front_20": 0.20,
        "centre_rear_10": -0.10,
    }


def test_the_compliance_centre_moves_law_and_motion_together(component: Protocol) -> None:
    for own in component.conditions:
        setup = component.setup_for(own.name)
        assert isinstance(setup.controller, RateController)
        centre = getattr(setup.law, "compliance_centre", 0.0)
        assert setup.controller.compliance_centre == centre


def test_levels_say_what_the_laws_do(component: Protocol) -> None:
    levels = {
        own.name: {level.factor: level.level for level in own.levels}
        for own in component.conditions
    }
    assert levels["none"] == {"feedback": "without", "torque": "without", "compliance_centre": "0"}
    assert levels["full"] == {"feedback": "with", "torque": "with", "compliance_centre": "0"}
    assert levels["zero_torque"]["torque"] == "without"
    assert levels["centre_rear_10"]["compliance_centre"] == "-0.1"


def test_the_schedule_adds_durations_and_pauses(component: Protocol) -> None:
    first, second = schedule(component, 0)[:2]
    assert first.start_s == 0.0
    assert second.start_s == first.duration_s + 60.0


def test_the_arm_protocol_changes_the_arm_alone() -> None:
    protocol = compose_protocol("utah2017_arm_stiffness")
    quantiles = []
    for own in protocol.conditions:
        setup = protocol.setup_for(own.name)
        assert isinstance(setup.operator, VirtualDriver)
        quantiles.append(setup.operator.arm_stiffness_quantile)
        assert setup.law == protocol.law
    assert quantiles == [0.05, 0.25, 0.5, 0.75, 0.95]
    assert {trial.repetition for slot in range(8) for trial in plan(protocol, slot)} == {1}


def test_both_protocols_drive_the_same_operator_law_and_world(component: Protocol) -> None:
    stiffness = compose_protocol("utah2017_arm_stiffness")
    for part in ("world", "plant", "device", "controller", "law", "operator", "task", "recording"):
        assert getattr(stiffness, part) == getattr(component, part)
