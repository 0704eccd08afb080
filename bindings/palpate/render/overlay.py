# SPDX-License-Identifier: BSD-3-Clause
"""What is written over a picture: title, legend, and the label of the arrow."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch, Polygon
from numpy.typing import NDArray

from palpate.render.colour_map import COLOUR_MAPS, Legend
from palpate.render.theme import Colour, Theme

DPI = 100
FONT = "DejaVu Sans"
"""Comes with matplotlib, so that a picture has the same letters on every machine."""
REFERENCE = (1280, 720)
"""The size [px] that the lengths below are given for."""
SMALLEST_TEXT = 10.5
"""[px] Letters shrink with the picture, but not below what can be read."""
SUPERSCRIPT = str.maketrans("-0123456789", "\N{SUPERSCRIPT MINUS}⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Box:
    """A rectangle of the picture [px] from its upper left corner."""

    left: float
    top: float
    right: float
    bottom: float

    def meets(self, other: Box, gap: float = 0.0) -> bool:
        return (
            self.left < other.right + gap
            and other.left < self.right + gap
            and self.top < other.bottom + gap
            and other.top < self.bottom + gap
        )

    def holds(self, other: Box) -> bool:
        return (
            self.left <= other.left
            and other.right <= self.right
            and self.top <= other.top
            and other.bottom <= self.bottom
        )


class Overlay:
    """A transparent sheet the size of the picture, and which of its places are taken."""

    def __init__(self, size: tuple[int, int], theme: Theme):
        self.size, self.theme = size, theme
        self.scale = min(size[0] / REFERENCE[0], size[1] / REFERENCE[1])
        self.margin = 26.0 * self.scale
        self.taken: list[Box] = []
        self.free = Box(self.margin, self.margin, size[0] - self.margin, size[1] - self.margin)
        """What the title and the legend leave for the organ."""
        figure = Figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI)
        figure.patch.set_alpha(0.0)
        self._canvas = FigureCanvasAgg(figure)
        self._axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self._axes.set(xlim=(0, size[0]), ylim=(size[1], 0))
        self._axes.set_axis_off()

    def letters(self, pixels: float) -> float:
        """Height of text [px] that is `pixels` high in the reference picture."""
        return max(pixels * self.scale, min(SMALLEST_TEXT, pixels))

    def measure(self, text: str, pixels: float, weight: str = "normal") -> tuple[float, float]:
        """Width and height [px] of a line, room for descenders included."""
        drawn = self._axes.text(
            0, 0, text, fontsize=pixels * 72 / DPI, family=FONT, weight=weight, parse_math=False
        )
        width = drawn.get_window_extent(self._canvas.get_renderer()).width
        drawn.remove()
        return width, 1.3 * pixels

    def write(
        self,
        x: float,
        y: float,
        text: str,
        pixels: float,
        colour: Colour,
        weight: str = "normal",
        align: str = "left",
    ) -> None:
        """A line with its middle at the height y."""
        self._axes.text(
            x,
            y,
            text,
            fontsize=pixels * 72 / DPI,
            family=FONT,
            weight=weight,
            color=colour,
            ha=align,
            va="center_baseline",
            parse_math=False,
        )

    def back(self, box: Box, opacity: float) -> None:
        """A rounded panel that text stands on."""
        rounding = min(9.0 * self.scale + 2.0, (box.bottom - box.top) / 2)
        self._axes.add_patch(
            FancyBboxPatch(
                (box.left, box.top),
                box.right - box.left,
                box.bottom - box.top,
                boxstyle=f"round,pad=0,rounding_size={rounding}",
                linewidth=0,
                facecolor=(*self.theme.panel, opacity),
            )
        )

    def add_title(self, title: str) -> None:
        """One line on top, shortened where the picture is too narrow for it."""
        pixels = self.letters(22.0)
        room = self.size[0] - 2 * self.margin
        text = title
        while text and self.measure(text, pixels, "bold")[0] > room:
            text = text.removesuffix("…")[:-1].rstrip() + "…" if len(text) > 2 else ""
        if not text:
            return
        width, height = self.measure(text, pixels, "bold")
        m = self.margin
        self.write(m, m + height / 2, text, pixels, self.theme.text, "bold")
        self._take(Box(m, m, m + width, m + height))
        self._shrink(top=m + height + 0.25 * m)

    def add_legend(self, legend: Legend, title: str) -> None:
        """Bar, ticks and unit on the left; left out where the picture is too small for them."""
        pixels = self.letters(15.0)
        if legend.exponent:
            power = str(legend.exponent).translate(SUPERSCRIPT)
            title = f"{title} \N{MULTIPLICATION SIGN} 10{power}".strip()
        pad, bar = 0.9 * pixels, 1.1 * pixels
        title_width, line = self.measure(title, pixels) if title else (0.0, 0.0)
        label_width = max(self.measure(label, pixels)[0] for label in legend.labels)
        ends = 0.8 * bar
        length = min(
            max(0.42 * self.size[1], 1.45 * pixels * len(legend.labels)),
            self.free.bottom - self.free.top - 2 * pad - 1.4 * line - 2 * ends,
        )
        width = 2 * pad + max(title_width, bar + 0.75 * pixels + label_width)
        if width > 0.4 * self.size[0] or length < 1.3 * pixels * (len(legend.labels) - 1):
            return
        box = Box(
            self.free.left,
            self.free.top,
            self.free.left + width,
            self.free.top + 2 * pad + 1.4 * line + length + 2 * ends,
        )
        self.back(box, 0.55)
        if title:
            self.write(box.left + pad, box.top + pad + line / 2, title, pixels, self.theme.text)
        top = box.top + pad + 1.4 * line + ends
        column = Box(box.left + pad, top, box.left + pad + bar, top + length)
        self._draw_bar(legend, column, ends)
        for tick, label in zip(legend.ticks, legend.labels, strict=True):
            share = (tick - legend.low) / (legend.high - legend.low)
            y = column.bottom - share * length
            self._axes.plot(
                [column.right, column.right + 0.35 * pixels],
                [y, y],
                linewidth=0.8,
                color=self.theme.faint,
            )
            self.write(column.right + 0.75 * pixels, y, label, pixels, self.theme.text)
        self._take(box)
        self._shrink(left=box.right + self.margin)

    def add_note(self, text: str) -> None:
        """A faint line at the bottom, on the left."""
        pixels = self.letters(13.0)
        width, height = self.measure(text, pixels)
        box = Box(
            self.margin,
            self.size[1] - self.margin - height,
            self.margin + width,
            self.size[1] - self.margin,
        )
        whole = Box(0, 0, *self.size)
        if not whole.holds(box) or any(box.meets(other) for other in self.taken):
            return
        self.write(box.left, (box.top + box.bottom) / 2, text, pixels, self.theme.faint)
        self._take(box)
        self._shrink(bottom=box.top)

    def add_label(
        self, text: str, start: NDArray[np.float64], end: NDArray[np.float64], thickness: float
    ) -> None:
        """A label near the end of an arrow of some thickness, all [px], clear of it and of all that
        is written; left out where there is no such place.
        """
        pixels = self.letters(17.0)
        width, height = self.measure(text, pixels, "bold")
        half = np.array([width / 2 + 0.55 * pixels, height / 2 + 0.15 * pixels])
        rim = 0.35 * self.margin
        whole = Box(rim, rim, self.size[0] - rim, self.size[1] - rim)
        arrow = start + np.linspace(0.0, 1.0, 64)[:, None] * (end - start)
        ahead = np.arctan2(end[1] - start[1], end[0] - start[0])
        for turn in np.deg2rad([0, 50, -50, 90, -90, 120, -120, 150, -150, 180]):
            d = np.array([np.cos(ahead + turn), np.sin(ahead + turn)])
            # far enough for the box to clear the point, whichever of its sides is nearer
            x, y = (
                end + (min(half / np.maximum(np.abs(d), 1e-9)) + 0.6 * pixels + thickness / 2) * d
            )
            box = Box(x - half[0], y - half[1], x + half[0], y + half[1])
            near = np.abs(arrow - [x, y]) < half + thickness / 2 + 0.25 * pixels
            if whole.holds(box) and not (
                near.all(axis=1).any() or any(box.meets(other, 2.0) for other in self.taken)
            ):
                self.back(box, 0.72)
                self.write(x, y, text, pixels, self.theme.text, "bold", align="center")
                self._take(box)
                return

    def blend(self, picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """The picture with the sheet laid over it."""
        self._canvas.draw()
        sheet = np.asarray(self._canvas.buffer_rgba())
        alpha = sheet[..., 3:].astype(np.float32) / 255.0
        over = picture + alpha * (sheet[..., :3].astype(np.float32) - picture)
        return np.round(over).astype(np.uint8)

    def _draw_bar(self, legend: Legend, column: Box, ends: float) -> None:
        colours = COLOUR_MAPS[legend.colour_map]()
        self._axes.imshow(
            colours[::-1, None],
            extent=(column.left, column.right, column.bottom, column.top),
            aspect="auto",
            interpolation="bilinear",
            zorder=2,
        )
        self._axes.set(xlim=(0, self.size[0]), ylim=(self.size[1], 0))
        middle = (column.left + column.right) / 2
        # a point at an end says that there is more beyond it
        for more, y, tip, colour in (
            (legend.above, column.top, column.top - ends, colours[-1]),
            (legend.below, column.bottom, column.bottom + ends, colours[0]),
        ):
            if more:
                corners = [(column.left, y), (column.right, y), (middle, tip)]
                self._axes.add_patch(Polygon(corners, facecolor=colour / 255.0, linewidth=0))

    def _take(self, box: Box) -> None:
        self.taken.append(box)

    def _shrink(self, left: float = 0.0, top: float = 0.0, bottom: float = np.inf) -> None:
        self.free = Box(
            max(self.free.left, left),
            max(self.free.top, top),
            self.free.right,
            min(self.free.bottom, bottom),
        )
