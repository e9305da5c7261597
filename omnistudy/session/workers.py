"""Trials of virtual operators on several cores, given back in their order."""

from __future__ import annotations

import signal
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context

from omnistudy.errors.session import WorkerDied
from omnistudy.trial import TrialResult, TrialSpec, run_trial

AHEAD = 2
"""Trials that each worker may have finished or waiting before the first is taken."""


def run_all(specs: Iterable[TrialSpec], workers: int) -> Iterator[TrialResult]:
    """Run trials on `workers` processes (one: in this process); results in the order given.

    A trial depends on its spec alone, so the number of workers changes no byte. Raises WorkerDied
    when the system ends a worker.
    """
    if workers <= 1:
        yield from map(run_trial, specs)
        return
    waiting: deque[Future[TrialResult]] = deque()
    with ProcessPoolExecutor(
        workers,
        mp_context=get_context("spawn"),
        # Ctrl-C reaches workers too: they end at once, instead of reporting it and going on.
        initializer=signal.signal,
        initargs=(signal.SIGINT, signal.SIG_DFL),
    ) as pool:
        try:
            for spec in specs:
                waiting.append(pool.submit(run_trial, spec))
                if len(waiting) >= workers * AHEAD:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        except BrokenProcessPool as cause:
            raise WorkerDied from cause
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
