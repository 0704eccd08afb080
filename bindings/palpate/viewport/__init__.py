# SPDX-License-Identifier: BSD-3-Clause
"""The 3D view of a window: palpate.render's pictures, turned, picked and pressed with a mouse.

Needs PySide6, which the plain `palpate` distribution does not: pip install "palpate[player]".
"""

from palpate.viewport.fbo_view import FboView
from palpate.viewport.gl_view import GLView
from palpate.viewport.hud import Hud
from palpate.viewport.instruments import SeenInstrument, see_instruments
from palpate.viewport.legend_bar import LegendBar
from palpate.viewport.make_view import View, make_view
from palpate.viewport.pointer_hand import Grip, PointerHand
from palpate.viewport.pointer_hands import PointerHands
from palpate.viewport.show_frame import show_frame
from palpate.viewport.view_base import ViewBase
from palpate.viewport.view_tool import ViewTool

__all__ = [
    "FboView",
    "GLView",
    "Grip",
    "Hud",
    "LegendBar",
    "PointerHand",
    "PointerHands",
    "SeenInstrument",
    "View",
    "ViewBase",
    "ViewTool",
    "make_view",
    "see_instruments",
    "show_frame",
]
