# SPDX-License-Identifier: BSD-3-Clause
"""Shader programs from the files in shaders/."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files

import moderngl
import numpy as np
from numpy.typing import NDArray


def build_program(
    context: moderngl.Context,
    name: str,
    geometry: bool = False,
    defines: Mapping[str, int] | None = None,
) -> moderngl.Program:
    """The program of name.vert, name.frag and, where asked for, name.geom.

    `defines` are constants that the fragment shader is compiled with.
    """
    folder = files("palpate.render") / "shaders"
    fragment = (folder / f"{name}.frag").read_text(encoding="utf-8")
    for key, value in (defines or {}).items():
        fragment = fragment.replace("core\n", f"core\n#define {key} {value}\n", 1)
    return context.program(
        vertex_shader=(folder / f"{name}.vert").read_text(encoding="utf-8"),
        geometry_shader=(folder / f"{name}.geom").read_text(encoding="utf-8") if geometry else None,
        fragment_shader=fragment,
    )


def write_matrix(program: moderngl.Program, name: str, matrix: NDArray[np.float64]) -> None:
    """OpenGL keeps matrices column by column."""
    program[name].write(np.ascontiguousarray(matrix.T, dtype=np.float32))
