"""How long `omnistudy --help` takes."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from pathlib import Path

RUNS = 5


def help_seconds() -> float:
    """Give the median time in s from start to end of the process."""
    omnistudy = Path(sys.executable).parent / "omnistudy"
    times = []
    for _ in range(RUNS):
        began = time.perf_counter()
        subprocess.run([omnistudy, "--help"], stdout=subprocess.DEVNULL, check=True)
        times.append(time.perf_counter() - began)
    return statistics.median(times)
