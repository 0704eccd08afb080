# SPDX-License-Identifier: GPL-3.0-or-later
"""What stage bar, menus, palette, help and log ask of a stage, and the stages in their order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol


class Stage(Protocol):
    """A step on the way from a file to a scenario. Each class of panel is one."""

    stage: str
    """Its name in programs: what `Problem.stage` says."""
    colouring: str
    """What the organ is coloured by while it is shown: plain, stiffness or distance."""
    shows_fixed: bool
    """Whether fixed vertices are marked while it is shown."""
    dock: str | None
    """The dock below the viewport that comes with it."""

    @staticmethod
    def title() -> str:
        """In the language of the window."""

    @staticmethod
    def help() -> list[str]:
        """Paragraphs, in the language of the window."""


class Stages:
    """All stages of a window, by name."""

    def __init__(self, stages: Sequence[Stage]):
        self.by_name = {stage.stage: stage for stage in stages}
        self.names = tuple(self.by_name)
        """In their order."""

    def title(self, name: str) -> str:
        return self.by_name[name].title()

    def place(self, name: str) -> int:
        """From 0."""
        return self.names.index(name)

    def following(self, name: str) -> str | None:
        """The next one; None after the last."""
        rest = self.names[self.place(name) + 1 :]
        return rest[0] if rest else None
