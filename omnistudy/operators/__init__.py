"""Who holds the stick: virtual drivers, recorded people, real people."""

from omnistudy.operators.operator import Operator, Person, RunningOperator

__all__ = ["Operator", "Person", "RunningOperator"]
