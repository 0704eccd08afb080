# SPDX-License-Identifier: BSD-3-Clause
"""Where the shared data is, for tests that list it before they run."""

from __future__ import annotations

import os
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]


def find_data() -> Path:
    """The folder of shared data: PALPATE_DATA, or ../shared/data seen from the checkout."""
    return Path(os.environ.get("PALPATE_DATA") or CHECKOUT.parent / "shared" / "data").resolve()
