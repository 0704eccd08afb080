# SPDX-License-Identifier: BSD-3-Clause
"""What a step, a query and a tick cost on this machine, beside their naive forms."""

from palpate.bench.meshes import (
    BenchMesh,
    generate_ellipsoid,
    generate_meshes,
    read_shipped,
    read_surface,
)
from palpate.bench.rows import bench_meshes, find_missing

__all__ = [
    "BenchMesh",
    "bench_meshes",
    "find_missing",
    "generate_ellipsoid",
    "generate_meshes",
    "read_shipped",
    "read_surface",
]
