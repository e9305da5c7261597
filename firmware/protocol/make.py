"""Write all that is generated from description.yaml: the C header, Python modules and the page.

`--check` writes nothing, names what is stale, and exits 1 if anything is.
"""

from __future__ import annotations

import sys
from pathlib import Path

from c_header import header
from description import read_description
from page import page
from python_modules import layouts, messages

ROOT = Path(__file__).resolve().parents[2]
STICK = ROOT / "omnistudy" / "devices" / "stick"


def generated() -> dict[Path, str]:
    """Give every generated file with its text."""
    protocol = read_description()
    return {
        ROOT / "firmware" / "src" / "protocol.h": header(protocol),
        STICK / "messages.py": messages(protocol),
        STICK / "layouts.py": layouts(protocol),
        ROOT / "docs" / "joystick-protocol.md": page(protocol),
    }


def main() -> None:
    """Write, or check."""
    stale = {
        path: text
        for path, text in generated().items()
        if not path.is_file() or path.read_text(encoding="utf-8") != text
    }
    for path, text in stale.items():
        print(path.relative_to(ROOT))
        if "--check" not in sys.argv:
            path.write_text(text, encoding="utf-8")
    sys.exit("--check" in sys.argv and bool(stale))


if __name__ == "__main__":
    main()
