# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of scenes and of records, drawn with no display."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import palpate
from palpate.runs.element import read_sample
from palpate.runs.felt import read_column, read_force
from palpate.runs.replay import open_record
from palpate.runs.run import PUBLISHED, Run
from palpate.scene.surfaces import join_positions, join_rest_surfaces, join_triangles

if TYPE_CHECKING:
    from palpate.render import DrawnPart
    from palpate.render.hard_parts import Pose


def pose_at(scene: palpate.Scene, record: palpate.Record, tick: int) -> palpate.World:
    """The world after `tick` ticks of a record."""
    world = palpate.World(scene)
    hand = record.hand.reshape(len(record.hand), -1)
    for rows in hand[: tick + 1]:
        palpate.tick(scene, [read_sample(row) for row in rows], 1.0 / scene.rate, world)
    return world


def picture_of_rest(
    out: Path, organ: palpate.SurfaceMesh | palpate.Scene, title: str, options: dict[str, Any]
) -> None:
    """Draws a surface, or all bodies of a scene, at rest."""
    from palpate.render import save_picture

    if isinstance(organ, palpate.Scene):
        x, triangles = join_rest_surfaces(organ), join_triangles(organ)
        options = {"beside": draw_hard_parts(organ, organ.rigid)} | options
    else:
        x, triangles = np.asarray(organ.vertices), np.asarray(organ.triangles)
    save_picture(out, x, triangles, title=title, **options)


def picture_of_record(
    out: Path,
    record_path: Path,
    time: float | None,
    options: dict[str, Any],
    title: str | None = None,
    scene_path: Path | None = None,
) -> float:
    """Draws the organs of a record at a time [s], or where a force was greatest, with all
    instruments, and the force and the shadow of the one that felt most then; returns when.
    """
    from palpate.render import build_shade, save_picture
    from palpate.render.instrument import find_rotation
    from palpate.render.instrument_shade import find_glow

    record, where, scene = open_record(record_path, scene_path)
    times = read_column(record, "hand", "time").astype(float)
    forces = np.array([read_force(record, each) for each in range(record.instruments)])
    sizes = np.linalg.norm(forces, axis=2)
    if time is None:
        tick = int(sizes.max(axis=0).argmax())
    else:
        tick = int(np.searchsorted(times, time).clip(0, len(times) - 1))
    felt = int(sizes[:, tick].argmax())
    world = pose_at(scene, record, tick)
    x = join_positions([np.asarray(palpate.surface_position(body)) for body in world.bodies])
    its, state = scene.instruments[felt].tool, world.instruments[felt].tool
    glow = find_glow(bool(state.touching), float(sizes[felt, tick]))
    rotation = find_rotation(state.orientation)
    shade = build_shade(its, state.position, rotation, glow, opening=state.jaw_angle)
    save_picture(
        out,
        x,
        join_triangles(scene),
        values=1e3 * np.linalg.norm(x - join_rest_surfaces(scene), axis=1),
        legend="displacement [mm]",
        tool=(np.asarray(state.position), its.radius),
        instrument=place_instruments(scene, world),
        shade=shade,
        beside=draw_hard_parts(scene, world.rigid),
        force=forces[felt, tick],
        title=title or name_scene(where),
        **options,
    )
    return float(times[tick])


def draw_hard_parts(scene: palpate.Scene, poses: Sequence[Pose]) -> list[DrawnPart]:
    """[m] Scenery, and rigid bodies where they are."""
    from palpate.render.hard_parts import build_rigid, build_scenery, place_rigid

    return [*build_scenery(scene), *place_rigid(build_rigid(scene), poses)]


def place_instruments(scene: palpate.Scene, world: palpate.World) -> list[DrawnPart]:
    """[m] Every instrument where it is; none of an only one that is a ball, which a picture draws
    by itself."""
    from palpate.render import DrawnPart, build_instrument, place_instrument
    from palpate.render.instrument import METAL
    from palpate.render.shapes import build_sphere

    parts: list[DrawnPart] = []
    for its, now in zip(scene.instruments, world.instruments, strict=True):
        tool, drawn = now.tool, build_instrument(its.tool)
        if drawn is not None:
            parts += place_instrument(drawn, tool.position, tool.orientation, tool.jaw_angle)
        elif len(scene.instruments) > 1:
            parts.append(DrawnPart(build_sphere(tool.position, its.tool.radius), METAL))
    return parts


def name_scene(path: Path) -> str:
    """What a scene is called after its file."""
    return path.name.removesuffix(".json").removesuffix(".scene").removesuffix(PUBLISHED)


def plot_runs(out: Path, runs: dict[str, Run], title: str) -> None:
    """Force against time of one or several runs of the same script, as PNG."""
    from palpate.render import save_force_plot

    save_force_plot(out, {name: run.record for name, run in runs.items()}, title=title)
