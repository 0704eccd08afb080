# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface nobody can change, and the freezing of arrays it rests on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np


def freeze(values: Any, dtype: type, shape: tuple[int | None, ...]) -> np.ndarray:
    """`values` as an array that cannot be written; the very same one where it already is that.

    Raises ValueError for another shape; None in `shape` takes any length.
    """
    array = np.asarray(values)
    if array.ndim != len(shape) or any(
        wanted is not None and found != wanted
        for found, wanted in zip(array.shape, shape, strict=True)
    ):
        raise ValueError(f"got an array of shape {array.shape}, expected {shape}")
    kept = array.dtype == dtype and array.flags.c_contiguous and not array.flags.writeable
    if kept and (array.base is None or isinstance(array.base, bytes)):
        return array
    array = np.array(array, dtype=dtype, order="C")
    array.flags.writeable = False
    return array


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles in space. Compared by identity, so a view can tell whether it must redraw."""

    vertices: np.ndarray
    """[m] (n, 3), read-only"""
    triangles: np.ndarray
    """(t, 3) int32, counter-clockwise from outside, read-only"""
    colours: np.ndarray | None = None
    """(n, 3) uint8, sRGB, read-only: nothing that is felt; None where all are alike"""

    def __post_init__(self) -> None:
        object.__setattr__(self, "vertices", freeze(self.vertices, np.float64, (None, 3)))
        object.__setattr__(self, "triangles", freeze(self.triangles, np.int32, (None, 3)))
        if self.colours is not None:
            count = len(self.vertices)
            object.__setattr__(self, "colours", freeze(self.colours, np.uint8, (count, 3)))

    def __repr__(self) -> str:
        return f"Surface({len(self.vertices)} vertices, {len(self.triangles)} triangles)"


@dataclass(frozen=True, eq=False)
class Filling:
    """Tetrahedra as a file has them. Compared by identity, as surfaces are."""

    vertices: np.ndarray
    """[m] (n, 3), read-only"""
    tetrahedra: np.ndarray
    """(t, 4) int32, (b - a) x (c - a) towards d, read-only"""

    def __post_init__(self) -> None:
        object.__setattr__(self, "vertices", freeze(self.vertices, np.float64, (None, 3)))
        object.__setattr__(self, "tetrahedra", freeze(self.tetrahedra, np.int32, (None, 4)))

    def __repr__(self) -> str:
        return f"Filling({len(self.vertices)} vertices, {len(self.tetrahedra)} tetrahedra)"
