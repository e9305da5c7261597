"""Where Hydra looks: our plugin puts the folders in front, the lab's before ours."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from hydra.core.config_search_path import ConfigSearchPath
from hydra.core.plugins import Plugins
from hydra.plugins.search_path_plugin import SearchPathPlugin

_folders: ContextVar[tuple[Path, ...]] = ContextVar("folders", default=())


class FoldersInFront(SearchPathPlugin):
    """Prepends the chosen folders.

    `hydra.searchpath` would come after the main folder, so that a lab's page of the same name
    would silently lose.
    """

    def manipulate_search_path(self, search_path: ConfigSearchPath) -> None:
        """Put the folders in front, the first of them first."""
        for folder in reversed(_folders.get()):
            search_path.prepend(provider="omnistudy", path=f"file://{folder}")


@contextmanager
def searching(folders: tuple[Path, ...]) -> Iterator[None]:
    """Let Hydra look into these folders, the first of them first."""
    plugins = Plugins.instance()
    if FoldersInFront not in plugins.discover(SearchPathPlugin):
        plugins.register(FoldersInFront)
    token = _folders.set(folders)
    try:
        yield
    finally:
        _folders.reset(token)
