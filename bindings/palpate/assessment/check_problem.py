# SPDX-License-Identifier: BSD-3-Clause
"""One thing that is wrong with an assessment, or with a layout of organs."""

from __future__ import annotations

from dataclasses import dataclass

ERROR, WARNING, NOTE = "error", "warning", "note"
"""A note is what was done, or is good to know."""


@dataclass(frozen=True)
class Problem:
    """Where it is, and what, in a sentence."""

    severity: str
    """ERROR, WARNING or NOTE."""
    where: str
    message: str
