# SPDX-License-Identifier: BSD-3-Clause
"""A frame of a run, in a view."""

from __future__ import annotations

import palpate
from palpate.runs.live import Frame
from palpate.scene.surfaces import join_positions, join_torn
from palpate.viewport.instruments import see_instruments
from palpate.viewport.view_base import ViewBase


def show_frame(view: ViewBase, scene: palpate.Scene, frame: Frame) -> None:
    """All bodies and instruments of a scene as the frame has them."""
    view.move_surface(join_positions(frame.positions))
    view.show_torn(join_torn(frame.torn, frame.positions))
    view.move_rigid(frame.rigid)
    view.show_instruments(see_instruments(scene, frame))
