"""Real-time scheduling of a process, where the system allows it. Linux."""

from __future__ import annotations

import ctypes
import gc
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import NamedTuple

PRIORITY = 50
"""Of SCHED_FIFO, 1 .. 99: below the kernel's own threads of that kind (ours)."""
SIMULATION_PRIORITY = 10
"""Below the device's: a simulation that stands still for 0.3 s lets the stick go soft (ours)."""
ALL_NOW_AND_LATER = 1 | 2
"""MCL_CURRENT | MCL_FUTURE of mlockall(2)."""


class RealTimeMeans(NamedTuple):
    """What a process got that must not come late.

    scheduled : it runs before every ordinary process (SCHED_FIFO).
    locked : its memory is never swapped out (mlockall).
    """

    scheduled: bool
    locked: bool

    @property
    def missing(self) -> str:
        """What could not be had and how to get it, in one sentence; "" when nothing is missing."""
        wanting = []
        if not self.scheduled:
            wanting.append("real-time scheduling (`ulimit -r 50`)")
        if not self.locked:
            wanting.append("locked memory (`ulimit -l unlimited`)")
        if not wanting:
            return ""
        return (
            f"this system does not give {' and '.join(wanting)}: ticks may come late when the "
            "machine is busy; see docs/how-to/drive.md"
        )


def go_real_time() -> RealTimeMeans:
    """Give this process all of it that can be had, and stop the collection of garbage."""
    gc.collect()
    gc.freeze()
    gc.disable()
    return RealTimeMeans(_schedule(PRIORITY), _lock_memory())


@contextmanager
def before_others() -> Iterator[None]:
    """Run this thread before every ordinary process meanwhile, where the system allows it."""
    if sys.platform != "linux":
        yield
        return
    before, setting = os.sched_getscheduler(0), os.sched_getparam(0)
    _schedule(SIMULATION_PRIORITY)
    try:
        yield
    finally:
        os.sched_setscheduler(0, before, setting)


def real_time_means() -> RealTimeMeans:
    """Tell what a process of this user would get; nothing stays changed."""
    if sys.platform != "linux":
        return RealTimeMeans(False, False)
    import resource

    before, setting = os.sched_getscheduler(0), os.sched_getparam(0)
    scheduled = _schedule(PRIORITY)
    if scheduled:
        os.sched_setscheduler(0, before, setting)
    allowed, _ = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    return RealTimeMeans(scheduled, allowed == resource.RLIM_INFINITY or os.geteuid() == 0)


def _schedule(priority: int) -> bool:
    if sys.platform != "linux":
        return False
    with suppress(PermissionError):
        policy = os.SCHED_FIFO | os.SCHED_RESET_ON_FORK  # not for processes that this one starts
        os.sched_setscheduler(0, policy, os.sched_param(priority))
        return True
    return False


def _lock_memory() -> bool:
    if sys.platform != "linux":
        return False
    return bool(ctypes.CDLL(None).mlockall(ALL_NOW_AND_LATER) == 0)
