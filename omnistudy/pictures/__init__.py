"""Figures as files; what is drawn on them is the business of the rooms above."""

from omnistudy.pictures.picture import picture

__all__ = ["picture"]
