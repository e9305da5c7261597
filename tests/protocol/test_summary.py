from __future__ import annotations

from omnistudy.protocol import Protocol
from omnistudy.protocol.summary import changes, parts_of, settings


def test_a_part_lists_every_setting_with_its_unit(component: Protocol) -> None:
    listed = {one.name: (one.value, one.unit) for one in settings(component.law)}
    assert listed["boundary.layer_x"] == ("0.15", "m")
    assert listed["stiffness.x"][1] == "N/m"
    assert listed["compliance_centre"] == ("0", "m")


def test_a_condition_lists_what_it_changes(component: Protocol) -> None:
    assert changes(component, "full") == ()
    assert [str(change) for change in changes(component, "centre_front_10")] == [
        "controller.compliance_centre: 0.0 -> 0.1",
        "law.compliance_centre: 0.0 -> 0.1",
    ]
    assert [str(change) for change in changes(component, "none")] == ["law.kind: component -> none"]


def test_parts_that_replace_another_are_listed_after_it(component: Protocol) -> None:
    names = [name for name, _ in parts_of(component)]
    law = names.index("law")
    assert names[law : law + 3] == ["law", "law of none", "law of zero_torque"]
