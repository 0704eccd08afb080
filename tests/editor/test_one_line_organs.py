# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of meshes/README.md that make organs of other people's files do what they say there."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.cli.main import main
from palpate.runs.press import CLEARANCE, find_top
from palpate_editor.authoring import inspect_mesh
from palpate_editor.compile import compile_organ, mesh_of
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_editor.document.files import read_organ
from palpate_editor.edits import import_file
from palpate_editor.edits.keep_outer import keep_outer
from palpate_editor.edits.repair import keep_largest

README = Path(__file__).parents[2] / "meshes/README.md"
ANGLE = 20.0
"""[degree] The least of any triangle."""
PRESSED = 1.0
"""[s]"""


def list_lines() -> list[tuple[str, str, float]]:
    """File, command and the distance [-] of the diagonal that each row says."""
    text = README.read_text(encoding="utf-8").split("## Organs of other people's files")[1]
    rows = re.findall(r"^    (palpate import (\S+) .*?) +# ([\d.]+) %$", text, re.MULTILINE)
    return [(file, line, 0.01 * float(share)) for line, file, share in rows]


def make(line: str, file: str, shared_data, tmp_path: Path) -> Organ:
    words = shlex.split(line)
    out = tmp_path / words[words.index("-o") + 1]
    words[words.index("-o") + 1] = str(out)
    words[words.index(file)] = str(shared_data(f"organs/{file}"))
    assert main(words[1:]) == 0
    return read_organ(out)


def import_outer(line: str, path: Path) -> Surface:
    """The outer surface of what the line takes of its file, before anything else is done."""
    words = shlex.split(line)
    parts = [words[i + 1] for i, word in enumerate(words) if word == "--part"]
    surface = import_file(path, parts=parts)(EMPTY).surface
    if "--largest" in words:
        return keep_largest(surface)
    return keep_outer(surface).surface if "--visible" in words else surface


def spread_directions(count: int) -> np.ndarray:
    """(n, 3) of unit length, evenly over the sphere."""
    k = np.arange(count) + 0.5
    height, turn = 1.0 - 2.0 * k / count, np.pi * (1.0 + np.sqrt(5.0)) * k
    across = np.sqrt(1.0 - height**2)
    return np.column_stack([across * np.cos(turn), across * np.sin(turn), height])


def sample_seen(surface: Surface, share: float = 0.1, every: int = 40) -> np.ndarray:
    """[m] (k, 3) middles of triangles from which some of all directions lead past all others."""
    x, t = surface.vertices, surface.triangles
    tree = palpate.AabbTree(x, t)
    directions = spread_directions(50)
    middles = x[t].mean(axis=1)[::every]
    off = 1e-6 * palpate.compute_diagonal(x)
    least = round(share * len(directions))

    def is_seen(middle: np.ndarray) -> bool:
        free = 0
        for row, d in enumerate(directions):
            free += palpate.find_ray_hit(tree, x, middle + off * d, d) is None
            if free >= least or free + len(directions) - row - 1 < least:
                break
        return free >= least

    return middles[[is_seen(middle) for middle in middles]]


def sample(surface: Surface) -> np.ndarray:
    """Corners, middles of edges and of triangles [m] (k, 3)."""
    x = surface.vertices[surface.triangles]
    edges = 0.5 * (x + np.roll(x, 1, axis=1))
    return np.concatenate([surface.vertices, edges.reshape(-1, 3), x.mean(axis=1)])


def measure_distance(points: np.ndarray, to: Surface) -> float:
    """[m] from points (k, 3) to a surface, at most."""
    tree = palpate.AabbTree(to.vertices, to.triangles)
    return max(palpate.find_closest_point(tree, to.vertices, p).distance for p in points)


def press(organ: Organ) -> float:
    """[N] the largest force of a press of 3 mm that lasts a second. No tick may raise an alarm."""
    scene = compile_organ(organ)
    world, dt, place, largest = palpate.World(scene), 1.0 / scene.rate, find_top(scene), 0.0
    for tick in range(round(PRESSED * scene.rate)):
        part = min(1.0, tick * dt / 0.2)
        height = scene.instruments[0].tool.radius + CLEARANCE - part * (CLEARANCE + 3e-3)
        hand = palpate.HapticSample(time=tick * dt, position=place.point + height * place.outward)
        largest = max(largest, float(np.linalg.norm(palpate.tick(scene, hand, dt, world).force)))
        assert not world.alarm, (tick, world.alarm)
    return largest


def list_cases() -> list:
    everyday = ("VH_F_Spleen.glb", "VH_F_Pancreas.glb")
    return [
        pytest.param(*row, id=row[0], marks=() if row[0] in everyday else pytest.mark.landing)
        for row in list_lines()
    ]


@pytest.mark.parametrize(("file", "line", "share"), list_cases())
def test_a_line_makes_an_organ_of_a_file(file, line, share, shared_data, tmp_path):
    organ = make(line, file, shared_data, tmp_path)

    surface = organ.surface
    report = inspect_mesh(mesh_of(surface))
    assert report.vertices == int(re.search(r"--vertices (\d+)", line).group(1))
    assert (report.shells, report.non_manifold_edges) == (1, 0)
    assert len(report.border_loops) <= 1
    assert report.self_intersecting_faces == 0
    assert report.smallest_angle_deg >= ANGLE
    outer = import_outer(line, shared_data(f"organs/{file}"))
    most = share * palpate.compute_diagonal(outer.vertices)
    # a hole that was filled is none of the file
    source = organ.imported if "--fill-holes" in line else outer
    seen = sample_seen(outer) if "--wrap" in line else sample(outer)
    assert measure_distance(sample(surface), source) < most
    assert measure_distance(seen, surface) < most
    if "--wrap" in line:
        assert any("inside the wrap dropped" in note for note in organ.source.notes)
    assert press(organ) > 0.01


def test_the_page_has_a_line_of_eight_files_that_are_there(shared_data):
    named = {file for file, _, _ in list_lines()}

    assert len(named) == 8
    for file in named:
        assert shared_data(f"organs/{file}").is_file()
