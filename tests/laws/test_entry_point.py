"""A law of somebody else's package: installed beside ours, it is a kind like any other."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

LAW = """
    from typing import Literal

    from omnistudy.geometry import PlanarTwist, PlanarWrench, Scan
    from omnistudy.laws import WrenchLaw


    class Headwind(WrenchLaw):
        \"\"\"Pushes back, whatever is around. And some more.\"\"\"

        kind: Literal["headwind"] = "headwind"

        strength: float = 1.5

        def wrench(self, scan: Scan, twist: PlanarTwist) -> PlanarWrench:
            return PlanarWrench(-self.strength - 2.0 * twist.vx, 0.0, 0.0)
"""

PROTOCOL = """
    defaults:
      - utah2017_component
      - _self_

    name: headwind_study

    conditions:
      full:
        law: {kind: headwind, strength: 4.0}
"""


@pytest.fixture
def beside(tmp_path: Path) -> Path:
    """A folder on the path of Python that holds an installed package with one law."""
    (tmp_path / "headwind_laws.py").write_text(dedent(LAW))
    installed = tmp_path / "headwind_laws-1.0.dist-info"
    installed.mkdir()
    (installed / "METADATA").write_text(
        "Metadata-Version: 2.1\nName: headwind_laws\nVersion: 1.0\n"
    )
    (installed / "entry_points.txt").write_text(
        "[omnistudy.laws]\nheadwind = headwind_laws:Headwind\n"
    )
    return tmp_path


def answer(beside: Path, code: str) -> Any:
    """Run code in a fresh Python that finds the package, and give what it prints as JSON."""
    environment = {name: text for name, text in os.environ.items() if name != "OMNISTUDY_CONF"}
    path = os.pathsep.join(filter(None, [str(beside), os.environ.get("PYTHONPATH")]))
    run = subprocess.run(
        [sys.executable, "-c", dedent(code)],
        cwd=beside,
        env=environment | {"PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def test_it_is_loaded_by_its_kind_and_gives_a_field(beside: Path) -> None:
    found = answer(
        beside,
        """
        import json
        import numpy as np
        from omnistudy.geometry import PlanarTwist, Scan
        from omnistudy.laws import Sensed
        from omnistudy.registry import kinds, load_kind
        from omnistudy.registry.catalogue import entry

        law = load_kind("laws", "headwind")
        scan = Scan(np.zeros(1), np.ones(1), 0.5)
        twist = PlanarTwist(0.25, 0.0, 0.0)
        field = law().field(Sensed(scan, twist, ((3.0, 0, 0), (0, 0, 0), (0, 0, 0))))
        print(json.dumps({
            "kinds": kinds("laws"), "name": law.__name__, "entry": entry("laws", "headwind"),
            "wrench": field.wrench, "stiffness": field.stiffness,
        }))
        """,
    )
    assert {"headwind", "component", "none", "zero_torque"} <= set(found["kinds"])
    assert found["name"] == "Headwind"
    assert found["entry"][0] == "headwind"
    assert found["entry"][1].startswith("Pushes back, whatever is around.")
    assert found["entry"][2] == "headwind_laws"
    assert found["wrench"] == [-2.0, 0.0, 0.0]
    assert found["stiffness"] == [[6.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]


def test_a_protocol_can_name_it(beside: Path) -> None:
    (beside / "headwind_study.yaml").write_text(dedent(PROTOCOL))
    found = answer(
        beside,
        """
        import json
        from omnistudy.protocol.compose import compose_protocol

        protocol = compose_protocol("headwind_study.yaml")
        law = protocol.setup_for("full").law
        print(json.dumps({
            "module": type(law).__module__, "strength": law.strength,
            "other": protocol.setup_for("none").law.kind,
        }))
        """,
    )
    assert found == {"module": "headwind_laws", "strength": 4.0, "other": "none"}
