# SPDX-License-Identifier: BSD-3-Clause
"""What a hand really felt of a record."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import palpate


def read_force(record: palpate.Record) -> NDArray[np.float64]:
    """[N] (n, 3) per tick, as it was computed; none where the device's motors did not give it."""
    force = np.asarray(record.felt["force"], dtype=float)
    return np.where(read_rendered(record)[:, None], force, 0.0)


def read_rendered(record: palpate.Record) -> NDArray[np.bool_]:
    """(n,) whether the motors of the device were on."""
    return (np.asarray(record.felt["touched"]) & palpate.NOT_RENDERED) == 0


def read_touched(record: palpate.Record) -> NDArray[np.bool_]:
    """(n,) whether the tool touched, or held, the tissue."""
    return (np.asarray(record.felt["touched"]) & (palpate.TOUCHING | palpate.ATTACHED)) != 0
