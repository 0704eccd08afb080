# SPDX-License-Identifier: GPL-3.0-or-later
"""From the table of commands to the actions and menus of a window."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

from palpate_editor.views.command import MENUS, Command, menu_title
from palpate_editor.views.icons import icon
from palpate_editor.views.theme import Colours

INSIDE = {
    "stages": "view",
    "directions": "view",
    "colours": "view",
    "theme": "view",
    "language": "view",
    "docks": "view",
    "recent": "file",
}
"""Menus that open out of another one."""
AFTER = {"recent": "open"}
"""Where in it, when not at its end."""


class ActionSet(QObject):
    """All actions, by name, and the menus they stand in."""

    def __init__(self, window: QMainWindow, commands: Sequence[Command]):
        super().__init__(window)
        self.window, self.commands = window, commands
        self.actions: dict[str, QAction] = {}
        self.menus: dict[str, QMenu] = {}
        self.groups: dict[str, QActionGroup] = {}
        for menu in MENUS:
            self.menus[menu] = window.menuBar().addMenu(menu_title(menu))
        for command in commands:
            self.add(command)
        for menu in INSIDE:
            self.menu(menu)

    def menu(self, name: str) -> QMenu:
        """A menu, made where it is asked for first."""
        if name not in self.menus:
            above = self.menus[INSIDE[name]]
            made = QMenu(menu_title(name), above)
            before = None
            if name in AFTER:
                entries = above.actions()
                before = entries[entries.index(self.actions[AFTER[name]]) + 1]
            if before is not None:
                above.insertMenu(before, made)
            else:
                above.addMenu(made)
            self.menus[name] = made
        return self.menus[name]

    def add(self, command: Command) -> QAction:
        action = QAction(command.text, self.window)
        action.setObjectName(command.name)
        action.setShortcuts([QKeySequence(keys) for keys in command.keys])
        action.setCheckable(command.checkable or bool(command.group))
        action.triggered.connect(command.slot)
        menu = self.menu(command.menu)
        if command.line_before:
            menu.addSeparator()
        menu.addAction(action)
        self.window.addAction(action)
        if command.group:
            group = self.groups.setdefault(command.group, QActionGroup(self.window))
            group.addAction(action)
        self.actions[command.name] = action
        return action

    def adopt(self, actions: Sequence[QAction], menu: str) -> None:
        """Actions that others made, such as a tool's."""
        target = self.menu(menu)
        target.addSeparator()
        for action in actions:
            target.addAction(action)
            self.window.addAction(action)

    def use_colours(self, colours: Colours) -> None:
        for command in self.commands:
            if command.sign:
                self.actions[command.name].setIcon(
                    icon(command.sign, colours.text, "#ffffff", colours.disabled)
                )

    def show_organ(self, there: bool) -> None:
        """What needs an organ cannot be done without one."""
        for command in self.commands:
            if command.needs_organ:
                self.actions[command.name].setEnabled(there)

    def check(self, name: str) -> None:
        """Marks an action as the one of its group in force."""
        self.actions[name].setChecked(True)

    def walk(self) -> Iterator[tuple[str, QAction]]:
        """Every action of the menus with the way to it, for the palette."""
        for name in MENUS:
            menu = self.menus[name]
            yield from walk_menu(menu, menu.title().replace("&", ""))


def walk_menu(menu: QMenu, path: str) -> Iterator[tuple[str, QAction]]:
    for action in menu.actions():
        inner = action.menu()
        if inner is not None:
            yield from walk_menu(inner, f"{path} \N{SINGLE RIGHT-POINTING ANGLE QUOTATION MARK} "
                                        f"{inner.title().replace('&', '')}")  # fmt: skip
        elif not action.isSeparator() and action.text():
            yield path, action
