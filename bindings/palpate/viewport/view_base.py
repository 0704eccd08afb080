# SPDX-License-Identifier: BSD-3-Clause
"""What both hosts of the renderer share: what is shown, how it is turned, what is picked."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PySide6.QtCore import QPoint, QPointF, QTimer
from PySide6.QtGui import QImage, QResizeEvent

import palpate
from palpate.render import Appearance, Camera, Shape, build_legend
from palpate.render.hard_parts import Pose
from palpate.viewport import navigation
from palpate.viewport.canvas import Canvas
from palpate.viewport.force_arrow import choose_radius, keep_in_sight
from palpate.viewport.hard_parts import HardParts
from palpate.viewport.hint_line import HintLine
from palpate.viewport.hud import Hud
from palpate.viewport.instruments import Instruments, SeenInstrument
from palpate.viewport.legend_bar import LegendBar
from palpate.viewport.scenery import ARROW_RADIUS, Scenery
from palpate.viewport.scope_inset import ScopeInset
from palpate.viewport.view_events import ViewEvents

Array = NDArray[np.float64]

EDGE = 16
"""[px] between the view's sides and what is written over it."""
REST_MS = 200
"""[ms] without a change, after which the fine frame is begun."""
SHORTEST_ARROW = 1e-9
"""[m]"""
ARROW_EDGE = 14
"""[px] that the arrow keeps from what it may not leave."""
LIGHT_MS = 30
"""[ms] between two samples of the sky, each of some 10 ms on a processor."""


class ViewBase(ViewEvents):
    """A mixin of QWidget. Positions are in pixels of the widget, from its upper left corner."""

    force_scale: float
    """[m/N] of the arrow that show_force draws."""

    def set_up(self) -> None:
        """The rest of __init__, after that of the widget."""
        self.scenery = Scenery()
        self.instruments = Instruments(self.scenery)
        self.hard_parts = HardParts(self.scenery)
        self.camera = Camera()
        self.listen()
        self.force_scale = 0.01
        self.legend, self.hud, self.hint = LegendBar(self), Hud(self), HintLine(self)
        self.scope = ScopeInset(self)
        self._force: tuple[Array, Array] | None = None
        self._shows_force = True
        self._framed = True
        self._margins = (0, 0, 0, 0)
        self._canvas: Canvas | None = None
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self._refine)
        self._pause = QTimer(self)
        self._pause.setSingleShot(True)
        self._light = QTimer(self)
        self._light.setInterval(LIGHT_MS)
        self._light.timeout.connect(self._gather_light)
        self.setMinimumSize(160, 120)

    # ------------------------------------------------------------ what is shown

    def show_surface(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        """A new surface: vertices [m] (n, 3) and triangles (t, 3). Takes values and selection away.

        The camera stays, except for the first surface, which is fitted in. Raises ValueError.
        """
        first = not len(self.scenery.triangles)
        self.scenery.show_surface(vertices, triangles)
        self.legend.show_legend(None, "")
        if first:
            self.frame_all()
        self.update()

    def move_surface(self, vertices: ArrayLike, normals: ArrayLike | None = None) -> None:
        """New positions [m] of the same vertices; normals are computed where they are not given."""
        self.scenery.move_surface(vertices, normals)
        self.update()

    def show_values(
        self,
        values: ArrayLike | None,
        legend_title: str = "",
        value_range: tuple[float, float] | None = None,
        colour_map: str | None = None,
    ) -> None:
        """One number per vertex as colours, with a legend; None for plain tissue.

        Raises ValueError as palpate.render.build_legend does.
        """
        legend = None if values is None else build_legend(values, value_range, colour_map)
        self.scenery.show_values(values, legend)
        self.legend.show_legend(legend, legend_title)
        self._place_children()
        self.update()

    def use_appearance(self, appearance: Appearance | None) -> None:
        """How tissue takes the light wherever no values are shown; None for plain tissue."""
        self.scenery.use_appearance(appearance)
        self.update()

    def show_colours(self, colours: ArrayLike | None) -> None:
        """sRGB of each vertex of the surface shown, (n, 3) uint8, in place of its appearance's
        colour and pattern; None for those."""
        self.scenery.show_colours(colours)
        self.update()

    def show_torn(self, damage: ArrayLike | None) -> None:
        """0 to 1 per vertex, where tissue has torn; None for tissue that is whole."""
        self.scenery.show_torn(damage)
        self.update()

    def show_selection(self, weights: ArrayLike | None) -> None:
        """0 to 1 per vertex, what is highlighted."""
        self.scenery.show_selection(weights)
        self.update()

    def show_tool(self, centre: ArrayLike | None, radius: float = 0.0) -> None:
        """The tool's tip as a ball, both [m]; None takes it away."""
        self.scenery.show_tool(centre, radius)
        self.update()

    def show_instruments(self, seen: Sequence[SeenInstrument]) -> None:
        """The instruments as they are held, with shadow, ring and glow; none takes them away."""
        self.instruments.show(seen)
        self.scope.follow(seen)
        self.update()

    def change_scope(self) -> bool:
        """What the large picture and the inset are of, where there is a laparoscope; False where
        there is none."""
        changed = self.scope.change()
        self.update()
        return changed

    def show_hard_parts(self, scene: palpate.Scene) -> None:
        """Rigid bodies and scenery of a scene; before its surface, with which they are framed."""
        self.hard_parts.show(scene)
        self.update()

    def move_rigid(self, poses: Sequence[Pose]) -> None:
        """Rigid bodies of the scene shown, where they are now: RigidBody, RigidState or
        RigidSnapshot."""
        self.hard_parts.move(poses)
        self.update()

    def show_force(self, start: ArrayLike | None, vector: ArrayLike | None = None) -> None:
        """An arrow from `start` [m] for a force [N], kept in sight; None takes it away."""
        self._force = None
        if start is not None and vector is not None:
            shown = self.force_scale * np.asarray(vector, dtype=float)
            if np.linalg.norm(shown) >= SHORTEST_ARROW:
                self._force = np.array(start, dtype=float), shown
        self.update()

    def show_ring(
        self, centre: ArrayLike | None, normal: ArrayLike = (0, 0, 1), radius: float = 0.0
    ) -> None:
        """The cursor of a brush: a ring [m] on the surface; None takes it away."""
        self.scenery.show_ring(centre, normal, radius)
        self.update()

    def show_part(self, name: str, shape: Shape | None, appearance: Appearance) -> None:
        """Something beside the surface, by a name of its own; its triangles stay. None takes it
        away."""
        self.scenery.show_part(name, shape, appearance)
        self.update()

    def hide_part(self, name: str) -> None:
        """Until it is shown again; nothing where there is none of that name."""
        self.scenery.hide_part(name)
        self.update()

    @property
    def shows_force(self) -> bool:
        """Whether a force is drawn as an arrow."""
        return self._shows_force

    @shows_force.setter
    def shows_force(self, shown: bool) -> None:
        self._shows_force = bool(shown)
        self.update()

    @property
    def wireframe(self) -> bool:
        """Whether edges are drawn."""
        return self.scenery.wireframe

    @wireframe.setter
    def wireframe(self, shown: bool) -> None:
        self.scenery.wireframe = bool(shown)
        self.update()

    def use_theme(self, name: str) -> None:
        """dark or light. Raises KeyError for another one."""
        self.scenery.use_theme(name)
        self.legend.use_theme(self.scenery.theme)
        self.hud.use_theme(self.scenery.theme)
        self.hint.use_theme(self.scenery.theme)
        self.scope.use_theme(self.scenery.theme)
        self.update()

    def grab_picture(self) -> QImage:
        """What the view shows, drawn as finely as can be, legend and numbers included."""
        self.grab()
        if self._canvas is not None:
            with self.in_context():
                while self.scenery.is_at_rest() and self.scenery.gather_light():
                    pass
                self._canvas.draw(*self.shot())
                while self._canvas.refine(*self.shot()):
                    pass
            self.refined()
        return self.grab().toImage()

    def is_busy(self) -> bool:
        """A processor that draws has had its share: what moves by itself should drop this frame."""
        return self._pause.isActive()

    # ------------------------------------------------------------ camera: not that of an instrument

    def frame_all(self) -> None:
        """Comes as near as it can with all of the surface in sight."""
        self._framed = True
        navigation.fit(self.camera, self.scenery.points(), self._size(), self._margins)
        self.update()

    def keep_free(self, left: int = 0, top: int = 0, right: int = 0, bottom: int = 0) -> None:
        """Pixels at the sides that frame_all leaves for what is written over the view."""
        self._margins = (left, top, right, bottom)
        self._place_children()
        if self._framed:
            self.frame_all()

    def look_from(self, azimuth: float, elevation: float) -> None:
        """Turns to angles [rad] as Camera has them."""
        self.camera.azimuth, self.camera.elevation = 0.0, 0.0
        self.camera.orbit(azimuth, elevation)
        if self._framed:
            self.frame_all()
        self.update()

    def orbit(self, x: float, y: float) -> None:
        """Turns by a drag of (x, y) pixels."""
        if self.seen_from is not self.camera:
            return
        navigation.turn(self.camera, x, y)
        self._framed = False
        self.update()

    def pan(self, x: float, y: float) -> None:
        """Moves by a drag of (x, y) pixels."""
        if self.seen_from is not self.camera:
            return
        self.camera.pan(x, y, self._size())
        self._framed = False
        self.update()

    def zoom(self, factor: float, at: QPointF | None = None) -> None:
        """Comes nearer by a factor, to what lies at a pixel or to the middle."""
        if self.seen_from is not self.camera:
            return
        where = QPointF(self.width() / 2, self.height() / 2) if at is None else at
        origin, direction = self.ray_at(where)
        hit = self.scenery.pick(origin, direction)
        point = navigation.meet_target_plane(self.camera, origin, direction)
        if hit is not None:
            point = np.asarray(hit.point)
        navigation.zoom_to(self.camera, point, factor, self.scenery.radius)
        self._framed = False
        self.update()

    # ------------------------------------------------------------ where things are

    @property
    def seen_from(self) -> Camera:
        """What the large picture is seen from: `camera`, which a mouse turns, or a laparoscope."""
        return self.scope.choose(self.camera)[0]

    def ray_at(self, at: QPointF) -> tuple[Array, Array]:
        """The eye [m] and the unit direction through a pixel."""
        return self.seen_from.ray(at.x(), at.y(), self._size())

    def pick(self, at: QPointF) -> palpate.SurfacePoint | None:
        """The point of the surface under a pixel, if its outer side is seen there."""
        return self.scenery.pick(*self.ray_at(at))

    def world_to_pixel(self, point: ArrayLike) -> QPointF:
        pixels, _ = self.seen_from.project(point, self._size())
        return QPointF(*pixels[0])

    def pixel_size_at(self, point: ArrayLike) -> float:
        """[m] that a pixel covers at the depth of a point [m]."""
        return navigation.measure_pixel(self.seen_from, point, self._size()[1])

    # ------------------------------------------------------------ for the hosts

    def pixels(self) -> tuple[int, int]:
        """Size of a frame in pixels of the screen."""
        ratio = self.devicePixelRatioF()
        return max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))

    def shot(self) -> tuple[Scenery, Camera, tuple[int, int], float]:
        """What a canvas wants to know of a frame."""
        return self.scenery, self.seen_from, self.pixels(), self.devicePixelRatioF()

    def in_context(self) -> AbstractContextManager[None]:
        """Makes the view's OpenGL context current, where it is not always so."""
        return nullcontext()

    def draw_frame(self, canvas: Canvas) -> bool:
        """Draws a frame where something has changed, and has the fine one begun when it rests."""
        self._place_arrow()
        self.instruments.shade(self.pixel_size_at(self.scenery.centre))
        drawn = canvas.draw(*self.shot())
        self._draw_inset(canvas)
        if drawn and canvas.is_software:
            self._rest.start(REST_MS)
            if canvas.pause > 0.0:
                self._pause.start(round(1e3 * canvas.pause))
        if not self.scenery.is_lit and not self._light.isActive():
            self._light.start()
        return drawn

    def _draw_inset(self, canvas: Canvas) -> None:
        """The other picture, where there are two."""
        camera, ratio = self.scope.choose(self.camera)[1], self.devicePixelRatioF()
        if camera is None:
            return
        side = max(1, round(self.scope.width() * ratio))
        pixels = canvas.draw_inset(self.scenery, camera, (side, side), ratio)
        if pixels is not None:
            self.scope.take(pixels)

    def _place_arrow(self) -> None:
        """Where it is in sight, for the camera as it stands now."""
        if self._force is None or not self._shows_force:
            self.scenery.show_force(None)
            return
        size = self._size()
        left, top, right, bottom = navigation.find_frame(size, self._margins)
        frame = left + ARROW_EDGE, top + ARROW_EDGE, right - ARROW_EDGE, bottom - ARROW_EDGE
        tail, point = keep_in_sight(self.seen_from, size, frame, *self._force)
        usual = ARROW_RADIUS * 2 * self.scenery.radius
        self.scenery.show_force(tail, point, choose_radius(self.seen_from, size[1], tail, usual))

    def refined(self) -> None:
        """The fine frame is whole."""
        self.update()

    def _gather_light(self) -> None:
        """One look at the sky, while the view is seen."""
        if self._canvas is None or not self.isVisible():
            self._light.stop()
            return
        with self.in_context():
            more = self.scenery.gather_light()
        if not more:
            self._light.stop()
            self.update()

    def _refine(self) -> None:
        """One tile; the next one once the window has had its turn."""
        if self._canvas is None or not self.isVisible():
            return
        with self.in_context():
            more = self._canvas.refine(*self.shot())
        if more:
            self._rest.start(0)
        else:
            self.refined()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)  # type: ignore[misc]
        if self._framed:
            self.frame_all()
        self._place_children()

    def _place_children(self) -> None:
        left, _, right, bottom = self._margins
        self.legend.move(QPoint(EDGE, EDGE))
        self.hud.place(QPoint(self.width() - right - EDGE, EDGE))
        self.scope.place(EDGE, self.height() - bottom - EDGE, self.height())
        middle = (left + self.width() - right) / 2
        self.hint.place(middle, self.height() - EDGE - bottom, self.width() - left - right - EDGE)

    def _size(self) -> tuple[int, int]:
        return max(1, self.width()), max(1, self.height())
