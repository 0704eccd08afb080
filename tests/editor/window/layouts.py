# SPDX-License-Identifier: GPL-3.0-or-later
"""A layout of two small organs, a stone and a tray, and its window driven by hand."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import palpate
from palpate import scenario
from palpate.layout.document import History, Layout, apply
from palpate.layout.layout_file import write_layout
from palpate_editor.layout_changes import change
from palpate_editor.views.layout.layout_window import LayoutWindow
from palpate_editor.views.quantity_box import QuantityBox
from palpate_meshes.generate import ellipsoid
from patience import PATIENCE

HALF = (0.03, 0.025, 0.02)
"""[m] Of each organ, which are ellipsoids."""


def make_ball(half: tuple[float, float, float]) -> palpate.SurfaceMesh:
    """An ellipsoid of 162 vertices."""
    return palpate.SurfaceMesh(*ellipsoid(162, half, bow=0, hollow=0, notches=0))


def write_organ(path: Path) -> None:
    """Held at its foot, which is a region as its top is."""
    mesh = make_ball(HALF)
    z = np.asarray(mesh.vertices)[:, 2]
    options = palpate.SurfaceOptions(fixed=(z < 0.0).tolist(), home_stiffness=4e5)
    wall = palpate.Material(damping_ratio=0.2, wall_thickness=3e-3)
    tissue = palpate.build_mass_spring(mesh, wall, 100.0, options)
    regions = {"top": np.flatnonzero(z > 0.012), "foot": np.flatnonzero(z < -0.012)}
    made = scenario.Scenario(
        scene=palpate.build_scene(palpate.make_scene(tissue)),
        title=path.stem,
        authored=json.dumps(
            {"format": "organ", "version": 16, "content": {"regions": list(regions)}}
        ),
        authored_arrays={
            f"regions/{i}": rows.astype(np.int32) for i, rows in enumerate(regions.values())
        },
    )
    scenario.write(path, made)


def write_obj(path: Path, mesh: palpate.SurfaceMesh, scale: float = 1e3) -> None:
    rows = [f"v {x} {y} {z}" for x, y, z in scale * np.asarray(mesh.vertices)]
    rows += [f"f {a} {b} {c}" for a, b, c in np.asarray(mesh.triangles) + 1]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")


def write_two(folder: Path) -> Path:
    """two.layout.json, and beside it a mesh that is none."""
    for name in ("left", "right"):
        write_organ(folder / f"{name}.palpate")
    write_obj(folder / "stone.obj", make_ball((0.0045, 0.004, 0.0035)))
    corners = [(-0.06, -0.05, 0.0), (0.12, -0.05, 0.0), (0.12, 0.05, 0.0), (-0.06, 0.05, 0.0)]
    write_obj(folder / "tray.obj", palpate.SurfaceMesh(corners, [(0, 1, 2), (0, 2, 3)]))
    (folder / "damaged.obj").write_text("v 0 0\n", encoding="utf-8")
    path, history = folder / "two.layout.json", History(Layout(title="Two organs"))
    for words in (
        ("add", str(folder / "left.palpate")),
        ("add", str(folder / "right.palpate"), "--at=65,0,0"),
        ("pair", "left", "right"),
        ("add", str(folder / "stone.obj"), "--as=stone", "--unit=mm", "--at=33,-35,-26.4"),
        ("add", str(folder / "tray.obj"), "--as=scenery", "--unit=mm", "--at=0,0,-30"),
    ):
        history = apply(history, change(path, history.now, words))
    write_layout(path, history)
    return path


def wait(qtbot, window: LayoutWindow) -> None:
    """Until all is read and checked."""
    qtbot.waitUntil(
        lambda: (
            window.jobs.current is None
            and window.checked is not None
            and len({part.file for part in window.session.layout.parts}) <= len(window.shapes)
        ),
        timeout=PATIENCE,
    )


def find(window: LayoutWindow, kind: type, name: str):
    found = window.findChild(kind, name)
    assert found is not None, name
    return found


def enter(window: LayoutWindow, name: str, text: str) -> None:
    box = find(window, QuantityBox, name)
    box.lineEdit().setText(text)
    box.enter()


def log(window: LayoutWindow) -> str:
    return window.log.toPlainText()


def part(window: LayoutWindow, name: str):
    return window.session.layout.find_part(name)
