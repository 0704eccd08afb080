# SPDX-License-Identifier: GPL-3.0-or-later
"""What the actions of the menus call, for annotations: the window has all of it."""

from __future__ import annotations

from typing import Protocol

from palpate_editor.views.appearance import Appearance
from palpate_editor.views.chart.chart_view import ChartView
from palpate_editor.views.context import Context
from palpate_editor.views.files import Files
from palpate_editor.views.menu_actions import MenuActions
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.touch import TestPanel


class CommandTargets(Protocol):
    """The parts of a window that do what its actions say, and what the window does itself."""

    context: Context
    files: Files
    menu_actions: MenuActions
    appearance: Appearance
    publishing: Publishing
    test_panel: TestPanel
    chart: ChartView

    def quit(self) -> None: ...
    def show_palette(self) -> None: ...
    def ask_scan(self) -> None: ...
    def on_stage_action(self) -> None: ...
    def toggle_run(self) -> None: ...
    def show_chart(self) -> None: ...
    def switch_full(self) -> None: ...
    def reset_layout(self) -> None: ...
    def show_help(self) -> None: ...
    def show_keys(self) -> None: ...
    def show_about(self) -> None: ...
