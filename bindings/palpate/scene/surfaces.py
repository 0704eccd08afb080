# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of all bodies of a scene as one, for what draws them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import palpate


def join_positions(positions: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """[m] (n, 3) of all bodies, one after the other."""
    return positions[0] if len(positions) == 1 else np.concatenate(positions)


def join_torn(
    torn: Sequence[NDArray[np.float32]], positions: Sequence[NDArray[np.float64]]
) -> NDArray[np.float32] | None:
    """[-] (n,) of all bodies' vertices; None where none of them tears."""
    if not any(len(each) for each in torn):
        return None
    whole = [np.zeros(len(each), np.float32) for each in positions]
    return np.concatenate([t if len(t) else w for t, w in zip(torn, whole, strict=True)])


def join_rest_surfaces(scene: palpate.Scene) -> NDArray[np.float64]:
    """[m] (n, 3) of all bodies at rest."""
    tissues = [body.tissue for body in scene.bodies]
    return join_positions(
        [np.asarray(palpate.compute_surface(each, each.rest_position)) for each in tissues]
    )


def join_triangles(scene: palpate.Scene) -> NDArray[np.int32]:
    """(t, 3) of all bodies, naming vertices of join_positions()."""
    first, joined = 0, []
    for body in scene.bodies:
        joined.append(np.asarray(body.tissue.triangles, dtype=np.int32) + np.int32(first))
        first += len(palpate.compute_surface(body.tissue, body.tissue.rest_position))
    return np.concatenate(joined)
