"""How fast a trial runs with every law and with both robots, recording on."""

from __future__ import annotations

from dataclasses import replace

import published_trial

from omnistudy.session.parts import part, part_names
from omnistudy.trial import TrialSpec

ROBOTS = {"youbot": "component", "nexus_lidar": "component", "nexus": "infrared"}
"""Page of each robot, and a law that its sensors feed."""


def law_speeds(spec: TrialSpec) -> dict[str, float]:
    """Give simulated seconds a wall second by law, on the published trial's robot."""
    return {
        name: round(published_trial.speed(replace(spec, law=part("law", name))), 1)
        for name in part_names("law")
    }


def robot_speeds(spec: TrialSpec) -> dict[str, float]:
    """Give simulated seconds a wall second by robot."""
    return {
        name: round(
            published_trial.speed(replace(spec, plant=part("plant", name), law=part("law", law))), 1
        )
        for name, law in ROBOTS.items()
    }
