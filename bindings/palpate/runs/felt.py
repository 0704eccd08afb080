# SPDX-License-Identifier: BSD-3-Clause
"""What a hand really felt of a record."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import palpate


def read_column(
    record: palpate.Record, table: str, name: str, instrument: int = 0
) -> NDArray[np.generic]:
    """(n,) or (n, k): a field of one instrument's hand or felt, per tick; a view.

    Raises IndexError for an instrument that the record has not.
    """
    values = np.asarray(getattr(record, table)[name])
    if np.ndim(record.hand["time"]) == 1:  # of one instrument
        if instrument != 0:
            raise IndexError(f"instrument: got {instrument}, expected 0")
        return values
    return values[:, instrument]


def read_force(record: palpate.Record, instrument: int = 0) -> NDArray[np.float64]:
    """[N] (n, 3) per tick, as it was computed; none where the device's motors did not give it."""
    force = read_column(record, "felt", "force", instrument).astype(float)
    return np.where(read_rendered(record, instrument)[:, None], force, 0.0)


def read_rendered(record: palpate.Record, instrument: int = 0) -> NDArray[np.bool_]:
    """(n,) whether the motors of the device were on."""
    touched = read_column(record, "felt", "touched", instrument)
    return np.asarray((touched & palpate.NOT_RENDERED) == 0)


def read_touched(record: palpate.Record, instrument: int = 0) -> NDArray[np.bool_]:
    """(n,) whether the tool touched, or held, the tissue."""
    touched = read_column(record, "felt", "touched", instrument)
    return np.asarray((touched & (palpate.TOUCHING | palpate.ATTACHED)) != 0)


def read_touched_by_any(record: palpate.Record) -> NDArray[np.bool_]:
    """(n,) whether an instrument touched, or held, the tissue, whichever it was."""
    return np.any([read_touched(record, each) for each in range(record.instruments)], axis=0)


def read_felt_by_any(record: palpate.Record) -> NDArray[np.bool_]:
    """(n,) likewise, of instruments whose device's motors were on."""
    each = range(record.instruments)
    return np.any([read_touched(record, i) & read_rendered(record, i) for i in each], axis=0)


def read_all_rendered(record: palpate.Record) -> NDArray[np.bool_]:
    """(n,) whether the motors of all devices were on."""
    return np.all([read_rendered(record, each) for each in range(record.instruments)], axis=0)
