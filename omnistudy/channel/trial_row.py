"""Rows of a trial on their way from the process that makes them to the one that stores them."""

from omnistudy.channel.channel import Channel

TRIAL_ROW = (
    Channel("trial", "1", "number of the trial"),
    Channel("row", "1", "rows of this trial before this one"),
)
"""What stands before each row, so that a recorder knows whose it is and which are missing."""
