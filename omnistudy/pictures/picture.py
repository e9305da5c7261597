"""A figure as a file: same figure, same bytes; nothing is overwritten without being told."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from omnistudy.errors.pictures import PictureExists, PictureNotWritten, UnknownPictureFormat

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None, "Creator": None},
    ".png": {"Software": None},
}
"""What matplotlib would write of time and version, taken out so that bytes repeat."""


@contextmanager
def picture(path: Path, replace: bool) -> Iterator[Figure]:
    """Give an empty figure and save it as .svg or .png once it is drawn.

    Raises UnknownPictureFormat, or PictureExists unless `replace`, before anything is drawn, and
    PictureNotWritten after.
    """
    if path.suffix not in _METADATA:
        raise UnknownPictureFormat(path, _METADATA)
    if path.exists() and not replace:
        raise PictureExists(path)
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update({"svg.hashsalt": "omnistudy", "font.size": 9.0})
        figure = Figure(layout="constrained", facecolor="white")
        yield figure
        drawn = BytesIO()
        kind = path.suffix.removeprefix(".")
        figure.savefig(drawn, format=kind, dpi=150, metadata=_METADATA[path.suffix])
    try:
        path.write_bytes(drawn.getvalue())
    except OSError as refused:
        raise PictureNotWritten(path, refused.strerror or str(refused)) from refused
