# SPDX-License-Identifier: GPL-3.0-or-later
"""From scans to surfaces.

    scan = read_scan(path)                            # what it holds; its voxels if asked for
    found = segment_scan(path, Choice(labels=(1,)))   # a closed surface in metres

Volumes are read by SimpleITK and cut by scikit-image in a process of their own
(palpate_editor.scan_child), limited in time and memory, that can be ended at any moment. Neither is
imported here. A scan that is refused raises `palpate.FileError` with file, where, found, expected;
where the extra `scan` is not installed, `MissingExtra` says how to.
"""

from __future__ import annotations

from palpate_editor.scan.reader import (
    SUFFIXES,
    Cancelled,
    Limits,
    MissingExtra,
    SeveralSeries,
    hash_scan,
    is_scan,
    read_scan,
    segment_scan,
)
from palpate_editor.scan.values import Label, Scan, ScanSurface, Series
from palpate_editor.scan_child.choice import (
    MOST_SMOOTHING,
    USUAL_SMOOTHING,
    Choice,
    describe_choice,
    find_chosen,
    read_range,
)

__all__ = [
    "MOST_SMOOTHING",
    "SUFFIXES",
    "USUAL_SMOOTHING",
    "Cancelled",
    "Choice",
    "Label",
    "Limits",
    "MissingExtra",
    "Scan",
    "ScanSurface",
    "Series",
    "SeveralSeries",
    "describe_choice",
    "find_chosen",
    "hash_scan",
    "is_scan",
    "read_range",
    "read_scan",
    "segment_scan",
]
