"""Starting a process that Ctrl-C leaves alone: whoever started it ends it."""

from __future__ import annotations

import signal
import sys
from multiprocessing import resource_tracker
from multiprocessing.process import BaseProcess


def start_child(process: BaseProcess) -> None:
    """Start a process to which Ctrl-C never comes, not even while it is being started.

    A terminal sends it to every process of the command. Works in any thread; a Ctrl-C meanwhile
    comes to this process afterwards. On Windows the process hears it.
    """
    if sys.platform == "win32":
        process.start()
        return
    resource_tracker.ensure_running()  # starting it later would let SIGINT through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        process.start()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
