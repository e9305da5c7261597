"""Names, units, rates and rows of what is recorded."""

from omnistudy.channel.channel import Channel, with_rates
from omnistudy.channel.latest import LatestValue
from omnistudy.channel.measure import MEASURES, SATURATED, Measure, is_measure, measured
from omnistudy.channel.rates import Recording
from omnistudy.channel.recording import Event, Stream
from omnistudy.channel.ring import Ring
from omnistudy.channel.sample import SAMPLE_CHANNELS, SAMPLE_COLUMNS

__all__ = [
    "MEASURES",
    "SAMPLE_CHANNELS",
    "SAMPLE_COLUMNS",
    "SATURATED",
    "Channel",
    "Event",
    "LatestValue",
    "Measure",
    "Recording",
    "Ring",
    "Stream",
    "is_measure",
    "measured",
    "with_rates",
]
