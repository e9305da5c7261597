"""The accessibility checker axe, run on a page."""

from __future__ import annotations

from pathlib import Path

from omnistudy.view.chromium import Tab


def complaints(tab: Tab, front: Path) -> list[str]:
    """Give what axe finds wrong with the page in a tab, one line a rule and place."""
    tab.value((front / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8"))
    found = tab.value("axe.run().then((result) => result.violations)")
    return [f"{one['id']}: {node['html']}" for one in found for node in one["nodes"]]
