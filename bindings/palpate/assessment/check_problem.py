# SPDX-License-Identifier: BSD-3-Clause
"""One thing that is wrong with an assessment, or with a layout of organs."""

from __future__ import annotations

from dataclasses import dataclass

ERROR, WARNING = "error", "warning"


@dataclass(frozen=True)
class Problem:
    """Where it is, and what, in a sentence."""

    severity: str
    """ERROR or WARNING, or another that its checker says."""
    where: str
    message: str
