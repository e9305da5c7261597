"""Field types of a protocol's parts: the `kind` picks the class, and all of it is written out."""

from __future__ import annotations

from typing import Annotated

from pydantic import SerializeAsAny

from omnistudy.controllers import Controller
from omnistudy.devices import Device
from omnistudy.laws import Law
from omnistudy.operators import Operator
from omnistudy.plants import Plant
from omnistudy.protocol.ordering.order import Order
from omnistudy.registry import kind_validator
from omnistudy.registry.name import Name as Name
from omnistudy.tasks import Task
from omnistudy.worlds import World

AnyWorld = Annotated[SerializeAsAny[World], kind_validator("worlds")]
AnyPlant = Annotated[SerializeAsAny[Plant], kind_validator("plants")]
AnyDevice = Annotated[SerializeAsAny[Device], kind_validator("devices")]
AnyController = Annotated[SerializeAsAny[Controller], kind_validator("controllers")]
AnyLaw = Annotated[SerializeAsAny[Law], kind_validator("laws")]
AnyOperator = Annotated[SerializeAsAny[Operator], kind_validator("operators")]
AnyTask = Annotated[SerializeAsAny[Task], kind_validator("tasks")]
AnyOrder = Annotated[SerializeAsAny[Order], kind_validator("orders")]
