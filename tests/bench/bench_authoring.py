# SPDX-License-Identifier: BSD-3-Clause
"""What a designer waits for, beside its goals: processor time on one core, and memory.

./run bench --authoring [--quick] [--json]
"""

from __future__ import annotations

import argparse
import json
import resource
import statistics
import struct
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import palpate
from palpate_editor import authoring, edits
from palpate_editor.check import measure_surface
from palpate_editor.document import EMPTY, Organ, Surface
from palpate_meshes.catalogue import read_organ_mesh

REPEATS = 3
LARGE = "memory"
"""The word by which this program is told to be the one whose memory is measured."""


@dataclass(frozen=True)
class Row:
    """One piece of work: medians, and what is asked of them."""

    work: str
    value: float
    unit: str
    goal: str
    met: bool
    found: str = ""
    """What came of the work, where that is asked for too."""


def count_seconds() -> float:
    """[s] of the processor, by this process and those that it has waited for."""
    used = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in used)


def measure(work: Callable[[], object], repeats: int) -> tuple[float, object]:
    """[s] the median, and what came of the last."""
    taken, made = [], None
    for _ in range(repeats):
        begun = count_seconds()
        made = work()
        taken.append(count_seconds() - begun)
    return statistics.median(taken), made


def row(work: str, seconds: float, goal: float, found: str = "", good: bool = True) -> Row:
    return Row(work, seconds, "s", f"< {goal:g} s", seconds < goal and good, found)


# ---------------------------------------------------------------- what is worked on


def write_stl(path: Path, x: np.ndarray, triangles: np.ndarray) -> Path:
    records = np.zeros(len(triangles), [("n", "<f4", 3), ("c", "<f4", (3, 3)), ("a", "<u2")])
    records["c"] = 1e3 * x[triangles]
    path.write_bytes(b"\0" * 80 + struct.pack("<I", len(triangles)) + records.tobytes())
    return path


def torus(around: int, across: int) -> tuple[np.ndarray, np.ndarray]:
    """[m] 2 around across triangles, 130 mm wide."""
    i, j = (g.ravel() for g in np.meshgrid(np.arange(around), np.arange(across), indexing="ij"))
    u, v = 2.0 * np.pi * i / around, 2.0 * np.pi * j / across
    r = 0.045 + 0.02 * np.cos(v)
    x = np.column_stack([r * np.cos(u), r * np.sin(u), 0.02 * np.sin(v)])

    def number(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return (a % around) * across + b % across

    a, b, c, d = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
    return x, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def make_organ(around: int, across: int) -> Organ:
    return EMPTY.with_surface(Surface(*torus(around, across)))


def damage(organ: Organ) -> Organ:
    """With a few triangles missing, turned and doubled."""
    surface = organ.surface
    triangles = np.concatenate([surface.triangles[30:], surface.triangles[100:120]])
    triangles[::997] = triangles[::997, ::-1]
    return EMPTY.with_surface(Surface(surface.vertices, triangles))


def open_up(organ: Organ) -> Organ:
    """With holes of a triangle each."""
    surface = organ.surface
    kept = np.arange(len(surface.triangles)) % 997 > 0
    return EMPTY.with_surface(Surface(surface.vertices, surface.triangles[kept]))


def cut(organ: Organ) -> Organ:
    """In two halves whose borders lie on each other."""
    x, triangles = organ.surface.vertices, organ.surface.triangles
    apart = triangles + len(x) * (np.arange(len(triangles)) % len(triangles) < 7000)[:, None]
    used, numbers = np.unique(apart, return_inverse=True)
    return EMPTY.with_surface(Surface(x[used % len(x)], numbers.reshape(-1, 3)))


def fold(organ: Organ) -> Organ:
    """With vertices pushed through the other side of it, so that triangles cross."""
    x = organ.surface.vertices.copy()
    middle = x.mean(axis=0)
    pushed = np.linalg.norm(x - x[0], axis=1) < 0.03 * np.ptp(x)
    x[pushed] = middle - 1.1 * (x[pushed] - middle)
    return EMPTY.with_surface(Surface(x, organ.surface.triangles))


def import_and_measure(path: Path) -> Organ:
    organ = edits.import_file(path)(EMPTY)
    measure_surface(organ.surface)
    return organ


# ---------------------------------------------------------------- the rows


def time_import(folder: Path, repeats: int) -> Row:
    path = write_stl(folder / "large.stl", *torus(500, 100))
    seconds, organ = measure(lambda: import_and_measure(path), repeats)
    return row("import and doctor", seconds, 1.5, f"{len(organ.surface.triangles)} triangles")


def time_decimation(repeats: int) -> Row:
    mesh = palpate.SurfaceMesh(*torus(500, 100))
    seconds, made = measure(lambda: authoring.decimate(mesh, 5_000), repeats)
    angle = made.smallest_angle_deg
    found = f"100k to {len(made.mesh.triangles)} triangles, {angle:.1f} degrees (20 asked)"
    return row("decimate", seconds, 6.0, found, angle >= 20.0)


def time_repairs(repeats: int) -> Iterator[Row]:
    organ = make_organ(250, 60)
    damaged, opened, folded = damage(organ), open_up(organ), fold(organ)
    steps = [
        (edits.CleanUp(), damaged, 1.0),
        (edits.StitchBorders(), cut(organ), 1.0),
        (edits.FillHoles(even=True, bent=True), opened, 1.0),
        (edits.Smooth(10), opened, 1.0),
        (edits.RemoveCrossings(), folded, 10.0),
        (edits.Wrap(past_holes=True), damaged, 10.0),
    ]
    for edit, organ, goal in steps:
        try:
            seconds, _ = measure(lambda e=edit, o=organ: e(o), repeats)
        except edits.EditError as refused:
            yield Row(str(edit.title), 0.0, "s", f"< {goal:g} s", False, str(refused))
            continue
        yield row(str(edit.title), seconds, goal, "30k triangles")


def time_filling(repeats: int) -> Row:
    mesh = palpate.SurfaceMesh(*read_organ_mesh("spleen"))
    seconds, solid = measure(lambda: authoring.fill_to_count(mesh, 10_000), repeats)
    return row("fill", seconds, 1.0, f"{len(solid.tetrahedra)} tetrahedra")


def measure_memory(folder: Path) -> Row:
    """Of a process of its own that imports and measures 500k triangles, with its reader."""
    path = write_stl(folder / "huge.stl", *torus(1000, 250))
    said = subprocess.run(
        [sys.executable, "-P", __file__, LARGE, str(path)], capture_output=True, check=True
    )
    megabytes = float(said.stdout)
    return Row("memory", megabytes, "MB", "< 1000 MB", megabytes < 1000.0, "500k triangles")


def report_memory(path: Path) -> None:
    """[MB] at most of this process or of its reader, as a line."""
    import_and_measure(path)
    most = max(
        resource.getrusage(w).ru_maxrss for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    )
    print(most * 1024e-6)


def list_rows(folder: Path, repeats: int) -> Iterator[Row]:
    yield measure_memory(folder)
    yield time_import(folder, repeats)
    yield time_filling(repeats)
    yield from time_repairs(repeats)
    yield time_decimation(repeats)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--authoring", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="each work once")
    parser.add_argument("--json", action="store_true")
    call = parser.parse_args()
    repeats = 1 if call.quick else REPEATS
    rows = []
    with tempfile.TemporaryDirectory() as name:
        for made in list_rows(Path(name), repeats):
            rows.append(made)
            met = "met" if made.met else "NOT met"
            line = f"{made.work:22} {made.value:9.2f} {made.unit:3} {made.goal:12} {met:8}"
            print(line, made.found, file=sys.stderr if call.json else sys.stdout, flush=True)
    if call.json:
        print(json.dumps({"repeats": repeats, "rows": [asdict(r) for r in rows]}, indent=2))


if __name__ == "__main__":
    if sys.argv[1:2] == [LARGE]:
        report_memory(Path(sys.argv[2]))
    else:
        main()
