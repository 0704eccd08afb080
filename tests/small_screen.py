# SPDX-License-Identifier: BSD-3-Clause
"""A screen of another size than the one this machine has."""

from __future__ import annotations

import json
import os
from pathlib import Path


def list_environment(folder: Path, size: tuple[int, int], factor: float) -> dict[str, str]:
    """Of a program that has one screen of `size` [pixels] and Qt's scale `factor`."""
    screen = {"name": "small", "x": 0, "y": 0, "width": size[0], "height": size[1]}
    screen |= {"logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}
    config = folder / "screens.json"
    config.write_text(json.dumps({"screens": [screen]}), encoding="utf-8")
    return os.environ | {
        "QT_QPA_PLATFORM": f"offscreen:configfile={config}",
        "QT_SCALE_FACTOR": str(factor),
    }
