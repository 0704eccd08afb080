# SPDX-License-Identifier: GPL-3.0-or-later
"""What one action of the window is, and what the menus are called."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from palpate_editor.views.translations import tr

MENUS = ("file", "edit", "view", "mesh", "material", "simulate", "publish", "help")


def menu_title(menu: str) -> str:
    return {
        "file": tr("&File"),
        "edit": tr("&Edit"),
        "view": tr("&View"),
        "mesh": tr("&Mesh"),
        "material": tr("M&aterial"),
        "simulate": tr("&Simulate"),
        "publish": tr("&Publish"),
        "help": tr("&Help"),
        "recent": tr("Open &recent"),
        "stages": tr("&Stage"),
        "colours": tr("&Colours"),
        "directions": tr("&Look from"),
        "theme": tr("&Theme"),
        "language": tr("&Language"),
        "docks": tr("&Panels"),
    }[menu]


@dataclass(frozen=True)
class Command:
    """One action as it is asked for."""

    name: str
    menu: str
    text: str
    slot: Callable[[], None]
    """A bound method."""
    keys: tuple[str, ...] = ()
    sign: str = ""
    group: str = ""
    """Actions of one group exclude each other."""
    checkable: bool = False
    needs_organ: bool = False
    line_before: bool = False
