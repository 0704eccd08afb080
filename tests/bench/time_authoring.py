# SPDX-License-Identifier: BSD-3-Clause
"""Processor time of what a designer waits for, on one core.

.venv/bin/python tests/bench/time_authoring.py
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import palpate
from palpate_editor import authoring
from palpate_meshes.catalogue import read_organ_mesh

SOLIDS = ("spleen", "liver", "kidney", "kidney_stone")
COUNTS = (100, 300, 1000, 4000, 10_000)


def measure(work: Callable[[], object]) -> tuple[float, object]:
    """[s] of the processor, and what came of it."""
    begun = time.process_time()
    made = work()
    return time.process_time() - begun, made


def print_fillings() -> None:
    print("filled            asked    made   smallest dihedral [deg]   time [s]")
    for name in SOLIDS:
        mesh = palpate.SurfaceMesh(*read_organ_mesh(name))
        for count in COUNTS:
            seconds, solid = measure(lambda m=mesh, n=count: authoring.fill_to_count(m, n))
            angle = np.degrees(palpate.compute_smallest_dihedral(solid))
            made = len(solid.tetrahedra)
            print(f"{name:14} {count:8} {made:7} {angle:25.1f} {seconds:10.2f}")


def print_decimations() -> None:
    print(
        "decimated         from      to   smallest angle [deg]   largest distance [mm]   time [s]"
    )
    for name in SOLIDS[:3]:
        mesh = palpate.SurfaceMesh(*read_organ_mesh(name))
        most = len(mesh.vertices)
        for count in (most // 2, most // 4):
            seconds, small = measure(lambda m=mesh, n=count: authoring.decimate(m, n))
            print(
                f"{name:14} {most:7} {count:7} {small.smallest_angle_deg:22.1f} "
                f"{1e3 * small.max_distance:23.2f} {seconds:10.2f}"
            )


if __name__ == "__main__":
    print_fillings()
    print_decimations()
