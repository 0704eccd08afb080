# SPDX-License-Identifier: BSD-3-Clause
"""A whole picture of an organ, with no display: surface, tool, force, legend and title."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import matplotlib.image
import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.files.whole_file import write_whole
from palpate.render.camera import Camera
from palpate.render.colour_map import build_legend
from palpate.render.hard_parts import BESIDE, choose_framed
from palpate.render.instrument import METAL, DrawnPart
from palpate.render.instrument_shade import InstrumentShade
from palpate.render.overlay import Overlay
from palpate.render.part import Appearance
from palpate.render.renderer import decode_all
from palpate.render.shapes import (
    ARROW_HEAD,
    Shape,
    as_point,
    build_arrow,
    build_sphere,
    require_positive,
)
from palpate.render.studio import Shot, Thing, take_picture
from palpate.render.theme import FORCE, THEMES, TISSUE, Colour

Array = NDArray[np.float64]

SMALLEST, LARGEST = 16, 8192
"""[px] of a side."""
LONGEST_ARROW = 0.32
ARROW_RADIUS = 0.0065
"""[-] of the organ's diagonal."""
FORCE_SHOWN = 5e-4
"""[N] The smallest that the label does not call zero."""


@dataclass(frozen=True)
class Picture:
    """Everything that a picture shows and how."""

    vertices: ArrayLike
    """[m] (n, 3), where the organ is now."""
    triangles: ArrayLike
    """(t, 3), counter-clockwise from outside; the surface may be open."""
    values: ArrayLike | None = None
    """(n,) what the colours tell, in the unit that the legend names."""
    legend: str = ""
    """Title of the legend, with the unit: "displacement [mm]"."""
    value_range: tuple[float, float] | None = None
    """Ends of the colour map; without it round numbers that hold all values."""
    colour_map: str | None = None
    """viridis or cool_warm; without it the latter where values have both signs."""
    selection: ArrayLike | None = None
    """(n,) 0 to 1, what is highlighted."""
    tool: tuple[ArrayLike, float] | None = None
    """Centre [m] and radius [m] of the tip."""
    instrument: Sequence[DrawnPart] = ()
    """[m] What is drawn in the place of the tip's ball: an instrument where it is."""
    beside: Sequence[DrawnPart] = ()
    """[m] What stands beside the organ: stones, bones, tables."""
    shade: InstrumentShade | None = None
    """Its shadow on the organ and its glow; without one, those of the tip's ball."""
    force: ArrayLike | None = None
    """[N] (3,) what the hand feels: an arrow from the middle of the tool, which it needs."""
    force_scale: float | None = None
    """[m/N] length of the arrow; without it a round one that suits the organ."""
    title: str = ""
    theme: str = "dark"
    """dark or light."""
    size: tuple[int, int] = (1280, 720)
    """[px] width and height, each 16 to 8192."""
    azimuth: float = -60.0
    """[degree] of the eye around z, from +x towards +y."""
    elevation: float = 25.0
    """[degree] of the eye above the horizontal, -90 to 90."""
    camera: Camera | None = None
    """The eye itself; without it all is fitted in as seen from azimuth and elevation."""
    wireframe: bool = True
    colour: Colour = TISSUE
    """sRGB, 0 to 1, of an organ without values."""
    appearance: Appearance | None = None
    """How an organ without values takes the light; without it, `colour` alone."""
    vertex_colours: ArrayLike | None = None
    """(n, 3) uint8, sRGB, in place of that one's colour and pattern."""
    supersample: int = 2
    """Rows and columns of samples per pixel, 1 to 4; edges get four times as many."""


def draw_picture(vertices: ArrayLike, triangles: ArrayLike, **options: Any) -> NDArray[np.uint8]:
    """Draws a picture, (h, w, 3), sRGB, the top row first.

    `options` are the other fields of Picture. Raises ValueError where one of them is wrong and
    RenderError where this machine cannot draw.
    """
    picture = Picture(vertices, triangles, **options)
    x, faces = check_surface(picture)
    check_options(picture)
    theme = THEMES[picture.theme]
    values = None if picture.values is None else as_column(picture.values, len(x), "values")
    legend = None
    if values is not None:
        legend = build_legend(values, picture.value_range, picture.colour_map)
    things = [build_organ(picture, x, faces, values)]
    arrow = find_arrow(picture, x)
    stand = [as_thing(part.shape, part.appearance) for part in picture.beside]
    things += [*stand, *build_tool(picture, arrow)]

    overlay = Overlay(picture.size, theme)
    overlay.add_title(picture.title)
    if legend is not None:
        overlay.add_legend(legend, picture.legend)
    if arrow is not None:
        overlay.add_note(f"arrow: {1e3 * arrow.scale:g} mm per N")
    camera = picture.camera or place_camera(picture, things, overlay)
    if arrow is not None:
        label_arrow(overlay, camera, arrow, picture.size)
    floor = min(float(thing.points()[:, 2].min()) for thing in [things[0], *stand])
    shades = find_shades(picture)
    shot = Shot(camera, picture.size, picture.supersample, theme, legend, floor, shades)
    return overlay.blend(take_picture(things, shot))


def save_picture(
    path: str | os.PathLike[str], vertices: ArrayLike, triangles: ArrayLike, **options: Any
) -> None:
    """Draws a picture as draw_picture does and writes it as PNG. Raises OSError as well."""
    write_png(path, draw_picture(vertices, triangles, **options))


def write_png(path: str | os.PathLike[str], pixels: NDArray[np.uint8]) -> None:
    """Writes a picture (h, w, 3), whole or not at all. Raises OSError."""
    file = io.BytesIO()
    # the words say nothing that changes from day to day: the same picture is the same file
    matplotlib.image.imsave(file, pixels, format="png")
    write_whole(path, file.getvalue())


# ---------------------------------------------------------------- what is shown


@dataclass(frozen=True)
class Arrow:
    """A force as it is drawn."""

    start: Array
    end: Array
    """[m] (3,)"""
    radius: float
    """[m] of the shaft."""
    scale: float
    """[m/N]"""
    label: str


def find_arrow(picture: Picture, x: Array) -> Arrow | None:
    """The arrow of the force; none where no force is shown or it is as good as zero."""
    if picture.force is None or picture.tool is None:
        return None
    force = as_point(picture.force, "force")
    size = float(np.linalg.norm(force))
    if size < FORCE_SHOWN:
        return None
    scale = picture.force_scale
    if scale is None:
        scale = 1e-3 * round_down(1e3 * LONGEST_ARROW * measure_diagonal(x) / size)
    start = as_point(picture.tool[0], "tool")
    decimals = 2 if size >= 0.1 else 3
    radius = ARROW_RADIUS * measure_diagonal(x)
    return Arrow(start, start + scale * force, radius, scale, f"{size:.{decimals}f} N")


def build_organ(
    picture: Picture, x: Array, faces: NDArray[np.int32], values: Array | None
) -> Thing:
    appearance = Appearance(
        colour=picture.colour,
        mapped=values is not None,
        wired=picture.wireframe,
        receives_instruments=True,
        gloss=0.55 if values is None else 0.4,
        # red light creeping round would be read as a value
        subsurface=0.3 if values is None else 0.0,
    )
    if picture.appearance is not None and values is None:
        appearance = replace(picture.appearance, wired=picture.wireframe, receives_instruments=True)
    selection, tint = picture.selection, None
    if picture.vertex_colours is not None and values is None:
        if np.shape(picture.vertex_colours) != np.shape(x):
            got = np.shape(picture.vertex_colours)
            raise ValueError(f"vertex_colours must have shape {np.shape(x)}, got {got}")
        tint = decode_all(picture.vertex_colours)
        appearance = replace(appearance, tinted=True)
    return Thing(
        x,
        np.asarray(palpate.compute_vertex_normals(x, faces)),
        faces,
        appearance,
        values,
        None if selection is None else as_column(selection, len(x), "selection"),
        tint,
    )


def build_tool(picture: Picture, arrow: Arrow | None) -> list[Thing]:
    """The tip and its force, where there are any."""
    things = []
    if picture.tool is not None:
        ball = DrawnPart(build_sphere(*picture.tool), METAL)
        things += [as_thing(part.shape, part.appearance) for part in picture.instrument or (ball,)]
    if arrow is not None:
        sign = build_arrow(arrow.start, arrow.end, arrow.radius)
        # a sign, not a thing: it leaves no shadow
        appearance = Appearance(
            FORCE, gloss=0.3, subsurface=0.0, seen_through=True, casts_shadow=False
        )
        things.append(as_thing(sign, appearance))
    return things


def find_shades(picture: Picture) -> tuple[InstrumentShade, ...]:
    """What the instrument does to the look of the organ."""
    if picture.shade is not None:
        return (picture.shade,)
    if picture.tool is None:
        return ()
    middle = as_point(picture.tool[0], "tool")[None]
    return (InstrumentShade(middle, middle, float(picture.tool[1])),)


def as_thing(shape: Shape, appearance: Appearance) -> Thing:
    return Thing(shape.vertices, shape.normals, shape.triangles, appearance)


def place_camera(picture: Picture, things: list[Thing], overlay: Overlay) -> Camera:
    """As near as the first thing, the organ, and what stands by it fit into what title and legend
    leave free: a shaft may leave the picture."""
    camera = Camera(math.radians(picture.azimuth), math.radians(picture.elevation))
    free = overlay.free
    frame = (free.left, free.top, free.right, free.bottom)
    if free.right - free.left < picture.size[0] / 4 or free.bottom - free.top < picture.size[1] / 4:
        frame = (0.0, 0.0, float(picture.size[0]), float(picture.size[1]))
    organ = things[0].points()
    middle = 0.5 * (organ.min(axis=0) + organ.max(axis=0))
    reach = BESIDE * np.linalg.norm(organ - middle, axis=1).max()
    count = 1 + len(picture.beside)
    others = np.concatenate([organ[:0], *(thing.points() for thing in things[count:])])
    near = others[np.linalg.norm(others - middle, axis=1) <= reach]
    beside = choose_framed(picture.beside, middle, reach / BESIDE)
    camera.fit(np.concatenate([organ, near, beside]), picture.size, frame)
    return camera


def label_arrow(overlay: Overlay, camera: Camera, arrow: Arrow, size: tuple[int, int]) -> None:
    ends, depth = camera.project([arrow.start, arrow.end], size)
    if depth.min() <= 0.0:  # behind the eye
        return
    pixels = size[1] / 2 / math.tan(camera.field_of_view / 2) / depth[1]
    overlay.add_label(arrow.label, ends[0], ends[1], 2 * ARROW_HEAD * arrow.radius * pixels)


def round_down(value: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is not above a positive value."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(m * power for m in (5.0, 2.0, 1.0) if m * power <= value * (1 + 1e-9))


def measure_diagonal(x: Array) -> float:
    return float(np.linalg.norm(x.max(axis=0) - x.min(axis=0)))


# ---------------------------------------------------------------- the border


def check_surface(picture: Picture) -> tuple[Array, NDArray[np.int32]]:
    """Vertices and triangles as arrays. Raises ValueError."""
    x = np.ascontiguousarray(picture.vertices, dtype=float)
    if x.ndim != 2 or x.shape[1] != 3 or not np.isfinite(x).all():
        raise ValueError(f"vertices must be finite numbers of shape (n, 3), got shape {x.shape}")
    faces = np.asarray(picture.triangles)
    if faces.ndim != 2 or faces.shape[1:] != (3,) or len(faces) == 0:
        raise ValueError(f"triangles must have shape (t, 3), t > 0, got shape {faces.shape}")
    if faces.min() < 0 or faces.max() >= len(x):
        raise ValueError(
            f"triangles must name vertices 0 to {len(x) - 1}, got {faces.min()} to {faces.max()}"
        )
    if measure_diagonal(x) == 0.0:
        raise ValueError(f"vertices: got {len(x)} in one point, expected some apart")
    return x, np.ascontiguousarray(faces, dtype=np.int32)


def check_options(picture: Picture) -> None:
    """Raises ValueError for anything that is wrong beside the surface."""
    if picture.theme not in THEMES:
        raise ValueError(f"theme must be one of {', '.join(THEMES)}, got {picture.theme!r}")
    if not all(SMALLEST <= side <= LARGEST for side in picture.size):
        raise ValueError(f"size must be {SMALLEST} to {LARGEST} pixels, got {picture.size}")
    if picture.supersample not in (1, 2, 3, 4):
        raise ValueError(f"supersample must be 1 to 4, got {picture.supersample}")
    if not (math.isfinite(picture.azimuth) and -90.0 <= picture.elevation <= 90.0):
        raise ValueError(
            f"azimuth must be finite and elevation -90 to 90 degrees, "
            f"got {picture.azimuth} and {picture.elevation}"
        )
    if picture.tool is not None:
        as_point(picture.tool[0], "tool")
        require_positive(picture.tool[1], "radius of the tool")
    if picture.force is not None and picture.tool is None:
        raise ValueError("tool: got none, expected one: force is drawn from it")
    if picture.force_scale is not None:
        require_positive(picture.force_scale, "force_scale")


def as_column(values: ArrayLike, count: int, name: str) -> Array:
    column = np.asarray(values, dtype=float)
    if column.shape != (count,) or not np.isfinite(column).all():
        raise ValueError(f"{name} must be finite, one per vertex ({count}), got {column.shape}")
    return column
