"""A lab's folder: what is written into it when somebody starts something of their own."""

from omnistudy.lab.next_steps import next_steps
from omnistudy.lab.start import NOUNS, NewFile, Started, default_folder, plan_start, write_start

__all__ = [
    "NOUNS",
    "NewFile",
    "Started",
    "default_folder",
    "next_steps",
    "plan_start",
    "write_start",
]
