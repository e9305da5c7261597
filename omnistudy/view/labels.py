"""What pages call conditions: by their masked labels, or by name for those who ask."""

from __future__ import annotations

from omnistudy.store.study_file import StudyFile


class Labels:
    """The words for a study's conditions."""

    def __init__(self, study: StudyFile, *, unmask: bool) -> None:
        """Read them; `unmask` gives names in place of masked labels."""
        table = study.conditions()
        words = table["condition" if unmask else "masked_label"]
        self._words = dict(zip(table["condition"], words, strict=True))

    def of(self, condition: str | None) -> str:
        """Give the word for a condition; "" for one that is still to be chosen."""
        return "" if condition is None else str(self._words[condition])
