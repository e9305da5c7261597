"""What stick, firmware and device process take: `make bench-stick`.

The emulated board's own figures are in emulated time and the same everywhere; those in wall time
depend on the machine and on what else runs there. Prints tables in Markdown, or JSON with --json.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
from collections.abc import Callable, Mapping, Sequence

from omnistudy.devices.stick.emulator import EmulatedStick
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import CYCLES_PER_TICK, Field, Telemetry
from omnistudy.devices.stick.toolchain import missing_packages

TIMES = 200
LOOK = 20e-6
"""s between two looks at pins and line."""
SPREAD = 137e-6
"""s by which each field, or edge, comes later in its tick than the one before."""
Figures = Mapping[str, object]


def figures() -> dict[str, object]:
    """Give what the board alone takes, in emulated time; a few seconds."""
    missing = missing_packages()
    if missing:
        return {"not_run": f"needs {', '.join(missing)}"}
    board = EmulatedStick()
    line = _armed(board)
    heard = line.listen(0.0)
    to_pwm = [_field_to_pwm(board, line, heard, index) for index in range(TIMES)]
    to_host = [_edge_to_host(board, line, heard, index) for index in range(TIMES)]
    ticks = heard[-1].tick - heard[0].tick + 1
    return {
        "field_to_pwm_ms": spread(to_pwm),
        "edge_to_host_ms": spread(to_host),
        "cycles_to_drive_the_motors": {
            "p50": statistics.median(one.worked for one in heard),
            "max": max(one.worked for one in heard),
            "wanted": CYCLES_PER_TICK // 2,
        },
        "cycles_of_a_tick": {
            "p50": statistics.median(one.busy for one in heard),
            "max": max(one.busy for one in heard),
            "of": CYCLES_PER_TICK,
        },
        "ticks": ticks,
        "frames_lost": ticks - len(heard) + line.deframer.damaged,
    }


def spread(seconds: Sequence[float]) -> dict[str, float]:
    """Give median, 99th percentile and greatest, ms."""
    ordered = sorted(seconds)
    told = {
        "p50": statistics.median(ordered),
        "p99": ordered[int(0.99 * len(ordered))],
        "max": ordered[-1],
    }
    return {name: round(value * 1e3, 2) for name, value in told.items()}


def _field_to_pwm(
    board: EmulatedStick, line: StickLine, heard: list[Telemetry], index: int
) -> float:
    """From a field's first byte at the host to another duty at a pin, s."""
    _pass_time(board, line, heard, index)
    before, began = board.duties, board.now()
    push = 32 * (50 if index % 2 else 60)
    line.send(Field((push,) * 3, (0,) * 3, (1,) * 9, (1,) * 9, 1))
    _wait(board, lambda: board.duties != before)
    return board.now() - began


def _edge_to_host(
    board: EmulatedStick, line: StickLine, heard: list[Telemetry], index: int
) -> float:
    """From an encoder's edge to the last byte, at the host, of the telemetry that has it, s."""
    _pass_time(board, line, heard, index)
    count = board.count(0) + (1 if index % 2 else -1)
    board.turn(0, count, 1e6)
    began = board.now()

    def told() -> bool:
        heard.extend(line.listen(LOOK))
        return heard[-1].position[0] == count

    while not told():
        pass
    return board.now() - began


def _pass_time(board: EmulatedStick, line: StickLine, heard: list[Telemetry], index: int) -> None:
    """Let fields of 20 ms come as a law's do, each at another moment of a tick."""
    board.run(index * SPREAD % 1e-3)
    heard.extend(line.listen(0.02))


def _wait(board: EmulatedStick, happened: Callable[[], bool]) -> None:
    while not happened():
        board.run(LOOK)


def _armed(board: EmulatedStick) -> StickLine:
    line = StickLine(board)
    board.press_estop(False)
    board.hold_dead_man(True)
    line.listen(0.05)
    line.configure(line.configuration()._replace(soft_start=10, silence=1000))
    line.arm()
    line.listen(0.05)
    return line


def main() -> None:
    """Measure everything."""
    from stick_live import live_figures
    from stick_stiffness import table

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print JSON instead of tables")
    given = parser.parse_args()
    board = figures()
    if "not_run" in board:
        raise SystemExit(f"not run: {board['not_run']}; see `make system-packages`")
    measured = {
        "programs_that_want_to_run": round(os.getloadavg()[0], 1),
        "cores": os.cpu_count(),
        "board": board,
        "largest_stable_stiffness": [row._asdict() for row in table()],
        "live": live_figures(),
    }
    if given.json:
        print(json.dumps(measured, indent=2))
        return
    print_table(("the board, emulated time", "figure"), _flat(board))
    rows = [
        (row["loop"], f"{row['bare']:.0f}", f"{row['hand']:.0f}")
        for row in measured["largest_stable_stiffness"]
    ]
    print_table(("largest stable stiffness, N/m", "bare", "in a hand"), rows)
    busy = f"{measured['programs_that_want_to_run']} programs on {measured['cores']} cores"
    print(f"In wall time, with {busy} at the beginning:\n")
    for name, told in measured["live"].items():
        print_table((f"live, {name}", "figure"), _flat(told))


def _flat(figures: Figures) -> list[tuple[str, str]]:
    """Give each figure as one row, what belongs together in one."""
    return [
        (
            name.replace("_", " "),
            ", ".join(f"{key} {number:g}" for key, number in value.items())
            if isinstance(value, dict)
            else str(value),
        )
        for name, value in figures.items()
    ]


def print_table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table in Markdown."""
    for row in (columns, ["---"] * len(columns), *rows):
        print(f"| {' | '.join(row)} |")
    print()


if __name__ == "__main__":
    main()
