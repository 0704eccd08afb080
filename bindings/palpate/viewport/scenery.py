# SPDX-License-Identifier: BSD-3-Clause
"""What a view shows, kept in main memory, so that it can be put on any graphics context."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import moderngl
import numpy as np
from numpy.typing import ArrayLike, NDArray

import palpate
from palpate.render import (
    Appearance,
    Legend,
    Renderer,
    Shape,
    build_arrow,
    build_sphere,
)
from palpate.render.instrument_shade import InstrumentShade
from palpate.render.renderer import decode_all
from palpate.render.theme import DARK, THEMES
from palpate.viewport.appearance import ARROW, PAINTED, PLAIN, RIM, RING, TOOL
from palpate.viewport.dents import Dents
from palpate.viewport.drawn_dent import DrawnDent
from palpate.viewport.ring import build_ring
from palpate.viewport.sky_light import SkyLight
from palpate.viewport.thing import Thing

Array = NDArray[np.float64]

BALL = build_sphere(np.zeros(3), 1.0)
RING_THICKNESS = 0.004
"""[-] of the surface's radius."""
ARROW_RADIUS = 0.0065
"""[-] of the surface's diagonal."""
ROOM = 1.6
"""[-] radius of all that may be in sight in radii of the surface: tools stand beside it."""


class Scenery:
    """Surface, tool, arrow and ring. Only build, draw and release touch OpenGL.

    Everything else writes arrays, so it may be called without a current context, before there is
    one and after one was lost.
    """

    def __init__(self) -> None:
        self.version = self.surface_version = 0
        """Grow with every change of what is to be seen, and with every new surface."""
        self.theme = DARK
        self.legend: Legend | None = None
        self._wireframe = True
        self._tissue = PLAIN
        self.vertices: Array = np.zeros((0, 3))
        """[m] (n, 3) of the surface as it is shown; its own copy."""
        self.triangles: NDArray[np.int32] = np.zeros((0, 3), np.int32)
        self._used: NDArray[np.intp] = np.zeros(0, np.intp)
        self.room: Array = np.zeros((0, 3))
        """[m] (n, 3) what is to be in sight beside the surface."""
        self.reach = 0.0
        """[m] from the centre, of what is drawn and need not be in sight."""
        self.centre, self.radius = np.zeros(3), 1.0
        """[m] the ball around the surface as it was shown first."""
        self._things: dict[str, Thing] = {}
        self._arrow: tuple[float, ...] = ()
        self.shades: tuple[InstrumentShade, ...] = ()
        """Of the instruments in sight."""
        self._gone: list[Thing] = []
        self._renderer: Renderer | None = None
        self._tinted = False
        self._sky: SkyLight | None = None
        self.is_lit = True
        """Whether all the light that there is has been gathered."""
        self._dents: Dents | None = None
        self._dent = DrawnDent()
        self._openness: Array | float = 1.0
        """[-] (n,) of the surface at rest."""
        self._tree: palpate.AabbTree | None = None
        self._tree_is_stale = False

    # ------------------------------------------------------------ what is shown

    def show_surface(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        """A new surface. Raises ValueError for one that cannot be drawn."""
        x = np.array(vertices, dtype=np.float64, order="C")
        faces = np.array(triangles, dtype=np.int32, order="C")
        if x.ndim != 2 or x.shape[1] != 3 or not np.isfinite(x).all():
            raise ValueError(f"vertices must be finite, of shape (n, 3), got shape {x.shape}")
        if faces.ndim != 2 or faces.shape[1:] != (3,):
            raise ValueError(f"triangles must have shape (t, 3), got {faces.shape}")
        if len(faces) and (faces.min() < 0 or faces.max() >= len(x)):
            raise ValueError(
                f"triangles: got vertices {faces.min()} to {faces.max()}, "
                f"expected 0 to {len(x) - 1}"
            )
        self._dent.take_surface(x, faces)
        self._drop("surface")
        self._tinted = False
        self.version += 1
        self.surface_version += 1
        self.vertices, self.triangles = x, faces
        in_use = np.zeros(len(x), dtype=bool)
        in_use[faces] = True
        self._used = np.flatnonzero(in_use)
        self._tree, self.legend = None, None
        if not len(faces):
            return
        used = np.concatenate([x[self._used], self.room])
        self.centre = (used.min(axis=0) + used.max(axis=0)) / 2
        self.radius = max(1e-9, float(np.linalg.norm(used - self.centre, axis=1).max()))
        self._things["surface"] = Thing(len(x), faces, self._tissue)
        self._things["surface"].write("rest", x)
        self.is_lit, self._openness, self._dents = False, 1.0, None
        self.move_surface(x)

    def move_surface(self, vertices: ArrayLike, normals: ArrayLike | None = None) -> None:
        """New positions [m] of the same vertices. Raises ValueError for another number of them."""
        surface = self._things.get("surface")
        if surface is None or np.shape(vertices) != self.vertices.shape:
            raise ValueError(
                f"vertices must have the shape of the surface shown, {self.vertices.shape}, "
                f"got {np.shape(vertices)}"
            )
        if self._dents is None and not np.array_equal(self.vertices, vertices):
            at_rest = np.asarray(palpate.compute_vertex_normals(self.vertices, self.triangles))
            self._dents = Dents(self.vertices, at_rest)
        np.copyto(self.vertices, vertices)
        if normals is None:
            normals = palpate.compute_vertex_normals(self.vertices, self.triangles)
        self.version += 1
        surface.write("position", self.vertices)
        surface.write("normal", normals)
        self._darken()
        self._tree_is_stale = True

    def show_values(self, values: ArrayLike | None, legend: Legend | None) -> None:
        """One number per vertex in the colours of a legend; None for the colour of tissue."""
        surface = self._things.get("surface")
        self.legend = legend if values is not None else None
        self.version += 1
        if surface is not None:
            if values is not None:
                surface.write("value", values)
            surface.appearance = self._look() if values is None else PAINTED

    def show_colours(self, colours: ArrayLike | None) -> None:
        """sRGB of each vertex, (n, 3) uint8; None for the colour and the pattern of tissue."""
        surface = self._things.get("surface")
        self._tinted = colours is not None and surface is not None
        self.version += 1
        if surface is None:
            return
        if colours is not None:
            surface.tint()
            surface.write("tint", decode_all(colours))
        if self.legend is None:
            surface.appearance = self._look()

    def _look(self) -> Appearance:
        return replace(self._tissue, tinted=self._tinted)

    def use_appearance(self, appearance: Appearance | None) -> None:
        """How tissue takes the light wherever no values are shown; None for plain tissue."""
        surface = self._things.get("surface")
        before, self._tissue = self._tissue, appearance or PLAIN
        if surface is not None and self.legend is None and before != self._tissue:
            surface.appearance = self._look()
            self.version += 1

    def show_torn(self, damage: ArrayLike | None) -> None:
        """0 to 1 per vertex, where tissue has torn; None for tissue that is whole."""
        surface = self._things.get("surface")
        if surface is not None and (damage is not None or surface.streams["torn"].any()):
            self.version += 1
            surface.write("torn", 0.0 if damage is None else damage)

    def show_selection(self, weights: ArrayLike | None) -> None:
        """0 to 1 per vertex, what is highlighted."""
        surface = self._things.get("surface")
        self.version += 1
        if surface is not None:
            surface.write("selection", 0.0 if weights is None else weights)

    def show_tool(self, centre: ArrayLike | None, radius: float) -> None:
        """A ball, and its dent in the surface as that stands now."""
        self._draw_dent(centre, radius)
        if centre is None:
            self.hide_part("tool")
            return
        self.show_ball("tool", centre, radius)

    def show_ball(self, name: str, centre: ArrayLike, radius: float) -> None:
        """The tip of an instrument without a shaft [m], by name."""
        thing = self._use(name, len(BALL.vertices), BALL.triangles, TOOL)
        thing.write("normal", BALL.normals)
        thing.place(BALL.vertices, radius, centre)

    def shade(self, shades: Sequence[InstrumentShade]) -> None:
        """Shadow, ring and glow of the instruments on the surface; none takes them away."""
        if shades or self.shades:
            self.shades = tuple(shades)
            self.version += 1

    def show_force(
        self, tail: ArrayLike | None, point: ArrayLike | None = None, radius: float = 0.0
    ) -> None:
        """An arrow between two points [m], its shaft of a radius [m]; none without them."""
        if tail is None or point is None:
            self.hide_part("arrow")
            self._arrow = ()
            return
        arrow = (*np.ravel(tail), *np.ravel(point), radius)
        if arrow != self._arrow:
            self._arrow = arrow
            self.show_part("arrow", build_arrow(tail, point, radius), ARROW)

    def show_ring(
        self, centre: ArrayLike | None, normal: ArrayLike = (0, 0, 1), radius: float = 0.0
    ) -> None:
        if centre is None or not radius > 0.0:
            self.hide_part("ring")
            self.hide_part("rim")
            return
        thickness = RING_THICKNESS * self.radius
        for name, appearance, reach in (
            ("ring", RING, radius),
            ("rim", RIM, radius + 1.7 * thickness),
        ):
            self.show_part(name, build_ring(centre, normal, reach, thickness), appearance)

    def show_part(self, name: str, shape: Shape | None, appearance: Appearance = TOOL) -> None:
        """Something beside the surface, by name; its triangles stay. None takes it away, and with
        it its triangles."""
        if shape is None:
            self._drop(name)
            self.version += 1
            return
        thing = self._use(name, len(shape.vertices), shape.triangles, appearance)
        thing.appearance = appearance
        thing.write("normal", shape.normals)
        thing.write("position", shape.vertices)

    @property
    def wireframe(self) -> bool:
        return self._wireframe

    @wireframe.setter
    def wireframe(self, shown: bool) -> None:
        self._wireframe = shown
        self.version += 1

    # ------------------------------------------------------------ what is asked

    def points(self) -> Array:
        """[m] The vertices that some triangle uses, and the room; one point without either."""
        seen = np.concatenate([self.vertices[self._used], self.room])
        return seen if len(seen) else np.zeros((1, 3))

    def find_nearest(self, point: ArrayLike) -> palpate.SurfacePoint | None:
        """The point of the surface that is nearest to one [m]."""
        tree = self._refit()
        return None if tree is None else palpate.find_closest_point(tree, self.vertices, point)

    def _refit(self) -> palpate.AabbTree | None:
        """Of the surface as it is shown; None where there is none."""
        if not len(self.triangles):
            return None
        if self._tree is None:
            self._tree = palpate.AabbTree(self.vertices, self.triangles)
        elif self._tree_is_stale:
            self._tree.refit(self.vertices)
        self._tree_is_stale = False
        return self._tree

    def pick(self, origin: Array, direction: Array) -> palpate.SurfacePoint | None:
        """Where a ray first meets the surface from its outer side."""
        tree = self._refit()
        if tree is None:
            return None
        hit = palpate.find_ray_hit(tree, self.vertices, origin, direction)
        if hit is None:
            return None
        a, b, c = self.vertices[self.triangles[hit.triangle]]
        return hit if np.cross(b - a, c - a) @ direction < 0.0 else None

    # ------------------------------------------------------------ OpenGL

    def build(self, context: moderngl.Context) -> None:
        """Starts on a context, which must be current; what was on another one is forgotten."""
        self._renderer = Renderer(context, self.theme)
        self._sky, self.is_lit = None, False
        self._gone.clear()
        for thing in self._things.values():
            thing.part = None

    def prepare(self, shadow_softness: float, wire_width: float) -> Renderer:
        """The renderer with everything in it as it is now. The context must be current."""
        renderer = self._renderer
        assert renderer is not None, "build() comes first"
        for thing in self._gone:
            thing.hide_from(renderer)
            self._forget_sky()
            if renderer.ground is not None:
                renderer.ground.release()
                renderer.ground = None
        self._gone.clear()
        renderer.theme = self.theme
        renderer.shadow_softness, renderer.wire_width = shadow_softness, wire_width
        renderer.use_bounds(self.centre, max(ROOM * self.radius, self.reach))
        renderer.use_instruments(self.shades)
        if self.legend is not None:
            renderer.use_legend(self.legend)
        surface = self._things.get("surface")
        if surface is not None and surface.appearance.wired != self.wireframe:
            surface.appearance = replace(surface.appearance, wired=self.wireframe)
        for thing in self._things.values():
            thing.show_in(renderer)
        return renderer

    def release(self) -> None:
        """Gives back the graphics card's memory. The context must be current."""
        if self._renderer is not None:
            self._forget_sky()
            self._renderer.release()
            self._renderer = None
        self._gone.clear()
        for thing in self._things.values():
            thing.part = None

    def gather_light(self) -> bool:
        """Looks at the sky over the surface in one more direction; False when there is no more to
        do. The context must be current, and the surface must have been drawn.

        Goes on only while the surface stands where it was shown: what it is pressed in for a
        moment would stay dark.
        """
        surface, renderer = self._things.get("surface"), self._renderer
        if self.is_lit or surface is None or surface.part is None or renderer is None:
            return False
        if self._sky is None:
            x = self.vertices.copy()
            normals = np.asarray(palpate.compute_vertex_normals(x, self.triangles))
            ball = (self.centre, self.radius)
            self._sky = SkyLight(renderer.context, surface.part, (x, normals), ball)
        if not self.is_at_rest():
            return True
        if self._sky.step():
            return True
        self._openness = self._sky.result()
        self._darken()
        if renderer.ground is not None:
            renderer.ground.release()
        renderer.ground = self._sky.build_ground()
        self._forget_sky()
        self.is_lit = True
        self.version += 1
        return False

    def is_at_rest(self) -> bool:
        """Whether the surface stands where it stood when light was first gathered."""
        return self._sky is None or np.array_equal(self._sky.vertices, self.vertices)

    def _darken(self) -> None:
        """What the surface sees of the sky, as it is pressed in now."""
        surface = self._things["surface"]
        shade = 1.0 if self._dents is None else self._dents.shade(self.vertices)
        surface.write("openness", self._openness * shade)

    def _draw_dent(self, centre: ArrayLike | None, radius: float) -> None:
        surface = self._things.get("surface")
        ball = None if centre is None else (centre, radius)
        if self._dent.show(surface, self.vertices, self.triangles, ball):
            assert self._dent.thing is not None
            self._things["dent"] = self._dent.thing
            self.version += 1

    def _forget_sky(self) -> None:
        if self._sky is not None:
            self._sky.release()
            self._sky = None

    def use_theme(self, name: str) -> None:
        self.theme = THEMES[name]
        self.version += 1

    def _use(
        self, name: str, count: int, triangles: NDArray[np.integer], appearance: Appearance
    ) -> Thing:
        if name not in self._things:
            self._things[name] = Thing(count, triangles, appearance)
        self._things[name].visible = True
        self.version += 1
        return self._things[name]

    def hide_part(self, name: str) -> None:
        """Until it is shown again; its triangles stay."""
        if name in self._things and self._things[name].visible:
            self._things[name].visible = False
            self.version += 1

    def _drop(self, name: str) -> None:
        if name in self._things:
            self._gone.append(self._things.pop(name))
