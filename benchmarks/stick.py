"""What the stick's firmware does on the emulated board, in emulated time."""

from __future__ import annotations

import statistics

from omnistudy.devices.stick.emulator import EmulatedStick
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import CYCLES_PER_TICK, Field
from omnistudy.devices.stick.toolchain import missing_packages

FIELDS = 200
LOOK = 20e-6
"""s between two looks at the pins."""
SPREAD = 137e-6
"""s by which each field comes later in its tick than the one before."""


def figures() -> dict[str, object]:
    """Give latency from a field's first byte to the pin, cycles of a tick, and frames lost."""
    missing = missing_packages()
    if missing:
        return {"not_run": f"needs {', '.join(missing)}"}
    board = EmulatedStick()
    line = _armed(board)
    delays: list[float] = []
    heard = line.listen(0.0)
    for index in range(FIELDS):
        board.run(index * SPREAD % 1e-3)
        heard += line.listen(0.02)
        before, began = board.duties, board.now()
        push = 32 * (50 if index % 2 else 60)
        line.send(Field((push,) * 3, (0,) * 3, (1,) * 9, (1,) * 9, 1))
        while board.duties == before:
            board.run(LOOK)
        delays.append((board.now() - began) * 1e3)
    ticks = heard[-1].tick - heard[0].tick + 1
    ordered = sorted(delays)
    return {
        "field_to_pwm_ms": {
            "p50": round(statistics.median(ordered), 2),
            "p99": round(ordered[int(0.99 * len(ordered))], 2),
            "max": round(ordered[-1], 2),
        },
        "cycles_to_drive_the_motors": {
            "p50": statistics.median(one.worked for one in heard),
            "max": max(one.worked for one in heard),
            "wanted": CYCLES_PER_TICK // 2,
        },
        "frames_lost": ticks - len(heard) + line.deframer.damaged,
    }


def _armed(board: EmulatedStick) -> StickLine:
    line = StickLine(board)
    board.press_estop(False)
    board.hold_dead_man(True)
    line.listen(0.05)
    line.configure(line.configuration()._replace(soft_start=10))
    line.arm()
    line.listen(0.05)
    return line


if __name__ == "__main__":
    print(figures())
