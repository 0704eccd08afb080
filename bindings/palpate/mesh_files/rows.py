# SPDX-License-Identifier: BSD-3-Clause
"""What the three formats share: faces as fans, and refusals that name the place."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from palpate.error import FileError

LONGEST = 40
"""[characters] of a line that a refusal repeats."""


def quote(text: str) -> str:
    """A line as a refusal shows it."""
    return repr(text.strip()[:LONGEST])


def read_numbers(
    file: str, number: int, line: str, tokens: Sequence[str], expected: str
) -> list[float]:
    """Finite numbers from the tokens of a line. Raises FileError, naming the line."""
    try:
        values = [float(token) for token in tokens]
    except ValueError:
        values = [float("nan")]
    if not all(np.isfinite(values)):
        raise FileError(file, f"line {number}", quote(line), expected)
    return values


def fan(corners: Sequence[int]) -> list[tuple[int, int, int]]:
    """A polygon as triangles about its first corner."""
    return [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]


def require_finite(file: str, vertices: NDArray[np.float64], name: str) -> None:
    """Raises FileError for the first row of vertices, shape (n, 3), with no finite numbers."""
    wrong = np.flatnonzero(~np.isfinite(vertices).all(axis=1))
    if len(wrong) > 0:
        found = vertices[wrong[0]].tolist()
        raise FileError(file, f"{name} {wrong[0] + 1}", f"{found}", "three finite numbers")
