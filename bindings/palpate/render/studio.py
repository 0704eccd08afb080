# SPDX-License-Identifier: BSD-3-Clause
"""From surfaces to pixels with no display: a floor, three lamps, the sky, and a camera."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import NDArray

from palpate.render.camera import Camera
from palpate.render.colour_map import Legend
from palpate.render.context import open_context
from palpate.render.ground import build_ground
from palpate.render.instrument_shade import InstrumentShade
from palpate.render.openness import Sky
from palpate.render.part import Appearance
from palpate.render.renderer import Renderer, Tile
from palpate.render.theme import Theme

TILE = 1024
"""[px] Sides of what is drawn at once, so that no picture is too large for the graphics card."""
EDGE_SAMPLES = 4
SHADOW_SOFTNESS = 0.035
"""[-] of the radius of what is in sight."""
WIRE_WIDTH = 1.05
"""[px] of a picture 720 pixels high."""


@dataclass(frozen=True)
class Thing:
    """A surface in the studio and how it looks."""

    vertices: NDArray[np.floating]
    """[m] (n, 3)"""
    normals: NDArray[np.floating]
    """(n, 3), unit."""
    triangles: NDArray[np.integer]
    """(t, 3)"""
    appearance: Appearance
    values: NDArray[np.floating] | None = None
    """(n,)"""
    selection: NDArray[np.floating] | None = None
    """(n,) 0 to 1."""
    tint: NDArray[np.floating] | None = None
    """(n, 3) Of each vertex, in linear light."""

    def points(self) -> NDArray[np.floating]:
        """[m] The vertices that some triangle uses: the others are nowhere to be seen."""
        return self.vertices[np.unique(self.triangles)]


@dataclass(frozen=True)
class Shot:
    """How a picture is taken."""

    camera: Camera
    size: tuple[int, int]
    """[px]"""
    supersample: int
    theme: Theme
    legend: Legend | None
    floor: float
    """[m] height of the floor."""
    shades: tuple[InstrumentShade, ...] = ()
    """Of the instruments among the things."""


def take_picture(things: Sequence[Thing], shot: Shot) -> NDArray[np.uint8]:
    """(h, w, 3), the top row first. Raises RenderError."""
    with open_context() as context:
        renderer = Renderer(context, shot.theme)
        arrange(renderer, things, shot)
        height, width = shot.size[1], shot.size[0]
        picture = np.empty((height, width, 3), np.uint8)
        for tile in cut_tiles(shot.size, TILE // shot.supersample):
            top = height - tile.bottom - tile.height
            picture[top : top + tile.height, tile.left : tile.left + tile.width] = expose(
                context, renderer, tile, shot
            )
        renderer.release()
    return picture


def arrange(renderer: Renderer, things: Sequence[Thing], shot: Shot) -> None:
    """Fills a renderer: parts, how much sky each point of them sees, shadows, floor."""
    centre, radius = find_ball(things)
    renderer.use_bounds(centre, radius)
    renderer.shadow_softness = SHADOW_SOFTNESS
    renderer.use_instruments(shot.shades)
    renderer.wire_width = max(0.7, WIRE_WIDTH * shot.size[1] / 720) * shot.supersample
    if shot.legend is not None:
        renderer.use_legend(shot.legend)
    for thing in things:
        part = renderer.add(len(thing.vertices), thing.triangles, thing.appearance)
        part.update(position=as_stream(thing.vertices), normal=as_stream(thing.normals))
        if thing.values is not None:
            part.update(value=as_stream(thing.values))
        if thing.selection is not None:
            part.update(selection=as_stream(thing.selection))
        if thing.tint is not None:
            part.update(tint=as_stream(thing.tint))
    sky = Sky(renderer.context, renderer.parts, centre, radius)
    for thing, part in zip(things, renderer.parts, strict=True):
        if thing.appearance.casts_shadow:
            part.update(openness=as_stream(sky.measure(thing.vertices, thing.normals)))
    middle, reach = find_ball([thing for thing in things if thing.appearance.casts_shadow])
    renderer.ground = build_ground(renderer.context, sky, middle, reach, shot.floor)


def find_ball(things: Sequence[Thing]) -> tuple[NDArray[np.float64], float]:
    """Centre and radius [m] of a ball that holds all things."""
    points = np.concatenate([thing.points() for thing in things]).astype(float)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return centre, float(np.linalg.norm(points - centre, axis=1).max())


def expose(
    context: moderngl.Context, renderer: Renderer, tile: Tile, shot: Shot
) -> NDArray[np.uint8]:
    """One tile of the picture, (h, w, 3), the top row first."""
    s = shot.supersample
    large = Tile(s * tile.left, s * tile.bottom, s * tile.width, s * tile.height)
    size = (large.width, large.height)
    samples = min(EDGE_SAMPLES, context.max_samples)
    # half floats: eight bits would show the steps of the backdrop
    attachments = (
        context.renderbuffer(size, 4, samples=samples, dtype="f2"),
        context.depth_renderbuffer(size, samples=samples),
        context.texture(size, 4, dtype="f2"),
    )
    drawn = context.framebuffer([attachments[0]], attachments[1])
    resolved = context.framebuffer([attachments[2]])
    drawn.use()
    renderer.draw(shot.camera, (s * shot.size[0], s * shot.size[1]), large)
    context.copy_framebuffer(resolved, drawn)
    pixels = np.frombuffer(attachments[2].read(), np.float16).reshape(large.height, large.width, 4)
    for thing in (drawn, resolved, *attachments):
        thing.release()
    blocks = pixels[..., :3].astype(np.float32).reshape(tile.height, s, tile.width, s, 3)
    mean = blocks.mean(axis=(1, 3))
    levels = np.floor(255.0 * np.clip(mean, 0.0, 1.0) + dither(tile)[..., None])
    return np.clip(levels, 0, 255).astype(np.uint8)[::-1]


def dither(tile: Tile) -> NDArray[np.float32]:
    """A threshold of 0 to 1 for every pixel, (h, w), that depends on its place alone and looks like
    grain: interleaved gradient noise [Jimenez14].
    """
    y, x = np.mgrid[0 : tile.height, 0 : tile.width]
    wave = 0.06711056 * (x + tile.left) + 0.00583715 * (y + tile.bottom)
    return ((52.9829189 * (wave % 1.0)) % 1.0).astype(np.float32)


def cut_tiles(size: tuple[int, int], largest: int) -> Iterator[Tile]:
    """Tiles of at most `largest` pixels a side that cover a picture once."""
    for bottom in range(0, size[1], largest):
        for left in range(0, size[0], largest):
            yield Tile(left, bottom, min(largest, size[0] - left), min(largest, size[1] - bottom))


def as_stream(array: NDArray[np.floating]) -> NDArray[np.float32]:
    return np.ascontiguousarray(array, dtype=np.float32)
