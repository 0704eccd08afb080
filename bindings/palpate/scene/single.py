# SPDX-License-Identifier: BSD-3-Clause
"""What is done only with scenes of one body and one instrument, as files hold them."""

from __future__ import annotations

import palpate


def require_single(scene: palpate.Scene, what: str) -> None:
    """Raises ValueError where a scene has several; `what` is of one body and one instrument."""
    for name in ("bodies", "instruments"):
        count = len(getattr(scene, name))
        if count != 1:
            raise ValueError(f"scene.{name}: got {count}, expected 1, as {what} has")
