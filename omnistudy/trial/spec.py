"""Everything that decides a trial, as one value that travels between processes."""

from __future__ import annotations

from dataclasses import dataclass

from omnistudy.channel import Recording
from omnistudy.controllers import Controller
from omnistudy.devices import Device
from omnistudy.laws import Law
from omnistudy.operators import Operator, Person
from omnistudy.plants import Plant
from omnistudy.tasks import Messages, Task
from omnistudy.worlds import World


@dataclass(frozen=True, slots=True)
class TrialSpec:
    """What is coupled with what, where, on which route, with which seeds."""

    world: World
    route: str
    plant: Plant
    device: Device
    controller: Controller
    law: Law
    operator: Operator
    task: Task
    recording: Recording
    messages: Messages
    person: Person
