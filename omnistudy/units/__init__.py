"""Numbers with a unit, as field types: `x: Metres` is a finite float in m.

A string such as "10 cm" is refused with the unit that is expected, because a silent conversion in a
protocol would be a second way to write the same thing.
"""

from omnistudy.units.quantity import (
    Hertz,
    Kilograms,
    KilogramSquareMetres,
    Metres,
    MetresPerSecond,
    MetresPerSecondPerNewton,
    NewtonMetres,
    NewtonMetreSeconds,
    NewtonMetresPerRadian,
    Newtons,
    NewtonSecondsPerMetre,
    NewtonsPerMetre,
    Positive,
    Radians,
    RadiansPerSecond,
    RadiansPerSecondPerNewtonMetre,
    Ratio,
    Seconds,
    TorqueStiffness,
)

__all__ = [
    "Hertz",
    "KilogramSquareMetres",
    "Kilograms",
    "Metres",
    "MetresPerSecond",
    "MetresPerSecondPerNewton",
    "NewtonMetreSeconds",
    "NewtonMetres",
    "NewtonMetresPerRadian",
    "NewtonSecondsPerMetre",
    "Newtons",
    "NewtonsPerMetre",
    "Positive",
    "Radians",
    "RadiansPerSecond",
    "RadiansPerSecondPerNewtonMetre",
    "Ratio",
    "Seconds",
    "TorqueStiffness",
]
