# SPDX-License-Identifier: GPL-3.0-or-later
"""How the arguments of the verbs are spelled.

For the verbs, which read them, and for the window, which shows the command line of each edit.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

import numpy as np

MOST_LETTERS = 100_000
"""Of one argument: the system takes at most 128 KiB [execve(2), MAX_ARG_STRLEN]."""
LAWS = {
    "model.angle_law": "--angle-law",
    "model.damping_law": "--damping-law",
    "model.contact_law": "--contact-law",
    "model.contact_curvature": "--contact-curvature",
    "model.contact_hold": "--contact-hold",
    "model.integrator": "--integrator",
    "model.constants": "--constants",
    "model.spring_rule": "--spring-rule",
}
NONE = "none"
"""The word for a constant that is not given: no wall, the builder's own home springs."""


def write_ids(ids: np.ndarray) -> str:
    """Ascending vertex numbers as 3,5-9."""
    return ",".join(write_row(row) for row in split_rows(ids))


def write_row(row: np.ndarray) -> str:
    return str(row[0]) if len(row) == 1 else f"{row[0]}-{row[-1]}"


def split_rows(ids: np.ndarray, values: np.ndarray | None = None) -> Iterator[np.ndarray]:
    """Consecutive numbers together, and only those of one value where there are values."""
    ids = np.asarray(ids, dtype=np.int64)
    if not ids.size:
        return
    apart = np.diff(ids) != 1
    if values is not None:
        apart |= np.diff(values) != 0.0
    yield from np.split(ids, np.flatnonzero(apart) + 1)


def write_factors(ids: np.ndarray, values: np.ndarray) -> Iterator[str]:
    """Vertex numbers with their factors as 3:2.5,5-9:1.25, in pieces that fit one argument.

    Factors are written so that they are read back exactly.
    """
    ids = np.asarray(ids, dtype=np.int64)
    order = np.argsort(ids, kind="stable")
    ids, values = ids[order], np.broadcast_to(np.asarray(values, dtype=float), ids.shape)[order]
    value_of = dict(zip(ids.tolist(), values.tolist(), strict=True))
    piece, letters = [], 0
    for row in split_rows(ids, values):
        word = f"{write_row(row)}:{value_of[int(row[0])]!r}"
        if piece and letters + len(word) > MOST_LETTERS:
            yield ",".join(piece)
            piece, letters = [], 0
        piece.append(word)
        letters += len(word) + 1
    if piece:
        yield ",".join(piece)


def read_row(text: str) -> np.ndarray:
    """Raises argparse.ArgumentTypeError for anything but 7 or 5-9."""
    first, dash, last = text.partition("-")
    try:
        low = int(first)
        high = int(last) if dash else low
    except ValueError:
        low, high = 0, -1
    if not 0 <= low <= high < 2**31 or high - low > 10_000_000:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected vertex numbers such as 3,5-9")
    return np.arange(low, high + 1)


def read_ids(text: str) -> np.ndarray:
    return np.unique(np.concatenate([read_row(word) for word in text.split(",")]))


def read_factors(text: str) -> tuple[np.ndarray, np.ndarray]:
    ids, values = [], []
    for word in text.split(","):
        numbers, colon, factor = word.partition(":")
        try:
            value = float(factor) if colon else float("nan")
        except ValueError:
            value = float("nan")
        if value != value:
            raise argparse.ArgumentTypeError(f"got {word!r}, expected vertices:factor, as 5-9:2.5")
        ids.append(read_row(numbers))
        values.append(np.full(len(ids[-1]), value))
    return np.concatenate(ids), np.concatenate(values)


def read_region(text: str) -> tuple[str, np.ndarray]:
    """The name may have any letters, so the last = counts."""
    name, equals, ids = text.rpartition("=")
    if not equals:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected NAME=3,5-9")
    return name, read_ids(ids)
