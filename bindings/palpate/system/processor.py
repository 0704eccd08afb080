# SPDX-License-Identifier: BSD-3-Clause
"""What a machine's processor is called, for figures that only hold on it."""

from __future__ import annotations

import platform
from pathlib import Path

CPUINFO = Path("/proc/cpuinfo")


def name_processor() -> str:
    """As Linux says it; elsewhere as Python knows it, and the machine's kind where it does not."""
    try:
        lines = CPUINFO.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    for line in lines:
        name, _, value = line.partition(":")
        if name.strip() == "model name" and value.strip():
            return value.strip()
    return platform.processor() or platform.machine() or "an unknown processor"
