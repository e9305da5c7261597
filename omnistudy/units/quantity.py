"""The quantities of the house, each a finite float that knows its SI unit."""

from typing import Annotated, Any

from annotated_types import Gt
from pydantic import AllowInfNan, BeforeValidator, WithJsonSchema


def _plain_number(unit: str) -> BeforeValidator:
    wanted = "a plain number" if unit == "1" else f"a plain number in {unit}"

    def refuse_text(value: Any) -> Any:
        if isinstance(value, str | bool):
            raise ValueError(f"{wanted} is needed, without a unit")
        return value

    return BeforeValidator(refuse_text)


def _schema(unit: str) -> WithJsonSchema:
    return WithJsonSchema({"type": "number", "unit": unit})


Positive = Gt(0.0)
"""Marks a quantity that must be above zero: `Annotated[Metres, Positive]`."""

Metres = Annotated[float, _plain_number("m"), AllowInfNan(False), _schema("m")]
Radians = Annotated[float, _plain_number("rad"), AllowInfNan(False), _schema("rad")]
Seconds = Annotated[float, _plain_number("s"), AllowInfNan(False), _schema("s")]
Hertz = Annotated[float, _plain_number("Hz"), AllowInfNan(False), _schema("Hz")]
Kilograms = Annotated[float, _plain_number("kg"), AllowInfNan(False), _schema("kg")]
KilogramSquareMetres = Annotated[
    float, _plain_number("kg·m²"), AllowInfNan(False), _schema("kg·m²")
]
Newtons = Annotated[float, _plain_number("N"), AllowInfNan(False), _schema("N")]
NewtonMetres = Annotated[float, _plain_number("N·m"), AllowInfNan(False), _schema("N·m")]
MetresPerSecond = Annotated[float, _plain_number("m/s"), AllowInfNan(False), _schema("m/s")]
RadiansPerSecond = Annotated[float, _plain_number("rad/s"), AllowInfNan(False), _schema("rad/s")]
NewtonsPerMetre = Annotated[float, _plain_number("N/m"), AllowInfNan(False), _schema("N/m")]
NewtonSecondsPerMetre = Annotated[
    float, _plain_number("N·s/m"), AllowInfNan(False), _schema("N·s/m")
]
NewtonMetresPerRadian = Annotated[
    float, _plain_number("N·m/rad"), AllowInfNan(False), _schema("N·m/rad")
]
MetresPerSecondPerNewton = Annotated[
    float, _plain_number("(m/s)/N"), AllowInfNan(False), _schema("(m/s)/N")
]
RadiansPerSecondPerNewtonMetre = Annotated[
    float, _plain_number("(rad/s)/(N·m)"), AllowInfNan(False), _schema("(rad/s)/(N·m)")
]
NewtonMetreSeconds = Annotated[float, _plain_number("N·m·s"), AllowInfNan(False), _schema("N·m·s")]
TorqueStiffness = Annotated[float, _plain_number("N·m/m²"), AllowInfNan(False), _schema("N·m/m²")]
Ratio = Annotated[float, _plain_number("1"), AllowInfNan(False), _schema("1")]
