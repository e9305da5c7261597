"""Names, units, rates and rows of what is recorded."""

from omnistudy.channel.channel import Channel, with_rates
from omnistudy.channel.latest import LatestValue
from omnistudy.channel.measure import Measure
from omnistudy.channel.rates import Recording
from omnistudy.channel.recording import Event, Stream
from omnistudy.channel.ring import Ring
from omnistudy.channel.sample import SAMPLE_CHANNELS, SAMPLE_COLUMNS

__all__ = [
    "SAMPLE_CHANNELS",
    "SAMPLE_COLUMNS",
    "Channel",
    "Event",
    "LatestValue",
    "Measure",
    "Recording",
    "Ring",
    "Stream",
    "with_rates",
]
