# SPDX-License-Identifier: GPL-3.0-or-later
"""Which voxels belong to the organ: by label or by a range of grey levels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from palpate_editor.scan_child.choice import Choice, find_chosen
from palpate_editor.scan_child.refused import Refused
from palpate_editor.scan_child.volume import Volume

EDGES = ("left", "right", "front", "back", "bottom", "top")
MOST_LABELS_SHOWN = 40


@dataclass
class Part:
    """The voxels of the organ within a box: a voxel is around them where the volume has one."""

    mask: np.ndarray
    """(d, h, w) bool"""
    field: np.ndarray
    """(d, h, w) float32, positive where `mask` is: its zero is the surface without smoothing."""
    corner: np.ndarray
    """(3,) slice, row and column of the box's first voxel."""
    pieces_dropped: int
    """Of voxels that touch by their faces."""


def find_part(volume: Volume, choice: Choice) -> Part:
    """Raises Refused where nothing is chosen."""
    whole = find_chosen(volume.voxels, choice)
    if not whole.any():
        raise Refused(*describe_nothing(volume, choice))
    tight = ndimage.find_objects(whole.view(np.uint8))[0]
    # with a voxel around: between it and the first inside stands the surface
    box = tuple(slice(max(edge.start - 1, 0), edge.stop + 1) for edge in tight)
    mask = whole[box]
    field = field_of(volume.voxels[box], mask, choice)
    mask, dropped = drop_pieces(mask, choice, volume.voxel_size)
    if choice.largest:
        mask = ndimage.binary_fill_holes(mask)
    # what was dropped is outside, what was filled inside, by as much as it was the other
    field = np.where(mask, np.abs(field), -np.abs(field)).astype(np.float32)
    return Part(mask, field, np.array([edge.start for edge in box]), dropped)


def field_of(voxels: np.ndarray, mask: np.ndarray, choice: Choice) -> np.ndarray:
    """Of a label ±0.5; of a range how far a grey level is inside of it, never 0.

    Whole grey levels are cut half-way between two of them, since a surface through the middle of
    voxels degenerates.
    """
    if choice.labels:
        return np.where(mask, np.float32(0.5), np.float32(-0.5))
    low, high = choice.low, choice.high
    if np.issubdtype(voxels.dtype, np.integer):
        low = None if low is None else np.ceil(low) - 0.5
        high = None if high is None else np.floor(high) + 0.5
    grey = voxels.astype(np.float32)
    if low is not None and high is not None:
        field = np.minimum(grey - np.float32(low), np.float32(high) - grey)
    else:
        field = grey - np.float32(low) if low is not None else np.float32(high) - grey
    least = 1e-4 * max(float(np.abs(field).max()), 1e-30)
    return np.where(mask, np.maximum(field, least), np.minimum(field, -least))


def drop_pieces(mask: np.ndarray, choice: Choice, voxel_size: float) -> tuple[np.ndarray, int]:
    """Without what is too small, and without all but the largest piece where that is asked for.

    Raises Refused where nothing is left.
    """
    marks, count = ndimage.label(mask)
    if count == 1:
        return mask, 0
    sizes = np.bincount(marks.ravel())[1:] * voxel_size
    kept = sizes >= 1e9 * choice.least_volume
    if choice.largest:
        kept = np.arange(count) == sizes.argmax()
    if not kept.any():
        raise Refused(
            "--least-volume",
            f"{count} pieces, the largest of {1e-3 * sizes.max():.4g} ml",
            f"one of at least {1e6 * choice.least_volume:.4g} ml",
        )
    return np.concatenate(([False], kept))[marks], int(count - kept.sum())


def describe_nothing(volume: Volume, choice: Choice) -> tuple[str, str, str]:
    """Where, got, expected for a choice without a voxel."""
    if choice.labels:
        shown = ", ".join(map(str, choice.labels))
        there = [int(label) for label in np.unique(volume.voxels)[: MOST_LABELS_SHOWN + 1] if label]
        known = ", ".join(map(str, there[:MOST_LABELS_SHOWN])) or "none but 0"
        return "--label", f"{shown}, which no voxel has", f"one that there is: {known}"
    low, high = float(volume.voxels.min()), float(volume.voxels.max())
    return (
        "--threshold",
        f"{'' if choice.low is None else f'{choice.low:g}'}:"
        f"{'' if choice.high is None else f'{choice.high:g}'}, within which no voxel is",
        f"a range that meets {low:g} to {high:g}",
    )


def find_cut_sides(part: Part, volume: Volume) -> list[str]:
    """Names of the volume's sides at which the organ ends because the scan does."""
    found: list[str] = []
    for axis in range(3):
        first = part.corner[axis] == 0
        last = part.corner[axis] + part.mask.shape[axis] == volume.voxels.shape[axis]
        for is_cut, sign, at in ((first, -1.0, 0), (last, 1.0, -1)):
            if is_cut and part.mask.take(at, axis).any():
                found.append(name_side(sign * volume.steps[:, 2 - axis]))
    return sorted(set(found), key=EDGES.index)


def name_side(away: np.ndarray) -> str:
    """Where a direction of the patient points: x is his left, y his back, z up."""
    axis = int(np.abs(away).argmax())
    return (("right", "left"), ("front", "back"), ("bottom", "top"))[axis][int(away[axis] > 0.0)]
