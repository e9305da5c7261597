"""What a process gets of real time, which depends on the system; what it leaves behind does not."""

from __future__ import annotations

import gc
import os
import subprocess
import sys

import pytest

from omnistudy.devices.real_time import RealTimeMeans, before_others, real_time_means

linux = pytest.mark.skipif(sys.platform != "linux", reason="needs Linux's schedulers")


def test_what_is_missing_is_one_sentence() -> None:
    assert RealTimeMeans(scheduled=True, locked=True).missing == ""
    both = RealTimeMeans(scheduled=False, locked=False).missing
    assert "real-time scheduling (`ulimit -r 50`) and locked memory" in both
    assert "locked memory" not in RealTimeMeans(scheduled=False, locked=True).missing


@linux
def test_asking_changes_nothing() -> None:
    before = os.sched_getscheduler(0), os.sched_getparam(0).sched_priority
    real_time_means()
    assert (os.sched_getscheduler(0), os.sched_getparam(0).sched_priority) == before
    assert gc.isenabled()


@linux
def test_a_simulation_is_before_others_for_a_while_and_what_it_starts_is_not() -> None:
    normal = os.sched_getscheduler(0)
    allowed = real_time_means().scheduled
    ask = "import os; print(os.sched_getscheduler(0))"
    with before_others():
        inside = os.sched_getscheduler(0)
        child = subprocess.run(
            [sys.executable, "-c", ask], check=True, capture_output=True, text=True
        )
    assert (inside != normal) == allowed
    assert int(child.stdout) == os.SCHED_OTHER
    assert os.sched_getscheduler(0) == normal


@linux
def test_going_real_time_takes_what_the_system_gives() -> None:
    code = (
        "import gc, os\n"
        "from omnistudy.devices.real_time import go_real_time, real_time_means\n"
        "allowed = real_time_means()\n"
        "got = go_real_time()\n"
        "fifo = bool(os.sched_getscheduler(0) & os.SCHED_FIFO)\n"
        "print(got.scheduled == allowed.scheduled == fifo, gc.isenabled())"
    )
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.split() == ["True", "False"]
