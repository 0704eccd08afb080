# SPDX-License-Identifier: GPL-3.0-or-later
"""Touching the organ in the view: brushes, selection, and the live test with its force plot."""

from __future__ import annotations

from palpate_editor.views.context import Context
from palpate_editor.views.touch.brush_keys import BrushKeys
from palpate_editor.views.touch.brushes import FixTool, StiffnessTool
from palpate_editor.views.touch.colours import show_painted
from palpate_editor.views.touch.force_plot import ForcePlot
from palpate_editor.views.touch.live_costs import LiveCosts
from palpate_editor.views.touch.select_tool import SelectTool
from palpate_editor.views.touch.stroke import Brush
from palpate_editor.views.touch.test_panel import TestPanel
from palpate_editor.views.touch.tools import Tool

__all__ = [
    "Brush",
    "FixTool",
    "ForcePlot",
    "LiveCosts",
    "SelectTool",
    "StiffnessTool",
    "TestPanel",
    "build_tools",
    "show_painted",
]


def build_tools(context: Context) -> list[Tool]:
    """The tools of a window in the order of its tool strip; the brushes share one size."""
    brush = Brush()
    fix, stiffness = FixTool(context, brush), StiffnessTool(context, brush)
    stiffness.keys = BrushKeys([fix, stiffness], context)
    return [SelectTool(context), fix, stiffness]
