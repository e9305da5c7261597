"""Whether the process that started this one is still there."""

import os
from multiprocessing import parent_process


def orphaned() -> bool:
    """Tell whether this process was started by multiprocessing and its parent is gone.

    The parent's number came with the start: a parent that dies before we first look is missed too.
    """
    parent = parent_process()
    return parent is not None and os.getppid() != parent.pid
