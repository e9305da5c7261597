"""Names, units, rates and rows of what is recorded."""

from omnistudy.channel.channel import Channel
from omnistudy.channel.latest import LatestValue
from omnistudy.channel.rates import Recording
from omnistudy.channel.recording import Event, Stream
from omnistudy.channel.sample import SAMPLE_CHANNELS, SAMPLE_COLUMNS

__all__ = [
    "SAMPLE_CHANNELS",
    "SAMPLE_COLUMNS",
    "Channel",
    "Event",
    "LatestValue",
    "Recording",
    "Stream",
]
