"""What a trial keeps while it runs."""

from __future__ import annotations

from array import array
from math import nan

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import (
    SAMPLE_CHANNELS,
    SAMPLE_COLUMNS,
    Channel,
    Event,
    Recording,
    Stream,
    with_rates,
)
from omnistudy.devices import DeviceState
from omnistudy.geometry import PlanarWrench

INPUT = "input"
"""The stream that holds what every physics step consumed: device position, then rate."""


class Recorder:
    """Takes the input of every step and a sample at the sample rate.

    Plant and device channels that are named like a column of `sample` go there, the law's wrench
    too; the others go to the streams "plant" and "device".
    """

    def __init__(
        self,
        recording: Recording,
        axes: tuple[Channel, ...],
        device_channels: tuple[Channel, ...],
        plant_channels: tuple[Channel, ...],
    ) -> None:
        self._recording = recording
        self._axes = axes
        self._device_channels = device_channels
        self._plant_channels = plant_channels
        self._input = array("d")
        self._rows: list[tuple[float, ...]] = []
        self.events: list[Event] = []

    def consumed(self, state: DeviceState) -> None:
        """Keep the device state that this physics step uses."""
        self._input.extend(state.position)
        self._input.extend(state.rate)

    def sample(
        self,
        t: float,
        plant: tuple[float, ...],
        position: tuple[float, ...],
        wrench: PlanarWrench,
        device: tuple[float, ...],
    ) -> None:
        """Keep one row; the parts are in the order of their channels."""
        self._rows.append((t, *plant, *position, *wrench, *device))

    def input_stream(self) -> Stream:
        """Give what every physics step consumed."""
        width = 2 * len(self._axes)
        data = np.frombuffer(self._input, dtype=np.float64).reshape(-1, width).copy()
        return Stream(INPUT, self._recording.physics_hz, with_rates(self._axes), data)

    def _columns(self) -> tuple[str, ...]:
        return (
            "t",
            *(channel.name for channel in self._plant_channels),
            *(axis.name for axis in self._axes),
            "fx",
            "fy",
            "tau",
            *(channel.name for channel in self._device_channels),
        )

    def _table(self) -> NDArray[np.float64]:
        return np.array(self._rows, dtype=np.float64).reshape(-1, len(self._columns()))

    def samples(self) -> NDArray[np.float64]:
        """Give the rows of the `sample` table, columns SAMPLE_COLUMNS; NaN where there is none."""
        table, columns = self._table(), self._columns()
        out = np.full((len(table), len(SAMPLE_COLUMNS)), nan)
        for index, name in enumerate(SAMPLE_COLUMNS):
            if name in columns:
                out[:, index] = table[:, columns.index(name)]
        return out

    def streams(self) -> tuple[Stream, ...]:
        """Give the input and every channel that `sample` has no column for."""
        table, columns = self._table(), self._columns()
        standard = {channel.name for channel in SAMPLE_CHANNELS}
        streams = [self.input_stream()]
        for name, channels in (("plant", self._plant_channels), ("device", self._device_channels)):
            kept = tuple(channel for channel in channels if channel.name not in standard)
            if kept:
                data = table[:, [columns.index(channel.name) for channel in kept]]
                streams.append(Stream(name, self._recording.sample_hz, kept, data))
        return tuple(streams)
