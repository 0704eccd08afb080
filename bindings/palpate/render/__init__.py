# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of organs and forces: moderngl, no Qt, no display needed."""

from palpate.render.camera import Camera
from palpate.render.colour_map import Legend, build_legend
from palpate.render.context import describe_gl, open_context
from palpate.render.error import RenderError
from palpate.render.force_plot import draw_force_plot, save_force_plot
from palpate.render.instrument import (
    DrawnInstrument,
    DrawnPart,
    build_instrument,
    build_trocar,
    place_instrument,
)
from palpate.render.instrument_shade import InstrumentShade, build_shade
from palpate.render.part import Appearance, Part, Pattern, build_appearance
from palpate.render.picture import Picture, draw_picture, save_picture, write_png
from palpate.render.renderer import Renderer, Tile
from palpate.render.scope_camera import ScopeCamera, has_camera, place_scope
from palpate.render.shapes import Shape, build_arrow, build_capsule, build_sphere

__all__ = [
    "Camera",
    "DrawnInstrument",
    "DrawnPart",
    "InstrumentShade",
    "Legend",
    "Appearance",
    "Part",
    "Pattern",
    "Picture",
    "RenderError",
    "Renderer",
    "ScopeCamera",
    "Shape",
    "Tile",
    "build_arrow",
    "build_capsule",
    "build_legend",
    "build_appearance",
    "build_instrument",
    "build_shade",
    "build_sphere",
    "build_trocar",
    "describe_gl",
    "draw_force_plot",
    "draw_picture",
    "has_camera",
    "open_context",
    "place_instrument",
    "place_scope",
    "save_force_plot",
    "save_picture",
    "write_png",
]
