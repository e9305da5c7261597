"""A number that is worth recording, with its name and unit."""

from typing import NamedTuple


class Channel(NamedTuple):
    """One recorded quantity: `name` (unique within a trial), SI `unit`, one line of meaning.

    resolution : step in which a sensor tells it, such as one encoder count; 0 for none. Values are
        then whole multiples of it, which the store keeps as whole numbers.
    """

    name: str
    unit: str
    description: str
    resolution: float = 0.0


def with_rates(axes: tuple[Channel, ...]) -> tuple[Channel, ...]:
    """Give the channels of position axes, then those of their rates."""
    rates = (
        Channel(
            f"{axis.name}_rate", f"{axis.unit}/s", f"rate of: {axis.description}", axis.resolution
        )
        for axis in axes
    )
    return (*axes, *rates)
