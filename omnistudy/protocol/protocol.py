"""A protocol: what is to be run, as one frozen value."""

from __future__ import annotations

from typing import Annotated, NamedTuple

from pydantic import Field

from omnistudy.channel import Recording
from omnistudy.controllers import Controller
from omnistudy.devices import Device
from omnistudy.errors.protocol import UnknownCondition
from omnistudy.laws import Law
from omnistudy.operators import Operator
from omnistudy.plants import Plant
from omnistudy.protocol.condition import Condition, Factor
from omnistudy.protocol.fields import (
    AnyController,
    AnyDevice,
    AnyLaw,
    AnyOperator,
    AnyOrder,
    AnyPlant,
    AnyTask,
    AnyWorld,
    Name,
)
from omnistudy.protocol.limit import Limit
from omnistudy.protocol.participants import Participants, SessionLimits
from omnistudy.protocol.site import Site
from omnistudy.protocol.visit import Block, Visit
from omnistudy.registry import Model
from omnistudy.tasks import Messages, Task
from omnistudy.worlds import World


class Setup(NamedTuple):
    """What is coupled in the trials of one condition, every part complete."""

    world: World
    plant: Plant
    device: Device
    controller: Controller
    law: Law
    operator: Operator
    task: Task
    recording: Recording


class Protocol(Model):
    """Everything that decides a study, resolved; cross-field faults are found by `checks`."""

    name: Name
    """What files and tables call it."""
    title: Annotated[str, Field(min_length=1)]
    """One line for people."""
    description: str = ""
    """What a reviewer of the ethics board wants to know."""
    site: Site
    """What may differ from laboratory to laboratory."""
    messages: Messages
    """Every sentence that participants read, in their language; part of the site."""
    factors: tuple[Factor, ...] = ()
    """What the conditions vary: a mapping from the factor's name to its levels."""
    conditions: Annotated[tuple[Condition, ...], Field(min_length=1)]
    """The conditions: a mapping from the condition's name to what differs from the parts below."""
    world: AnyWorld
    """Where it happens."""
    plant: AnyPlant
    """The robot."""
    device: AnyDevice
    """What the participant holds."""
    controller: AnyController
    """How the device's position becomes the robot's command."""
    law: AnyLaw
    """What the device makes the hand feel."""
    operator: AnyOperator
    """Who holds the device."""
    task: AnyTask
    """What is to be done."""
    recording: Recording = Recording()
    """How often physics, scan and samples tick."""
    order: AnyOrder | None = None
    """In which sequence a participant meets the conditions; short for one visit of one block."""
    visits: tuple[Visit, ...] = ()
    """Instead of `order`: a mapping from the visit's name to its blocks of trials."""
    routes: Annotated[tuple[str, ...], Field(min_length=1)]
    """Routes of the world, spread evenly over each condition and shuffled."""
    participants: Participants
    """Who takes part."""
    session: SessionLimits = SessionLimits()
    """How long a session may last."""

    limits: tuple[Limit, ...] = ()
    """How badly an attempt may have been run: what is above a limit is not analysed."""

    @property
    def course(self) -> tuple[Visit, ...]:
        """The visits, whichever way the page gives them."""
        if self.order is None:
            return self.visits
        return (Visit(name="first", blocks=(Block(order=self.order),)),)

    @property
    def driven_by_people(self) -> bool:
        """Whether a person holds the device in some condition."""
        setups = (self.setup_for(condition.name) for condition in self.conditions)
        return any(not setup.operator.in_lockstep for setup in setups)

    def condition(self, name: str) -> Condition:
        """Give a condition by name; raises UnknownCondition."""
        for condition in self.conditions:
            if condition.name == name:
                return condition
        raise UnknownCondition(name, [condition.name for condition in self.conditions])

    def setup_for(self, condition: str) -> Setup:
        """Give the complete set-up of a condition; raises UnknownCondition."""
        own = self.condition(condition)
        return Setup(
            world=own.world or self.world,
            plant=own.plant or self.plant,
            device=own.device or self.device,
            controller=own.controller or self.controller,
            law=own.law or self.law,
            operator=own.operator or self.operator,
            task=own.task or self.task,
            recording=self.recording,
        )
