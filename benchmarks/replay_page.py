"""Measure the replay page: how soon it opens, how evenly it plays, its size: `make bench-view`.

Prints JSON. Needs Chromium, which draws in software here: a graphics card does far better. Times
depend on the machine and on what else it does, so its load is told with them.
"""

from __future__ import annotations

import json
import os
import time
from base64 import b64decode, b64encode
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

import omnistudy
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import run_trials
from omnistudy.study import create_study
from omnistudy.view.chromium import Tab, browser
from omnistudy.view.film import Film, film
from omnistudy.view.page import replay_page, write_page

STARTS = 3
"""Browsers that open the page, each for the first time in its life."""
PLAYED_S = 8
SPEEDS = (1, 8)
LONGEST_FRAME = """new Promise((tell) => {
  const {player} = window.replay;
  let [begun, last, longest, frames] = [0, 0, 0, 0];
  player.speed = SPEED;
  player.seek(FROM);
  player.start();
  const frame = (now) => {
    begun ||= now;
    if (last) longest = Math.max(longest, now - last);
    last = now;
    frames += 1;
    if (now - begun < PLAYED) requestAnimationFrame(frame);
    else { player.pause(); tell([longest, frames]); }
  };
  requestAnimationFrame(frame);
})"""


def main() -> None:
    """Measure a trial of the published world, and one of ten minutes."""
    with TemporaryDirectory(prefix="omnistudy-bench-") as folder:
        driven = _driven(Path(folder) / "bench.db")
        pages = {}
        for name, seconds in (("150 s", 150), ("10 min", 600)):
            pages[name] = Path(folder) / f"{seconds}.html"
            write_page(replay_page([_lasting(driven, seconds)]), pages[name])
        told = {name: _measured(page) for name, page in pages.items()}
    print(json.dumps({"load": os.getloadavg()[0], "cores": os.cpu_count(), **told}, indent=2))


def _driven(study: Path) -> Film:
    """Drive one trial of the published study."""
    create_study(compose_protocol("utah2017_component", ("participants.count=1",)), study, "bench")
    run_trials(study, limit=1)
    with omnistudy.open(study) as opened:
        return film(opened, 1)


def _lasting(driven: Film, seconds: int) -> Film:
    """Give a film of a duration: SYNTHETIC, the driven one's samples begin anew at their end."""
    times = np.arange(20 * seconds + 1) / 20
    series = []
    for one in driven.series:
        values = np.frombuffer(b64decode(one.data), dtype="<f4")
        longer = times if one.name == "t" else np.resize(values, len(times))
        data = b64encode(longer.astype("<f4").tobytes()).decode()
        series.append(one.model_copy(update={"data": data}))
    return driven.model_copy(update={"series": tuple(series), "end": float(times[-1])})


def _measured(page: Path) -> dict[str, object]:
    opened = []
    for _ in range(STARTS):
        with browser() as running:
            tab = running.tab()
            begun = time.monotonic()
            tab.ask("Page.navigate", url=page.as_uri())
            tab.wait_for("window.replay !== undefined")
            opened.append(round(time.monotonic() - begun, 2))
            if len(opened) == STARTS:
                halfway = 0.5 * tab.value("window.replay.end")
                played = {f"{speed}x": _played(tab, speed, halfway) for speed in SPEEDS}
    return {"bytes": page.stat().st_size, "opens_cold_s": opened, "played": played}


def _played(tab: Tab, speed: int, begin: float) -> dict[str, float]:
    """Play a while from `begin` s; give what stood still longest, and how often it moved."""
    wish = {"SPEED": speed, "FROM": begin, "PLAYED": 1000 * PLAYED_S}
    script = LONGEST_FRAME
    for name, value in wish.items():
        script = script.replace(name, str(value))
    longest, frames = tab.value(script)
    return {
        "longest_frame_ms": round(longest, 1),
        "frames_a_second": round(frames / PLAYED_S, 1),
    }


if __name__ == "__main__":
    main()
