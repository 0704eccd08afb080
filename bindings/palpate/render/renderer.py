# SPDX-License-Identifier: BSD-3-Clause
"""Draws parts with any moderngl context: a window's, or one with no display. Knows no Qt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.render.camera import Camera
from palpate.render.colour_map import COLOUR_MAPS, LUT_SIZE, Legend
from palpate.render.ground import Ground
from palpate.render.instrument_shade import InstrumentShade, ShadeUniforms
from palpate.render.part import Appearance, Part, Pattern
from palpate.render.program import build_program, write_matrix
from palpate.render.shadow import ShadowMap
from palpate.render.theme import DARK, SELECTED, Colour, Theme

KEY = (-0.55, 0.75, 0.62)
FILL = (0.85, 0.10, 0.45)
RIM = (0.25, 0.65, -0.80)
"""Towards the lamps: right, up and back to the eye. They move with the camera, so that what one
looks at is never in the dark."""
COLOURS_UNIT, SHADOW_UNIT = 0, 1
GAMMA = 2.2
USUAL_ROUGHNESS = 0.3
"""[-] With it, highlights are as wide as the shader has them."""
SHADOW_TAPS = 24
"""Comparisons that blur the edge of a shadow."""


@dataclass(frozen=True)
class Tile:
    """A part of a picture that is too large to be drawn at once: pixels from its lower left."""

    left: int
    bottom: int
    width: int
    height: int


class Renderer:
    """Everything in sight, and the programs that draw it.

    The context must be current in every call. Bounds are the caller's: organs move little, and
    measuring them again in each frame would cost more than it gives.
    """

    def __init__(self, context: moderngl.Context, theme: Theme = DARK):
        self.context = context
        self.theme = theme
        self.parts: list[Part] = []
        self.ground: Ground | None = None
        self.shadow_softness = 0.0
        """[-] blur of the shadows in radii of what is in sight; 0 for none, the fastest."""
        self.wire_width = 1.0
        """[px]"""
        self._centre, self._radius = np.zeros(3), 1.0
        self._shades = ShadeUniforms()
        self._surfaces: dict[tuple[bool, bool, bool], moderngl.Program] = {}
        self._bare = self._choose_surface(False, False)
        self._backdrop = context.vertex_array(build_program(context, "background"), [])
        self._colours = context.texture((LUT_SIZE, 1), 3, dtype="f4")
        self._colours.filter = (moderngl.LINEAR, moderngl.LINEAR)
        self._colours.repeat_x = self._colours.repeat_y = False
        self._shadow = ShadowMap(context)
        self._range = (0.0, 1.0)
        self._write_colours("viridis")

    def add(self, vertex_count: int, triangles: ArrayLike, appearance: Appearance) -> Part:
        """A new part; its streams are empty until Part.update. Raises ValueError."""
        part = Part(self.context, self._bare, vertex_count, triangles, appearance)
        self.parts.append(part)
        return part

    def remove(self, part: Part) -> None:
        self.parts.remove(part)
        part.release()

    def use_legend(self, legend: Legend) -> None:
        """Paints values as a legend says; costs nothing per vertex."""
        self._write_colours(legend.colour_map)
        self._range = (legend.low, legend.high)

    def use_bounds(self, centre: ArrayLike, radius: float) -> None:
        """The ball [m] that holds all that is in sight."""
        self._centre, self._radius = np.asarray(centre, dtype=float), radius

    def use_instruments(self, shades: Sequence[InstrumentShade]) -> None:
        """Those that cast a shadow on the tissue, glow where they touch it and have a ring."""
        self._shades.use(shades)

    def draw(
        self,
        camera: Camera,
        size: tuple[int, int],
        tile: Tile | None = None,
        new_shadows: bool = True,
    ) -> None:
        """Draws a picture of `size` pixels, or a tile of it, into the framebuffer in use.

        Without `new_shadows`, shadows fall as cast_shadows left them: for tiles of one picture.
        """
        screen = self.context.fbo
        if new_shadows:
            self.cast_shadows(camera)
            screen.use()
        tile = tile or Tile(0, 0, *size)
        screen.viewport = (0, 0, tile.width, tile.height)
        studio = camera.headlight <= 0.0
        if studio:
            screen.clear(*self.theme.corner, 1.0)
            self._draw_backdrop(size, tile)
        else:  # what the lamp beside the eye does not reach is dark
            screen.clear(0.0, 0.0, 0.0, 1.0)
        near, far = camera.depths(self._centre, self._radius)
        seen = camera.projection(size[0] / size[1], near, far) @ camera.view()
        world_to_clip = cut(size, tile) @ seen
        if self.ground is not None and studio and camera.elevation > 0.0:
            self.ground.draw(self.theme, world_to_clip)
        # a lamp beside the eye casts its shadows where the eye does not look
        shaded = self.shadow_softness > 0.0 and studio
        for patterned in {has_pattern(part.appearance) for part in self.parts}:
            program = self._choose_surface(shaded, patterned)
            self._light(program, camera, world_to_clip, shaded)
        self._draw_parts(shaded)

    def cast_shadows(self, camera: Camera) -> None:
        """Finds what lies in the shade, if there is any; leaves its own framebuffer in use."""
        if self.shadow_softness > 0.0 and camera.headlight <= 0.0:
            self._shadow.draw(self.parts, self._centre, self._radius, lamp(camera, KEY))

    def release(self) -> None:
        """Gives back all memory of the graphics card, that of the parts included."""
        for part in self.parts:
            part.release()
        self.parts.clear()
        if self.ground is not None:
            self.ground.release()
        self._shadow.release()
        for thing in (self._backdrop, self._colours, *self._surfaces.values()):
            thing.release()

    def _write_colours(self, name: str) -> None:
        colours = (COLOUR_MAPS[name]() / 255.0) ** GAMMA
        self._colours.write(colours.astype(np.float32).tobytes())

    def _choose_surface(self, shaded: bool, patterned: bool) -> moderngl.Program:
        """With shadows, patterns and instruments only where there are any: they are most of the
        work."""
        key = (shaded, patterned, self._shades.capsules > 0)
        if key not in self._surfaces:
            defines = {
                "SHADOW_TAPS": SHADOW_TAPS if shaded else 0,
                "PATTERN": int(patterned),
                "INSTRUMENTS": int(key[2]),
            }
            program = build_program(self.context, "surface", geometry=True, defines=defines)
            self._surfaces[key] = program
        return self._surfaces[key]

    def _draw_backdrop(self, size: tuple[int, int], tile: Tile) -> None:
        self.context.enable_only(moderngl.NOTHING)
        program = self._backdrop.program
        program["middle"].value, program["rim"].value = self.theme.backdrop, self.theme.corner
        program["aspect"].value = size[0] / size[1]
        program["tile"].value = (
            tile.left / size[0],
            tile.bottom / size[1],
            (tile.left + tile.width) / size[0],
            (tile.bottom + tile.height) / size[1],
        )
        self._backdrop.render(moderngl.TRIANGLES, vertices=3)

    def _light(
        self,
        program: moderngl.Program,
        camera: Camera,
        world_to_clip: NDArray[np.float64],
        shaded: bool,
    ) -> None:
        """What all parts of one frame share."""
        write_matrix(program, "world_to_clip", world_to_clip)
        program["eye"].value = tuple(camera.eye())
        for name, direction in (("to_key", KEY), ("to_fill", FILL), ("to_rim", RIM)):
            program[name].value = tuple(lamp(camera, direction))
        program["headlight"].value = camera.headlight
        program["ambient"].value = self.theme.ambient
        program["value_range"].value = self._range
        program["highlight"].value = decode(SELECTED)
        program["colours"].value = COLOURS_UNIT
        self._colours.use(COLOURS_UNIT)
        if self._shades.capsules > 0:
            self._shades.write(program)
        if not shaded:
            return
        program["shadow"].value = SHADOW_UNIT
        self._shadow.texture.use(SHADOW_UNIT)
        # the map is two radii wide
        program["shadow_softness"].value = self.shadow_softness / 2
        write_matrix(program, "world_to_shadow", self._shadow.world_to_texture)

    def _draw_parts(self, shaded: bool) -> None:
        """First what may hide, then ghosts of what is hidden behind it, then what is not."""
        self.context.enable_only(moderngl.DEPTH_TEST)
        for part in self.parts:
            if not part.appearance.seen_through:
                self._draw_part(shaded, part, 1.0)
        screen, through = self.context.fbo, [p for p in self.parts if p.appearance.seen_through]
        # back faces would shine through the ghost itself
        self.context.enable_only(moderngl.DEPTH_TEST | moderngl.BLEND | moderngl.CULL_FACE)
        self.context.blend_func = (
            moderngl.SRC_ALPHA,
            moderngl.ONE_MINUS_SRC_ALPHA,
            moderngl.ZERO,
            moderngl.ONE,
        )
        self.context.depth_func, screen.depth_mask = ">", False
        for part in through:
            self._draw_part(shaded, part, part.appearance.ghost)
        self.context.depth_func, screen.depth_mask = "<", True
        self.context.enable_only(moderngl.DEPTH_TEST)
        for part in through:
            self._draw_part(shaded, part, 1.0)

    def _draw_part(self, shaded: bool, part: Part, opacity: float) -> None:
        appearance = part.appearance
        program = self._choose_surface(shaded, has_pattern(appearance))
        program["mapped"].value, program["colour"].value = (
            appearance.mapped,
            decode(appearance.colour),
        )
        program["tinted"].value = appearance.tinted
        program["gloss"].value, program["subsurface"].value = (
            appearance.gloss,
            appearance.subsurface,
        )
        program["sharpness"].value = USUAL_ROUGHNESS / max(appearance.roughness, 0.02)
        if appearance.pattern is not None and has_pattern(appearance):
            write_pattern(program, appearance.pattern)
        program["wire_width"].value = self.wire_width if appearance.wired else 0.0
        program["opacity"].value = opacity
        if self._shades.capsules > 0:
            program["tissue"].value = appearance.receives_instruments
        part.draw(program)


def has_pattern(appearance: Appearance) -> bool:
    """A colour map tells values, so nothing else is painted beside it."""
    return appearance.pattern is not None and not appearance.mapped


def write_pattern(program: moderngl.Program, pattern: Pattern) -> None:
    program["pattern_colour"].value = decode(pattern.colour)
    program["vein_colour"].value = decode(pattern.vein_colour)
    program["pattern_size"].value = pattern.size
    program["pattern_strength"].value = pattern.strength
    program["vein_strength"].value = pattern.vein_strength
    program["relief"].value = pattern.relief


def decode_all(colours: ArrayLike) -> NDArray[np.float32]:
    """The same of (n, 3) uint8, as the stream `tint` has it."""
    return np.asarray((np.asarray(colours) / 255.0) ** GAMMA, np.float32)


def decode(colour: Colour) -> Colour:
    """sRGB to linear light, as the shader turns it back."""
    red, green, blue = (part**GAMMA for part in colour)
    return red, green, blue


def lamp(camera: Camera, direction: tuple[float, float, float]) -> NDArray[np.float64]:
    """A direction given as right, up and back to the eye, as a unit vector of the world."""
    right, up, forward = camera.basis()
    towards = direction[0] * right + direction[1] * up - direction[2] * forward
    return np.asarray(towards / np.linalg.norm(towards))


def cut(size: tuple[int, int], tile: Tile) -> NDArray[np.float64]:
    """Clip space of a whole picture to that of a tile of it, (4, 4)."""
    matrix = np.eye(4)
    matrix[0, 0], matrix[1, 1] = size[0] / tile.width, size[1] / tile.height
    matrix[0, 3] = (size[0] - 2 * tile.left) / tile.width - 1.0
    matrix[1, 3] = (size[1] - 2 * tile.bottom) / tile.height - 1.0
    return matrix
