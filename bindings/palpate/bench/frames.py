# SPDX-License-Identifier: BSD-3-Clause
"""How fast pictures of a deforming organ follow each other when nothing waits for a screen."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.render import Appearance, Camera, Renderer, open_context
from palpate.render.authored_appearance import find_appearance
from palpate.runs.press import find_top

SIZE = (1280, 720)
"""[px]"""
EDGE_SAMPLES = 4
DEPTH = 3e-3
"""[m] of the press that is shown."""
PRESS_TICKS = 100
WARM, LEAST_FRAMES, MOST_FRAMES, BUDGET = 3, 40, 2000, 2.0
"""Frames not counted, at least and at most counted, and [s] after which at least will do."""


@dataclass(frozen=True)
class Frames:
    """[s] by the clock, from new positions to a finished picture."""

    median: float
    p99: float


def measure_frames(scene: palpate.Scene, published: Path) -> Frames:
    """Draws the organ of a scene, at rest and pressed in turn. Raises RenderError."""
    shapes = [np.asarray(scene.bodies[0].tissue.rest_position), press(scene)]
    triangles = np.asarray(scene.bodies[0].tissue.triangles)
    appearance = find_appearance(palpate.scenario.read(published)) or Appearance()
    with open_context() as context:
        renderer = Renderer(context)
        part = renderer.add(len(shapes[0]), triangles, appearance)
        middle = (shapes[0].min(axis=0) + shapes[0].max(axis=0)) / 2
        renderer.use_bounds(middle, float(np.linalg.norm(shapes[0] - middle, axis=1).max()))
        camera = Camera(np.radians(-60.0), np.radians(25.0))
        camera.fit(shapes[0], SIZE, (0.0, 0.0, float(SIZE[0]), float(SIZE[1])))
        screen = open_screen(context)

        def draw(shape: NDArray[np.float64]) -> None:
            normals = np.asarray(palpate.compute_vertex_normals(shape, triangles))
            part.update(position=shape.astype(np.float32), normal=normals.astype(np.float32))
            screen.use()
            renderer.draw(camera, SIZE)
            context.finish()

        times = take_times(draw, shapes)
        renderer.release()
    return Frames(float(np.median(times)), float(np.percentile(times, 99)))


def press(scene: palpate.Scene) -> NDArray[np.float64]:
    """[m] (n, 3) the organ after a press from above."""
    world, place = palpate.World(scene), find_top(scene)
    for k in range(1, PRESS_TICKS + 1):
        height = scene.instruments[0].tool.radius - DEPTH * k / PRESS_TICKS
        sample = palpate.HapticSample(position=place.point + height * place.outward)
        palpate.tick(scene, sample, 1.0 / scene.rate, world)
    return np.array(world.bodies[0].tissue.position)


def open_screen(context: Any) -> Any:
    """A framebuffer of a moderngl context, as large as a picture."""
    samples = min(EDGE_SAMPLES, context.max_samples)
    colour = context.renderbuffer(SIZE, 4, samples=samples)
    return context.framebuffer([colour], context.depth_renderbuffer(SIZE, samples=samples))


def take_times(
    draw: Callable[[NDArray[np.float64]], None], shapes: list[NDArray[np.float64]]
) -> list[float]:
    """[s] of each frame."""
    times: list[float] = []
    began = time.perf_counter()
    while len(times) < WARM + LEAST_FRAMES or (
        len(times) < MOST_FRAMES and time.perf_counter() - began < BUDGET
    ):
        start = time.perf_counter()
        draw(shapes[len(times) % 2])
        times.append(time.perf_counter() - start)
    return times[WARM:]
