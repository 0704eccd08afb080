# SPDX-License-Identifier: BSD-3-Clause
"""One thing that is wrong with an assessment."""

from __future__ import annotations

from dataclasses import dataclass

ERROR, WARNING = "error", "warning"


@dataclass(frozen=True)
class Problem:
    """Where it is, and what, in a sentence."""

    severity: str
    """ERROR or WARNING."""
    where: str
    message: str
