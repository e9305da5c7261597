"""An arm on its chair as URDF, for physics and for viewers."""

from __future__ import annotations

from xml.etree import ElementTree as Xml

from omnistudy.arm.profile import ArmProfile, Joint

CHAIR_JOINTS = ("chair_x", "chair_y", "chair_theta")
"""The wheelchair slides and turns on three joints over the floor: its pose is theirs."""

HAND_LINK = "hand"

MASS, INERTIA = 1.0, 0.01
"""kg and kg·m² of every link: no published weights are known; physics needs some."""

THICKNESS = 0.04
"""m, of the bars that stand for the links."""

FURTHEST = 1000.0
"""m that the chair may slide either way."""

EFFORT = 100.0
"""N·m that a joint may take; ours."""


def urdf(profile: ArmProfile) -> str:
    """Give the URDF of a profile.

    Links: ground, chair (the arm's base), link_1 to link_n, hand. The chair's three joints come
    first, then joint_1 to joint_n, then the fixed one to the hand.
    """
    robot = Xml.Element("robot", name=profile.name)
    Xml.SubElement(robot, "link", name="ground")
    _chair(robot, profile)
    parent, before = "chair", 0.0
    for number, joint in enumerate(profile.joints, start=1):
        child = f"link_{number}"
        _link(robot, child, joint.d)
        _revolute(robot, f"joint_{number}", (parent, child), joint, before)
        parent, before = child, joint.d
    _link(robot, HAND_LINK, 0.0)
    hand = _joint(robot, HAND_LINK, "fixed", (parent, HAND_LINK))
    _origin(hand, (0.0, 0.0, before + profile.gripper), 0.0)
    Xml.indent(robot)
    return f'<?xml version="1.0"?>\n{Xml.tostring(robot, encoding="unicode")}\n'


def _chair(robot: Xml.Element, profile: ArmProfile) -> None:
    chair = profile.chair
    kinds = (("prismatic", "1 0 0"), ("prismatic", "0 1 0"), ("continuous", "0 0 1"))
    links = ("ground", "sliding_x", "sliding_y", "chair")
    for index, (kind, axis) in enumerate(kinds):
        _link(robot, links[index + 1], 0.0)
        joint = _joint(robot, CHAIR_JOINTS[index], kind, (links[index], links[index + 1]))
        _origin(joint, (0.0, 0.0, chair.arm_height if index == 0 else 0.0), 0.0)
        Xml.SubElement(joint, "axis", xyz=axis)
        turning = kind == "continuous"
        top = chair.top_turn if turning else chair.top_speed
        limit = Xml.SubElement(joint, "limit", effort=_number(EFFORT), velocity=_number(top))
        if not turning:
            limit.attrib.update(lower=_number(-FURTHEST), upper=_number(FURTHEST))


def _revolute(
    robot: Xml.Element, name: str, links: tuple[str, str], joint: Joint, before: float
) -> None:
    """Add a joint: its frame stands `before` up the axis of the one before, then a, then alpha."""
    element = _joint(robot, name, "revolute", links)
    _origin(element, (joint.a, 0.0, before), joint.alpha)
    Xml.SubElement(element, "axis", xyz="0 0 1")
    Xml.SubElement(
        element,
        "limit",
        lower=_number(joint.lower),
        upper=_number(joint.upper),
        velocity=_number(joint.top_speed),
        effort=_number(EFFORT),
    )


def _joint(robot: Xml.Element, name: str, kind: str, links: tuple[str, str]) -> Xml.Element:
    joint = Xml.SubElement(robot, "joint", name=name, type=kind)
    Xml.SubElement(joint, "parent", link=links[0])
    Xml.SubElement(joint, "child", link=links[1])
    return joint


def _origin(joint: Xml.Element, place: tuple[float, float, float], roll: float) -> None:
    numbers = " ".join(_number(value) for value in place)
    Xml.SubElement(joint, "origin", xyz=numbers, rpy=f"{_number(roll)} 0 0")


def _link(robot: Xml.Element, name: str, length: float) -> None:
    """Add a link; a bar along its axis stands for one that has a length."""
    link = Xml.SubElement(robot, "link", name=name)
    inertial = Xml.SubElement(link, "inertial")
    Xml.SubElement(inertial, "mass", value=_number(MASS))
    inertia = Xml.SubElement(inertial, "inertia", ixy="0", ixz="0", iyz="0")
    inertia.attrib.update(dict.fromkeys(("ixx", "iyy", "izz"), _number(INERTIA)))
    if length == 0.0:
        return
    visual = Xml.SubElement(link, "visual")
    _origin(visual, (0.0, 0.0, 0.5 * length), 0.0)
    geometry = Xml.SubElement(visual, "geometry")
    size = " ".join(map(_number, (THICKNESS, THICKNESS, abs(length))))
    Xml.SubElement(geometry, "box", size=size)


def _number(value: float) -> str:
    return repr(float(value))
